//! Pictures of a mesh, drawn on the processor: previews a person is glad to look at, and
//! silhouettes.
//!
//! 1. The mesh is checked, its textures get smaller levels (`texture`).
//! 2. Depth maps are drawn from the sun and from directions all over the sky (`shadow`).
//! 3. The picture is drawn in bands of rows: each sample finds its nearest triangle (`visibility`,
//!    `raster`), each triangle seen in a pixel is shaded once, in the middle of its samples
//!    (`shade`), samples are averaged in linear light, and a film curve makes bytes of them.
//!
//! The same mesh and parameters give the same bits on every platform and for any number of threads.
//!
//! ```
//! use tree_lod::preview::{self, Style, View};
//! let (mesh, control) = (tree_mesh::Mesh::default(), tree_core::Control::default());
//! let view = View { width: 64, height: 48, ..View::default() };
//! let picture = preview::render(&mesh, &view, &Style::default(), &control)?;
//! assert_eq!(picture.pixels.len(), 4 * 64 * 48);
//! # Ok::<(), tree_lod::LodError>(())
//! ```

mod camera;
mod picture;
mod project;
mod raster;
mod render;
mod scene;
mod shade;
mod shadow;
mod style;
mod texture;
mod visibility;

#[cfg(test)]
mod robust_tests;
#[cfg(test)]
mod tests;

pub(crate) use camera::Projector;
pub use camera::{Camera, Framing, Lens, Pose};
pub use picture::{Mask, Picture};
pub(crate) use project::Spot;
pub(crate) use project::clip_loose;
pub(crate) use raster::{Band, Filter};
pub use render::{mask, render, silhouette};
pub(crate) use scene::{Pattern, Scene};
pub(crate) use shadow::hemisphere;
pub use style::{Backdrop, Style};
pub(crate) use texture::Srgb;
pub(crate) use visibility::{Part, Stage as Draw};

use crate::error::{Result, check_range};
use tree_core::{Limits, Resource};

/// Size, quality and camera of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// Width in pixels, 1 to 16,384. Default 1024.
    pub width: u32,
    /// Height in pixels, 1 to 16,384. Default 1024.
    pub height: u32,
    /// Samples per pixel in each direction, 1 (jagged) to 4. Cost grows with the square; default 2.
    pub samples: u32,
    /// Where the picture is taken from.
    pub camera: Camera,
}

impl Default for View {
    fn default() -> Self {
        Self { width: 1024, height: 1024, samples: 2, camera: Camera::default() }
    }
}

impl View {
    /// Checks all numbers.
    ///
    /// # Errors
    /// [`LodError::Parameter`](crate::LodError::Parameter) or
    /// [`LodError::Camera`](crate::LodError::Camera), naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("view.width", self.width.into(), 1.0, 16_384.0)?;
        check_range("view.height", self.height.into(), 1.0, 16_384.0)?;
        check_range("view.samples", self.samples.into(), 1.0, 4.0)?;
        self.camera.validate()
    }

    /// Asks `limits` for all samples, and `others` besides.
    fn check_pixels(&self, others: u64, limits: &Limits) -> Result<()> {
        let samples = u64::from(self.samples) * u64::from(self.samples);
        let requested = u64::from(self.width) * u64::from(self.height) * samples;
        Ok(limits.check(Resource::Pixels, requested + others)?)
    }
}
