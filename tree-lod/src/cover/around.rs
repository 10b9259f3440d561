//! From where to look.

use crate::error::{Result, check_range};
use crate::preview::{Camera, Framing};
use std::f32::consts::TAU;

/// Views around a model, each of which frames all of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Around {
    /// Directions around the trunk for each pitch, evenly spread, 1 to 360. Default 8.
    pub azimuths: u32,
    /// Where the first stands, in radians. Default 0. Views for measuring should not be those that
    /// an order was made with.
    pub turn: f32,
    /// How far the cameras look down in radians, −π/2 to π/2, each with all azimuths: every next ring
    /// is turned by a share of the step, so that no two stand above each other. Default `[0.0]`.
    pub pitches: Vec<f32>,
    /// Width and height of the masks in pixels, 8 to 4096. Default 512.
    pub size: u32,
    /// Vertical field of view in radians, 0.017 to 2.8, for perspective; none for parallel
    /// projection. Default none.
    pub fov: Option<f32>,
}

impl Default for Around {
    fn default() -> Self {
        Self { azimuths: 8, turn: 0.0, pitches: vec![0.0], size: 512, fov: None }
    }
}

/// Empty share of the picture on each side: scaled leaves reach out of the full model's box.
const MARGIN: f32 = 0.06;
/// Most azimuths.
const AZIMUTHS_MAX: u32 = 360;
/// Most views in all.
const VIEWS_MAX: f64 = 4096.0;
/// Most pitches.
const PITCHES_MAX: usize = 64;

impl Around {
    /// Checks all numbers.
    ///
    /// # Errors
    /// [`LodError::Parameter`](crate::LodError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("around.azimuths", self.azimuths.into(), 1.0, AZIMUTHS_MAX.into())?;
        check_range("around.turn", self.turn.into(), -1e6, 1e6)?;
        check_range("around.pitches.len", self.pitches.len() as f64, 1.0, PITCHES_MAX as f64)?;
        let views = f64::from(self.azimuths) * self.pitches.len() as f64;
        check_range("around.azimuths * pitches", views, 1.0, VIEWS_MAX)?;
        check_range("around.size", self.size.into(), 8.0, 4096.0)?;
        self.cameras().iter().try_for_each(Camera::validate)
    }

    /// The cameras, pitch by pitch.
    #[must_use]
    pub fn cameras(&self) -> Vec<Camera> {
        let step = TAU / self.azimuths.max(1) as f32;
        let rings = self.pitches.len().max(1) as f32;
        let ring = |(ring, &pitch): (usize, &f32)| {
            let turn = self.turn + step * ring as f32 / rings;
            let camera = move |azimuth: u32| {
                Camera::Framed(Framing {
                    yaw: turn + step * azimuth as f32,
                    pitch,
                    fov: self.fov.unwrap_or(Framing::default().fov),
                    margin: MARGIN,
                    orthographic: self.fov.is_none(),
                })
            };
            (0..self.azimuths.min(AZIMUTHS_MAX)).map(camera)
        };
        self.pitches.iter().enumerate().flat_map(ring).collect()
    }
}
