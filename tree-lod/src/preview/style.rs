//! What the picture looks like: light, ground, backdrop.

use crate::error::{Result, check_range};
use glam::Vec3;
use std::f32::consts::FRAC_PI_2;

/// Light, ground and backdrop of a picture. The default is a clear day on grass.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    /// Where the sun stands around the trunk, in radians, as [`Framing::yaw`](super::Framing::yaw):
    /// 0 on +Z, a quarter turn on +X. Finite; default -0.35.
    pub sun_yaw: f32,
    /// Height of the sun over the horizon in radians, 0.05 to π/2. Default 0.85.
    pub sun_pitch: f32,
    /// Strength of the sun, 0 (none) to 100. Default 2.3.
    pub sun: f32,
    /// Strength of the sky, 0 (none) to 100. Default 1.
    pub sky: f32,
    /// What the light is multiplied with before the tone curve, 0.01 to 100. Default 1.
    pub exposure: f32,
    /// Sharpness of the sun's shadows: about this many texels squared, 16 to 8192. Cost grows with the
    /// square. Default 2048.
    pub sun_map_px: u32,
    /// From how many directions sky light is taken, 0 (unhindered everywhere) to 64. More gives
    /// smoother shade at a cost of one pass over all triangles each. Default 12.
    pub sky_directions: u32,
    /// Sharpness of the sky's shade: texels squared per direction, 16 to 2048. Default 256.
    pub sky_map_px: u32,
    /// What is behind the mesh.
    pub backdrop: Backdrop,
    /// Height in metres of an endless ground, -1e6 to 1e6, or None for no ground (roots stay
    /// visible). Default 0, the base of the tree.
    pub ground: Option<f32>,
    /// Linear colour of the ground, 0 to 1 each; varied a little over the ground under
    /// [`Backdrop::Sky`].
    pub ground_color: [f32; 3],
}

/// What is behind the mesh, and the light that comes from there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Backdrop {
    /// A clear sky.
    #[default]
    Sky,
    /// Light grey paper under soft white light.
    Studio,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            sun_yaw: -0.35,
            sun_pitch: 0.85,
            sun: 2.3,
            sky: 1.0,
            exposure: 1.0,
            sun_map_px: 2048,
            sky_directions: 12,
            sky_map_px: 256,
            backdrop: Backdrop::Sky,
            ground: Some(0.0),
            ground_color: [0.075, 0.098, 0.032],
        }
    }
}

impl Style {
    /// Light grey paper, with ground.
    #[must_use]
    pub fn studio() -> Self {
        Self {
            backdrop: Backdrop::Studio,
            sun: 1.4,
            sky: 0.7,
            ground_color: [0.48, 0.48, 0.49],
            ..Self::default()
        }
    }

    /// Checks all numbers.
    ///
    /// # Errors
    /// [`LodError::Parameter`](crate::LodError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("style.sun_yaw", self.sun_yaw.into(), -1e6, 1e6)?;
        check_range(
            "style.sun_pitch",
            self.sun_pitch.into(),
            0.05,
            FRAC_PI_2.into(),
        )?;
        check_range("style.sun", self.sun.into(), 0.0, 100.0)?;
        check_range("style.sky", self.sky.into(), 0.0, 100.0)?;
        check_range("style.exposure", self.exposure.into(), 0.01, 100.0)?;
        check_range("style.sun_map_px", self.sun_map_px.into(), 16.0, 8192.0)?;
        check_range(
            "style.sky_directions",
            self.sky_directions.into(),
            0.0,
            64.0,
        )?;
        check_range("style.sky_map_px", self.sky_map_px.into(), 16.0, 2048.0)?;
        if let Some(height) = self.ground {
            check_range("style.ground", height.into(), -1e6, 1e6)?;
        }
        self.ground_color
            .into_iter()
            .try_for_each(|v| check_range("style.ground_color", v.into(), 0.0, 1.0))
    }

    /// Texels of all depth maps together.
    pub(super) fn map_texels(&self) -> u64 {
        let square = |side: u32| u64::from(side) * u64::from(side);
        square(self.sun_map_px) + u64::from(self.sky_directions) * square(self.sky_map_px)
    }

    /// Where the sun is.
    pub(super) fn sun_direction(&self) -> Vec3 {
        let (sin_yaw, cos_yaw) = libm::sincosf(self.sun_yaw);
        let (sin, cos) = libm::sincosf(self.sun_pitch);
        Vec3::new(sin_yaw * cos, sin, cos_yaw * cos)
    }

    /// Linear colour of the sun's light on a surface that faces it.
    pub(super) fn sun_light(&self) -> Vec3 {
        match self.backdrop {
            Backdrop::Sky => Vec3::new(1.0, 0.93, 0.80) * self.sun,
            Backdrop::Studio => Vec3::new(1.0, 0.98, 0.95) * self.sun,
        }
    }

    /// Light from the sky in a direction, as it falls on surfaces.
    pub(super) fn sky_light(&self, direction: Vec3) -> Vec3 {
        let up = direction.y.max(0.0);
        match self.backdrop {
            Backdrop::Sky => {
                let low = (1.0 - up) * (1.0 - up);
                let sky = Vec3::new(0.46, 0.62, 0.95).lerp(Vec3::new(0.98, 0.98, 0.96), low);
                sky * (1.15 * self.sky)
            }
            Backdrop::Studio => Vec3::splat((0.75 + 0.45 * up) * self.sky),
        }
    }

    /// What the camera sees behind everything.
    pub(super) fn backdrop(&self, direction: Vec3, sun: Vec3) -> Vec3 {
        let up = direction.y.clamp(-1.0, 1.0);
        match self.backdrop {
            Backdrop::Sky => {
                let above = up.max(0.0);
                let low = 1.0 / (1.0 + 9.0 * above);
                let sky = Vec3::new(0.060, 0.190, 0.600).lerp(Vec3::new(0.45, 0.63, 0.84), low);
                // Haze around the sun.
                let aside = 1.0 - direction.dot(sun);
                let glow = 0.04 / (0.04 + aside);
                let warm = Vec3::new(1.0, 0.93, 0.80) * (0.16 * glow);
                // Below the horizon, without ground: fades into pale haze.
                (sky + warm) * (1.0 + 0.15 * up.min(0.0))
            }
            Backdrop::Studio => Vec3::splat(0.80 + 0.10 * up),
        }
    }
}
