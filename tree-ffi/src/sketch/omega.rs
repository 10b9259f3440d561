//! Ω: how the axes of a tree go on and branch.

use super::branches::{label, label_number, tree_sketch_branches, tree_sketch_label};
use super::drawing::at;
use super::tree_templates;
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, Versioned, call, fill, foresee, get, init, out_value,
    read, slice, tree_status, write,
};
use crate::control::{limits, tree_control};
use tree_model::sketch::{Habit, Normal, Omega, Relation};
use tree_model::tree_core::Resource;

/// Orders of axes that a `tree_sketch_omega` tells apart.
pub const TREE_SKETCH_ORDERS: usize = 8;

/// A normal distribution.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_sketch_normal {
    /// Its mean μ.
    pub mean: f32,
    /// Its standard deviation σ, 1e-4 to 10.
    pub deviation: f32,
}

/// How axes of one order go on and branch. Angles in radians.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_sketch_habit {
    /// Natural logarithm of the length of the apical segment over that of the segment below. The mean is -10 to 10.
    pub scale: tree_sketch_normal,
    /// Natural logarithm of the length of a lateral's first segment over that of the segment below. The mean is -10
    /// to 10.
    pub lateral_scale: tree_sketch_normal,
    /// α: the angle between the apical segment and the segment below. The mean is 0 to π.
    pub alpha: tree_sketch_normal,
    /// β: the angle between a lateral and the segment below. The mean is 0 to π.
    pub beta: tree_sketch_normal,
    /// γ: the turn about the axis from one lateral to the next. The mean is -2π to 2π.
    pub gamma: tree_sketch_normal,
}

/// Ω, the global parameters of a tree: a habit for axes of order 0 (the trunk), 1 and so on. Begin with
/// `tree_sketch_omega_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_omega {
    /// `sizeof(tree_sketch_omega)`.
    pub struct_size: usize,
    /// How many orders have a habit of their own, 1 to `TREE_SKETCH_ORDERS`; the last one holds for all higher
    /// orders too. Default 1. Of a template with more of them the first are given.
    pub n_orders: u32,
    /// 0.
    pub reserved: u32,
    /// The habits; rows from `n_orders` on do not count. Default: a broad-leaved tree's, with nearly straight axes
    /// and laterals at half a right angle in a golden spiral.
    pub orders: [tree_sketch_habit; TREE_SKETCH_ORDERS],
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_sketch_omega {
    const NAME: &'static str = "tree_sketch_omega";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Omega::default())
    }
}

impl tree_sketch_normal {
    fn of(normal: Normal) -> Self {
        Self { mean: normal.mean, deviation: normal.deviation }
    }

    fn rust(self) -> Normal {
        Normal::new(self.mean, self.deviation)
    }
}

impl tree_sketch_habit {
    fn of(habit: &Habit) -> Self {
        Self {
            scale: tree_sketch_normal::of(habit.scale),
            lateral_scale: tree_sketch_normal::of(habit.lateral_scale),
            alpha: tree_sketch_normal::of(habit.alpha),
            beta: tree_sketch_normal::of(habit.beta),
            gamma: tree_sketch_normal::of(habit.gamma),
        }
    }

    fn rust(&self) -> Habit {
        Habit {
            scale: self.scale.rust(),
            lateral_scale: self.lateral_scale.rust(),
            alpha: self.alpha.rust(),
            beta: self.beta.rust(),
            gamma: self.gamma.rust(),
        }
    }
}

impl tree_sketch_omega {
    /// In C's form.
    pub(crate) fn of(omega: &Omega) -> Self {
        let mut orders = [tree_sketch_habit::default(); TREE_SKETCH_ORDERS];
        for (row, habit) in orders.iter_mut().zip(&omega.orders) {
            *row = tree_sketch_habit::of(habit);
        }
        let n_orders = omega.orders.len().min(TREE_SKETCH_ORDERS) as u32;
        Self { struct_size: size_of::<Self>(), n_orders, reserved: 0, orders }
    }

    /// In Rust's form, its ranges not yet checked.
    pub(crate) fn rust(&self) -> Result<Omega> {
        let found = usize::try_from(self.n_orders).ok().and_then(|n| self.orders.get(..n));
        let Some(rows @ [_, ..]) = found else {
            let (n, most) = (self.n_orders, TREE_SKETCH_ORDERS);
            let text = format!("omega.n_orders is {n}, it must be 1 to {most}");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        };
        Ok(Omega { orders: rows.iter().map(tree_sketch_habit::rust).collect() })
    }
}

/// A caller's Ω, checked. NULL is the default.
pub(super) unsafe fn omega(omega: *const tree_sketch_omega) -> Result<Omega> {
    if omega.is_null() {
        return Ok(Omega::default());
    }
    let omega = unsafe { read(omega, "omega") }?.rust()?;
    omega.validate()?;
    Ok(omega)
}

/// Makes `omega`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_omega_init(
    omega: *mut tree_sketch_omega,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(omega, size) })
}

/// Whether all numbers are in range: `TREE_OK`, or the error that their use would give, which names order and
/// field.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_omega_check(omega: *const tree_sketch_omega) -> tree_status {
    call(|| {
        let omega = unsafe { read(omega, "omega") }?;
        Ok(omega.rust()?.validate()?)
    })
}

/// Ω of branches. Orders with few segments borrow from all orders together; what the branches do not show at all
/// is the default's. Set `omega->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_omega_fit(
    branches: *const tree_sketch_branches,
    omega: *mut tree_sketch_omega,
) -> tree_status {
    call(|| {
        let branches = unsafe { get(branches, "branches") }?.rust();
        unsafe { foresee(omega, "omega") }?;
        let found = Omega::fit(&branches.branches);
        unsafe { write(omega, "omega", &tree_sketch_omega::of(&found)) }
    })
}

/// Ω of template `index`, which is below `tree_templates_count`: that of its exemplar's main branches. Set
/// `omega->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_templates_omega(
    templates: *const tree_templates,
    index: usize,
    omega: *mut tree_sketch_omega,
) -> tree_status {
    call(|| {
        let templates = unsafe { get(templates, "templates") }?.rust();
        let found = &at(templates, index, "templates")?.omega;
        unsafe { write(omega, "omega", &tree_sketch_omega::of(found)) }
    })
}

/// Ω of `n_relations` relations, of one tree or of many: those of `tree_sketch_branches_relations`, joined.
/// `control` may be NULL; `nodes` of its limits caps the relations. Set `omega->struct_size` first.
/// `TREE_ERROR_PARAMETER` names the row with a number that is not finite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_omega_of_relations(
    relations: *const tree_sketch_relation,
    n_relations: usize,
    control: *const tree_control,
    omega: *mut tree_sketch_omega,
) -> tree_status {
    call(|| {
        unsafe { foresee(omega, "omega") }?;
        let (limits, nodes) = (unsafe { limits(control) }?, Resource::Nodes);
        let rows = unsafe { slice(relations, n_relations, &limits, nodes, "relations") }?;
        let rows = rows.iter().enumerate().map(|(i, row)| row.rust(i));
        let found = Omega::of_relations(&rows.collect::<Result<Vec<_>>>()?);
        unsafe { write(omega, "omega", &tree_sketch_omega::of(&found)) }
    })
}

/// The same parameters for the whole tree, as in the thesis: those of the orders of `omega`, averaged. `omega` may
/// be NULL for the default. Set `whole->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_omega_without_orders(
    omega: *const tree_sketch_omega,
    whole: *mut tree_sketch_omega,
) -> tree_status {
    call(|| {
        let found = unsafe { self::omega(omega) }?.without_orders();
        unsafe { write(whole, "whole", &tree_sketch_omega::of(&found)) }
    })
}

/// How a segment lies to its parent.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, bytemuck::AnyBitPattern)]
pub struct tree_sketch_relation {
    /// The segment.
    pub segment: u32,
    /// Its label.
    pub label: tree_sketch_label,
    /// Gravelius order of its parent's axis: the order whose habit it follows.
    pub order: u32,
    /// 1 where `roll` counts: not for apical segments, nor for the first lateral of an axis.
    pub has_roll: u32,
    /// Natural logarithm of its length over its parent's.
    pub scale: f64,
    /// Angle to its parent in radians: α of an apical segment, β of a lateral.
    pub divergence: f64,
    /// For a lateral, the turn about the axis from the last lateral's side, less what its place in the fork's whorl
    /// gives, -π to π. 0 where there is none.
    pub roll: f64,
}

impl tree_sketch_relation {
    fn of(relation: &Relation) -> Self {
        Self {
            segment: relation.segment,
            label: label_number(relation.label),
            order: relation.order,
            has_roll: relation.roll.is_some().into(),
            scale: relation.scale,
            divergence: relation.divergence,
            roll: relation.roll.unwrap_or(0.0),
        }
    }

    fn rust(&self, row: usize) -> Result<Relation> {
        let roll = (self.has_roll != 0).then_some(self.roll);
        let fields =
            [("scale", self.scale), ("divergence", self.divergence), ("roll", roll.unwrap_or(0.0))];
        if let Some((field, found)) = fields.into_iter().find(|(_, found)| !found.is_finite()) {
            let text = format!("relations[{row}].{field} is {found}, it must be finite");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        Ok(Relation {
            segment: self.segment,
            label: label(self.label, &format!("relations[{row}].label"))?,
            order: self.order,
            scale: self.scale,
            divergence: self.divergence,
            roll,
        })
    }
}

/// How each segment lies to its parent, in the order of segments; none for segments without length and those of an
/// imagined root. Their number goes into `n_relations`, they themselves into `relations`, which has room for
/// `capacity` rows; with NULL they are only counted. There are fewer than segments.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_branches_relations(
    branches: *const tree_sketch_branches,
    relations: *mut tree_sketch_relation,
    capacity: usize,
    n_relations: *mut usize,
) -> tree_status {
    call(|| {
        let found = unsafe { get(branches, "branches") }?.rust().branches.relations();
        unsafe { out_value(n_relations, found.len(), "n_relations") }?;
        if relations.is_null() {
            return Ok(());
        }
        let rows: Vec<_> = found.iter().map(tree_sketch_relation::of).collect();
        unsafe { fill(relations, capacity, &rows, "relations") }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn omega_comes_back_from_c_as_it_went() {
        let mut other = Habit::default();
        other.gamma.mean = -1.0;
        let omega = Omega { orders: vec![Habit::default(), other] };
        assert_eq!(tree_sketch_omega::of(&omega).rust().unwrap(), omega);
    }

    #[test]
    fn omega_without_orders_or_with_too_many_is_refused() {
        for n_orders in [0, 9, u32::MAX] {
            let omega = tree_sketch_omega { n_orders, ..tree_sketch_omega::default_value() };
            assert_eq!(omega.rust().unwrap_err().status, TREE_ERROR_PARAMETER);
        }
    }
}
