//! Branches that grow in: what a shader does between two levels, in three languages and, as the reference,
//! here. The paper's levels pop, which it names as the one demand of section 2.3 that it misses.

use glam::Vec3;

/// The function in WGSL.
pub const WGSL: &str = include_str!("shaders/grow.wgsl");
/// The function in GLSL, from version 1.30 (desktop) or 3.00 (ES) on.
pub const GLSL: &str = include_str!("shaders/grow.glsl");
/// The function in HLSL, any shader model.
pub const HLSL: &str = include_str!("shaders/grow.hlsl");

/// Where a vertex is drawn at a fractional level: 3.25 draws three paths whole and a quarter of the fourth,
/// drawn together about its fork. `branch` holds the fork and the number of the path, from 0
/// ([`MultiMesh::branches`](super::MultiMesh::branches)).
#[must_use]
pub fn position(position: Vec3, branch: [f32; 4], level: f32) -> Vec3 {
    let [x, y, z, path] = branch;
    let fork = Vec3::new(x, y, z);
    let size = (level - path).clamp(0.0, 1.0);
    fork + size * (position - fork)
}
