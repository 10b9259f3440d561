//! Parameters of leaf placement.

use super::Phyllotaxis;
use crate::error::{Result, check};
use std::f32::consts::PI;

/// Where leaves stand and how they are held. Lengths in metres, angles in radians.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct LeafParams {
    /// Arrangement along the shoot. Default a spiral at the golden angle.
    pub arrangement: Phyllotaxis,
    /// Distance between leaf-bearing nodes along the shoot, above 0. Default 0.07.
    pub spacing: f32,
    /// Shoots bear leaves up to this distance from their tip, 0 or more. Default 0.55.
    pub bearing: f32,
    /// Length of a leaf, above 0. Default 0.13.
    pub size: f32,
    /// Sizes vary by up to this share either way, 0 to 0.9. Default 0.25.
    pub size_variation: f32,
    /// Angle between shoot and midrib, 0 (along the shoot) to π (back along it). Default 0.9.
    pub pitch: f32,
    /// Random deviation of all angles, 0 to π. Default 0.35.
    pub jitter: f32,
    /// How far leaves hang: 0 not at all, 1 straight down. Default 0.15.
    pub droop: f32,
    /// How far upper faces turn to the sky: 0 not at all, 1 wholly. Default 0.6.
    pub phototropism: f32,
    /// Whether each tip bears a leaf that goes on in its direction. Default true.
    pub terminal: bool,
    /// Index into the species' leaf kinds. Default 0.
    pub kind: u16,
}

impl Default for LeafParams {
    fn default() -> Self {
        Self {
            arrangement: Phyllotaxis::default(),
            spacing: 0.07,
            bearing: 0.55,
            size: 0.13,
            size_variation: 0.25,
            pitch: 0.9,
            jitter: 0.35,
            droop: 0.15,
            phototropism: 0.6,
            terminal: true,
            kind: 0,
        }
    }
}

impl LeafParams {
    /// Checks all ranges; `n_kinds` is the number of leaf kinds of the species.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field.
    pub fn validate(&self, n_kinds: usize) -> Result<()> {
        match self.arrangement {
            Phyllotaxis::Spiral { divergence } => {
                check("leaves.arrangement.divergence", divergence, -2.0 * PI, 2.0 * PI)?;
            }
            Phyllotaxis::Whorled { count } => check("leaves.arrangement.count", count, 3, 64)?,
            _ => {}
        }
        check("leaves.spacing", self.spacing, 1e-4, 1e6)?;
        check("leaves.bearing", self.bearing, 0.0, 1e6)?;
        check("leaves.size", self.size, 1e-6, 1e6)?;
        check("leaves.size_variation", self.size_variation, 0.0, 0.9)?;
        check("leaves.pitch", self.pitch, 0.0, PI)?;
        check("leaves.jitter", self.jitter, 0.0, PI)?;
        check("leaves.droop", self.droop, 0.0, 1.0)?;
        check("leaves.phototropism", self.phototropism, 0.0, 1.0)?;
        check("leaves.kind", self.kind, 0.0, n_kinds as f64 - 1.0)
    }
}
