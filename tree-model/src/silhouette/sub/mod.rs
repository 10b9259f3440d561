//! Sub-silhouettes: the part of a crown that is one branch's (Wither et al. 2009, section 4.1 and Fig. 6).
//!
//! 1. `shared`: a cone about the line from the branch's base to its end cuts a part out of the parent's outline,
//!    the wider the rounder the branch's bump is.
//! 2. `close`: two Hermite curves lead from there to the base, in the outline's directions at the joins
//!    (G¹), and close the sub-silhouette.
//!
//! The paper does not say how long the curves' tangents are, nor what becomes of curves that cross. Ours are half
//! the distance of the ends, as those of its branches, and shorter until the outline is simple, holds the middle of the
//! branch and stays inside its parent; where that does not help less of the outline is shared. At the base the curves open as wide
//! as the cone, and wider for a branch that bends out of it.
//!
//! O(n) for a parent of n points.

mod close;
mod hermite;
mod shared;
#[cfg(test)]
mod tests;

use super::{Line, Outline};
use crate::error::{Result, check};
use glam::Vec2;

pub use hermite::Hermite;

/// How sub-silhouettes are cut out.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct SubParams {
    /// Opening of the cone at a sharp feature, in radians, 0.02 to 3. Default 20°, as in the paper.
    pub narrow: f32,
    /// Opening where the radius at the end is the branch's span or more, in radians, 0.02 to 3. Default 110°, as in the
    /// paper.
    pub wide: f32,
}

impl Default for SubParams {
    fn default() -> Self {
        Self { narrow: 20_f32.to_radians(), wide: 110_f32.to_radians() }
    }
}

impl SubParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("subs.narrow", self.narrow, 0.02_f32, 3.0_f32)?;
        check("subs.wide", self.wide, 0.02_f32, 3.0_f32)
    }

    /// Opening of the cone of a branch of this span with this radius at its end, in radians.
    #[must_use]
    pub fn opening(&self, radius: f32, span: f32) -> f32 {
        let share = radius / span;
        let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
        self.narrow + share * (self.wide - self.narrow)
    }
}

/// Where a curve joins the shared part of the outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Join {
    /// The place.
    pub point: Vec2,
    /// Direction of the outline there, against the clock, of unit length.
    pub tangent: Vec2,
}

/// The sub-silhouette of a branch.
#[derive(Clone, Debug, PartialEq)]
pub struct SubOutline {
    /// The whole of it: the shared part, and the curves by [`CURVE_STEPS`] sides each.
    pub outline: Outline,
    /// The part shared with the parent, from one length along it, against the clock, to another; the second may be
    /// greater than the perimeter. Of no length where nothing could be shared; the outline is a spindle about the branch
    /// then.
    pub shared: [f32; 2],
    /// Begin and end of the shared part.
    pub joins: [Join; 2],
    /// From the base of the branch to the begin, and from the end to the base.
    pub curves: [Hermite; 2],
}

/// Sides of the outline for each curve.
pub const CURVE_STEPS: usize = 12;

/// The sub-silhouette of a branch with the given radius at its end (see [`Bump`](super::bump::Bump)). With a `stretch` only
/// that part of the parent is shared; without one, whatever the cone reaches.
///
/// It is simple and against the clock whatever the branch. For a branch inside the parent it holds the branch's middle
/// unless the branch winds a lot, and stays inside the parent as far as it can.
///
/// # Complexity
/// O(n): about 20 µs for a parent of 500 points.
#[must_use]
pub fn sub_outline(
    parent: &Outline,
    branch: &Line,
    radius: f32,
    stretch: Option<[f32; 2]>,
    params: &SubParams,
) -> SubOutline {
    let half = 0.5 * params.opening(radius, branch.span().length());
    let round = shared::Round::of(parent);
    let section = round.section(branch, half, stretch);
    close::close(&round, branch, half, section)
}
