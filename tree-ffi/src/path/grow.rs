//! From parameters to trees.

use super::params::tree_path_params;
use super::report::tree_path_report;
use crate::border::{Result, call, foresee, out, read_or_default, tree_status, view};
use crate::control::{limits, run, tree_control};
use crate::io::tree_bytes;
use crate::tree::tree_tree;
use tree_model::path::PathTree;
use tree_model::tree_core::Seed;

unsafe fn grow(
    params: *const tree_path_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_path_report,
) -> Result<PathTree> {
    unsafe { foresee(report, "report") }?;
    let params = unsafe { read_or_default(params, "params") }?;
    let params = unsafe { params.rust(&limits(control)?, "params") }?;
    let grown = unsafe { run(control, move |control| Ok(params.grow(Seed(seed), control)?)) }?;
    unsafe { view(report, "report", &tree_path_report::of(&grown.report)) }?;
    Ok(grown)
}

/// Grows a tree of least-cost paths. The same parameters and `seed` give the same bits for any number of
/// threads. `params` may be NULL for an oak, `control` and `report` may be NULL. Free the tree with
/// `tree_tree_free`. `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` says why
/// nothing grows, for instance a root outside the volume; `TREE_ERROR_LIMIT` comes before the level that
/// would exceed a limit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_path_grow(
    params: *const tree_path_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_path_report,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        place.put(tree_tree::new(unsafe { grow(params, seed, control, report) }?.tree));
        Ok(())
    })
}

/// As `tree_path_grow`, and hands out the level at which each node of the skeleton was grown: a byte for
/// each node, from 1 for the base volume, 0 for nodes of the root system. Free it with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_path_grow_with_levels(
    params: *const tree_path_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_path_report,
    node_levels: *mut *mut tree_bytes,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        let levels = unsafe { out(node_levels, "node_levels") }?;
        let grown = unsafe { grow(params, seed, control, report) }?;
        levels.put(tree_bytes::new(grown.levels));
        place.put(tree_tree::new(grown.tree));
        Ok(())
    })
}
