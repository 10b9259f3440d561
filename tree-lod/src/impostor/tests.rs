//! Meshes for the tests of this module.

use super::boxes::{Bearers, BoxParams, Boxes};
use crate::element::{Elements, Grain, LeafSurfaces};
use glam::{Vec2, Vec3};
use tree_core::{Control, Seed, Skeleton, seed};
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

/// Square leaves, each across a direction of its own, one surface.
pub(crate) fn leaves(at: &[Vec3], half: f32) -> Mesh {
    let mut surface = Surface { anchors: at.to_vec(), ..Surface::default() };
    for (i, &at) in at.iter().enumerate() {
        let normal = seed::unit_vector(&mut Seed(i as u64).rng());
        let (right, up) = normal.any_orthonormal_pair();
        let first = surface.positions.len() as u32;
        for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            surface.positions.push(at + (right * x + up * y) * half);
            surface.normals.push(normal);
            surface.uvs.push(Vec2::new(0.5 + 0.5 * x, 0.5 - 0.5 * y));
        }
        surface.indices.extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
    }
    mesh_of(std::iter::once(surface))
}

/// A tree with its leaves in boxes.
pub(crate) struct Forked {
    pub(crate) skeleton: Skeleton,
    pub(crate) mesh: Mesh,
    pub(crate) elements: Elements,
    pub(crate) bearers: Bearers,
    pub(crate) boxes: Boxes,
}

/// A trunk that forks three ways, and each of those again three ways; leaves around the tips.
pub(crate) fn forked(n_leaves: usize) -> Forked {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.2).unwrap();
    let fork = builder.add(0, Vec3::Y * 2.0, 0.15).unwrap();
    let mut tips = Vec::new();
    for i in 0..3 {
        let (sin, cos) = libm::sincosf(2.1 * i as f32 + 0.4);
        let out = Vec3::new(sin, 0.0, cos);
        let limb = builder.add(fork, Vec3::Y * 3.0 + out * 2.0, 0.1).unwrap();
        for k in 0..3 {
            let (sin, cos) = libm::sincosf(2.1 * k as f32 + i as f32);
            let tip = Vec3::Y * 3.8 + out * 3.0 + Vec3::new(sin, 0.3 * cos, cos);
            tips.push((builder.add(limb, tip, 0.03).unwrap(), tip));
        }
    }
    let skeleton = builder.finish();
    let mut rng = Seed(3).rng();
    let (mut at, mut nodes) = (Vec::new(), Vec::new());
    for i in 0..n_leaves {
        let (node, tip) = tips[i % tips.len()];
        at.push(tip + 0.4 * seed::in_unit_ball(&mut rng));
        nodes.push(node);
    }
    let mesh = leaves(&at, 0.05);
    let control = Control::default();
    let elements = Elements::of_mesh(&mesh, &LeafSurfaces::Found, Grain::Leaf, &control).unwrap();
    let bearers = Bearers(nodes);
    let params = BoxParams { least_volume: 0.001, least_leaves: 10, ..BoxParams::default() };
    let boxes = Boxes::along(&skeleton, &mesh, &elements, &bearers, &params, &control).unwrap();
    Forked { skeleton, mesh, elements, bearers, boxes }
}
