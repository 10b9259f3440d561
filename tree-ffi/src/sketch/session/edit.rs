//! Changes to a session. Each forgets what depends on it and keeps the rest.

use super::params::{sketch_params, tree_sketch_params};
use super::{ask, keep, lock, stage, tree_sketch_session, tree_sketch_stage};
use crate::border::{
    Failure, TREE_ERROR_BUFFER, call, fill, floats, get_opt, out_value, read, tree_status,
};
use crate::control::{limits, tree_control};
use crate::sketch::{tree_sketch_stroke, tree_templates};
use crate::volume::tree_volume;
use glam::Vec2;
use tree_model::sketch::session::Session;
use tree_model::sketch::template::Template;
use tree_model::tree_core::{Control, Seed};

/// Another seed: other depths within Ω, another growth. Depths that edits kept are forgotten.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_set_seed(
    session: *mut tree_sketch_session,
    seed: u64,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        held.session.set_seed(Seed(seed));
        held.seed = seed;
        Ok(())
    })
}

/// Other parameters, NULL for the defaults; only stages whose parameters differ are done again. Where those of
/// inference, the template or the height differ, depths that edits kept are forgotten.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_set_params(
    session: *mut tree_sketch_session,
    params: *const tree_sketch_params,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        held.session.set_params(unsafe { sketch_params(params) }?)?;
        held.params = keep(&held.session);
        Ok(())
    })
}

/// Templates of one's own, which are copied, instead of those built in; NULL for these again. Depths that edits kept
/// are forgotten.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_set_templates(
    session: *mut tree_sketch_session,
    templates: *const tree_templates,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        let templates = match unsafe { get_opt(templates, "templates") }? {
            Some(own) => own.rust(),
            None => Template::builtin()?,
        };
        held.session.set_templates(templates.to_vec());
        Ok(())
    })
}

/// What new branches are to keep out of: a volume in the tree's metres, its base at the origin, or NULL for nothing.
/// Sketched branches stay as they are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_set_obstacles(
    session: *mut tree_sketch_session,
    obstacles: *const tree_volume,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        let obstacles = unsafe { get_opt(obstacles, "obstacles") }?;
        held.session.set_obstacles(obstacles.map(|obstacles| obstacles.rust().clone()));
        Ok(())
    })
}

/// Forgets depths, Ω, scale and the choice of template that edits keep, so that all are found anew.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_infer_anew(
    session: *mut tree_sketch_session,
) -> tree_status {
    call(|| {
        unsafe { lock(session) }?.session.infer_anew();
        Ok(())
    })
}

/// Forgets the results of a stage and of all later ones, so that they are done again; what edits keep stays.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_redo_from(
    session: *mut tree_sketch_session,
    stage: tree_sketch_stage,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        held.session.redo_from(self::stage(stage)?);
        Ok(())
    })
}

/// Draws one more stroke, which is copied; its number in the drawing goes into `number`. Depths of all other branches
/// stay. `control` may be NULL; `nodes` of its limits caps the points. What is wrong with the stroke comes to light
/// with the next stage; erase it then.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_add_stroke(
    session: *mut tree_sketch_session,
    stroke: *const tree_sketch_stroke,
    control: *const tree_control,
    number: *mut usize,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(session) }?;
        let limits = unsafe { limits(control) }?;
        let stroke = unsafe { read(stroke, "stroke")?.rust(&limits, "stroke") }?;
        let next = held.session.drawing().strokes.len();
        unsafe { out_value(number, next, "number") }?;
        held.session.add_stroke(stroke);
        Ok(())
    })
}

/// Erases a stroke, and with a branch all that it bears. Depths of all other branches stay, and so do the numbers of
/// their strokes. Numbers of those that are gone go into `gone`, which has room for `capacity` of them, at least as
/// many as there are strokes (`tree_drawing_count` of `tree_sketch_session_drawing`), and how many they are into
/// `n_gone`. Both may be NULL where they are not wanted. `TREE_ERROR_INVALID` for a stroke that is not there or was
/// erased before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_erase_stroke(
    session: *mut tree_sketch_session,
    stroke: usize,
    control: *const tree_control,
    gone: *mut u32,
    capacity: usize,
    n_gone: *mut usize,
) -> tree_status {
    call(|| {
        let needed = unsafe { lock(session) }?.session.drawing().strokes.len();
        // Before anything is erased: a caller who asks again would find nothing to erase.
        if !gone.is_null() && capacity < needed {
            let text = format!("gone has room for {capacity} values, {needed} may be needed");
            return Err(Failure::new(TREE_ERROR_BUFFER, text));
        }
        let body =
            |session: &mut Session, control: &Control| Ok(session.erase_stroke(stroke, control)?);
        let found = unsafe { ask(session, control, body) }?;
        if !gone.is_null() {
            let found: Vec<_> = found.iter().map(|&stroke| stroke as u32).collect();
            unsafe { fill(gone, capacity, &found, "gone") }?;
        }
        if n_gone.is_null() { Ok(()) } else { unsafe { out_value(n_gone, found.len(), "n_gone") } }
    })
}

/// Moves the tip or fork of a stroke that is nearest to `at`, two floats in the drawing's units, to `depth` in metres,
/// positive towards the viewer. What it bears is inferred anew; the rest stays. The end of the root segment stays in
/// the plane. `TREE_ERROR_INVALID` for a stroke that is not there, was erased, or has no tip or fork to move;
/// `TREE_ERROR_PARAMETER` for numbers that are not finite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_set_depth(
    session: *mut tree_sketch_session,
    stroke: usize,
    at: *const f32,
    depth: f32,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let at = Vec2::from_array(unsafe { floats::<2>(at, "at") }?);
        let body = |session: &mut Session, control: &Control| {
            Ok(session.set_depth(stroke, at, depth, control)?)
        };
        unsafe { ask(session, control, body) }
    })
}
