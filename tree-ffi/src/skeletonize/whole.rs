//! From a mesh to a tree in one call.

use super::params::tree_skeletonize_params;
use super::part::{parts_of_mesh, read_parts, tree_hint, tree_mesh_part};
use super::report::tree_skeletonize_report;
use crate::border::{Result, call, foresee, out, read_or_default, tree_status, view};
use crate::control::{limits, run, tree_control};
use crate::mesh::tree_mesh;
use crate::tree::tree_tree;
use tree_model::skeletonize::{Part, skeletonize};
use tree_model::tree_core::Tree;

unsafe fn make(
    parts: &[Part<'_>],
    params: *const tree_skeletonize_params,
    control: *const tree_control,
    report: *mut tree_skeletonize_report,
) -> Result<Tree> {
    unsafe { foresee(report, "report") }?;
    let params = unsafe { read_or_default(params, "params") }?.rust();
    let made = unsafe { run(control, |control| Ok(skeletonize(parts, &params, control)?)) }?;
    unsafe { view(report, "report", &tree_skeletonize_report::of(&made.report)) }?;
    Ok(made.tree)
}

/// Makes a tree of a mesh, in the mesh's unit: closed surfaces, tubes stuck into each other, thousands of
/// separate prisms; cards or blobs for leaves. `parts` is `n_parts` structs, which are not kept. Its bark is
/// named after the part with most wood, leaf kinds after the parts their leaves come from; no look is built
/// in by such names, so give `tree_mesh_build` one of `tree_look_of_tree(tree, 1, &look)`, or of
/// `tree_look_new` with the mesh's own textures. `params`,
/// `control` and `report` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_NO_RESULT` where
/// nothing looks like wood; `TREE_ERROR_INVALID` for parts whose columns do not fit together.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeletonize(
    parts: *const tree_mesh_part,
    n_parts: usize,
    params: *const tree_skeletonize_params,
    control: *const tree_control,
    report: *mut tree_skeletonize_report,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        let parts = unsafe { read_parts(parts, n_parts, &limits(control)?) }?;
        place.put(tree_tree::new(unsafe { make(&parts, params, control, report) }?));
        Ok(())
    })
}

/// As `tree_skeletonize`, of a mesh: each surface is a part, named after its material. `hints` is NULL, or
/// has one for each surface.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeletonize_mesh(
    mesh: *const tree_mesh,
    hints: *const tree_hint,
    n_hints: usize,
    params: *const tree_skeletonize_params,
    control: *const tree_control,
    report: *mut tree_skeletonize_report,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        let parts = unsafe { parts_of_mesh(mesh, hints, n_hints, &limits(control)?) }?;
        place.put(tree_tree::new(unsafe { make(&parts, params, control, report) }?));
        Ok(())
    })
}
