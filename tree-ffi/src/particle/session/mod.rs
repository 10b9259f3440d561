//! The whole way from photographs to a tree, stage by stage, with changes in between.

mod edit;
mod get;
mod params;
mod pictures;
mod report;
mod shot;
mod whole;

pub use edit::*;
pub use get::*;
pub use params::*;
pub use pictures::*;
pub use report::*;
pub use shot::*;
pub use whole::*;

use self::params::photo_params;
use self::shot::shots as shots_of;
use super::keep::Kept;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_ORDER, TREE_ERROR_PARAMETER, call, free, get, out,
    tree_status,
};
use crate::control::{limits, tree_control};
use std::sync::{Mutex, MutexGuard, TryLockError};
use tree_model::particle::session::{Session, Stage};
use tree_model::tree_core::Seed;

/// A stage of a session: one of the `TREE_PHOTO_STAGE_` constants, in the order in which they are done.
pub type tree_photo_stage = u32;
/// Cameras: base, height and scale of each view.
pub const TREE_PHOTO_STAGE_VIEWS: u32 = 0;
/// Main branches in each view.
pub const TREE_PHOTO_STAGE_ATTRACTORS: u32 = 1;
/// The density in space, and the way to the base through it.
pub const TREE_PHOTO_STAGE_DENSITY: u32 = 2;
/// The direction field of each view.
pub const TREE_PHOTO_STAGE_FIELDS: u32 = 3;
/// The particles' traces.
pub const TREE_PHOTO_STAGE_FLOW: u32 = 4;
/// Branches.
pub const TREE_PHOTO_STAGE_WOOD: u32 = 5;
/// Twigs and leaves.
pub const TREE_PHOTO_STAGE_CROWN: u32 = 6;

fn stage(found: tree_photo_stage) -> Result<Stage> {
    match found {
        TREE_PHOTO_STAGE_VIEWS => Ok(Stage::Views),
        TREE_PHOTO_STAGE_ATTRACTORS => Ok(Stage::Attractors),
        TREE_PHOTO_STAGE_DENSITY => Ok(Stage::Density),
        TREE_PHOTO_STAGE_FIELDS => Ok(Stage::Fields),
        TREE_PHOTO_STAGE_FLOW => Ok(Stage::Flow),
        TREE_PHOTO_STAGE_WOOD => Ok(Stage::Wood),
        TREE_PHOTO_STAGE_CROWN => Ok(Stage::Crown),
        other => Err(Failure::not_one_of("stage", other, "TREE_PHOTO_STAGE_")),
    }
}

/// A tree in the making: photographs, parameters, and what has been made of them so far.
///
/// Every stage can be asked for by itself. What is there is kept, so that a change redoes only what comes
/// after it: painting density keeps the branches found in the pictures, another seed keeps density and
/// fields. A call that fails or is cancelled leaves the session as it was, with the stages done by then.
///
/// It is an object that changes: do not use it from two threads at once. A call that
/// comes while another is at work on it, from a progress callback too, is `TREE_ERROR_ORDER`. What it hands
/// out is copied, does not change with it, and outlives it.
pub struct tree_photo_session(Mutex<Held>);

/// A session, and its parameters in C's form.
struct Held {
    session: Session,
    params: (tree_photo_params, Kept),
}

// SAFETY: the parameters in C's form point at what is kept with them, and at nothing of a thread's.
unsafe impl Send for Held {}

impl Handle for tree_photo_session {
    const NAME: &'static str = "tree_photo_session";
}

impl tree_photo_session {
    fn new(session: Session) -> Self {
        let params = keep(&session);
        Self(Mutex::new(Held { session, params }))
    }
}

/// A session's parameters in C's form.
fn keep(session: &Session) -> (tree_photo_params, Kept) {
    let mut kept = Kept::default();
    (tree_photo_params::of(session.params(), &mut kept), kept)
}

/// The session of a handle, for this call alone.
unsafe fn lock<'a>(session: *const tree_photo_session) -> Result<MutexGuard<'a, Held>> {
    match unsafe { get(session, "session") }?.0.try_lock() {
        Ok(held) => Ok(held),
        // A stage that panicked is not there, and is done anew.
        Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
        Err(TryLockError::WouldBlock) => {
            let text = "session is at work in another call: one call at a time";
            Err(Failure::new(TREE_ERROR_ORDER, text))
        }
    }
}

fn check_view(session: &Session, view: usize) -> Result<()> {
    let n = session.shots().len();
    if view < n { Ok(()) } else { Err(no_view(view, n)) }
}

fn no_view(view: usize, n: usize) -> Failure {
    let text = format!("view is {view}, but there are {n} views, counted from 0");
    Failure::new(TREE_ERROR_PARAMETER, text)
}

/// Begins with `n_shots` photographs, 1 to 1000, which are copied. `params` may be NULL for the defaults.
/// `control` may be NULL; only its limits matter: no work is done yet. Free the session with
/// `tree_photo_session_free`. `TREE_ERROR_PARAMETER` names what is out of range; `TREE_ERROR_NO_RESULT` a
/// photograph that is not of its matte's size.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_new(
    shots: *const tree_photo_shot,
    n_shots: usize,
    params: *const tree_photo_params,
    seed: u64,
    control: *const tree_control,
    session: *mut *mut tree_photo_session,
) -> tree_status {
    call(|| {
        let place = unsafe { out(session, "session") }?;
        let limits = unsafe { limits(control) }?;
        let shots = unsafe { shots_of(shots, n_shots, &limits) }?;
        let params = unsafe { photo_params(params, &limits) }?;
        place.put(tree_photo_session::new(Session::new(shots, params, Seed(seed))?));
        Ok(())
    })
}

/// A second session in the state of the first, with all that has been made so far: to try something, and
/// go back. Free it too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_copy(
    session: *const tree_photo_session,
    copy: *mut *mut tree_photo_session,
) -> tree_status {
    call(|| {
        let place = unsafe { out(copy, "copy") }?;
        let copy = unsafe { lock(session) }?.session.clone();
        place.put(tree_photo_session::new(copy));
        Ok(())
    })
}

/// Frees a session. What it handed out lives on. `TREE_ERROR_ORDER` while a call is at work on it, from a
/// progress callback for instance: it lives on then.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_free(session: *mut tree_photo_session) -> tree_status {
    call(|| {
        if !session.is_null() {
            // Waits for no one: who holds it would go on with what is freed.
            drop(unsafe { lock(session) }?);
        }
        unsafe { free(session, "session") }
    })
}
