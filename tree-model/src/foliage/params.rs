//! Parameters of leaf placement.

use super::{LeafForm, Phyllotaxis};
use crate::error::{Result, check, check_finite};
use glam::Vec3;
use std::f32::consts::PI;
use tree_core::ParameterError;

/// Where leaves stand and how they are held. Lengths in metres, angles in radians.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct LeafParams {
    /// Arrangement along the shoot. Default a spiral at the golden angle.
    pub arrangement: Phyllotaxis,
    /// One blade, or leaflets or needles. Default one blade.
    pub form: LeafForm,
    /// Distance between leaf-bearing nodes along the shoot, above 0. Default 0.07.
    pub spacing: f32,
    /// Shoots bear leaves up to this distance from their tip, 0 or more. Default 0.55.
    pub bearing: f32,
    /// Length of a blade (of a full leaflet or needle where the leaf has many), above 0. Default 0.13.
    pub size: f32,
    /// Sizes vary by up to this share either way, 0 to 0.9. Default 0.25.
    pub size_variation: f32,
    /// How much smaller leaves are at the tip than at the lower end of the bearing zone, 0 to 0.9 of
    /// their size; a negative number makes those at the lower end smaller. Default 0.
    pub size_gradient: f32,
    /// Length of the petiole in lengths of the blade, 0 to 100. The blade stands off the shoot by as
    /// much. Default 0: whatever petiole there is belongs to the picture of the leaf.
    pub petiole: f32,
    /// Radius of the petiole in lengths of the blade, 0 to 0.5, for
    /// [`grow_leaves_with_stalks`](super::grow_leaves_with_stalks). Default 0.008.
    pub petiole_radius: f32,
    /// Angle between shoot and petiole, 0 (along the shoot) to π (back along it). Default 0.9.
    pub pitch: f32,
    /// Random deviation of all angles, 0 to π. Default 0.35.
    pub jitter: f32,
    /// How far blades hang: 0 not at all, 1 straight down. The petiole does not hang. Default 0.15.
    pub droop: f32,
    /// How far upper faces turn to the light by rolling about the midrib: 0 not at all, 1 as far as
    /// that brings them. Default 0.6.
    pub phototropism: f32,
    /// Largest angle between petiole and blade, 0 to π: after the roll, the blade turns towards the
    /// light by the share `phototropism` of what is left, but no more than this. Default 0: the midrib
    /// goes on as it was.
    pub lamina_turn: f32,
    /// Where light comes from; any length but 0. Default +Y.
    pub light: Vec3,
    /// Whether each tip bears a leaf that goes on in its direction. Default true.
    pub terminal: bool,
    /// Index into the species' leaf kinds. Default 0.
    pub kind: u16,
}

impl Default for LeafParams {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl LeafParams {
    /// The default of every field, for constants.
    pub const DEFAULT: Self = Self {
        arrangement: Phyllotaxis::GOLDEN,
        form: LeafForm::Simple,
        spacing: 0.07,
        bearing: 0.55,
        size: 0.13,
        size_variation: 0.25,
        size_gradient: 0.0,
        petiole: 0.0,
        petiole_radius: 0.008,
        pitch: 0.9,
        jitter: 0.35,
        droop: 0.15,
        phototropism: 0.6,
        lamina_turn: 0.0,
        light: Vec3::Y,
        terminal: true,
        kind: 0,
    };

    /// Checks all ranges; `n_kinds` is the number of leaf kinds of the species.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) or [`ModelError::NotFinite`](crate::ModelError::NotFinite), naming the field.
    pub fn validate(&self, n_kinds: usize) -> Result<()> {
        self.arrangement.validate("leaves.arrangement")?;
        self.form.validate()?;
        check("leaves.spacing", self.spacing, 1e-4_f32, 1e6)?;
        check("leaves.bearing", self.bearing, 0.0, 1e6)?;
        check("leaves.size", self.size, 1e-6_f32, 1e6)?;
        check("leaves.size_variation", self.size_variation, 0.0, 0.9_f32)?;
        check("leaves.size_gradient", self.size_gradient, -0.9_f32, 0.9_f32)?;
        check("leaves.petiole", self.petiole, 0.0, 100.0)?;
        check("leaves.petiole_radius", self.petiole_radius, 0.0, 0.5)?;
        check("leaves.pitch", self.pitch, 0.0, PI)?;
        check("leaves.jitter", self.jitter, 0.0, PI)?;
        check("leaves.droop", self.droop, 0.0, 1.0)?;
        check("leaves.phototropism", self.phototropism, 0.0, 1.0)?;
        check("leaves.lamina_turn", self.lamina_turn, 0.0, PI)?;
        check_light("leaves.light", self.light)?;
        check("leaves.kind", self.kind, 0.0, n_kinds as f64 - 1.0)
    }
}

/// Checks that a vector has a direction.
pub(super) fn check_light(field: &'static str, light: Vec3) -> Result<()> {
    check_finite(field, light)?;
    if light.try_normalize().is_some() {
        return Ok(());
    }
    let (found, min, max) = (light.length().into(), f32::MIN_POSITIVE.into(), f32::MAX.into());
    Err(ParameterError { field: format!("{field}'s length").into(), found, min, max }.into())
}
