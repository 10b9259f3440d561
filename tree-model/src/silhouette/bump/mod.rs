//! Bumps of an outline, by the chordal axis (Wither et al. 2009, section 3.1).

use super::Outline;
use crate::error::{Result, check};
use glam::Vec2;

/// One bump of an outline: the foliage of one major branch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bump {
    /// Its central point, where the branch ends.
    pub centre: Vec2,
    /// Its outermost point, on the outline.
    pub tip: Vec2,
    /// Direction of the chordal axis at the centre, outwards, of unit length.
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
    /// How far a feature must stand out to be a bump, as a share of the width of what it stands on, 0.01 to 10. Default 0.2.
    pub prominence: f32,
}

impl Default for BumpParams {
    fn default() -> Self {
        Self { prominence: 0.2 }
    }
}

impl BumpParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("bumps.prominence", self.prominence, 0.01_f32, 10.0_f32)
    }
}

/// The bumps of an outline, in their order against the clock along it.
#[must_use]
pub fn bumps(_outline: &Outline, _params: &BumpParams) -> Vec<Bump> {
    Vec::new()
}
