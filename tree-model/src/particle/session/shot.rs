//! Photographs as they go in.

use crate::error::{ModelError, Result};
use crate::particle::attractor::AttractorGraph;
use crate::particle::{AlignParams, Alignment, Camera, Matte, Photo, Projection, align};
use glam::Vec2;

/// Where a photograph was taken from.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Placing {
    /// Base, height and scale are found in the matte; see [`align`](crate::particle::align).
    Aligned {
        /// Where the camera stood around the trunk, in radians: 0 on +Z, a quarter turn on +X.
        yaw: f32,
        /// How far it looked down, in radians; 0 if unknown.
        pitch: f32,
        /// How it projects; orthographic if unknown.
        projection: Projection,
    },
    /// As the caller knows.
    Placed(Camera),
}

impl Placing {
    /// Aligned, from the ground, from afar.
    #[must_use]
    pub const fn at(yaw: f32) -> Self {
        Self::Aligned { yaw, pitch: 0.0, projection: Projection::Orthographic }
    }
}

/// Where a photograph's main branches come from.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Attractor {
    /// Livewire from points on the silhouette.
    #[default]
    Livewire,
    /// Livewire from these points, in pixels.
    Seeds(Vec<Vec2>),
    /// Strokes as a person drew them, in pixels.
    Strokes(Vec<Vec<Vec2>>),
    /// A graph.
    Graph(AttractorGraph),
    /// None: this view's branches are left to chance.
    None,
}

/// One photograph as it goes in.
#[derive(Clone, Debug, PartialEq)]
pub struct Shot {
    /// How much of each pixel the tree covers; see [`matting`](crate::particle::matting).
    pub matte: Matte,
    /// The photograph, of the same size, for livewire; without it, livewire looks at the matte.
    pub photo: Option<Photo>,
    /// Where it was taken from.
    pub placing: Placing,
    /// Its main branches.
    pub attractor: Attractor,
}

impl Shot {
    /// A photograph taken from `yaw` (radians; 0 for the front), with branches by livewire.
    #[must_use]
    pub fn new(matte: Matte, photo: Option<Photo>, yaw: f32) -> Self {
        Self { matte, photo, placing: Placing::at(yaw), attractor: Attractor::Livewire }
    }

    /// Whether its camera is found in the matte.
    pub(super) fn is_aligned(&self) -> bool {
        matches!(self.placing, Placing::Aligned { .. })
    }

    /// Its camera, and what the matte shows of the tree. That must be enough where the camera is to be found
    /// in it; one that the caller knows does without. `view` is its index for errors.
    pub(super) fn place(&self, view: usize, height: f32) -> Result<(Camera, Option<Alignment>)> {
        let known = match self.placing {
            Placing::Placed(camera) => camera,
            // What is not known yet is anything valid.
            Placing::Aligned { yaw, pitch, projection } => {
                Camera { yaw, pitch, projection, size: Vec2::ONE, base: Vec2::ZERO, scale: 1.0 }
            }
        };
        known.validate(&format!("shots[{view}].camera"))?;
        let Camera { yaw, pitch, projection, .. } = known;
        let found = align(&self.matte, &AlignParams { height, yaw, pitch, projection });
        if !self.is_aligned() {
            return Ok((known, found.ok().map(|(_, alignment)| alignment)));
        }
        let (camera, alignment) = found.map_err(|error| error.in_view(view))?;
        Ok((camera, Some(alignment)))
    }

    /// Checks that photograph and matte are of one size; `view` is its index for the error.
    pub(super) fn check(&self, view: usize) -> Result<()> {
        let size = (self.matte.width(), self.matte.height());
        match &self.photo {
            Some(photo) if (photo.width(), photo.height()) != size => Err(ModelError::View {
                view,
                problem: format!(
                    "the photograph is {} × {} pixels and its matte {} × {}; both must be of one size",
                    photo.width(),
                    photo.height(),
                    size.0,
                    size.1
                ),
            }),
            _ => Ok(()),
        }
    }
}
