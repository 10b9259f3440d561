//! From where a stroke is drawn.

use crate::error::{Result, check};
use glam::Vec2;
use std::f32::consts::{FRAC_PI_2, PI, TAU};

/// A view of the tree without perspective.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Viewpoint {
    /// How far the viewer has gone round the tree, against the clock seen from above, in radians, -2π to 2π. Default 0: in
    /// front, +X to the right.
    pub yaw: f32,
    /// How far he looks down, in radians, within ±1.4. Default 0.
    pub pitch: f32,
}

impl Viewpoint {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("view.yaw", self.yaw, -TAU, TAU)?;
        check("view.pitch", self.pitch, -1.4_f32, 1.4_f32)
    }

    /// The azimuth that lies to the right, or left, of the trunk as seen from here, in 0 to 2π.
    #[must_use]
    pub fn azimuth(&self, left: bool) -> f32 {
        let right = -self.yaw;
        (if left { right + PI } else { right }).rem_euclid(TAU)
    }

    /// Whether this is the view of the drawing's plane, to a quarter of a degree.
    #[must_use]
    pub fn is_front(&self) -> bool {
        let turn = self.yaw.rem_euclid(TAU);
        turn.min(TAU - turn) < 0.004 && self.pitch.abs() < 0.004
    }

    /// A point of the view, in metres, y up, the origin at the trunk's base, as it lies in the upright plane through the
    /// trunk that faces the viewer.
    #[must_use]
    pub fn to_plane(&self, point: Vec2) -> Vec2 {
        let cos = libm::cosf(self.pitch.clamp(-FRAC_PI_2 + 0.1, FRAC_PI_2 - 0.1));
        Vec2::new(point.x, point.y / cos)
    }
}
