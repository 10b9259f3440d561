//! The whole way from a drawing to a tree, stage by stage, with edits in between.

mod edit;
mod get;
mod params;
mod report;
mod whole;

pub use edit::*;
pub use get::*;
pub use params::*;
pub use report::*;
pub use whole::*;

use self::params::sketch_params;
use super::tree_drawing;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_ORDER, call, free, get as object, out, tree_status,
};
use crate::control::{run, tree_control};
use crate::particle::Kept;
use std::sync::{Mutex, MutexGuard, TryLockError};
use tree_model::sketch::session::{Session, Stage};
use tree_model::tree_core::{Control, Seed};

/// A stage of a session: one of the `TREE_SKETCH_STAGE_` constants, in the order in which they are done.
pub type tree_sketch_stage = u32;
/// Strokes joined, the crown closed.
pub const TREE_SKETCH_STAGE_CLEAN: u32 = 0;
/// Templates compared.
pub const TREE_SKETCH_STAGE_SELECT: u32 = 1;
/// Depths inferred.
pub const TREE_SKETCH_STAGE_INFER: u32 = 2;
/// Branches propagated.
pub const TREE_SKETCH_STAGE_PROPAGATE: u32 = 3;
/// Wood with radii.
pub const TREE_SKETCH_STAGE_WOOD: u32 = 4;
/// Twigs and leaves.
pub const TREE_SKETCH_STAGE_TREE: u32 = 5;

fn stage(found: tree_sketch_stage) -> Result<Stage> {
    match found {
        TREE_SKETCH_STAGE_CLEAN => Ok(Stage::Clean),
        TREE_SKETCH_STAGE_SELECT => Ok(Stage::Select),
        TREE_SKETCH_STAGE_INFER => Ok(Stage::Infer),
        TREE_SKETCH_STAGE_PROPAGATE => Ok(Stage::Propagate),
        TREE_SKETCH_STAGE_WOOD => Ok(Stage::Wood),
        TREE_SKETCH_STAGE_TREE => Ok(Stage::Tree),
        other => Err(Failure::not_one_of("stage", other, "TREE_SKETCH_STAGE_")),
    }
}

/// A sketch on its way to a tree: a drawing, parameters, templates, and what has been made of them so far.
///
/// Every stage can be asked for by itself and is done when its result, or that of a later one, is first asked for.
/// Edits keep what does not depend on them: once depths have been inferred, strokes can be added and erased and
/// depths moved, and those of all other branches stay, as do scale, template, Ω and what grew on other branches.
/// `tree_sketch_session_infer_anew` forgets all of that. A call that fails or is cancelled leaves the session as it
/// was, with the stages done by then.
///
/// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
/// on it, from a progress callback too, is `TREE_ERROR_ORDER`. What it hands out is copied, does not change with it,
/// and outlives it.
pub struct tree_sketch_session(Mutex<Held>);

/// A session, its seed, and its parameters in C's form.
struct Held {
    session: Session,
    seed: u64,
    params: (tree_sketch_params, Kept),
}

// SAFETY: the parameters in C's form point at what is kept with them, and at nothing of a thread's.
unsafe impl Send for Held {}

impl Handle for tree_sketch_session {
    const NAME: &'static str = "tree_sketch_session";
}

impl tree_sketch_session {
    fn new(session: Session, seed: u64) -> Self {
        let params = keep(&session);
        Self(Mutex::new(Held { session, seed, params }))
    }
}

/// A session's parameters in C's form.
fn keep(session: &Session) -> (tree_sketch_params, Kept) {
    let mut kept = Kept::default();
    (tree_sketch_params::of(session.params(), &mut kept), kept)
}

/// The session of a handle, for this call alone.
unsafe fn lock<'a>(session: *const tree_sketch_session) -> Result<MutexGuard<'a, Held>> {
    match unsafe { object(session, "session") }?.0.try_lock() {
        Ok(held) => Ok(held),
        // A stage that panicked is not there, and is done anew.
        Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
        Err(TryLockError::WouldBlock) => {
            let text = "session is at work in another call: one call at a time";
            Err(Failure::new(TREE_ERROR_ORDER, text))
        }
    }
}

/// Works on a session, as `control` says.
unsafe fn ask<R: Send>(
    session: *const tree_sketch_session,
    control: *const tree_control,
    work: impl FnOnce(&mut Session, &Control) -> Result<R> + Send,
) -> Result<R> {
    let mut held = unsafe { lock(session) }?;
    let session = &mut held.session;
    unsafe { run(control, move |control| work(session, control)) }
}

/// Begins with a drawing, which is copied. `params` may be NULL for the defaults. No work is done yet: what is wrong
/// with the drawing comes to light with the first stage. Templates and obstacles are set with
/// `tree_sketch_session_set_templates` and `tree_sketch_session_set_obstacles`. Free the session with
/// `tree_sketch_session_free`. `TREE_ERROR_PARAMETER` names what is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_new(
    drawing: *const tree_drawing,
    params: *const tree_sketch_params,
    seed: u64,
    session: *mut *mut tree_sketch_session,
) -> tree_status {
    call(|| {
        let place = unsafe { out(session, "session") }?;
        let drawing = unsafe { object(drawing, "drawing") }?.rust().clone();
        let params = unsafe { sketch_params(params) }?;
        let made = Session::new(drawing, params, Seed(seed))?;
        place.put(tree_sketch_session::new(made, seed));
        Ok(())
    })
}

/// A second session in the state of the first, with all that has been made so far: to try something, and
/// go back. Free it too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_copy(
    session: *const tree_sketch_session,
    copy: *mut *mut tree_sketch_session,
) -> tree_status {
    call(|| {
        let place = unsafe { out(copy, "copy") }?;
        let held = unsafe { lock(session) }?;
        place.put(tree_sketch_session::new(held.session.clone(), held.seed));
        Ok(())
    })
}

/// Frees a session. What it handed out lives on. `TREE_ERROR_ORDER` while a call is at work on it, from a
/// progress callback for instance: it lives on then.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_session_free(
    session: *mut tree_sketch_session,
) -> tree_status {
    call(|| {
        if !session.is_null() {
            // Waits for no one: who holds it would go on with what is freed.
            drop(unsafe { lock(session) }?);
        }
        unsafe { free(session, "session") }
    })
}
