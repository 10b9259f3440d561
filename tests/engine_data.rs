//! What engines get of grown trees: collision capsules, occlusion, packed vertices.

#![allow(clippy::unwrap_used)]

use glam::{Vec2, Vec3};
use tree_core::seed::uniform;
use tree_core::{Continuation, Control, Rng, Seed, Skeleton, Tree};
use tree_mesh::collide::{Capsule, CapsuleParams, capsules};
use tree_mesh::occlusion::{OcclusionParams, bake};
use tree_mesh::{Look, Mesh, MeshParams, pack};
use tree_model::path::PRESETS;

fn grow(preset: &tree_model::path::Preset) -> Tree {
    preset.params().unwrap().grow(Seed(3), &Control::default()).unwrap().tree
}

fn build(tree: &Tree) -> Mesh {
    let look = Look::built_in(tree.species()).unwrap();
    tree_mesh::build(tree, &look, &MeshParams::default(), &Control::default()).unwrap().mesh
}

/// Thick wood as (base, tip, radius at the base, radius at the tip), gathered anew.
fn thick(skeleton: &Skeleton, radius_min: f32) -> Vec<(Vec3, Vec3, f32, f32)> {
    let axes = skeleton.axes(Continuation::Thickest);
    let (positions, radii) = (skeleton.positions(), skeleton.radii());
    skeleton
        .segments()
        .map(|(parent, node)| {
            let same = axes.axis_of()[parent as usize] == axes.axis_of()[node as usize];
            let base = if same { radii[parent as usize] } else { radii[node as usize] };
            let (a, b) = (positions[parent as usize], positions[node as usize]);
            (a, b, base, radii[node as usize])
        })
        .filter(|&(a, b, base, tip)| a != b && base.min(tip) >= radius_min)
        .collect()
}

/// Share of the wood in the capsules, by points drawn at random within the frusta.
fn held(wood: &[(Vec3, Vec3, f32, f32)], capsules: &[Capsule], rng: &mut Rng) -> f64 {
    let volume =
        |&(a, b, r, s): &(Vec3, Vec3, f32, f32)| f64::from(a.distance(b) * (r * r + r * s + s * s));
    let total: f64 = wood.iter().map(volume).sum();
    let (mut inside, mut drawn) = (0, 0);
    for frustum in wood {
        let (a, b, r, s) = *frustum;
        let along = (b - a).normalize();
        let across = along.any_orthonormal_vector();
        let up = along.cross(across);
        let share = 30_000.0 * volume(frustum) / total;
        let count = share as u32 + u32::from(f64::from(uniform(rng, 0.0, 1.0)) < share.fract());
        let mut kept = 0;
        while kept < count {
            // Within the cylinder around the frustum, and kept when within the frustum.
            let t = uniform(rng, 0.0, 1.0);
            let wide = r.max(s);
            let (x, y) = (uniform(rng, -wide, wide), uniform(rng, -wide, wide));
            if Vec2::new(x, y).length() > r + (s - r) * t {
                continue;
            }
            kept += 1;
            let p = a + (b - a) * t + across * x + up * y;
            let within = |capsule: &Capsule| {
                let (c, d) = (capsule.a, capsule.b);
                let nearest = (0..=64).map(|i| (c + (d - c) * (i as f32 / 64.0)).distance(p));
                let step = c.distance(d) / 128.0;
                let nearest = nearest.fold(f32::INFINITY, f32::min);
                // The nearest of 65 points is at most half a step off along the core.
                (nearest * nearest - step * step).max(0.0).sqrt() <= capsule.radius
            };
            inside += u32::from(capsules.iter().any(within));
        }
        drawn += count;
    }
    f64::from(inside) / f64::from(drawn.max(1))
}

#[test]
fn at_most_32_capsules_hold_95_percent_of_every_presets_thick_wood() {
    let mut rng = Seed(8).rng();
    for preset in PRESETS {
        let tree = grow(&preset);
        let params = CapsuleParams::default();
        let made = capsules(tree.skeleton(), &params, &Control::default()).unwrap();
        let report = made.report;
        assert!(made.capsules.len() <= 32 && report.is_enough, "{}: {report:?}", preset.name());
        let wood = thick(tree.skeleton(), report.radius_min);
        let found = held(&wood, &made.capsules, &mut rng);
        assert!(found >= 0.95, "{}: {found} {report:?}", preset.name());
        assert!((found - report.held).abs() < 0.02, "{}: {found} {report:?}", preset.name());
        assert!(report.bulk < 8.0, "{}: {report:?}", preset.name());
        println!(
            "{}: {} capsules hold {:.1} % of {} frusta, bulk {:.2}",
            preset.name(),
            made.capsules.len(),
            100.0 * report.held,
            wood.len(),
            report.bulk
        );
    }
}

#[test]
fn grown_trees_are_shaded_inside_and_packed_in_every_layout() {
    let preset = PRESETS.into_iter().next().unwrap();
    let mut mesh = build(&grow(&preset));
    bake(&mut mesh, &OcclusionParams::default(), &Control::default()).unwrap();
    mesh.check().unwrap();
    let textures = pack::pivot_painter::Textures::new(&mesh).unwrap();
    for (number, surface) in mesh.surfaces.iter().enumerate() {
        assert!(surface.occlusion.iter().all(|light| (0.0..=1.0).contains(light)));
        for packed in [
            pack::speedtree8::pack(&mesh, number),
            pack::speedtree9::pack(&mesh, number),
            pack::tree_creator::pack(&mesh, number),
            pack::pivot_painter::pack(&mesh, number, &textures),
            pack::godot::pack(&mesh, number, pack::godot::Precision::Half),
            pack::gltf_wind::pack(&mesh, number),
        ] {
            let packed = packed.unwrap();
            assert_eq!(packed.n_vertices(), surface.positions.len());
            assert_eq!(packed.indices.len(), surface.indices.len());
        }
        let packed = pack::vertex::pack(&mesh, number).unwrap();
        assert_eq!(packed.bytes().len(), 32 * surface.positions.len());
    }
    let lights: Vec<f32> = mesh.surfaces.iter().flat_map(|s| s.occlusion.iter().copied()).collect();
    let dark = lights.iter().filter(|&&light| light < 0.6).count();
    assert!(
        dark * 10 > lights.len(),
        "the inside of a crown is shaded: {dark} of {}",
        lights.len()
    );
}
