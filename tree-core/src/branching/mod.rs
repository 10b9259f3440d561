//! Branching: how a tree that is there branches, in the figures that botanists and foresters measure.
//!
//! * [`Strahler`]: Horton-Strahler orders, bifurcation ratio and length ratio.
//! * [`Runs`]: unbranched runs, the internodes between forks.
//! * [`pipe_exponents`] and [`pipe_exponent`]: Δ in r₀^Δ = Σ rᵢ^Δ, read off the radii.
//! * [`lateral_angles`]: the angles at which laterals leave their axes.
//!
//! [`allometry`](crate::allometry) goes the other way: from such figures to radii and angles. All is measured in
//! f64 and in one pass or a few; the radii are taken as they are.
//!
//! ```
//! use tree_core::{Skeleton, branching::{Strahler, pipe_exponent}, glam::Vec3};
//! let mut builder = Skeleton::builder(Vec3::ZERO, 0.2)?;
//! let fork = builder.add(0, Vec3::Y, 0.2)?;
//! for x in [-1.0, 1.0] {
//!     let branch = builder.add(fork, Vec3::new(x, 2.0, 0.0), 0.2 * 0.5_f32.sqrt())?;
//!     builder.add(branch, Vec3::new(x, 3.0, 0.0), 0.2 * 0.5_f32.sqrt())?;
//! }
//! let skeleton = builder.finish();
//! assert_eq!(Strahler::of(&skeleton).counts(), [2, 1]);
//! // Two halves of the cross-section: Leonardo's exponent.
//! assert!((pipe_exponent(&skeleton).unwrap() - 2.0).abs() < 1e-3);
//! # Ok::<(), tree_core::CoreError>(())
//! ```

mod angles;
mod pipe;
mod runs;
mod strahler;

pub use angles::{LateralAngle, lateral_angles};
pub use pipe::{pipe_exponent, pipe_exponents};
pub use runs::{Run, Runs};
pub use strahler::Strahler;

use crate::skeleton::Skeleton;
use glam::DVec3;

/// Where a node is, in f64.
fn place(skeleton: &Skeleton, node: u32) -> DVec3 {
    skeleton.positions().get(node as usize).map_or(DVec3::ZERO, |at| at.as_dvec3())
}

/// Length of the segment below a node in metres, 0 for the root.
fn length_below(skeleton: &Skeleton, node: u32) -> f64 {
    let below = skeleton.parent(node).unwrap_or(node);
    place(skeleton, below).distance(place(skeleton, node))
}

#[cfg(test)]
mod tests;
