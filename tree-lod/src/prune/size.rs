//! Memory of the buffers.

use super::model::Part;
use tree_mesh::{Mesh, Surface};

/// Bytes of the foliage's buffers before and after pruning was prepared: columns as the mesh has them, 4 bytes an
/// index, and 16 more a vertex for its centre.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sizes {
    /// Indices of the mesh that came in.
    pub indices_before: u64,
    /// Indices of all tiers.
    pub indices_after: u64,
    /// Vertices of the mesh that came in.
    pub vertices_before: u64,
    /// Vertices with copies and centres.
    pub vertices_after: u64,
}

impl Sizes {
    pub(super) fn of(before: &Mesh, after: &Mesh, parts: &[Part]) -> Self {
        let mut sizes = Self::default();
        for part in parts {
            let surface = part.surface as usize;
            let (before, after) = (&before.surfaces[surface], &after.surfaces[surface]);
            sizes.indices_before += 4 * before.indices.len() as u64;
            sizes.indices_after += 4 * after.indices.len() as u64;
            sizes.vertices_before += vertices(before);
            sizes.vertices_after += vertices(after) + size_of_val(&part.centers[..]) as u64;
        }
        sizes
    }
}

fn vertices(surface: &Surface) -> u64 {
    let bytes = size_of_val(&surface.positions[..])
        + size_of_val(&surface.normals[..])
        + size_of_val(&surface.uvs[..])
        + size_of_val(&surface.tangents[..])
        + size_of_val(&surface.uvs2[..])
        + size_of_val(&surface.branches[..])
        + size_of_val(&surface.occlusion[..]);
    bytes as u64
}
