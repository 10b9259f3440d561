//! From a drawing to a tree in one call.

use super::params::{sketch_params, tree_sketch_params};
use super::report::tree_sketch_report;
use crate::border::{call, foresee, get, get_opt, out, tree_status, view};
use crate::control::{run, tree_control};
use crate::sketch::{tree_drawing, tree_templates};
use crate::tree::tree_tree;
use crate::volume::tree_volume;
use tree_model::sketch::session::Session;
use tree_model::tree_core::{Control, Seed};

/// Makes a tree of a drawing: a session (`tree_sketch_session`) that is asked for its tree, in one call. Of
/// `templates`, which may be NULL for those built in, the one that suits best guides it, or the one that `params`
/// names; new branches keep out of `obstacles`, which may be NULL. `params`, `control` and `report` may be NULL too.
/// The tree's species is called by the template's name, unless `params` has a species. Free the tree with
/// `tree_tree_free`.
///
/// `TREE_ERROR_PARAMETER` names what is out of range, `TREE_ERROR_UNKNOWN_NAME` a template or species that there is
/// not; `TREE_ERROR_INVALID` says why a drawing, and which stroke of it, is of no use; `TREE_ERROR_LIMIT` comes before
/// the memory is asked for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_from_sketch(
    drawing: *const tree_drawing,
    templates: *const tree_templates,
    obstacles: *const tree_volume,
    params: *const tree_sketch_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_sketch_report,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        unsafe { foresee(report, "report") }?;
        let drawing = unsafe { get(drawing, "drawing") }?.rust().clone();
        let templates = unsafe { get_opt(templates, "templates") }?;
        let obstacles = unsafe { get_opt(obstacles, "obstacles") }?;
        let mut session = Session::new(drawing, unsafe { sketch_params(params) }?, Seed(seed))?;
        if let Some(templates) = templates {
            session.set_templates(templates.rust().to_vec());
        }
        session.set_obstacles(obstacles.map(|obstacles| obstacles.rust().clone()));
        let body = move |control: &Control| Ok(session.tree(control)?.clone());
        let made = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_sketch_report::of(&made.report)) }?;
        place.put(tree_tree::new(made.tree));
        Ok(())
    })
}
