//! Bumps of an outline, by the chordal axis (Wither et al. 2009, section 3.1): each is the foliage of one major branch.
//!
//! 1. `border`: the outline by points at even distances, each the mean of a short stretch: jitter goes.
//! 2. `mesh`: its triangulation. The middles of the edges inside, joined through the triangles, are the
//!    chordal axis (Prasad 1997); a triangle with one such edge is a terminal, with three a fork. Corners of triangles are
//!    points of the outline: that is the correspondence of axis and outline the paper asks for.
//! 3. `stand`: how far each terminal stands out, and the least is taken off until all that are left are
//!    bumps.
//! 4. `center`: central point, direction and radius of each.
//!
//! The paper does not say how the axis is pruned, and bare terminals are as many as the outline has corners. We ask how
//! far a terminal sticks out of the disc that fits into its fork, as a share of the width it stands on (the erosion
//! thickness of Liu, Chambers, Letscher & Ju 2011), and for valleys beside it: people divide shapes at
//! concavities (Hoffman & Singh 1997, the minima rule).
//!
//! An outline without anything that stands out, a circle, is one bump. An oval has one at either end once it is
//! about 1.7 times as long as it is wide, a drop one at its point.
//!
//! O(n + m log m + terminals · m) for n points of the outline and m = `border::POINTS`, whatever the outline.

mod border;
mod center;
mod mesh;
mod stand;
#[cfg(test)]
mod tests;

use super::Outline;
use crate::error::{Result, check};
use glam::Vec2;

/// One bump of an outline: the foliage of one major branch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bump {
    /// Its central point, where the branch ends: going from the tip inwards along the axis, the last point whose disc
    /// still touches the tip. That is the middle of a round end, and about the tip itself of a sharp one.
    pub center: Vec2,
    /// Its outermost point, on the outline: the farthest from the fork it hangs on.
    pub tip: Vec2,
    /// Direction of the chordal axis at the centre, outwards, of unit length: over about the width of the bump.
    pub tangent: Vec2,
    /// Radius of the disc about the centre that fits into the outline, in metres; about 0 at a sharp feature.
    pub radius: f32,
    /// The part of the outline that is the bump's: from one length along the outline, against the clock from its
    /// first point, to another. Where it passes the first point, the second is greater than the perimeter.
    pub stretch: [f32; 2],
}

/// How bumps are found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct BumpParams {
    /// How far a feature must stand out to be a bump, as a share of the width of what it stands on, 0.01 to 10.
    /// This holds for the middling: between clear valleys half of it is enough, without any it takes twice as much. Default 0.2.
    pub prominence: f32,
    /// Features that stand out less than this share of the outline's size (the longer side of its box) are no bumps
    /// whatever their form: unsteadiness of the hand, single leaves, 0.001 to 0.5. Default 0.02.
    pub detail: f32,
}

impl Default for BumpParams {
    fn default() -> Self {
        Self { prominence: 0.2, detail: 0.02 }
    }
}

impl BumpParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("bumps.prominence", self.prominence, 0.01_f32, 10.0_f32)?;
        check("bumps.detail", self.detail, 0.001_f32, 0.5_f32)
    }
}

/// The bumps of an outline, in their order against the clock along it; at least one, unless the outline has no area an
/// `f32` can tell.
///
/// The lower end of a crown, where the trunk comes in, may be one like every other: who knows the trunk leaves it out.
///
/// # Complexity
/// See the module: 0.5 ms for an outline of 500 points.
#[must_use]
pub fn bumps(outline: &Outline, params: &BumpParams) -> Vec<Bump> {
    let Some(border) = border::Border::of(outline) else { return Vec::new() };
    let Some(mut mesh) = mesh::Mesh::of(&border) else { return Vec::new() };
    let ends = stand::ends(&mut mesh, params);
    if ends.is_empty() {
        return vec![center::whole(outline, &border, &mesh)];
    }
    let mut bumps: Vec<Bump> =
        ends.iter().map(|end| center::bump(outline, &border, &mesh, end)).collect();
    bumps.sort_by(|a, b| a.stretch[0].total_cmp(&b.stretch[0]));
    bumps
}
