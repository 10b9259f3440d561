//! The density of the tree in space (Neubert 2012, section 3.3).
//!
//! How much leaf and wood there is in every voxel, such that looking through the grid gives the mattes.
//!
//! 1. [`carve`]: a grid around what the views see. A voxel begins with the least of the average mattes it
//!    projects to, and is thrown away where that is next to nothing (3.3.1, space carving).
//! 2. [`Equations`]: one ray for every few pixels. Along it the densities times the lengths add up to −ln of
//!    the transparency seen (3.3.2, equations 3.2 and 3.3).
//! 3. [`solve`]: the least-squares solution without negative densities.
//! 4. [`sample_points`]: points in proportion to the density, where particles start.
//!
//! [`paint`] and [`paint_volume`] change mattes and grids by strokes, [`look_through`] gives the matte of
//! a grid, [`crown_volume`] and [`overlap`] measure one.
//!
//! Where we depart from the thesis, and why:
//! * Entries of A are lengths in metres, not 1, so that densities do not depend on the voxel size, and
//!   −ln θ is bounded: θ = 0 has no logarithm.
//! * Two silhouettes leave boxes, and one leaves a prism without end. Horizontal sections of crowns are
//!   round, so each row is cut to an ellipse of the widths seen ([`DensityParams::rounding`], 0 for the
//!   thesis alone).
//! * The thesis drops negative densities from the unbounded solution; the bound is part of the problem
//!   here (MPRGP, Dostál 2009). A small Tikhonov term makes the solution unique: there are far more
//!   voxels than the rays can tell apart.
//!
//! Cost: O(voxels × views) for carving, O(entries of A) for every iteration; 64³ voxels from two pictures
//! of 1024² take well under half a second.

mod bounds;
mod carve;
mod coverage;
mod look;
mod minimize;
mod paint;
mod params;
mod rounding;
mod sample;
mod solve;
mod system;
#[cfg(test)]
mod tests;

pub use carve::{Carved, carve};
pub use look::{crown_volume, look_through, overlap};
pub use paint::{DensityBrush, DensityStroke, paint, paint_volume};
pub use params::DensityParams;
pub use sample::sample_points;
pub use solve::{DensityReport, DensityWarning, solve};
pub use system::Equations;
