//! Changes to a session. Each forgets what depends on it and keeps the rest.

use super::params::{photo_params, tree_photo_params};
use super::shot::{branches, placing, tree_photo_branches, tree_photo_placing};
use super::{check_view, keep, lock, stage, tree_photo_session, tree_photo_stage};
use crate::border::{call, get, tree_status};
use crate::control::{limits, run, tree_control};
use crate::particle::density::{brushes, strokes, tree_density_brush, tree_density_stroke};
use crate::particle::grid::tree_grid;
use crate::photo::{tree_attractor, tree_matte};
use tree_model::particle::session::Session;
use tree_model::tree_core::{Control, Seed};

/// Another seed: other particles, twigs and leaves in the same density.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_set_seed(
    session: *mut tree_photo_session,
    seed: u64,
) -> tree_status {
    call(|| {
        unsafe { lock(session) }?.session.set_seed(Seed(seed));
        Ok(())
    })
}

/// Other parameters, NULL for the defaults; only stages whose parameters differ are done again. Painted
/// density is lost when the density's parameters change. `control` may be NULL; only its limits matter.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_set_params(
    session: *mut tree_photo_session,
    params: *const tree_photo_params,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        let params = unsafe { photo_params(params, &limits(control)?) }?;
        held.session.set_params(params)?;
        held.params = keep(&held.session);
        Ok(())
    })
}

/// Moves a view's camera; NULL aligns it anew, from the front.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_set_placing(
    session: *mut tree_photo_session,
    view: usize,
    placing: *const tree_photo_placing,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        check_view(&held.session, view)?;
        let placing = unsafe { self::placing(placing, "placing") }?;
        Ok(held.session.set_placing(view, placing)?)
    })
}

/// Paints and erases density in a view, in pixels. Branches found before stay as they are. `control` may be
/// NULL; `nodes` of its limits caps the points of a stroke. `TREE_ERROR_PARAMETER` names the stroke that is
/// out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_paint(
    session: *mut tree_photo_session,
    view: usize,
    strokes: *const tree_density_stroke,
    n_strokes: usize,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        check_view(&held.session, view)?;
        let strokes = unsafe { self::strokes(strokes, n_strokes, &limits(control)?) }?;
        let session = &mut held.session;
        unsafe { run(control, move |_| Ok(session.paint(view, &strokes)?)) }
    })
}

/// Replaces a view's matte by one of the same size, for instance after another matting. Camera and branches
/// found before stay as they are; `tree_photo_session_redo_from` finds them anew. `TREE_ERROR_NO_RESULT` for
/// another size.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_set_matte(
    session: *mut tree_photo_session,
    view: usize,
    matte: *const tree_matte,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        check_view(&held.session, view)?;
        let matte = unsafe { get(matte, "matte") }?.rust().clone();
        Ok(held.session.set_matte(view, matte)?)
    })
}

/// Paints density in space, after it has been found from the pictures, which is done first where it is not
/// there. `TREE_ERROR_PARAMETER` names the brush that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_paint_volume(
    session: *mut tree_photo_session,
    brushes: *const tree_density_brush,
    n_brushes: usize,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        let brushes = unsafe { self::brushes(brushes, n_brushes, &limits(control)?) }?;
        let session = &mut held.session;
        unsafe { run(control, move |control| Ok(session.paint_volume(&brushes, control)?)) }
    })
}

/// Replaces the density, for instance by that of another source; it is copied.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_set_density(
    session: *mut tree_photo_session,
    density: *const tree_grid,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        let density = unsafe { get(density, "density") }?.rust().clone();
        held.session.set_density(density);
        Ok(())
    })
}

/// Where a view's branches come from; NULL is livewire from points on the silhouette. All views' branches
/// are found anew. `control` may be NULL; only its limits matter.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_set_branches(
    session: *mut tree_photo_session,
    view: usize,
    branches: *const tree_photo_branches,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        check_view(&held.session, view)?;
        let branches = unsafe { self::branches(branches, &limits(control)?, "branches") }?;
        Ok(held.session.set_attractor(view, branches)?)
    })
}

/// Changes a view's branches by hand: ask for them with `tree_photo_session_attractor`, change them with the
/// functions of `tree_attractor`, and hand the new graph over here. Other views' branches are not found anew.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_edit_attractor(
    session: *mut tree_photo_session,
    view: usize,
    attractor: *const tree_attractor,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        check_view(&held.session, view)?;
        let graph = unsafe { get(attractor, "attractor") }?.rust();
        let session: &mut Session = &mut held.session;
        let body = move |control: &Control| {
            Ok(session.edit_attractor(view, control, |_| Ok(graph.clone()))?)
        };
        unsafe { run(control, body) }
    })
}

/// Forgets the result of a stage and of all that depend on it, so that they are done again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_redo_from(
    session: *mut tree_photo_session,
    stage: tree_photo_stage,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        held.session.redo_from(self::stage(stage)?);
        Ok(())
    })
}
