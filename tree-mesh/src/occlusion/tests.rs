use super::*;
use crate::MeshError;
use crate::mesh::Material;
use crate::sample;
use tree_core::{CancelFlag, Limits};

fn baked(mut mesh: Mesh, params: &OcclusionParams) -> Mesh {
    bake(&mut mesh, params, &Control::default()).unwrap();
    mesh.check().unwrap();
    mesh
}

/// One leaf, a card of this half side at this place; vertices do not belong to a seam.
fn card(surface: &mut Surface, at: Vec3, half: f32) {
    let first = surface.positions.len() as u32;
    for (x, z) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)] {
        surface.positions.push(at + Vec3::new(x, 0.0, z) * half);
        surface.normals.push(Vec3::Y);
        surface.uvs.push(glam::Vec2::ZERO);
    }
    surface.anchors.push(at);
    surface.indices.extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
}

fn mesh_of(surfaces: Vec<Surface>) -> Mesh {
    Mesh { surfaces, materials: vec![Material::default()], ..Mesh::default() }
}

#[test]
fn values_lie_within_0_and_1_and_copies_are_equal() {
    let mesh = baked(sample::mesh(3), &OcclusionParams::default());
    for surface in &mesh.surfaces {
        assert_eq!(surface.occlusion.len(), surface.positions.len());
        assert!(surface.occlusion.iter().all(|light| (0.0..=1.0).contains(light)));
    }
    let bark = &mesh.surfaces[0];
    for (vertex, &first) in bark.welds.iter().enumerate() {
        assert_eq!(bark.occlusion[vertex].to_bits(), bark.occlusion[first as usize].to_bits());
    }
}

#[test]
fn a_lonely_leaf_is_bright_and_the_middle_of_a_crown_is_dark() {
    let mut lonely = Surface::default();
    card(&mut lonely, Vec3::ZERO, 0.05);
    card(&mut lonely, Vec3::X * 5.0, 0.05);
    let params = OcclusionParams { ground: 1.0, ..OcclusionParams::default() };
    let lonely = baked(mesh_of(vec![lonely]), &params);
    assert!(lonely.surfaces[0].occlusion.iter().all(|&light| light > 0.9));

    let mut ball = Surface::default();
    let seed = tree_core::Seed(4);
    for leaf in 0..20_000 {
        let p = [0, 1, 2].map(|axis| 2.0 * seed.child(leaf).unit(axis) - 1.0);
        let p = Vec3::from_array(p);
        if p.length() < 1.0 {
            card(&mut ball, p * 3.0, 0.06);
        }
    }
    let ball = baked(mesh_of(vec![ball]), &params);
    let mean = |low: f32, high: f32| {
        let surface = &ball.surfaces[0];
        let within = |p: &Vec3| (low..high).contains(&p.length());
        let lights = surface.positions.iter().zip(&surface.occlusion).filter(|(p, _)| within(p));
        let lights: Vec<f32> = lights.map(|(_, &light)| light).collect();
        lights.iter().sum::<f32>() / lights.len() as f32
    };
    let [inner, middle, outer] = [mean(0.0, 1.0), mean(1.5, 2.0), mean(2.8, 3.1)];
    assert!(inner < middle && middle < outer, "{inner} {middle} {outer}");
    // From the middle light meets opacity / 2 of the leaves' area over three metres.
    let area = ball.surfaces[0].anchors.len() as f32 * 0.12 * 0.12;
    let density = area / (4.0 / 3.0 * std::f32::consts::PI * 27.0);
    let wanted = libm::expf(-density * 0.25 * 3.0);
    assert!((inner - wanted).abs() < 0.06, "{inner} {wanted}");
    assert!(outer > inner + 0.2, "{inner} {outer}");
}

/// Beer and Lambert: light falls off as exp(−area per m² × opacity / 2 × way).
#[test]
fn a_deep_layer_of_leaves_dims_light_as_the_law_says() {
    let mut slab = Surface::default();
    let seed = tree_core::Seed(9);
    for leaf in 0..60_000 {
        let p = [0, 1, 2].map(|axis| seed.child(leaf).unit(axis) - 0.5);
        card(&mut slab, Vec3::new(20.0 * p[0], 2.0 * p[1], 20.0 * p[2]), 0.04);
    }
    let grid_of = |mesh: &Mesh| {
        let mut grid = Grid::over(mesh.bounds(), 96).unwrap();
        grid.allocate();
        grid.add(&mesh.surfaces[0], 0.5, &Control::default()).unwrap();
        grid.finish();
        grid
    };
    let mesh = mesh_of(vec![slab]);
    let grid = grid_of(&mesh);
    // Area 60,000 × 0.08² over 400 m², times opacity and mean cover.
    let wanted = libm::expf(-60_000.0 * 0.0064 / 400.0 * 0.25);
    let mut arrived = Vec::new();
    sweep::carry(&grid, Vec3::Y, &mut arrived);
    let [sx, _, sz] = grid.strides();
    let bottom: Vec<f32> = (30..60)
        .flat_map(|x| (30..60).map(move |z| (x, z)))
        .map(|(x, z)| arrived[x * sx + z * sz])
        .collect();
    let mean = bottom.iter().sum::<f32>() / bottom.len() as f32;
    assert!((mean - wanted).abs() < 0.02, "{mean} {wanted}");
}

#[test]
fn wood_below_a_roof_is_darker_than_wood_above_it() {
    let mut mesh = sample::mesh(0);
    mesh.surfaces.truncate(1);
    let mut roof = Surface::default();
    card(&mut roof, Vec3::Y * 5.0, 4.0);
    mesh.surfaces.push(roof);
    let params = OcclusionParams { leaf_opacity: 1.0, ..OcclusionParams::default() };
    let mesh = baked(mesh, &params);
    let bark = &mesh.surfaces[0];
    let at = |low: f32, high: f32| {
        let rows = bark.positions.iter().zip(&bark.occlusion);
        let lights: Vec<f32> =
            rows.filter(|(p, _)| (low..high).contains(&p.y)).map(|(_, &light)| light).collect();
        lights.iter().sum::<f32>() / lights.len() as f32
    };
    assert!(at(3.9, 4.9) + 0.1 < at(6.0, 7.0), "{} {}", at(3.9, 4.9), at(6.0, 7.0));
}

#[test]
fn threads_change_no_bit() {
    let bake_on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| baked(sample::mesh(2), &OcclusionParams::default()))
    };
    assert_eq!(bake_on(1), bake_on(3));
}

#[test]
fn bad_requests_are_refused_and_change_nothing() {
    let mut mesh = sample::mesh(1);
    let before = mesh.clone();
    let control = Control::default();
    type Change = fn(&mut OcclusionParams);
    let changes: [Change; 4] =
        [|p| p.cells = 3, |p| p.directions = 0, |p| p.leaf_opacity = f32::NAN, |p| p.ground = 1.5];
    for change in changes {
        let mut params = OcclusionParams::default();
        change(&mut params);
        assert!(matches!(bake(&mut mesh, &params, &control), Err(MeshError::Parameter(_))));
    }
    let params = OcclusionParams::default();
    let tight = Control::default().with_limits(Limits { voxels: 1000, ..Limits::default() });
    assert!(matches!(bake(&mut mesh, &params, &tight), Err(MeshError::Limit(_))));
    let stop = CancelFlag::default();
    stop.cancel();
    let stopped = Control::default().with_cancel(stop);
    assert!(matches!(bake(&mut mesh, &params, &stopped), Err(MeshError::Cancelled(_))));
    assert_eq!(mesh, before);
}

#[test]
fn a_mesh_without_extent_is_open() {
    let mut empty = Mesh::default();
    bake(&mut empty, &OcclusionParams::default(), &Control::default()).unwrap();
    let mut point = Surface::default();
    card(&mut point, Vec3::ZERO, 0.0);
    let point = baked(mesh_of(vec![point]), &OcclusionParams::default());
    assert_eq!(point.surfaces[0].occlusion, [1.0; 4]);
    for (at, extent) in [(0.0, 1e-20), (0.0, 1e30), (1e6, 0.1)] {
        let mut odd = Surface::default();
        card(&mut odd, Vec3::splat(at), extent);
        let odd = baked(mesh_of(vec![odd]), &OcclusionParams::default());
        assert_eq!(odd.surfaces[0].occlusion, [1.0; 4]);
    }
}
