//! How far apart two trees are, and which node goes to which.

use super::costs::{Given, tree_edit_costs};
use super::params::tree_edit_params;
use super::tree::tree_edit_tree;
use crate::border::{
    Failure, Handle, Result, Versioned, call, foresee, free, get, out, out_value, read_or_default,
    tree_status, view,
};
use crate::control::{run, tree_control};
use crate::mesh::column;
use crate::skeleton::tree_skeleton;
use tree_core::distance::{self, EditDistance};
use tree_model::tree_core::Control;

/// How far apart two trees are.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_edit_distance {
    /// `sizeof(tree_edit_distance)`.
    pub struct_size: usize,
    /// The least cost, in the unit of the weights or of your own costs.
    pub value: f64,
    /// 2 d / (a + b + d) for the weights a and b of the trees and the cost d, 0 to 1: 0 for equal trees, 1 where nothing
    /// of one is left in the other. A metric, too.
    pub normalized: f64,
    /// What deleting the first tree and what inserting the second costs.
    pub weights: [f64; 2],
    /// Nodes compared, after the reduction.
    pub n_nodes: [u64; 2],
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_edit_distance {
    const NAME: &'static str = "tree_edit_distance";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&EditDistance::default())
    }
}

impl tree_edit_distance {
    fn of(found: &EditDistance) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            value: found.value,
            normalized: found.normalized,
            weights: found.weights,
            n_nodes: found.n_nodes.map(|n| n as u64),
        }
    }
}

/// Two nodes that are changed into one another.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_edit_pair {
    /// A node of the first tree.
    pub first: u32,
    /// A node of the second tree.
    pub second: u32,
}

/// Pairs of nodes that are changed into one another: all others are deleted or inserted.
pub struct tree_edit_pairs(Vec<tree_edit_pair>);

impl tree_edit_pairs {
    fn new(mapping: &[[u32; 2]]) -> Self {
        let pair = |&[first, second]: &[u32; 2]| tree_edit_pair { first, second };
        Self(mapping.iter().map(pair).collect())
    }
}

impl Handle for tree_edit_pairs {
    const NAME: &'static str = "tree_edit_pairs";
}

/// Views the pairs, rising by the node of the first tree: where they begin and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_edit_pairs_view(
    pairs: *const tree_edit_pairs,
    rows: *mut *const tree_edit_pair,
    n_pairs: *mut usize,
) -> tree_status {
    call(|| {
        let pairs = &unsafe { get(pairs, "pairs") }?.0;
        unsafe { out_value(rows, column(pairs), "rows") }?;
        unsafe { out_value(n_pairs, pairs.len(), "n_pairs") }
    })
}

/// Frees pairs of nodes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_edit_pairs_free(pairs: *mut tree_edit_pairs) -> tree_status {
    call(|| unsafe { free(pairs, "pairs") })
}

/// Compares, and writes how far apart the trees are.
unsafe fn measure(
    control: *const tree_control,
    distance: *mut tree_edit_distance,
    work: impl FnOnce(&Control) -> Result<EditDistance> + Send,
) -> Result<EditDistance> {
    unsafe { foresee(distance, "distance") }?;
    let found = unsafe { run(control, work) }?;
    unsafe { view(distance, "distance", &tree_edit_distance::of(&found)) }?;
    Ok(found)
}

unsafe fn of_skeletons(
    [first, second]: [*const tree_skeleton; 2],
    params: *const tree_edit_params,
    mapping: bool,
    control: *const tree_control,
    distance: *mut tree_edit_distance,
) -> Result<EditDistance> {
    let first = unsafe { get(first, "first") }?.rust();
    let second = unsafe { get(second, "second") }?.rust();
    let params = unsafe { read_or_default(params, "params") }?.rust(mapping)?;
    let work = |control: &Control| Ok(distance::distance(first, second, &params, control)?);
    unsafe { measure(control, distance, work) }
}

unsafe fn of_trees(
    [first, second]: [*const tree_edit_tree; 2],
    costs: *const tree_edit_costs,
    mapping: bool,
    control: *const tree_control,
    distance: *mut tree_edit_distance,
) -> Result<EditDistance> {
    let first = unsafe { get(first, "first") }?.rust();
    let second = unsafe { get(second, "second") }?.rust();
    let given = unsafe { Given::read(costs) }?;
    let work = |control: &Control| {
        let Some(given) = given else {
            return Ok(distance::distance_of(first, second, mapping, control)?);
        };
        let costs = given.costs();
        let found = distance::distance_with(first, second, &costs, mapping, control)?;
        costs.check()?;
        Ok(found)
    };
    unsafe { measure(control, distance, work) }
}

/// The constrained edit distance between two skeletons (Zhang 1996): the least cost of deleting, inserting and changing
/// nodes that turns one tree into the other, where disjoint subtrees go to disjoint subtrees. The order of siblings and
/// where nodes are do not matter. `params` and `control` may be NULL; set `distance->struct_size` first.
///
/// The time goes with the product of the numbers of nodes and of children after the reduction. `TREE_ERROR_LIMIT` where
/// more pairs of nodes would be kept than `tree_limits.pairs`, 16 bytes each: here those of the nodes of the first tree
/// that wait for a sibling.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_distance(
    first: *const tree_skeleton,
    second: *const tree_skeleton,
    params: *const tree_edit_params,
    control: *const tree_control,
    distance: *mut tree_edit_distance,
) -> tree_status {
    call(|| {
        non_null(distance)?;
        unsafe { of_skeletons([first, second], params, false, control, distance) }.map(drop)
    })
}

/// As `tree_skeleton_distance`, and hands out which node of the skeletons is changed into which; of runs and axes their
/// uppermost nodes. All pairs of nodes are kept for it. `distance` may be NULL. Free the pairs with
/// `tree_edit_pairs_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_distance_pairs(
    first: *const tree_skeleton,
    second: *const tree_skeleton,
    params: *const tree_edit_params,
    control: *const tree_control,
    distance: *mut tree_edit_distance,
    pairs: *mut *mut tree_edit_pairs,
) -> tree_status {
    call(|| {
        let place = unsafe { out(pairs, "pairs") }?;
        let found = unsafe { of_skeletons([first, second], params, true, control, distance) }?;
        place.put(tree_edit_pairs::new(&found.mapping));
        Ok(())
    })
}

/// As `tree_skeleton_distance`, of trees prepared for it: for many comparisons with the same tree, for trees that are no
/// skeletons, and for costs of your own. `costs` and `control` may be NULL. `TREE_ERROR_PARAMETER` where `costs` gives
/// what is no cost.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_edit_tree_distance(
    first: *const tree_edit_tree,
    second: *const tree_edit_tree,
    costs: *const tree_edit_costs,
    control: *const tree_control,
    distance: *mut tree_edit_distance,
) -> tree_status {
    call(|| {
        non_null(distance)?;
        unsafe { of_trees([first, second], costs, false, control, distance) }.map(drop)
    })
}

/// As `tree_edit_tree_distance`, and hands out which node of the two trees is changed into which, as
/// `tree_skeleton_distance_pairs` does.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_edit_tree_distance_pairs(
    first: *const tree_edit_tree,
    second: *const tree_edit_tree,
    costs: *const tree_edit_costs,
    control: *const tree_control,
    distance: *mut tree_edit_distance,
    pairs: *mut *mut tree_edit_pairs,
) -> tree_status {
    call(|| {
        let place = unsafe { out(pairs, "pairs") }?;
        let found = unsafe { of_trees([first, second], costs, true, control, distance) }?;
        place.put(tree_edit_pairs::new(&found.mapping));
        Ok(())
    })
}

/// The distance is all there is to find.
fn non_null(distance: *const tree_edit_distance) -> Result<()> {
    if distance.is_null() { Err(Failure::null("distance")) } else { Ok(()) }
}
