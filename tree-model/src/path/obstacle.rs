//! Obstacles: volumes that no path may enter.

use crate::error::{Result, check};
use glam::Vec3;
use tree_core::Volume;

/// A segment that comes nearer than this share of its length counts as a hit: sphere tracing could
/// not tell it from one without ever shorter steps.
const TOUCH_SHARE: f32 = 1e-3;

/// A volume to stay out of, with a clearance.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Obstacle {
    /// Where no path may enter.
    pub volume: Volume,
    /// Distance to keep from it in metres, 0 or more.
    pub clearance: f32,
}

impl Obstacle {
    /// Checks the clearance.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field.
    pub fn validate(&self) -> Result<()> {
        check("obstacle.clearance", self.clearance, 0, 1e6)
    }

    /// Whether a point is in the way.
    #[must_use]
    pub fn holds(&self, point: Vec3) -> bool {
        self.volume.contains(point) || self.distance(point) < 0.0
    }

    /// Whether the segment from `a` to `b` stays outside. Steps by the distance to the obstacle
    /// (sphere tracing, Hart 1996), so that no wall is too thin.
    #[must_use]
    pub fn is_free(&self, a: Vec3, b: Vec3) -> bool {
        if self.holds(a) || self.holds(b) {
            return false;
        }
        let length = a.distance(b);
        let touch = TOUCH_SHARE * length;
        let mut along = 0.0;
        while along < length {
            let distance = self.distance(a.lerp(b, along / length));
            if distance < touch {
                return false;
            }
            along += distance;
        }
        true
    }

    /// Distance to the clearance, not too long; negative inside.
    fn distance(&self, point: Vec3) -> f32 {
        // There is none for points that are not finite; those are in the way.
        self.volume.distance(point).unwrap_or(f32::NEG_INFINITY) - self.clearance
    }
}
