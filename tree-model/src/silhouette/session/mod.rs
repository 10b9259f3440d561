//! Drawing a tree, stroke by stroke (Wither et al. 2009, section 2).
//!
//! A [`Session`] takes strokes in metres, y up, the trunk's base near the origin. Each edit says what [`Change`]d, and can be undone. The plan
//! in the plane is ready after each edit; the tree in space is made when it is asked for.
//!
//! * [`Session::draw_trunk`], [`Session::draw_crown`], [`Session::draw_section`]: level 0.
//! * [`Session::refine`]: the outline of a branch's foliage; its own branches are inferred, and its style spreads.
//! * [`Session::redraw`], [`Session::redraw_from`], [`Session::remove`]: branches.
//! * [`Session::draw_leaf`]: the last level.
//! * [`Session::copy_style`]: whose style goes where.
//!
//! [`Session::of_drawing`] plays a whole drawing; [`SilhouetteModel`] is that as a [`Modeler`](crate::Modeler).

mod change;
mod edit;
mod params;
mod play;
mod redraw;
mod state;
mod target;
mod view;

pub use change::Change;
pub use params::SilhouetteParams;
pub(super) use play::{Ground, stand};
pub use play::{PlayReport, SilhouetteModel};
pub use redraw::Transfer;
pub use state::Session;
pub use view::Viewpoint;

#[cfg(test)]
mod tests;
