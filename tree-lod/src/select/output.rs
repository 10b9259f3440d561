//! What a graphics processor reads: draw arguments, and a row for each drawn instance.

use bytemuck::{Pod, Zeroable};

/// Arguments of an indexed indirect draw, laid out as Vulkan, Direct3D 12, WebGPU and Metal take them.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Pod, Zeroable)]
pub struct DrawIndexed {
    /// Number of indices.
    pub index_count: u32,
    /// Number of instances, never 0.
    pub instance_count: u32,
    /// First index.
    pub first_index: u32,
    /// Added to each index.
    pub base_vertex: i32,
    /// Row of the first instance in the buffer of [`InstanceLod`].
    pub first_instance: u32,
}

/// How an instance is drawn in this frame, 20 bytes.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct InstanceLod {
    /// Number of the instance in the scene.
    pub instance: u32,
    /// Factor on the *length* of each element about its centre: √s.
    pub scale: f32,
    /// Share of the foliage's triangles, 0 to 1. It moves smoothly; the window drawn holds at least as much.
    pub lambda: f32,
    /// Width in λ of the end of the order that is fading: an element of rank u (0 first, 1 last) has the
    /// size clamp((λ − u) / fade, 0, 1). 0 where nothing fades: the full model.
    pub fade: f32,
    /// Factor on the contrast of colours that keeps its variance in the picture (Cook et al. 2007).
    pub contrast: f32,
}

/// How much was written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Written {
    /// Draws.
    pub draws: usize,
    /// Rows of instances.
    pub instances: usize,
}
