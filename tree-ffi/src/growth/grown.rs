//! A grown tree and how it came about.

use crate::border::{Handle, Versioned, call, free, get, out, tree_status, write};
use crate::mesh::column;
use crate::tree::tree_tree;
use std::sync::Arc;
use tree_model::growth::{Grown, YearReport};
use tree_model::tree_core::Tree;

/// A grown tree, the ages of its nodes, and what happened in each iteration.
pub struct tree_grown {
    tree: Arc<Tree>,
    ages: Vec<u32>,
    orders: Vec<u8>,
    years: Vec<tree_growth_year>,
}

impl Handle for tree_grown {
    const NAME: &'static str = "tree_grown";
}

impl tree_grown {
    pub(super) fn new(grown: Grown) -> Self {
        Self {
            tree: Arc::new(grown.tree),
            ages: grown.ages,
            orders: grown.orders,
            years: grown.report.years.iter().map(tree_growth_year::of).collect(),
        }
    }
}

/// One iteration of one tree.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_growth_year {
    /// Light that all buds found together.
    pub light: f32,
    /// Living buds before it grew.
    pub n_buds: u32,
    /// Buds that grew.
    pub n_shoots: u32,
    /// Shoots cut short by an obstacle or the ground.
    pub n_blocked: u32,
    /// Nodes shed.
    pub n_shed: u32,
    /// Nodes afterwards.
    pub n_nodes: u32,
}

impl tree_growth_year {
    fn of(year: &YearReport) -> Self {
        let YearReport { light, n_buds, n_shoots, n_blocked, n_shed, n_nodes } = *year;
        Self { light, n_buds, n_shoots, n_blocked, n_shed, n_nodes }
    }
}

/// A view of how a tree grew.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_grown_columns {
    /// `sizeof(tree_grown_columns)`.
    pub struct_size: usize,
    /// Number of nodes of the tree's skeleton.
    pub n_nodes: usize,
    /// One for each node: iterations since its segment grew, 0 for this year's. That of the base is its first
    /// internode's.
    pub ages: *const u32,
    /// One for each node: the Gravelius order of the axis it grew on, 0 for the trunk.
    pub orders: *const u8,
    /// Number of iterations.
    pub n_years: usize,
    /// What happened in each iteration.
    pub years: *const tree_growth_year,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_grown_columns {
    const NAME: &'static str = "tree_grown_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_nodes: 0,
            ages: std::ptr::null(),
            orders: std::ptr::null(),
            n_years: 0,
            years: std::ptr::null(),
        }
    }
}

/// The tree, not copied. Free it with `tree_tree_free`; it may outlive what it was asked of.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grown_tree(
    grown: *const tree_grown,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        place.put(tree_tree::shared(unsafe { get(grown, "grown") }?.tree.clone()));
        Ok(())
    })
}

/// Views ages, orders and years. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grown_view(
    grown: *const tree_grown,
    columns: *mut tree_grown_columns,
) -> tree_status {
    call(|| {
        let grown = unsafe { get(grown, "grown") }?;
        let value = tree_grown_columns {
            n_nodes: grown.ages.len(),
            ages: column(&grown.ages),
            orders: column(&grown.orders),
            n_years: grown.years.len(),
            years: column(&grown.years),
            ..tree_grown_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// Frees a grown tree. Trees handed out live on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grown_free(grown: *mut tree_grown) -> tree_status {
    call(|| unsafe { free(grown, "grown") })
}
