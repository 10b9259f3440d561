//! A small tree with every column filled, for tests.

use crate::mesh::{Material, Mesh, Surface};
use crate::wind;
use glam::{Vec2, Vec3};
use std::f32::consts::TAU;
use tree_core::{Continuation, Skeleton};

const SIDES: u32 = 8;

/// A trunk, boughs on it, twigs on each bough and so on, `levels` deep.
pub(crate) fn skeleton(levels: u32) -> Skeleton {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.3).unwrap();
    grow(&mut builder, (0, Vec3::ZERO), Vec3::Y, 8.0, 0.3, levels);
    builder.finish()
}

fn grow(
    builder: &mut tree_core::SkeletonBuilder,
    (from, start): (u32, Vec3),
    direction: Vec3,
    length: f32,
    radius: f32,
    levels: u32,
) {
    let mut nodes = vec![(from, start)];
    let mut at = start;
    for step in 1..=6 {
        at += direction * (length / 6.0);
        let below = nodes[step - 1].0;
        nodes.push((builder.add(below, at, radius * (1.0 - 0.12 * step as f32)).unwrap(), at));
    }
    if levels == 0 {
        return;
    }
    for (turn, &node) in nodes[2..6].iter().enumerate() {
        let side = direction.any_orthonormal_vector();
        let (sin, cos) = libm::sincosf(2.4 * turn as f32);
        let out = side * cos + direction.cross(side) * sin;
        let towards = (direction + out).normalize();
        grow(builder, node, towards, 0.45 * length, 0.25 * radius, levels - 1);
    }
}

/// Tubes along every axis, closed by a seam of copies, and three leaf cards at every tip.
pub(crate) fn mesh(levels: u32) -> Mesh {
    let skeleton = skeleton(levels);
    let axes = skeleton.axes(Continuation::Thickest);
    let (positions, radii) = (skeleton.positions(), skeleton.radii());
    let (mut bark, mut leaves) = (Surface::default(), Surface::default());
    for axis in axes.iter() {
        let fork = skeleton.parent(axis.nodes[0]);
        let path: Vec<u32> = fork.into_iter().chain(axis.nodes.iter().copied()).collect();
        let first = bark.positions.len() as u32;
        for (ring, &node) in path.iter().enumerate() {
            let at = positions[node as usize];
            let (next, last) = (path.get(ring + 1), ring.checked_sub(1).map(|ring| path[ring]));
            let along = match (next, last) {
                (Some(&next), _) => positions[next as usize] - at,
                (None, last) => at - positions[last.unwrap_or(node) as usize],
            };
            let radius = radii[node as usize].min(radii[axis.nodes[0] as usize]);
            add_ring(&mut bark, at, along.normalize(), radius, ring as f32, axis.index);
            if ring > 0 {
                add_quads(&mut bark, first + (ring as u32 - 1) * (SIDES + 1));
            }
        }
        let tip = positions[path[path.len() - 1] as usize];
        for leaf in 0..3 {
            add_leaf(&mut leaves, tip, 2.1 * (axis.index + leaf) as f32, axis.index);
        }
    }
    leaves.material = 1;
    let mut mesh = Mesh {
        surfaces: vec![bark, leaves],
        materials: vec![Material::default(), Material::default()],
        branches: wind::branches(&skeleton, &axes),
    };
    fill_light_maps(&mut mesh);
    mesh.check().unwrap();
    mesh
}

fn add_ring(out: &mut Surface, at: Vec3, along: Vec3, radius: f32, v: f32, branch: u32) {
    let first = out.positions.len() as u32;
    let across = along.any_orthonormal_vector();
    for side in 0..=SIDES {
        // The copy at the seam stands at the same bits.
        let angle = TAU * (side % SIDES) as f32 / SIDES as f32;
        let (sin, cos) = libm::sincosf(angle);
        let normal = across * cos + along.cross(across) * sin;
        out.positions.push(at + normal * radius);
        out.normals.push(normal.normalize());
        out.tangents.push(along.cross(normal).normalize().extend(-1.0));
        out.uvs.push(Vec2::new(3.0 * side as f32 / SIDES as f32, -2.5 * v));
        out.occlusion.push(0.5 + 0.5 * cos);
        out.branches.push(branch);
        out.welds.push(first + side % SIDES);
    }
}

fn add_quads(out: &mut Surface, below: u32) {
    for side in 0..SIDES {
        let [a, b] = [below + side, below + side + 1];
        let [c, d] = [a + SIDES + 1, b + SIDES + 1];
        out.indices.extend([a, b, d, a, d, c]);
    }
}

fn add_leaf(out: &mut Surface, anchor: Vec3, turn: f32, branch: u32) {
    let first = out.positions.len() as u32;
    let (sin, cos) = libm::sincosf(turn);
    let (along, across) = (Vec3::new(cos, 0.3, sin).normalize(), Vec3::new(-sin, 0.0, cos));
    for (u, v) in [(0.0, 1.0), (1.0, 1.0), (0.0, 0.0), (1.0, 0.0)] {
        out.positions.push(anchor + along * (0.12 * (1.0 - v)) + across * (0.08 * (u - 0.5)));
        out.normals.push(across.cross(along).normalize());
        out.tangents.push(across.normalize().extend(1.0));
        out.uvs.push(Vec2::new(u, v));
        out.occlusion.push(0.25);
        out.branches.push(branch);
    }
    out.anchors.push(anchor);
    out.indices.extend([0, 1, 3, 0, 3, 2].map(|corner| first + corner));
}

fn fill_light_maps(mesh: &mut Mesh) {
    for surface in &mut mesh.surfaces {
        let count = surface.positions.len().max(1) as f32;
        let rows = 0..surface.positions.len();
        surface.uvs2 =
            rows.map(|row| Vec2::new(row as f32 / count, 1.0 - row as f32 / count)).collect();
    }
}
