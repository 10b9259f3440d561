//! Edits: each is done whole or not at all, says what it changed, and can be undone.
//!
//! All take a place for a `tree_silhouette_change`, which may be NULL where it is not wanted.

use super::change::tree_silhouette_change;
use super::{lock, tree_silhouette_session};
use crate::border::{
    Failure, Result, TREE_ERROR_NO_RESULT, call, out_opt, slice, tree_status, vec2s,
};
use crate::control::{limits, run, tree_control};
use crate::silhouette::params::{keep, silhouette_params, tree_silhouette_params};
use glam::Vec2;
use tree_model::ModelError;
use tree_model::silhouette::session::{Change, Session, Transfer, Viewpoint};
use tree_model::tree_core::{Control, Limits, Resource, Seed};

/// Who takes the shape and angle of a branch that is drawn over: one of the `TREE_TRANSFER_` constants.
pub type tree_transfer = u32;
/// All siblings that were not drawn themselves.
pub const TREE_TRANSFER_SIBLINGS: u32 = 0;
/// Those of them on the same side of the axis.
pub const TREE_TRANSFER_SIDE: u32 = 1;
/// The siblings that are listed, drawn or not.
pub const TREE_TRANSFER_ONLY: u32 = 2;
/// None.
pub const TREE_TRANSFER_NOBODY: u32 = 3;

type ModelResult<T> = std::result::Result<T, ModelError>;

/// Ids of branches. There are fewer branches than nodes are allowed.
unsafe fn ids<'a>(first: *const u32, n: usize, argument: &str) -> Result<&'a [u32]> {
    unsafe { slice(first, n, &Limits::default(), Resource::Nodes, argument) }
}

/// Who takes the shape of a branch.
unsafe fn takers(found: tree_transfer, only: *const u32, n_only: usize) -> Result<Transfer> {
    match found {
        TREE_TRANSFER_SIBLINGS => Ok(Transfer::Siblings),
        TREE_TRANSFER_SIDE => Ok(Transfer::Side),
        TREE_TRANSFER_ONLY => Ok(Transfer::Only(unsafe { ids(only, n_only, "only") }?.to_vec())),
        TREE_TRANSFER_NOBODY => Ok(Transfer::Nobody),
        other => Err(Failure::not_one_of("transfer", other, "TREE_TRANSFER_")),
    }
}

/// Does an edit.
unsafe fn edit(
    silhouette: *mut tree_silhouette_session,
    change: *mut *mut tree_silhouette_change,
    work: impl FnOnce(&mut Session) -> Result<Change>,
) -> Result<()> {
    let place = unsafe { out_opt(change, "change") }?;
    let changed = work(&mut unsafe { lock(silhouette) }?.session)?;
    if let Some(place) = place {
        place.put(tree_silhouette_change::new(changed));
    }
    Ok(())
}

/// A stroke: two floats for each point.
#[derive(Clone, Copy)]
struct Stroke {
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
}

/// Does an edit with a stroke.
unsafe fn draw(
    silhouette: *mut tree_silhouette_session,
    stroke: Stroke,
    change: *mut *mut tree_silhouette_change,
    work: impl FnOnce(&mut Session, &[Vec2]) -> ModelResult<Change> + Send,
) -> Result<()> {
    let body = |session: &mut Session| {
        let limits = unsafe { limits(stroke.control) }?;
        let points =
            unsafe { vec2s(stroke.points, stroke.n_points, &limits, Resource::Nodes, "stroke") }?;
        let body = |control: &Control| {
            control.check()?;
            Ok(work(session, points)?)
        };
        unsafe { run(stroke.control, body) }
    };
    unsafe { edit(silhouette, change, body) }
}

/// Draws the trunk, from the ground up; one drawn downwards is turned. Branches are inferred anew when there is a
/// crown. `stroke` has two floats for each of `n_points` points, in metres, y up. `control` may be NULL; `nodes` of its
/// limits caps the points. `change` may be NULL where it is not wanted; else free what is put there with
/// `tree_silhouette_change_free`. `TREE_ERROR_INVALID` for a line without length or one that stays away from the crown.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_draw_trunk(
    silhouette: *mut tree_silhouette_session,
    stroke: *const f32,
    n_points: usize,
    control: *const tree_control,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    let stroke = Stroke { points: stroke, n_points, control };
    call(|| unsafe { draw(silhouette, stroke, change, Session::draw_trunk) })
}

/// Draws the crown's outline. Branches that were drawn or refined stay where the new crown has a branch near. `stroke`,
/// `control` and `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for what encloses no area, or where
/// the trunk stays away from it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_draw_crown(
    silhouette: *mut tree_silhouette_session,
    stroke: *const f32,
    n_points: usize,
    control: *const tree_control,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    let stroke = Stroke { points: stroke, n_points, control };
    call(|| unsafe { draw(silhouette, stroke, change, Session::draw_crown) })
}

/// Draws the crown as it is seen when the tree is turned by `azimuth` radians, -2π to 2π, from +X towards +Z: another
/// drawing plane. An outline in that plane is replaced. `stroke`, `control` and `change` as in
/// `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for what encloses no area, or before there is a crown.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_draw_section(
    silhouette: *mut tree_silhouette_session,
    azimuth: f32,
    stroke: *const f32,
    n_points: usize,
    control: *const tree_control,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    let stroke = Stroke { points: stroke, n_points, control };
    let work = |session: &mut Session, points: &[Vec2]| session.draw_section(azimuth, points);
    call(|| unsafe { draw(silhouette, stroke, change, work) })
}

/// Draws the outline of the foliage of a branch of a level, 1 (branches on the trunk) to 8. The branch is the one with
/// the greatest length inside; its own branches are inferred, and its style spreads to its siblings. `stroke`, `control`
/// and `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for what encloses no area or no part of a
/// branch of that level.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_refine(
    silhouette: *mut tree_silhouette_session,
    level: u32,
    stroke: *const f32,
    n_points: usize,
    control: *const tree_control,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    let stroke = Stroke { points: stroke, n_points, control };
    let work = |session: &mut Session, points: &[Vec2]| session.refine(level, points);
    call(|| unsafe { draw(silhouette, stroke, change, work) })
}

/// Draws the outline of the foliage of the branch of this id. `stroke`, `control` and `change` as in
/// `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for what encloses no area, and an id that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_refine_branch(
    silhouette: *mut tree_silhouette_session,
    id: u32,
    stroke: *const f32,
    n_points: usize,
    control: *const tree_control,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    let stroke = Stroke { points: stroke, n_points, control };
    let work = |session: &mut Session, points: &[Vec2]| session.refine_branch(id, points);
    call(|| unsafe { draw(silhouette, stroke, change, work) })
}

/// Draws a branch of a level, 1 (branches on the trunk) to 8, over: the one whose ends are nearest to the stroke's.
/// Where none is near, it is a new one. Its angle becomes a sample of the branching angles, and siblings take angle and
/// shape as `transfer` says; `only` lists `n_only` ids for `TREE_TRANSFER_ONLY`, and may be NULL for the others. `stroke`,
/// `control` and `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for a line without length, or where
/// there is no axis of that level.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_redraw(
    silhouette: *mut tree_silhouette_session,
    level: u32,
    stroke: *const f32,
    n_points: usize,
    transfer: tree_transfer,
    only: *const u32,
    n_only: usize,
    control: *const tree_control,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    let stroke = Stroke { points: stroke, n_points, control };
    call(|| {
        // NULL is there even where what comes next is an error.
        unsafe { out_opt(change, "change") }?;
        let takes = unsafe { takers(transfer, only, n_only) }?;
        let work = |session: &mut Session, points: &[Vec2]| session.redraw(level, points, &takes);
        unsafe { draw(silhouette, stroke, change, work) }
    })
}

/// Draws a branch on the trunk as it is seen by a viewer who has gone round the tree by `yaw` radians, -2π to 2π,
/// against the clock seen from above (0 is in front, +X to the right), and looks down by `pitch`, within ±1.4. It lies
/// in the upright plane through the trunk that faces the viewer. A branch drawn from near there before, with ends near
/// the stroke's, is replaced; else it is a new one. The rest as in `tree_silhouette_session_redraw`, which this is from in
/// front.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_redraw_from(
    silhouette: *mut tree_silhouette_session,
    yaw: f32,
    pitch: f32,
    stroke: *const f32,
    n_points: usize,
    transfer: tree_transfer,
    only: *const u32,
    n_only: usize,
    control: *const tree_control,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    let viewpoint = Viewpoint { yaw, pitch };
    let stroke = Stroke { points: stroke, n_points, control };
    call(|| {
        // NULL is there even where what comes next is an error.
        unsafe { out_opt(change, "change") }?;
        let takes = unsafe { takers(transfer, only, n_only) }?;
        let work =
            |session: &mut Session, points: &[Vec2]| session.redraw_from(viewpoint, points, &takes);
        unsafe { draw(silhouette, stroke, change, work) }
    })
}

/// Takes a branch away, with all on it. `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for an id
/// that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_remove(
    silhouette: *mut tree_silhouette_session,
    id: u32,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    call(|| unsafe { edit(silhouette, change, |session| Ok(session.remove(id)?)) })
}

/// Draws the leaf. Its length is as drawn. `stroke`, `control` and `change` as in `tree_silhouette_session_draw_trunk`.
/// `TREE_ERROR_INVALID` for what encloses no area, or before there is a crown.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_draw_leaf(
    silhouette: *mut tree_silhouette_session,
    stroke: *const f32,
    n_points: usize,
    control: *const tree_control,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    let stroke = Stroke { points: stroke, n_points, control };
    call(|| unsafe { draw(silhouette, stroke, change, Session::draw_leaf) })
}

/// Has `n_targets` branches take the style of the branch `source`, whose outline was drawn; 0: of the nearest such branch
/// again. `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_INVALID` for ids that are not there, and a source
/// whose outline was not drawn.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_copy_style(
    silhouette: *mut tree_silhouette_session,
    source: u32,
    targets: *const u32,
    n_targets: usize,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    call(|| {
        let body = |session: &mut Session| {
            let targets = unsafe { ids(targets, n_targets, "targets") }?;
            Ok(session.copy_style((source != 0).then_some(source), targets)?)
        };
        unsafe { edit(silhouette, change, body) }
    })
}

/// Other parameters, NULL for the defaults. Where those of branches or angles differ, branches are inferred anew.
/// `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_PARAMETER` names what is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_set_params(
    silhouette: *mut tree_silhouette_session,
    params: *const tree_silhouette_params,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    call(|| {
        let body =
            |session: &mut Session| Ok(session.set_params(unsafe { silhouette_params(params) }?)?);
        unsafe { edit(silhouette, change, body) }?;
        unsafe { keep_params(silhouette) }
    })
}

/// Another seed: only what is drawn by chance differs. This is no edit, and is not undone.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_set_seed(
    silhouette: *mut tree_silhouette_session,
    seed: u64,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(silhouette) }?;
        held.session.set_seed(Seed(seed));
        held.seed = seed;
        Ok(())
    })
}

/// Takes back the last edit, changes of parameters included. `change` as in `tree_silhouette_session_draw_trunk`.
/// `TREE_ERROR_NO_RESULT` where there is none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_undo(
    silhouette: *mut tree_silhouette_session,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    call(|| {
        let body =
            |session: &mut Session| session.undo().ok_or_else(|| nothing("no edit to take back"));
        unsafe { edit(silhouette, change, body) }?;
        unsafe { keep_params(silhouette) }
    })
}

/// Does again what was taken back last. `change` as in `tree_silhouette_session_draw_trunk`. `TREE_ERROR_NO_RESULT` where there
/// is nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_redo(
    silhouette: *mut tree_silhouette_session,
    change: *mut *mut tree_silhouette_change,
) -> tree_status {
    call(|| {
        let body =
            |session: &mut Session| session.redo().ok_or_else(|| nothing("no edit to do again"));
        unsafe { edit(silhouette, change, body) }?;
        unsafe { keep_params(silhouette) }
    })
}

fn nothing(text: &str) -> Failure {
    Failure::new(TREE_ERROR_NO_RESULT, text)
}

/// Puts the session's parameters in C's form anew.
unsafe fn keep_params(silhouette: *mut tree_silhouette_session) -> Result<()> {
    let mut held = unsafe { lock(silhouette) }?;
    held.params = keep(held.session.params());
    Ok(())
}
