//! What a session has, and its stages.

use super::params::tree_sketch_params;
use super::report::tree_sketch_report;
use super::{ask, lock, stage, tree_sketch_session, tree_sketch_stage};
use crate::border::{
    Failure, TREE_ERROR_NO_RESULT, call, fill, foresee, out, out_value, tree_status, view, write,
};
use crate::control::tree_control;
use crate::photo::tree_lines;
use crate::skeleton::tree_skeleton;
use crate::sketch::{
    tree_crown, tree_drawing, tree_inferred, tree_plan, tree_sketch_branches,
    tree_sketch_propagate_report, tree_template_choice, tree_templates,
};
use crate::tree::tree_tree;
use tree_model::sketch::crown::CrownReport;
use tree_model::sketch::session::Session;
use tree_model::tree_core::Control;

/// The drawing as it is after all edits; erased strokes are there without points. Free it with `tree_drawing_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_drawing(
    session: *const tree_sketch_session,
    drawing: *mut *mut tree_drawing,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawing, "drawing") }?;
        place.put(tree_drawing::new(unsafe { lock(session) }?.session.drawing().clone()));
        Ok(())
    })
}

/// The seed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_seed(
    session: *const tree_sketch_session,
    seed: *mut u64,
) -> tree_status {
    call(|| {
        let found = unsafe { lock(session) }?.seed;
        unsafe { out_value(seed, found, "seed") }
    })
}

/// The parameters, all parts given. What they point at belongs to the session and stays until
/// `tree_sketch_session_set_params` or `tree_sketch_session_free`. Set `params->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_get_params(
    session: *const tree_sketch_session,
    params: *mut tree_sketch_params,
) -> tree_status {
    call(|| {
        let held = unsafe { lock(session) }?;
        unsafe { write(params, "params", &held.params.0) }
    })
}

/// How often a stage has been done so far.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_runs(
    session: *const tree_sketch_session,
    stage: tree_sketch_stage,
    n_runs: *mut u32,
) -> tree_status {
    call(|| {
        let held = unsafe { lock(session) }?;
        unsafe { out_value(n_runs, held.session.runs(self::stage(stage)?), "n_runs") }
    })
}

/// The strokes as a tree in the plane, in metres, with what was done to them. Free it with `tree_plan_free`.
/// `TREE_ERROR_INVALID` says which stroke is of no use, or why the drawing is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_plan(
    session: *mut tree_sketch_session,
    control: *const tree_control,
    plan: *mut *mut tree_plan,
) -> tree_status {
    call(|| {
        let place = unsafe { out(plan, "plan") }?;
        let body = |session: &mut Session, control: &Control| Ok(session.cleaned(control)?.clone());
        place.put(tree_plan::new(unsafe { ask(session, control, body) }?));
        Ok(())
    })
}

/// The closed crown. What was repaired of it is among `tree_sketch_session_warnings`. Free it with `tree_crown_free`.
/// `TREE_ERROR_NO_RESULT` where none is drawn.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_crown(
    session: *mut tree_sketch_session,
    control: *const tree_control,
    crown: *mut *mut tree_crown,
) -> tree_status {
    call(|| {
        let place = unsafe { out(crown, "crown") }?;
        let body = |session: &mut Session, control: &Control| Ok(session.crown(control)?.cloned());
        let Some(found) = unsafe { ask(session, control, body) }? else {
            return Err(Failure::new(TREE_ERROR_NO_RESULT, "no crown is drawn"));
        };
        place.put(tree_crown::new(found, CrownReport::default()));
        Ok(())
    })
}

/// The templates compared with the drawing, best first: indices count in the session's templates, or in those built
/// in. Their number goes into `n_choices`, they themselves into `choices`, which has room for `capacity` rows; with
/// NULL they are only counted. There are none where the template was taken by name, or kept through an edit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_choices(
    session: *mut tree_sketch_session,
    control: *const tree_control,
    choices: *mut tree_template_choice,
    capacity: usize,
    n_choices: *mut usize,
) -> tree_status {
    call(|| {
        let body =
            |session: &mut Session, control: &Control| Ok(session.choices(control)?.to_vec());
        let found = unsafe { ask(session, control, body) }?;
        unsafe { out_value(n_choices, found.len(), "n_choices") }?;
        if choices.is_null() {
            return Ok(());
        }
        let rows: Vec<_> = found.iter().map(tree_template_choice::of).collect();
        unsafe { fill(choices, capacity, &rows, "choices") }
    })
}

/// The template taken: templates of one row. Free them with `tree_templates_free`. `TREE_ERROR_UNKNOWN_NAME` lists
/// the names there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_template_taken(
    session: *mut tree_sketch_session,
    control: *const tree_control,
    taken: *mut *mut tree_templates,
) -> tree_status {
    call(|| {
        let place = unsafe { out(taken, "taken") }?;
        let body =
            |session: &mut Session, control: &Control| Ok(session.template(control)?.clone());
        place.put(tree_templates::new(vec![unsafe { ask(session, control, body) }?]));
        Ok(())
    })
}

/// Depths, labels and Ω. Free them with `tree_inferred_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_inferred(
    session: *mut tree_sketch_session,
    control: *const tree_control,
    inferred: *mut *mut tree_inferred,
) -> tree_status {
    call(|| {
        let place = unsafe { out(inferred, "inferred") }?;
        let body =
            |session: &mut Session, control: &Control| Ok(session.inferred(control)?.clone());
        place.put(tree_inferred::new(unsafe { ask(session, control, body) }?));
        Ok(())
    })
}

/// The sketched branches with what grew on them. `report` may be NULL. Free them with `tree_sketch_branches_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_branches(
    session: *mut tree_sketch_session,
    control: *const tree_control,
    report: *mut tree_sketch_propagate_report,
    branches: *mut *mut tree_sketch_branches,
) -> tree_status {
    call(|| {
        let place = unsafe { out(branches, "branches") }?;
        unsafe { foresee(report, "report") }?;
        let body =
            |session: &mut Session, control: &Control| Ok(session.propagated(control)?.clone());
        let found = unsafe { ask(session, control, body) }?;
        let told = tree_sketch_propagate_report::of(&found.report);
        unsafe { view(report, "report", &told) }?;
        place.put(tree_sketch_branches::new(found));
        Ok(())
    })
}

/// The branches as a skeleton with radii. Free it with `tree_skeleton_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_wood(
    session: *mut tree_sketch_session,
    control: *const tree_control,
    wood: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(wood, "wood") }?;
        let body = |session: &mut Session, control: &Control| Ok(session.wood(control)?.clone());
        place.put(tree_skeleton::own(unsafe { ask(session, control, body) }?));
        Ok(())
    })
}

/// The tree. The same drawing, parameters and seed give the same bits for any number of threads. `control` and `report`
/// may be NULL. Free the tree with `tree_tree_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_tree(
    session: *mut tree_sketch_session,
    control: *const tree_control,
    report: *mut tree_sketch_report,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        unsafe { foresee(report, "report") }?;
        let body = |session: &mut Session, control: &Control| {
            let made = session.tree(control)?;
            Ok((made.tree.clone(), tree_sketch_report::of(&made.report)))
        };
        let (tree, told) = unsafe { ask(session, control, body) }?;
        unsafe { view(report, "report", &told) }?;
        place.put(tree_tree::new(tree));
        Ok(())
    })
}

/// All that was repaired or fell short, a line each, for a person to read; none where all went well. The tree is made
/// first where it is not there. Free the lines with `tree_lines_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_warnings(
    session: *mut tree_sketch_session,
    control: *const tree_control,
    warnings: *mut *mut tree_lines,
) -> tree_status {
    call(|| {
        let place = unsafe { out(warnings, "warnings") }?;
        let body =
            |session: &mut Session, control: &Control| Ok(session.tree(control)?.report.warnings());
        place.put(tree_lines::new(unsafe { ask(session, control, body) }?));
        Ok(())
    })
}
