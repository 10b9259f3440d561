//! The sky: where it is brightest, and the directions that stand for all of it.

use crate::error::{Result, check};
use glam::Vec3;
use std::f32::consts::PI;
use tree_core::ParameterError;

/// Directions that stand for the sky.
pub(in crate::plastic) const DIRECTIONS: usize = 64;

/// One number for each direction.
pub(in crate::plastic) type Weights = [f32; DIRECTIONS];

/// The light of the sky: intensity cos²(Δσ), Δσ the angle to the brightest point, 0 beyond a right angle and
/// below the horizon.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Sky {
    /// Direction to the brightest point, of any length but 0, not below the horizon. Default up.
    pub light: Vec3,
    /// Factor on all light, 0 to 10. Default 1. At 0 every branch starves but the trunk.
    pub brightness: f32,
}

impl Default for Sky {
    fn default() -> Self {
        Self { light: Vec3::Y, brightness: 1.0 }
    }
}

impl Sky {
    /// A sky that is brightest `elevation` above the horizon (radians, 0 to π/2), in the direction `azimuth` (radians
    /// from +Z towards +X).
    #[must_use]
    pub fn towards(azimuth: f32, elevation: f32) -> Self {
        let flat = libm::cosf(elevation);
        let light = Vec3::new(
            flat * libm::sinf(azimuth),
            libm::sinf(elevation),
            flat * libm::cosf(azimuth),
        );
        Self { light, ..Self::default() }
    }

    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::NotFinite`](crate::ModelError::NotFinite) or [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field.
    pub fn validate(&self) -> Result<()> {
        crate::error::check_finite("sky.light", self.light)?;
        let length = self.light.length();
        if length < 1e-6 || !length.is_finite() {
            let found = f64::from(length);
            let field = "length of sky.light".into();
            return Err(ParameterError { field, found, min: 1e-6, max: 1e18 }.into());
        }
        check("height of sky.light", self.light.y / length, -1e-3, 1.0)?;
        check("sky.brightness", self.brightness, 0.0, 10.0)
    }
}

/// The directions, in columns, seen from a tree: in its own frame.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::plastic) struct Bins {
    pub x: Weights,
    pub y: Weights,
    pub z: Weights,
    /// Share of the light; the sum over the open sky is 1.
    pub weight: Weights,
    /// Brightest direction, unit.
    pub brightest: Vec3,
    /// Away from the ground, unit.
    pub up: Vec3,
    pub brightness: f32,
}

impl Bins {
    /// Mean radius of a direction's share of the sky, in radians: [`DIRECTIONS`] of them fill the lobe of cos².
    pub(super) fn reach() -> f32 {
        (2.0 / 3.0 / DIRECTIONS as f32).sqrt()
    }

    /// `brightest` and `up` in the frame of whoever looks; both of length 1.
    pub(in crate::plastic) fn new(brightest: Vec3, up: Vec3, brightness: f32) -> Self {
        let golden = PI * (3.0 - 5.0_f32.sqrt());
        let (side, fore) = brightest.any_orthonormal_pair();
        let none = [0.0; DIRECTIONS];
        let mut bins = Self { x: none, y: none, z: none, weight: none, brightest, up, brightness };
        let mut above = 0.0_f32;
        for k in 0..DIRECTIONS {
            // cos³ is what is left of the light beyond an angle, so equal steps in it carry equal light.
            let cos = libm::cbrtf(1.0 - (k as f32 + 0.5) / DIRECTIONS as f32);
            let sin = (1.0 - cos * cos).max(0.0).sqrt();
            let turn = golden * k as f32;
            let way =
                brightest * cos + side * (sin * libm::cosf(turn)) + fore * (sin * libm::sinf(turn));
            (bins.x[k], bins.y[k], bins.z[k]) = (way.x, way.y, way.z);
            // The horizon cuts a direction's share as casters do, gradually.
            bins.weight[k] = (0.5 + way.dot(up) / (2.0 * Self::reach())).clamp(0.0, 1.0);
            above += bins.weight[k];
        }
        for weight in &mut bins.weight {
            *weight /= above;
        }
        bins
    }
}
