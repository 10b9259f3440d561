//! Trees from one to a few loose photographs, after Boris Neubert, Thomas Franken and Oliver Deussen,
//! *Approximate Image-Based Tree-Modeling using Particle Flows* (2007), here as chapter 3 of Neubert's
//! thesis (2012).
//!
//! Particles start where the photographs say that the tree is dense, flow down to its base along the
//! branches seen in the photographs, and join where they meet. What they leave behind are the branches.
//! The tree looks like the photographs from where they were taken; what they do not show is made up, and
//! every seed makes up something else.
//!
//! 1. [`matting`]: the tree is separated from what is behind it; the result is a [`Matte`] (3.2.1).
//! 2. [`attractor`]: main branches in each image, found by livewire or drawn (3.2.2).
//! 3. [`View`]s: where each photograph was taken from; [`align`](fn@align) finds base, height and scale.
//! 4. [`density`]: a grid of densities that gives the mattes when looked through (3.3).
//! 5. [`field`]: a direction field for each view, towards and along its attractor (3.5).
//! 6. [`flow`]: the particles' traces (3.4).
//! 7. [`finish`]: smoothing, radii, twigs and leaves.
//!
//! [`session`] does all of it from the second step on, keeps what is there, and redoes what a change
//! touches. All stages are also functions of their own, and [`draw`] makes pictures of them.
//!
//! # Example
//!
//! A matte made by hand, a disc on a stick, takes the place of a photograph. With the feature `image`,
//! `Photo::open` reads one, and [`matting::automatic`] separates a tree from the sky.
//!
//! ```
//! use tree_model::particle::Matte;
//! use tree_model::particle::session::{PhotoParams, Session, Shot};
//! use tree_model::tree_core::{Control, Seed};
//!
//! let (width, height) = (48, 64);
//! let inside = |x: i32, y: i32| {
//!     let crown = (x - 24).pow(2) + (y - 22).pow(2) < 18 * 18;
//!     let trunk = (x - 24).abs() < 2 && (22..62).contains(&y);
//!     f32::from(u8::from(crown || trunk))
//! };
//! let alpha = (0..width * height).map(|i| inside(i % width, i / width)).collect();
//! let shot = Shot::new(Matte::new(width as u32, height as u32, alpha)?, None, 0.0);
//!
//! let mut params = PhotoParams { height: 8.0, ..PhotoParams::default() };
//! params.density.resolution = 16;
//! params.flow.particles = 100;
//! let mut session = Session::new(vec![shot], params, Seed(1))?;
//! let grown = session.tree(&Control::default())?;
//! assert!(grown.tree.foliage().len() > 100);
//! for warning in grown.report.warnings() {
//!     println!("{warning}");
//! }
//! # Ok::<(), tree_model::ModelError>(())
//! ```
//!
//! # Where we depart from the thesis, and why
//!
//! * *Closed-form matting* ([`matting::natural`]) in place of the samplers that the thesis names: it makes
//!   do with fewer known pixels. A tree against sky needs no trimap ([`matting::automatic`]).
//! * *Livewire in three searches*, for the leader, for main branches, for all; each makes what it found
//!   cheaper for the next. The thesis searches for each seed by itself; in a closed crown such paths fan
//!   out from the base and do not look like a tree.
//! * *Cameras are found in the mattes*, and views made consistent ([`align_all`]); in the thesis a person
//!   arranges the images.
//! * *Crowns are round.* Two silhouettes leave boxes, one leaves a prism without end; each row of the grid
//!   is cut to an ellipse ([`density::DensityParams::rounding`]).
//! * *Non-negative least squares* (MPRGP): the thesis drops negative densities from a solution without
//!   bound, which then is no solution any more.
//! * *The pull to the base follows the cheapest way through the density* (fast marching), not a straight
//!   line, which leaves crowns that lean or stand on a bare trunk.
//! * *The views' directions are joined by least squares*, not averaged: an average halves what only one of
//!   two views can see, and may vanish. Where the images contradict each other, the way to the base leads.
//! * *A particle also joins a trace whose particle has gone on*: what flows in one bed at different times
//!   is one branch.
//! * *One photograph gets an imagined side*, itself mirrored, a quarter turn round
//!   ([`session::PhotoParams::imagine`]).
//! * *Leaves are counted in the images* and their number is put right where it is not what the matte asks
//!   for; the thesis follows the density alone.
//!
//! # Limits
//!
//! * Cameras are rough: any yaw, a pitch not far from level, parallel or with one field of view, without
//!   distortion by the lens. One upright tree for each set of photographs.
//! * Two silhouettes do not tell where between its limbs a crown is hollow, and rounding fills it. Sparse
//!   crowns of a few plates of leaves come out fuller than they are.
//! * Livewire sees branches where wood shows. In a closed crown its paths are plausible, not true;
//!   [`attractor::LivewireReport::evidence`] tells which.
//! * Of a bare tree the larger branches follow the photograph; fine twigs are made up, and do not fall on
//!   those of the photograph.
//! * [`matting::automatic`] needs sky about the crown. In front of other trees give a trimap or strokes;
//!   its report says how sure it is.
//!
//! # Cost
//!
//! O(pixels) for every picture, O(voxels) for the density and O(particles × steps) for the flow, of which
//! matting takes the most. `cargo run --release -p evaluate -- particle` prints times beside the
//! thesis's; benches are in `benches/particle.rs`.

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
