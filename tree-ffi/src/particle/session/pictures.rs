//! Pictures of what the stages did, for people to look at.

use super::{check_view, lock, tree_photo_session};
use crate::border::{call, out, tree_status};
use crate::control::{run, tree_control};
use crate::photo::tree_photo;
use tree_model::ModelError;
use tree_model::particle::Photo;
use tree_model::particle::session::Session;
use tree_model::tree_core::Control;

type DrawResult = Result<Photo, ModelError>;

unsafe fn draw(
    session: *const tree_photo_session,
    view: Option<usize>,
    control: *const tree_control,
    picture: *mut *mut tree_photo,
    draw: impl FnOnce(&mut Session, &Control) -> DrawResult + Send,
) -> tree_status {
    call(|| {
        let place = unsafe { out(picture, "picture") }?;
        let mut held = unsafe { lock(session) }?;
        if let Some(view) = view {
            check_view(&held.session, view)?;
        }
        let session = &mut held.session;
        let body = move |control: &Control| Ok(draw(session, control)?);
        place.put(tree_photo::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// A view's matte: white where the tree covers. Free the picture with `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_draw_matte(
    session: *const tree_photo_session,
    view: usize,
    picture: *mut *mut tree_photo,
) -> tree_status {
    let body = |session: &mut Session, _: &_| session.picture_of_matte(view);
    unsafe { draw(session, Some(view), std::ptr::null(), picture, body) }
}

/// A view's branches over its photograph, the base as a dot. Free the picture with `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_draw_attractor(
    session: *mut tree_photo_session,
    view: usize,
    control: *const tree_control,
    picture: *mut *mut tree_photo,
) -> tree_status {
    let body =
        |session: &mut Session, control: &Control| session.picture_of_attractor(view, control);
    unsafe { draw(session, Some(view), control, picture, body) }
}

/// A view's direction field as arrows over its matte. Free the picture with `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_draw_field(
    session: *mut tree_photo_session,
    view: usize,
    control: *const tree_control,
    picture: *mut *mut tree_photo,
) -> tree_status {
    let body = |session: &mut Session, control: &Control| session.picture_of_field(view, control);
    unsafe { draw(session, Some(view), control, picture, body) }
}

/// The particles' traces over a view's photograph, thicker where more went. Free the picture with
/// `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_draw_traces(
    session: *mut tree_photo_session,
    view: usize,
    control: *const tree_control,
    picture: *mut *mut tree_photo,
) -> tree_status {
    let body = |session: &mut Session, control: &Control| session.picture_of_traces(view, control);
    unsafe { draw(session, Some(view), control, picture, body) }
}

/// Horizontal slices through the density, from the base up: light where it is dense, seen from above with
/// the front below. Free the picture with `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_session_draw_density(
    session: *mut tree_photo_session,
    control: *const tree_control,
    picture: *mut *mut tree_photo,
) -> tree_status {
    let body = |session: &mut Session, control: &Control| session.picture_of_density(control);
    unsafe { draw(session, None, control, picture, body) }
}
