//! What a session has, and the tree.

use super::{lock, tree_silhouette_session};
use crate::border::{
    Failure, TREE_ERROR_NO_RESULT, call, foresee, out, out_value, tree_status, view, write,
};
use crate::control::{run, tree_control};
use crate::photo::tree_lines;
use crate::silhouette::grow::tree_silhouette_grown;
use crate::silhouette::params::tree_silhouette_params;
use crate::silhouette::plan::tree_outline_plan;
use crate::tree::tree_tree;
use tree_model::tree_core::Control;

/// The seed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_seed(
    silhouette: *const tree_silhouette_session,
    seed: *mut u64,
) -> tree_status {
    call(|| {
        let found = unsafe { lock(silhouette) }?.seed;
        unsafe { out_value(seed, found, "seed") }
    })
}

/// The parameters, all parts given; a trunk drawn as an area tells its radius there. What they point at belongs to the
/// session and stays until `tree_silhouette_session_set_params`, `tree_silhouette_session_undo`, `tree_silhouette_session_redo` or
/// `tree_silhouette_session_free`. Set `params->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_get_params(
    silhouette: *const tree_silhouette_session,
    params: *mut tree_silhouette_params,
) -> tree_status {
    call(|| {
        let held = unsafe { lock(silhouette) }?;
        unsafe { write(params, "params", &held.params.0) }
    })
}

/// Numbers of edits that can be undone, and done again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_depth(
    silhouette: *const tree_silhouette_session,
    n_undo: *mut usize,
    n_redo: *mut usize,
) -> tree_status {
    call(|| {
        let (undo, redo) = unsafe { lock(silhouette) }?.session.depth();
        unsafe { out_value(n_undo, undo, "n_undo") }?;
        unsafe { out_value(n_redo, redo, "n_redo") }
    })
}

/// How well the outlines of branches cover the crown: shares of its area, 0 to 1, in those of branches from bumps, and in
/// those of all. 0 before a crown was drawn.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_coverage(
    silhouette: *const tree_silhouette_session,
    by_bumps: *mut f32,
    by_all: *mut f32,
) -> tree_status {
    call(|| {
        let found = unsafe { lock(silhouette) }?.session.coverage();
        unsafe { out_value(by_bumps, found.by_bumps, "by_bumps") }?;
        unsafe { out_value(by_all, found.by_all, "by_all") }
    })
}

/// What was repaired in the drawing it began with, a line each, for a person to read. Free the lines with
/// `tree_lines_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_repairs(
    silhouette: *const tree_silhouette_session,
    lines: *mut *mut tree_lines,
) -> tree_status {
    call(|| {
        let place = unsafe { out(lines, "lines") }?;
        place.put(tree_lines::new(unsafe { lock(silhouette) }?.played.repairs.clone()));
        Ok(())
    })
}

/// Which strokes of the drawing it began with could not be used, and why, a line each. Free the lines with
/// `tree_lines_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_refused(
    silhouette: *const tree_silhouette_session,
    lines: *mut *mut tree_lines,
) -> tree_status {
    call(|| {
        let place = unsafe { out(lines, "lines") }?;
        place.put(tree_lines::new(unsafe { lock(silhouette) }?.played.refused.clone()));
        Ok(())
    })
}

/// The plan as it is now: a copy, which later edits do not change. Free it with `tree_outline_plan_free`.
/// `TREE_ERROR_NO_RESULT` before a crown was drawn.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_plan(
    silhouette: *const tree_silhouette_session,
    plan: *mut *mut tree_outline_plan,
) -> tree_status {
    call(|| {
        let place = unsafe { out(plan, "plan") }?;
        let held = unsafe { lock(silhouette) }?;
        let Some(found) = held.session.plan() else {
            let text = "there is no plan yet: draw the crown's outline first";
            return Err(Failure::new(TREE_ERROR_NO_RESULT, text));
        };
        place.put(tree_outline_plan::new(found.clone()));
        Ok(())
    })
}

/// The tree in space. The same strokes, parameters and seed give the same bits for any number of threads. `control` and
/// `report` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_INVALID` before a crown was drawn;
/// `TREE_ERROR_LIMIT` comes before the memory is asked for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_tree(
    silhouette: *const tree_silhouette_session,
    control: *const tree_control,
    report: *mut tree_silhouette_grown,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        unsafe { foresee(report, "report") }?;
        let held = unsafe { lock(silhouette) }?;
        let session = &held.session;
        let body = |control: &Control| Ok(session.tree(control)?);
        let grown = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_silhouette_grown::of(&grown.report)) }?;
        place.put(tree_tree::new(grown.tree));
        Ok(())
    })
}
