//! Six diagonal planes for each box, with pictures of its leaves (Lluch et al. 2010, §4.2.2, Fig. 3a).
//!
//! 1. [`planes`]: the planes through opposite edges of a box, two for each of its axes.
//! 2. [`Cards::bake`]: the leaves of each box are projected onto its planes, 64² or 128² texels each,
//!    whatever the size of the box (§4.2.3), and packed into an atlas.
//! 3. [`weights`]: how much each plane faces the viewer; smooth, and of sum 1 (§4.2.4, "blending to obtain
//!    smooth transition").
//! 4. [`Cards::mesh`]: the planes of any boxes as a mesh; [`Cards::to_glb`] with what a shader
//!    ([`WGSL`], [`GLSL`], [`HLSL`]) needs besides.
//! 5. [`Cards::plain`]: what to draw where there is no shader: light in the picture, normals of a crown, three
//!    planes of each box.
//! 6. [`Cards::view`]: the picture of a camera, as the shaders draw it.
//!
//! Departure: the paper adjusts the alpha of the planes. Several half-transparent planes cover more than one
//! opaque one, and need sorting. Here each pixel picks one plane of a box by a pattern, in
//! proportion to the weights ([`interval`]): coverage is the mean of the planes', whatever their number, and
//! nothing is sorted.

mod crown;
#[cfg(feature = "gltf")]
mod gltf;
mod make;
mod mesh;
mod plain;
mod plane;
mod shader;
#[cfg(test)]
mod tests;
mod view;
mod weight;

pub use make::{CardParams, CardReport};
pub use plain::PLAIN;
pub use plane::{Plane, planes};
pub use shader::{GLSL, HLSL, WGSL};
pub use weight::{interval, noise, weights};

use super::boxes::Boxes;
use crate::preview::Picture;

/// Planes of a box.
pub const PLANES: usize = 6;

/// Boxes with pictures on their planes.
#[derive(Clone, Debug, PartialEq)]
pub struct Cards {
    boxes: Boxes,
    /// sRGB colour without light, and alpha: the covered share.
    pub color: Picture,
    /// Normal in the space of the tree, −1 to 1 as 0 to 255, and depth: from −[`reach`](Plane::reach) to it,
    /// on the side that the plane's normal points to.
    pub detail: Picture,
    size: u32,
    gutter: u32,
    columns: u32,
    report: CardReport,
    crown: crown::Crown,
    /// For each box.
    leaf_sizes: Vec<f32>,
    lit: plain::Lit,
}

impl Cards {
    /// The boxes, in the order of the tiles.
    #[must_use]
    pub fn boxes(&self) -> &Boxes {
        &self.boxes
    }

    /// Side of a tile in texels, gutters included.
    #[must_use]
    pub fn size(&self) -> u32 {
        self.size
    }

    /// What was baked.
    #[must_use]
    pub fn report(&self) -> CardReport {
        self.report
    }

    /// Metres of a texel of a box's pictures: the largest of its planes.
    ///
    /// # Errors
    /// [`LodError::Impostor`](crate::LodError::Impostor) when there is no such box.
    pub fn texel(&self, number: u32) -> crate::error::Result<f32> {
        let longest = |plane: &Plane| 2.0 * plane.half.max_element();
        let size = planes(self.boxes.get(number)?).iter().map(longest).fold(0.0, f32::max);
        Ok(size / self.inner())
    }

    /// Side in metres of a square as large as a box's mean leaf.
    pub(crate) fn leaf_size(&self, number: u32) -> f32 {
        self.leaf_sizes.get(number as usize).copied().unwrap_or(f32::INFINITY)
    }

    /// Texels of a tile without gutters.
    fn inner(&self) -> f32 {
        (self.size - 2 * self.gutter) as f32
    }

    /// First column and row of a tile in the atlas.
    fn origin(&self, number: u32, plane: usize) -> [u32; 2] {
        let tile = number * PLANES as u32 + plane as u32;
        [tile % self.columns * self.size, tile / self.columns * self.size]
    }
}
