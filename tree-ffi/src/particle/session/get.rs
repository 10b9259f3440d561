//! What a session has, and its stages.

use super::params::tree_photo_params;
use super::report::{tree_photo_report, tree_photo_view_report};
use super::{check_view, lock, no_view, stage, tree_photo_session, tree_photo_stage};
use crate::border::{
    Failure, Result, TREE_ERROR_NO_RESULT, call, foresee, out, out_value, tree_status,
    view as show, write,
};
use crate::control::{run, tree_control};
use crate::particle::field::tree_direction_field;
use crate::particle::flow::tree_traces;
use crate::particle::grid::{fill_some, tree_grid};
use crate::photo::{
    or_nan, tree_align_warning, tree_attractor, tree_lines, tree_matte, tree_particle_camera,
    tree_photo, tree_strokes,
};
use crate::skeleton::tree_skeleton;
use crate::tree::tree_tree;
use tree_model::particle::session::{PhotoReport, Session, Shot};
use tree_model::tree_core::Control;

/// Number of photographs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_count(
    session: *const tree_photo_session,
    n_shots: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { lock(session) }?.session.shots().len();
        unsafe { out_value(n_shots, n, "n_shots") }
    })
}

/// Number of views: the photographs, and where all are from one side, an imagined one that comes last; see
/// `imagine` of the `tree_photo_params`. Cameras, branches and fields can be asked for of all of them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_count_views(
    session: *mut tree_photo_session,
    control: *const tree_control,
    n_views: *mut usize,
) -> tree_status {
    call(|| {
        let body = |session: &mut Session, control: &Control| Ok(session.views(control)?.len());
        let n = unsafe { ask(session, control, body) }?;
        unsafe { out_value(n_views, n, "n_views") }
    })
}

/// The seed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_seed(
    session: *const tree_photo_session,
    seed: *mut u64,
) -> tree_status {
    call(|| {
        let found = unsafe { lock(session) }?.session.seed().0;
        unsafe { out_value(seed, found, "seed") }
    })
}

/// The parameters, all parts given. What they point at belongs to the session and stays until
/// `tree_photo_session_set_params` or `tree_photo_session_free`. Set `params->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_get_params(
    session: *const tree_photo_session,
    params: *mut tree_photo_params,
) -> tree_status {
    call(|| {
        let held = unsafe { lock(session) }?;
        unsafe { write(params, "params", &held.params.0) }
    })
}

/// How often a stage has been done so far.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_runs(
    session: *const tree_photo_session,
    stage: tree_photo_stage,
    n_runs: *mut u32,
) -> tree_status {
    call(|| {
        let held = unsafe { lock(session) }?;
        unsafe { out_value(n_runs, held.session.runs(self::stage(stage)?), "n_runs") }
    })
}

/// A view's matte as it is now, painted or not. Free it with `tree_matte_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_matte(
    session: *const tree_photo_session,
    view: usize,
    matte: *mut *mut tree_matte,
) -> tree_status {
    call(|| {
        let place = unsafe { out(matte, "matte") }?;
        place.put(tree_matte::new(unsafe { shot(session, view) }?.matte));
        Ok(())
    })
}

/// A view's photograph. Free it with `tree_photo_free`. `TREE_ERROR_NO_RESULT` for a view without one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_photo(
    session: *const tree_photo_session,
    view: usize,
    photo: *mut *mut tree_photo,
) -> tree_status {
    call(|| {
        let place = unsafe { out(photo, "photo") }?;
        let Some(photo) = unsafe { shot(session, view) }?.photo else {
            let text = format!("view {view} has a matte only, no photograph");
            return Err(Failure::new(TREE_ERROR_NO_RESULT, text));
        };
        place.put(tree_photo::new(photo));
        Ok(())
    })
}

unsafe fn shot(session: *const tree_photo_session, view: usize) -> Result<Shot> {
    let held = unsafe { lock(session) }?;
    check_view(&held.session, view)?;
    Ok(held.session.shots()[view].clone())
}

/// Does a stage, as `control` says.
unsafe fn ask<R: Send>(
    session: *const tree_photo_session,
    control: *const tree_control,
    stage: impl FnOnce(&mut Session, &Control) -> Result<R> + Send,
) -> Result<R> {
    let mut held = unsafe { lock(session) }?;
    let session = &mut held.session;
    unsafe { run(control, move |control| stage(session, control)) }
}

/// A view's part of what a stage makes.
fn of_view<T>(all: &[T], view: usize) -> Result<&T> {
    all.get(view).ok_or_else(|| no_view(view, all.len()))
}

/// A view's camera, found in its matte or as it was given. Set `camera->struct_size` first.
/// `TREE_ERROR_NO_RESULT` names a photograph in which no tree is found.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_camera(
    session: *mut tree_photo_session,
    view: usize,
    control: *const tree_control,
    camera: *mut tree_particle_camera,
) -> tree_status {
    call(|| {
        let body = |session: &mut Session, control: &Control| {
            Ok(tree_particle_camera::of(&of_view(session.views(control)?, view)?.camera))
        };
        unsafe { foresee(camera, "camera") }?;
        let found = unsafe { ask(session, control, body) }?;
        unsafe { write(camera, "camera", &found) }
    })
}

/// A view's main branches; an empty graph where there are none. Free it with `tree_attractor_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_attractor(
    session: *mut tree_photo_session,
    view: usize,
    control: *const tree_control,
    attractor: *mut *mut tree_attractor,
) -> tree_status {
    call(|| {
        let place = unsafe { out(attractor, "attractor") }?;
        let body = |session: &mut Session, control: &Control| {
            Ok(of_view(session.attractors(control)?, view)?.clone())
        };
        place.put(tree_attractor::new(unsafe { ask(session, control, body) }?));
        Ok(())
    })
}

/// A view's main branches as strokes, one for each segment: what `TREE_BRANCHES_STROKES` takes, to draw on
/// where the library left off. Free them with `tree_strokes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_strokes(
    session: *mut tree_photo_session,
    view: usize,
    control: *const tree_control,
    strokes: *mut *mut tree_strokes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(strokes, "strokes") }?;
        let body = |session: &mut Session, control: &Control| {
            check_view(session, view)?;
            Ok(session.strokes(view, control)?)
        };
        place.put(tree_strokes::new(unsafe { ask(session, control, body) }?));
        Ok(())
    })
}

/// The density in space, optical depth per metre. Free it with `tree_grid_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_density(
    session: *mut tree_photo_session,
    control: *const tree_control,
    density: *mut *mut tree_grid,
) -> tree_status {
    call(|| {
        let place = unsafe { out(density, "density") }?;
        let body = |session: &mut Session, control: &Control| Ok(session.density(control)?.clone());
        place.put(tree_grid::new(unsafe { ask(session, control, body) }?));
        Ok(())
    })
}

/// The direction field of a view. Free it with `tree_direction_field_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_field(
    session: *mut tree_photo_session,
    view: usize,
    control: *const tree_control,
    field: *mut *mut tree_direction_field,
) -> tree_status {
    call(|| {
        let place = unsafe { out(field, "field") }?;
        let body = |session: &mut Session, control: &Control| {
            Ok(of_view(session.fields(control)?, view)?.clone())
        };
        place.put(tree_direction_field::new(unsafe { ask(session, control, body) }?));
        Ok(())
    })
}

/// The particles' traces. Free them with `tree_traces_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_traces(
    session: *mut tree_photo_session,
    control: *const tree_control,
    traces: *mut *mut tree_traces,
) -> tree_status {
    call(|| {
        let place = unsafe { out(traces, "traces") }?;
        let body = |session: &mut Session, control: &Control| Ok(session.traces(control)?.clone());
        place.put(tree_traces::new(unsafe { ask(session, control, body) }?));
        Ok(())
    })
}

/// Branches without twigs. Free the skeleton with `tree_skeleton_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_wood(
    session: *mut tree_photo_session,
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

/// The tree. The same photographs, parameters and seed give the same bits for any number of threads and in
/// whatever order the session was changed. `control` and `report` may be NULL. Free the tree with
/// `tree_tree_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_tree(
    session: *mut tree_photo_session,
    control: *const tree_control,
    report: *mut tree_photo_report,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        unsafe { foresee(report, "report") }?;
        let body = |session: &mut Session, control: &Control| {
            let made = session.tree(control)?;
            Ok((made.tree.clone(), tree_photo_report::of(&made.report)))
        };
        let (tree, told) = unsafe { ask(session, control, body) }?;
        unsafe { show(report, "report", &told) }?;
        place.put(tree_tree::new(tree));
        Ok(())
    })
}

/// What a session says of its tree, which is made first where it is not there.
unsafe fn report_of(
    session: *const tree_photo_session,
    control: *const tree_control,
) -> Result<PhotoReport> {
    let body = |session: &mut Session, control: &Control| Ok(session.tree(control)?.report.clone());
    unsafe { ask(session, control, body) }
}

/// What one view gave, an imagined one too. The tree is made first where it is not there. Set
/// `report->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_view_report(
    session: *mut tree_photo_session,
    view: usize,
    control: *const tree_control,
    report: *mut tree_photo_view_report,
) -> tree_status {
    call(|| {
        unsafe { foresee(report, "report") }?;
        let body = |session: &mut Session, control: &Control| {
            of_view(session.views(control)?, view)?;
            Ok(tree_photo_view_report::of(&session.tree(control)?.report, view))
        };
        let found = unsafe { ask(session, control, body) }?;
        unsafe { write(report, "report", &found) }
    })
}

/// For each of a view's strokes the gap in pixels that was closed to join it; NaN where it was left out. The
/// tree is made first where it is not there. `gaps` has room for `capacity` floats, one for each stroke.
/// Nothing is written for a view without strokes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_gaps(
    session: *mut tree_photo_session,
    view: usize,
    control: *const tree_control,
    gaps: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        check_view(&unsafe { lock(session) }?.session, view)?;
        let found = unsafe { report_of(session, control) }?;
        let strokes = found.views.get(view).and_then(|view| view.strokes.as_ref());
        let found = strokes.map_or(Vec::new(), |strokes| or_nan(&strokes.gaps));
        unsafe { fill_some(gaps, capacity, &found, "gaps") }
    })
}

/// Where the views do not agree with each other: `TREE_ALIGN_CROWN_BASE` and `TREE_ALIGN_CROWN_WIDTH`. Their
/// number goes into `n_warnings`, they themselves into `warnings`, which has room for `capacity` rows; with
/// NULL they are only counted. The tree is made first where it is not there.
/// `tree_align_warnings_text` puts them into words.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_disagreements(
    session: *mut tree_photo_session,
    control: *const tree_control,
    warnings: *mut tree_align_warning,
    capacity: usize,
    n_warnings: *mut usize,
) -> tree_status {
    call(|| {
        let found = unsafe { report_of(session, control) }?.disagreements;
        let rows: Vec<_> = found.iter().map(tree_align_warning::of).collect();
        unsafe { out_value(n_warnings, rows.len(), "n_warnings") }?;
        if warnings.is_null() {
            return Ok(());
        }
        unsafe { fill_some(warnings, capacity, &rows, "warnings") }
    })
}

/// Everything doubtful, a line each, for a person to read; none where all went well. The tree is made first
/// where it is not there. Free the lines with `tree_lines_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_warnings(
    session: *mut tree_photo_session,
    control: *const tree_control,
    warnings: *mut *mut tree_lines,
) -> tree_status {
    call(|| {
        let place = unsafe { out(warnings, "warnings") }?;
        let found = unsafe { report_of(session, control) }?;
        place.put(tree_lines::new(found.warnings()));
        Ok(())
    })
}
