//! Where something stands, and how it is turned.

use super::params::scene_error;
use crate::error::Result;
use glam::{Quat, Vec3};

/// Where something stands and how it is turned: a point p of its own frame is at `rotation * p + position` in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Pose {
    /// In metres.
    pub position: Vec3,
    /// A rotation; it need not be of length 1.
    pub rotation: Quat,
}

impl Default for Pose {
    fn default() -> Self {
        Self { position: Vec3::ZERO, rotation: Quat::IDENTITY }
    }
}

impl Pose {
    /// Stands at `position`, not turned.
    #[must_use]
    pub fn at(position: Vec3) -> Self {
        Self { position, ..Self::default() }
    }

    /// The same, with a rotation of length 1.
    ///
    /// # Errors
    /// [`ModelError::Scene`](crate::ModelError::Scene) for numbers that are not finite, farther out than 1000 km, and
    /// a rotation of length 0.
    pub(super) fn checked(self, what: &str) -> Result<Self> {
        if !self.position.is_finite() || self.position.abs().max_element() > 1e6 {
            return Err(scene_error(what, "its position is not finite or beyond 1,000,000 m"));
        }
        let length = self.rotation.length();
        if !(1e-6..1e6).contains(&length) {
            return Err(scene_error(what, "its rotation is not finite or of length 0"));
        }
        // What has length 1 already keeps its bits.
        if (length - 1.0).abs() < 1e-6 {
            return Ok(self);
        }
        Ok(Self { rotation: self.rotation.normalize(), ..self })
    }

    pub(super) fn to_local(self, point: Vec3) -> Vec3 {
        self.rotation.conjugate() * (point - self.position)
    }

    pub(super) fn to_world(self, point: Vec3) -> Vec3 {
        self.rotation * point + self.position
    }
}
