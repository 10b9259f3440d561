//! What a shader does with a pruned model, in three languages and, as the reference, here.
//!
//! | value | where from |
//! |---|---|
//! | `center_rank` | vertex attribute of 4 floats: [`Part::centers`](super::Part::centers) |
//! | `growth`, `lambda`, `fade`, `contrast` | per instance: a [`Level`](super::Level), or a row of [`InstanceLod`](crate::select::InstanceLod) |
//! | `mean` | per part: [`Part::mean`](super::Part::mean), linear |
//!
//! Positions are moved in the model's own space, before wind and the instance's transform. Normals do not
//! change: elements grow evenly in all directions.

use glam::Vec3;

/// The functions in WGSL.
pub const WGSL: &str = include_str!("shaders/prune.wgsl");
/// The functions in GLSL, from version 1.30 (desktop) or 3.00 (ES) on.
pub const GLSL: &str = include_str!("shaders/prune.glsl");
/// The functions in HLSL, any shader model.
pub const HLSL: &str = include_str!("shaders/prune.hlsl");

/// Where a vertex is drawn: moved from the centre of its element by `growth` (a factor on length), and
/// towards it when the element is one of the last, which fade (Cook et al. 2007, "smooth transitions").
///
/// `center_rank` holds the centre and the λ from which on the element is drawn. It has no size there, and
/// its full size `fade` further up. A `fade` of 0: nothing fades.
#[must_use]
pub fn position(
    position: Vec3,
    center_rank: [f32; 4],
    growth: f32,
    lambda: f32,
    fade: f32,
) -> Vec3 {
    let [x, y, z, rank] = center_rank;
    let center = Vec3::new(x, y, z);
    let mut size = growth;
    if fade > 0.0 {
        size *= ((lambda - rank) / fade).clamp(0.0, 1.0);
    }
    center + size * (position - center)
}

/// A linear colour with its contrast lowered, so that few large leaves look no more mottled than many small
/// ones (Cook et al. 2007). To be used on the colour of the leaf, before light.
#[must_use]
pub fn color(color: Vec3, mean: Vec3, contrast: f32) -> Vec3 {
    mean + contrast * (color - mean)
}
