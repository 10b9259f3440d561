//! Trees from one to a few loose photographs, after Boris Neubert, Thomas Franken and Oliver Deussen,
//! *Approximate Image-Based Tree-Modeling using Particle Flows* (2007), here as chapter 3 of Neubert's
//! thesis (2012).
//!
//! Particles start where the photographs say that the tree is dense, flow down to its base along the
//! branches seen in the photographs, and join where they meet. What they leave behind are the branches.
//!
//! 1. [`matting`]: the tree is separated from what is behind it; the result is a [`Matte`] (3.2.1).
//! 2. [`attractor`]: main branches in each image, found by livewire or drawn (3.2.2).
//! 3. [`View`]s: where each photograph was taken from; [`align`] finds base, height and scale.
//! 4. [`density`]: a grid of densities that gives the mattes when looked through (3.3).
//! 5. [`field`]: a direction field for each view, towards and along its attractor (3.5).
//! 6. [`flow`]: the particles' traces (3.4).
//! 7. [`finish`]: smoothing, radii, twigs and leaves.
//!
//! [`session`] does all of it, keeps what is there, and redoes what a change touches.

mod align;
pub mod attractor;
mod camera;
pub mod density;
pub mod draw;
pub mod field;
pub mod finish;
pub mod flow;
mod grid;
mod matte;
pub mod matting;
mod photo;
#[cfg(feature = "image")]
mod picture_file;
pub mod session;
mod view;

pub use align::{AlignParams, AlignWarning, AlignedViews, Alignment, align, align_all};
pub use camera::{Camera, Frame, Projection, Projector, Stand};
pub use grid::Grid;
pub use matte::Matte;
pub use photo::Photo;
pub use view::View;
