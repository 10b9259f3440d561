//! A tree of given size, made of random leaves around tubes in an ellipsoid: as heavy as a real one.

use std::f32::consts::TAU;
use std::sync::Arc;
use tree_lod::glam::{Quat, Vec2, Vec3};
use tree_lod::tree_core::{Rng, Seed, seed};
use tree_lod::tree_mesh::{Alpha, Material, Mesh, Surface, Texture};

/// Crown of about 10 m across; `n_triangles` in all, 30 % bark and 70 % leaf cards.
pub(crate) fn tree(n_triangles: usize) -> Mesh {
    let mut rng = Seed(1).rng();
    let mut bark = Surface { material: 0, ..Surface::default() };
    let n_tubes = (n_triangles * 3 / 10 / TRIANGLES_PER_TUBE).max(1);
    tube(&mut bark, Vec3::ZERO, Vec3::new(0.0, 6.0, 0.0), 0.25);
    let mut twigs = Vec::new();
    for _ in 1..n_tubes {
        let tip = in_crown(&mut rng);
        let from = Vec3::new(0.0, 2.5, 0.0).lerp(tip, seed::uniform(&mut rng, 0.5, 0.95));
        tube(&mut bark, from, tip, 0.012);
        twigs.push(tip);
    }
    // Leaves stand around the tips, twig by twig, as a modeler would write them.
    let mut leaves = Surface { material: 1, ..Surface::default() };
    let n_leaves = (n_triangles - bark.n_triangles()) / 2;
    for i in 0..n_leaves {
        let tip = twigs.get(i * twigs.len() / n_leaves).copied().unwrap_or(Vec3::Y * 6.0);
        let at = tip + seed::in_unit_ball(&mut rng) * 0.6;
        let spin =
            Quat::from_axis_angle(seed::unit_vector(&mut rng), seed::uniform(&mut rng, 0.0, TAU));
        quad(&mut leaves, at, spin, 0.1);
    }
    Mesh { surfaces: vec![bark, leaves], materials: materials(), ..Default::default() }
}

const SIDES: u32 = 6;
const RINGS: u32 = 6;
const TRIANGLES_PER_TUBE: usize = (2 * SIDES * (RINGS - 1)) as usize;

fn in_crown(rng: &mut Rng) -> Vec3 {
    let p = seed::in_unit_ball(rng);
    // Leaves are denser outside.
    let p = p * (1.0 / p.length().max(0.05)).sqrt();
    Vec3::new(0.0, 6.5, 0.0) + p * Vec3::new(5.0, 4.0, 5.0)
}

fn tube(surface: &mut Surface, from: Vec3, to: Vec3, radius: f32) {
    let first = surface.positions.len() as u32;
    let side = (to - from).normalize().any_orthonormal_vector();
    let other = (to - from).normalize().cross(side);
    for ring in 0..RINGS {
        let t = ring as f32 / (RINGS - 1) as f32;
        for i in 0..=SIDES {
            let u = i as f32 / SIDES as f32;
            let (sin, cos) = Vec2::from_angle(u * TAU).into();
            let normal = side * sin + other * cos;
            surface.positions.push(from.lerp(to, t) + normal * (radius * (1.0 - 0.5 * t)));
            surface.normals.push(normal);
            surface.uvs.push(Vec2::new(u, t * 4.0));
        }
    }
    for ring in 0..RINGS - 1 {
        for i in 0..SIDES {
            let a = first + ring * (SIDES + 1) + i;
            let b = a + SIDES + 1;
            surface.indices.extend([a, a + 1, b, b, a + 1, b + 1]);
        }
    }
}

fn quad(surface: &mut Surface, at: Vec3, spin: Quat, size: f32) {
    let first = surface.positions.len() as u32;
    for (u, v) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
        surface.positions.push(at + spin * Vec3::new(u - 0.5, 0.0, v) * size);
        surface.normals.push(spin * Vec3::Y);
        surface.uvs.push(Vec2::new(u, v));
    }
    surface.indices.extend([0, 2, 1, 0, 3, 2].map(|i| first + i));
}

fn materials() -> Vec<Material> {
    let side = 256_u32;
    let texel = |i: u32| {
        let (x, y) = ((i % side) as f32 / side as f32 - 0.5, (i / side) as f32 / side as f32);
        let width = 1.3 * y * (1.0 - y);
        let vein = (40.0 * y + 60.0 * x.abs()).rem_euclid(8.0) < 1.0 || x.abs() < 0.01;
        let green = if vein { [120, 150, 60] } else { [80, 120, 35] };
        [green[0], green[1], green[2], if x.abs() < width { 255 } else { 0 }]
    };
    let pixels = (0..side * side).flat_map(texel).collect();
    let leaf = Texture { name: "leaf".into(), width: side, height: side, pixels };
    vec![
        Material {
            name: "bark".into(),
            base_color: [0.20, 0.15, 0.11, 1.0],
            ..Material::default()
        },
        Material {
            name: "leaf".into(),
            texture: Some(Arc::new(leaf)),
            alpha: Alpha::Mask(0.5),
            double_sided: true,
            translucency: 0.4,
            roughness: 0.55,
            ..Material::default()
        },
    ]
}
