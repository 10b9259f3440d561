//! What single edits cost, by a function of the caller's.

use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, Versioned, call, init, read_or_default, tree_status,
};
use crate::control::User;
use std::cell::Cell;
use std::ffi::c_void;
use tree_core::distance::EditCosts;
use tree_model::tree_core::NO_PARENT;

/// What an edit costs, finite and 0 or more: changing node `first` of the first tree into node `second` of the second;
/// deleting `first` where `second` is `TREE_NO_PARENT`; inserting `second` where `first` is. Called from one thread at
/// a time, once for each pair; must not unwind.
pub type tree_edit_cost_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, first: u32, second: u32) -> f64>;

/// What edits cost. Begin with `tree_edit_costs_init`. For a metric, changing costs at most deleting plus inserting, is
/// symmetric, and obeys the triangle inequality.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct tree_edit_costs {
    /// `sizeof(tree_edit_costs)`.
    pub struct_size: usize,
    /// Costs of single edits. Default NULL: deleting and inserting cost the weight, changing the difference of the
    /// weights.
    pub cost: tree_edit_cost_fn,
    /// Handed to `cost`.
    pub user: *mut c_void,
}

// SAFETY: repr(C), begins with its size, and holds pointers only.
unsafe impl Versioned for tree_edit_costs {
    const NAME: &'static str = "tree_edit_costs";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), cost: None, user: std::ptr::null_mut() }
    }
}

/// Makes `costs`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_edit_costs_init(
    costs: *mut tree_edit_costs,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(costs, size) })
}

/// The caller's function, which may go to another thread; `None` for the weights.
#[derive(Clone, Copy)]
pub(super) struct Given {
    cost: unsafe extern "C" fn(user: *mut c_void, first: u32, second: u32) -> f64,
    user: User,
}

impl Given {
    pub(super) unsafe fn read(costs: *const tree_edit_costs) -> Result<Option<Self>> {
        let costs = unsafe { read_or_default(costs, "costs") }?;
        Ok(costs.cost.map(|cost| Self { cost, user: User(costs.user) }))
    }

    pub(super) fn costs(self) -> Costs {
        Costs { given: self, bad: Cell::new(None) }
    }
}

/// The caller's costs, and the first answer that is none.
pub(super) struct Costs {
    given: Given,
    bad: Cell<Option<(u32, u32, f64)>>,
}

impl Costs {
    fn ask(&self, first: u32, second: u32) -> f64 {
        // SAFETY: the caller's function with the caller's pointer, as the header says.
        let found = unsafe { (self.given.cost)(self.given.user.get(), first, second) };
        if found.is_finite() && found >= 0.0 {
            return found;
        }
        self.bad.set(self.bad.get().or(Some((first, second, found))));
        0.0
    }

    /// The error of a function that answered with something that is no cost.
    pub(super) fn check(&self) -> Result<()> {
        let Some((first, second, found)) = self.bad.get() else { return Ok(()) };
        let edit = match (first, second) {
            (NO_PARENT, second) => format!("inserting node {second}"),
            (first, NO_PARENT) => format!("deleting node {first}"),
            (first, second) => format!("changing node {first} into node {second}"),
        };
        let text = format!("costs.cost gives {found} for {edit}; finite and 0 or more is right");
        Err(Failure::new(TREE_ERROR_PARAMETER, text))
    }
}

impl EditCosts for Costs {
    fn delete(&self, first: u32) -> f64 {
        self.ask(first, NO_PARENT)
    }

    fn insert(&self, second: u32) -> f64 {
        self.ask(NO_PARENT, second)
    }

    fn change(&self, first: u32, second: u32) -> f64 {
        self.ask(first, second)
    }
}
