//! Octahedral impostors: a whole tree as pictures from all sides, the modern alternative to planes.
//!
//! Source: Brucks 2018, "Octahedral impostors", which stores views from the directions of an unfolded
//! octahedron and blends the three nearest; parallax by depth as in Policarpo et al. 2005, "Real-time relief
//! mapping on arbitrary polygonal surfaces".
//!
//! 1. [`OctahedralParams`] and [`Octahedral::bake`]: grid × grid views in parallel projection, each into a
//!    square of two pictures: sRGB colour + alpha, and normal + depth ([`super::texel`]).
//! 2. `map`: which views lie around a direction ([`frames`]), and where each was taken from ([`axes`]).
//! 3. `trace`: a ray of a pixel is followed through the depths of three views at once.
//! 4. [`Octahedral::view`]: the picture of a camera, as the shaders ([`WGSL`], [`GLSL`], [`HLSL`]) draw it.
//!
//! Departures: the three views are chosen for each pixel by its own ray, not once for the tree, and depth is
//! searched, not guessed in one step: near trees are right as well. The views are not blended after each has found its
//! own leaf: at each step all three are asked about one point. One sees it, where the point is on the leaf layer
//! ([`THICKNESS`], [`SLACK`]); one has it hidden behind what it sees, and counts for not quite a half
//! ([`HIDDEN`]); one sees through it, and counts against it. So leaves that one view misses are found by the others, and the
//! layer need not be thick, which would blur outlines (it is the voting of space carving, Kutulakos, Seitz 2000, with
//! three pictures and no voxels). Alpha is the most that is found along the ray. A
//! view is as wide and high as an upright cylinder around the tree looks, not as the ball: slender trees get
//! more texels.
//!
//! Cost: see [`Octahedral::bake`]. At the default size both pictures are 33.6 MB in memory (21 MB with
//! [`OctahedralParams::half_detail`]) and 11 to 15 MB as PNG files. Drawing takes up to 3 × [`STEPS`] texels
//! of depth and of alpha a pixel.

mod make;
mod map;
mod meta;
mod shader;
mod trace;
mod view;

pub use make::OctahedralParams;
pub use map::{axes, decode, encode, frames};
pub use meta::OctahedralMeta;
pub use shader::{GLSL, HLSL, WGSL};
pub use trace::{HIDDEN, SLACK, STEPS, THICKNESS};

use crate::preview::Picture;

/// A tree as pictures from all sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Octahedral {
    /// Sizes and places.
    pub meta: OctahedralMeta,
    /// sRGB colour without light, and alpha: the covered share. View (column, row) begins at
    /// (column, row) × `meta.tile` texels.
    pub color: Picture,
    /// Normal in the space of the tree, −1 to 1 as 0 to 255, and depth, −`radius` to `radius`
    /// towards the viewer, likewise.
    pub detail: Picture,
    /// What went in and came out.
    pub report: OctahedralReport,
}

/// What was baked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OctahedralReport {
    /// Number of views.
    pub n_views: usize,
    /// Triangles drawn in each.
    pub n_triangles: usize,
    /// Texels covered at least by half, of all views.
    pub covered: u64,
    /// Bytes of both pictures, as they are in memory.
    pub bytes: usize,
}

#[cfg(test)]
mod tests;
