//! Meshes for the tests of this module.

use glam::{Vec2, Vec3};
use tree_mesh::{Material, Mesh, Surface};

/// A square card across +Z, of this half side.
pub(crate) fn card(at: Vec3, half: f32) -> Surface {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    Surface {
        positions: corners.map(|(x, y)| at + Vec3::new(x, y, 0.0) * half).to_vec(),
        normals: vec![Vec3::Z; 4],
        uvs: corners.map(|(x, y)| Vec2::new(0.5 + 0.5 * x, 0.5 - 0.5 * y)).to_vec(),
        indices: vec![0, 1, 2, 0, 2, 3],
        ..Surface::default()
    }
}

/// Surfaces with one plain material.
pub(crate) fn mesh_of(surfaces: impl Iterator<Item = Surface>) -> Mesh {
    let materials = vec![Material { double_sided: true, ..Material::default() }];
    Mesh { surfaces: surfaces.collect(), materials, ..Mesh::default() }
}
