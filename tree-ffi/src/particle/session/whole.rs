//! From photographs to a tree in one call.

use super::params::{photo_params, tree_photo_params};
use super::report::tree_photo_report;
use super::shot::{shots, tree_photo_shot};
use crate::border::{call, foresee, out, tree_status, view};
use crate::control::{limits, run, tree_control};
use crate::tree::tree_tree;
use tree_model::particle::session::Session;
use tree_model::tree_core::{Control, Seed};

/// Makes a tree of `n_shots` photographs, 1 to 1000: a session (`tree_photo_session`) that is asked for its
/// tree, in one call. `params` may be NULL for the defaults, `control` and `report` may be NULL. Free the tree
/// with `tree_tree_free`. `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` a
/// photograph of no use; `TREE_ERROR_LIMIT` comes before the memory is asked for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_from_photos(
    shots: *const tree_photo_shot,
    n_shots: usize,
    params: *const tree_photo_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_photo_report,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        unsafe { foresee(report, "report") }?;
        let limits = unsafe { limits(control) }?;
        let shots = unsafe { self::shots(shots, n_shots, &limits) }?;
        let params = unsafe { photo_params(params, &limits) }?;
        let body = |control: &Control| {
            // As `PhotoModel` does, which keeps no report.
            let mut session = Session::new(shots, params, Seed(seed))?;
            Ok(session.tree(control)?.clone())
        };
        let made = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_photo_report::of(&made.report)) }?;
        place.put(tree_tree::new(made.tree));
        Ok(())
    })
}
