//! Drawing a tree, outline by outline, with edits that can be undone.

mod change;
mod edit;
mod get;
mod report;

pub use change::*;
pub use edit::*;
pub use get::*;
pub use report::*;

use super::params::{keep, silhouette_params, tree_silhouette_params};
use super::tree_outline_drawing;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_INVALID, TREE_ERROR_ORDER, call, foresee, free,
    get as object, out, tree_status, view,
};
use crate::control::{run, tree_control};
use crate::particle::Kept;
use std::sync::{Mutex, MutexGuard, TryLockError};
use tree_model::silhouette::read::TreeStrokes;
use tree_model::silhouette::session::{PlayReport, Session};
use tree_model::tree_core::{Control, Seed};

/// A tree being drawn: trunk, crown, outlines of branches, leaf. Strokes are in metres, y up, the trunk's base near
/// the origin. The plan in the plane is ready after each edit; the tree in space is made when it is asked for.
///
/// Branches are named by ids, which are above 0 and stay for as long as the branch is there. An edit is done whole or not
/// at all, and can be undone.
///
/// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
/// on it, from a progress callback too, is `TREE_ERROR_ORDER`. What it hands out is copied, does not change with it,
/// and outlives it.
pub struct tree_silhouette_session(Mutex<Held>);

/// A session, its seed, its parameters in C's form, and what became of the drawing it began with.
struct Held {
    session: Session,
    seed: u64,
    params: (tree_silhouette_params, Kept),
    played: PlayReport,
}

// SAFETY: the parameters in C's form point at what is kept with them, and at nothing of a thread's.
unsafe impl Send for Held {}

impl Handle for tree_silhouette_session {
    const NAME: &'static str = "tree_silhouette_session";
}

impl tree_silhouette_session {
    pub(super) fn new(session: Session, seed: u64, played: PlayReport) -> Self {
        let params = keep(session.params());
        Self(Mutex::new(Held { session, seed, params, played }))
    }
}

/// The strokes of a tree of a drawing.
fn tree_of(drawing: &tree_outline_drawing, tree: usize) -> Result<&TreeStrokes> {
    let trees = &drawing.rust().trees;
    trees.get(tree).ok_or_else(|| {
        let text = format!("tree is {tree}, the drawing has {}", trees.len());
        Failure::new(TREE_ERROR_INVALID, text)
    })
}

/// The session of a handle, for this call alone.
unsafe fn lock<'a>(silhouette: *const tree_silhouette_session) -> Result<MutexGuard<'a, Held>> {
    match unsafe { object(silhouette, "silhouette") }?.0.try_lock() {
        Ok(held) => Ok(held),
        // An edit that panicked was not done.
        Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
        Err(TryLockError::WouldBlock) => {
            let text = "silhouette is at work in another call: one call at a time";
            Err(Failure::new(TREE_ERROR_ORDER, text))
        }
    }
}

/// Begins with nothing drawn. `params` may be NULL for the defaults. Free it with `tree_silhouette_session_free`.
/// `TREE_ERROR_PARAMETER` names what is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_new(
    params: *const tree_silhouette_params,
    seed: u64,
    silhouette: *mut *mut tree_silhouette_session,
) -> tree_status {
    call(|| {
        let place = unsafe { out(silhouette, "silhouette") }?;
        let session = Session::new(unsafe { silhouette_params(params) }?, Seed(seed))?;
        place.put(tree_silhouette_session::new(session, seed, PlayReport::default()));
        Ok(())
    })
}

/// Draws all strokes of one tree of a drawing, the first being number 0; its height becomes that of the parameters.
/// Strokes of finer levels that cannot be used are left out: `report`, `tree_silhouette_session_repairs` and
/// `tree_silhouette_session_refused` tell which, and why. What was read cannot be undone. `params`, `control` and `report` may be
/// NULL. Free it with `tree_silhouette_session_free`. `TREE_ERROR_INVALID` says why level 0 gives no crown.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_of_drawing(
    drawing: *const tree_outline_drawing,
    tree: usize,
    params: *const tree_silhouette_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_silhouette_play_report,
    silhouette: *mut *mut tree_silhouette_session,
) -> tree_status {
    call(|| {
        let place = unsafe { out(silhouette, "silhouette") }?;
        unsafe { foresee(report, "report") }?;
        let strokes = tree_of(unsafe { object(drawing, "drawing") }?, tree)?;
        let params = unsafe { silhouette_params(params) }?;
        let body = |control: &Control| {
            control.check()?;
            Ok(Session::of_drawing(strokes, params, Seed(seed))?)
        };
        let (session, played) = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_silhouette_play_report::of(&played)) }?;
        place.put(tree_silhouette_session::new(session, seed, played));
        Ok(())
    })
}

/// A second one in the state of the first, with all that can be undone: to try something, and go back. Free it
/// too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_copy(
    silhouette: *const tree_silhouette_session,
    copy: *mut *mut tree_silhouette_session,
) -> tree_status {
    call(|| {
        let place = unsafe { out(copy, "copy") }?;
        let held = unsafe { lock(silhouette) }?;
        let played = held.played.clone();
        place.put(tree_silhouette_session::new(held.session.clone(), held.seed, played));
        Ok(())
    })
}

/// Frees it. What it handed out lives on. `TREE_ERROR_ORDER` while a call is at work on it, from a progress callback
/// for instance: it lives on then.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_session_free(
    silhouette: *mut tree_silhouette_session,
) -> tree_status {
    call(|| {
        if !silhouette.is_null() {
            // Waits for no one: who holds it would go on with what is freed.
            drop(unsafe { lock(silhouette) }?);
        }
        unsafe { free(silhouette, "silhouette") }
    })
}
