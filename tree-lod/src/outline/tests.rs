use super::*;
use crate::cover::{Around, score};
use crate::element::{Elements, Grain, LeafSurfaces};
use crate::error::LodError;
use crate::quality::Score;
use glam::{Quat, Vec2, Vec3};
use proptest::prelude::*;
use std::sync::Arc;
use tree_core::Control;
use tree_mesh::{Alpha, Look, Material, Mesh, Surface, Texture};

/// Half the width of an ovate leaf at four heights.
const WIDTHS: [f32; 4] = [0.25, 0.33, 0.28, 0.17];

fn finished(positions: Vec<Vec3>, indices: Vec<u32>) -> Surface {
    let n = positions.len();
    let (normals, uvs) = (vec![Vec3::Z; n], vec![Vec2::ZERO; n]);
    Surface { positions, indices, normals, uvs, ..Surface::default() }
}

/// A leaf of 16 triangles with a midrib, whose halves stand up and which bends.
fn leaf(widths: [f32; 4], fold: f32, bend: f32) -> Surface {
    let place = |x: f32, y: f32| Vec3::new(x, y, fold * x.abs() - bend * y * y);
    let mut positions = vec![Vec3::ZERO];
    for (row, w) in widths.iter().enumerate() {
        positions.extend([-w, 0.0, *w].map(|x| place(x, 0.2 * (row + 1) as f32)));
    }
    positions.push(place(0.0, 1.0));
    let mut indices = vec![0, 2, 1, 0, 3, 2, 10, 11, 13, 11, 12, 13];
    for a in [1, 2, 4, 5, 7, 8] {
        indices.extend([a, a + 1, a + 4, a, a + 4, a + 3]);
    }
    finished(positions, indices)
}

fn ovate() -> Surface {
    leaf(WIDTHS, 0.0, 0.0)
}

fn quad() -> Surface {
    let positions = [Vec3::ZERO, Vec3::X, Vec3::ONE, Vec3::Y].map(|p| p.with_z(0.0)).to_vec();
    finished(positions, vec![0, 1, 2, 0, 2, 3])
}

fn mesh(surfaces: Vec<Surface>) -> Mesh {
    Mesh { surfaces, materials: vec![Material::default()], ..Mesh::default() }
}

/// Copies of a leaf, turned and scaled.
fn copies(leaf: &Surface, n: usize) -> Surface {
    let mut out = Surface::default();
    for i in 0..n {
        let turn = Quat::from_rotation_y(i as f32) * Quat::from_rotation_x(0.7 * i as f32);
        let (at, size) = (Vec3::X * 2.0 * i as f32, 1.0 + 0.1 * (i % 5) as f32);
        let first = out.positions.len() as u32;
        out.positions.extend(leaf.positions.iter().map(|&p| at + turn * p * size));
        out.indices.extend(leaf.indices.iter().map(|v| first + v));
    }
    finished(out.positions, out.indices)
}

fn split(mesh: &Mesh) -> Elements {
    let all = LeafSurfaces::Surfaces((0..mesh.surfaces.len() as u32).collect());
    Elements::of_mesh(mesh, &all, Grain::Blade, &Control::default()).unwrap()
}

fn tiers_of(mesh: &Mesh) -> Vec<Tier> {
    tiers(mesh, &split(mesh), &OutlineParams::default(), &Control::default()).unwrap()
}

fn costs(tiers: &[Tier]) -> Vec<u32> {
    tiers.iter().map(|tier| tier.cost(0)).collect()
}

fn cross(surface: &Surface, triangle: [u32; 3]) -> Vec3 {
    let [a, b, c] = triangle.map(|v| surface.positions[v as usize]);
    0.5 * (b - a).cross(c - a)
}

/// The first element in a tier, grown about its centre to the area that it has in full.
fn grown(mesh: &Mesh, tier: &Tier) -> Mesh {
    let elements = split(mesh);
    let mut surface = mesh.surfaces[0].clone();
    let area: f32 = tier.of(0).iter().map(|&t| cross(&surface, t).length()).sum();
    let growth = (elements.areas[0] / area).sqrt();
    let center = elements.centers[0];
    surface.positions.iter_mut().for_each(|p| *p = center + (*p - center) * growth);
    surface.indices = tier.of(0).concat();
    Mesh { surfaces: vec![surface], ..mesh.clone() }
}

/// Pixels seen of both against those seen of either, over all views.
fn overlap(mesh: &Mesh, tier: &Tier, around: &Around) -> f64 {
    let cameras = around.cameras();
    let scores = score(&grown(mesh, tier), mesh, &cameras, 128, &Control::default()).unwrap();
    let Score { both, wrong, missed } = scores.into_iter().sum();
    both as f64 / (both + wrong + missed) as f64
}

#[test]
fn an_ovate_leaf_keeps_its_outline() {
    let mesh = mesh(vec![ovate()]);
    let tiers = tiers_of(&mesh);
    assert_eq!(costs(&tiers), [16, 8, 4, 2, 1]);
    let front = Around { azimuths: 1, ..Around::default() };
    for (tier, least) in tiers.iter().zip([1.0, 0.99, 0.91, 0.85, 0.65]) {
        let overlap = overlap(&mesh, tier, &front);
        assert!(overlap >= least, "{} triangles: {overlap}", tier.cost(0));
    }
}

#[test]
fn a_folded_leaf_stays_folded_from_all_sides() {
    let mesh = mesh(vec![leaf(WIDTHS, 0.5, 0.3)]);
    let around = Around { pitches: vec![-1.0, -0.3, 0.5, 1.2], turn: 0.3, ..Around::default() };
    for (tier, least) in tiers_of(&mesh).iter().zip([1.0, 0.93, 0.84, 0.74, 0.5]) {
        let overlap = overlap(&mesh, tier, &around);
        assert!(overlap >= least, "{} triangles: {overlap}", tier.cost(0));
    }
}

#[test]
fn leaves_that_are_alike_get_the_same_triangles() {
    let mesh = mesh(vec![copies(&leaf(WIDTHS, 0.3, 0.2), 40)]);
    for tier in tiers_of(&mesh) {
        for element in 1..40 {
            let own: Vec<_> =
                tier.of(element).iter().map(|t| t.map(|v| v - 14 * element as u32)).collect();
            assert_eq!(own, tier.of(0));
        }
    }
}

#[test]
fn blades_of_a_compound_leaf_share_its_triangles_by_area() {
    let (large, mut small) = (ovate(), ovate());
    small.positions.iter_mut().for_each(|p| *p = *p * 0.3 + Vec3::X);
    let n = large.positions.len() as u32;
    let both = [large.positions, small.positions].concat();
    let indices = large.indices.iter().copied().chain(small.indices.iter().map(|v| n + v));
    let mut surface = finished(both, indices.collect());
    surface.anchors = vec![Vec3::ZERO];
    let mesh = mesh(vec![surface]);
    let elements =
        Elements::of_mesh(&mesh, &LeafSurfaces::Found, Grain::Leaf, &Control::default()).unwrap();
    let tiers = tiers(&mesh, &elements, &OutlineParams::default(), &Control::default()).unwrap();
    let of_small = |tier: &Tier| tier.of(0).iter().filter(|t| t[0] >= n).count();
    assert!(tiers.iter().all(|tier| tier.of(0).len() >= 2 * of_small(tier)));
    assert_eq!(costs(&tiers).last(), Some(&2));
    assert_eq!(tiers.last().map(of_small), Some(1), "as long as there are enough, all get one");
}

#[test]
fn cards_with_a_mask_stay_whole_and_plain_ones_do_not() {
    let plain = mesh(vec![quad()]);
    assert_eq!(costs(&tiers_of(&plain)), [2, 1]);
    let pixels = vec![255; 4];
    let mut masked = plain;
    masked.materials[0] = Material {
        alpha: Alpha::Mask(0.5),
        texture: Some(Arc::new(Texture { name: "leaf".into(), width: 1, height: 1, pixels })),
        ..Material::default()
    };
    assert_eq!(costs(&tiers_of(&masked)), [2]);
}

#[test]
fn an_element_without_area_keeps_its_triangles() {
    let mut flat = ovate();
    flat.positions.fill(Vec3::Y);
    let tiers = tiers_of(&mesh(vec![flat, ovate()]));
    assert!(tiers.len() > 1 && tiers.iter().all(|tier| tier.cost(0) == 16));
}

#[test]
fn a_thin_tube_is_simplified_too() {
    let ring =
        |y: f32| [(0.02, 0.0), (-0.01, -0.017), (-0.01, 0.017)].map(|(x, z)| Vec3::new(x, y, z));
    let positions = [ring(0.0), ring(1.0)].concat();
    let indices = vec![0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 2, 0, 3, 2, 3, 5];
    assert_eq!(costs(&tiers_of(&mesh(vec![finished(positions, indices)]))), [6, 3, 2, 1]);
}

#[test]
fn a_ball_stays_closed_enough_to_be_seen_from_everywhere() {
    let mut ball = finished(Vec::new(), Vec::new());
    let point = |i: u32, j: u32| {
        let (a, b) = (i as f32 * std::f32::consts::PI / 6.0, j as f32 * std::f32::consts::PI / 6.0);
        Quat::from_rotation_y(b) * Quat::from_rotation_x(a) * Vec3::Y
    };
    let at = |i: u32, j: u32| match i {
        0 => 0,
        6 => 61,
        _ => 1 + (i - 1) * 12 + j % 12,
    };
    ball.positions.push(Vec3::Y);
    for i in 1..6 {
        ball.positions.extend((0..12).map(|j| point(i, j)));
    }
    ball.positions.push(Vec3::NEG_Y);
    for j in 0..12 {
        ball.indices.extend([0, at(1, j), at(1, j + 1), 61, at(5, j + 1), at(5, j)]);
        for i in 1..5 {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            ball.indices.extend([a, b, c, a, c, d]);
        }
    }
    let mesh = mesh(vec![finished(ball.positions, ball.indices)]);
    let around = Around { pitches: vec![-0.7, 0.7], ..Around::default() };
    for (tier, least) in tiers_of(&mesh).iter().zip([1.0, 0.9, 0.8, 0.7]) {
        let overlap = overlap(&mesh, tier, &around);
        assert!(overlap >= least, "{} triangles: {overlap}", tier.cost(0));
    }
}

#[test]
fn lobed_leaves_of_the_looks_keep_their_lobes() {
    let species = tree_core::Species { leaf_kinds: vec!["maple".into()], ..Default::default() };
    let mut look = Look::built_in(&species).unwrap().leaves.remove(0);
    look.form = tree_mesh::LeafForm::Modelled { max_vertices: 20 };
    let leaf = look.model().unwrap().mesh;
    let mesh = mesh(vec![finished(leaf.positions.clone(), leaf.indices.clone())]);
    let front = Around { azimuths: 1, ..Around::default() };
    let tiers = tiers_of(&mesh);
    let overlaps: Vec<f64> = tiers.iter().map(|tier| overlap(&mesh, tier, &front)).collect();
    assert!(overlaps[1] > 0.9 && overlaps[2] > 0.8, "{overlaps:?}");
}

#[test]
fn elements_of_another_mesh_and_shares_that_rise_are_refused() {
    let (one, two) = (mesh(vec![quad()]), mesh(vec![ovate()]));
    let of = |mesh: &Mesh, params: &OutlineParams| {
        tiers(mesh, &split(&two), params, &Control::default())
    };
    assert!(matches!(of(&one, &OutlineParams::default()), Err(LodError::Foliage(_))));
    for shares in [vec![0.2, 0.5], vec![f32::NAN], vec![1.5], vec![0.1; 17]] {
        let params = OutlineParams { shares, ..OutlineParams::default() };
        assert!(matches!(of(&two, &params), Err(LodError::Parameter(_))));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn tiers_have_fewer_triangles_of_own_vertices_that_face_as_before(
        widths in prop::array::uniform4(0.1_f32..0.5),
        fold in 0.0_f32..0.8,
        bend in 0.0_f32..0.6,
    ) {
        let mesh = mesh(vec![leaf(widths, fold, bend)]);
        let elements = split(&mesh);
        let tiers = tiers_of(&mesh);
        let within = |(cost, most): (u32, u32)| (1..=most).contains(&cost);
        prop_assert!(costs(&tiers).into_iter().zip([16, 8, 4, 2, 1]).all(within));
        for tier in &tiers {
            let crosses = tier.of(0).iter().map(|&t| cross(&mesh.surfaces[0], t));
            prop_assert!(tier.triangles.as_flattened().iter().all(|&v| v < 14));
            prop_assert!(crosses.clone().all(|c| c.dot(elements.normals[0]) > 0.0));
            let area: f32 = crosses.map(Vec3::length).sum();
            prop_assert!(area > 0.1 * elements.areas[0] && area < 2.0 * elements.areas[0]);
        }
        prop_assert_eq!(tiers, tiers_of(&mesh));
    }

    #[test]
    fn soups_of_triangles_never_fail(
        positions in prop::collection::vec(prop::array::uniform3(-1.0_f32..1.0), 9),
        indices in prop::collection::vec(0_u32..9, 3..60),
    ) {
        let n = indices.len() / 3 * 3;
        let positions: Vec<Vec3> = positions.into_iter().map(Vec3::from_array).collect();
        let mesh = mesh(vec![finished(positions, indices[..n].to_vec())]);
        let tiers = tiers_of(&mesh);
        for pair in tiers.windows(2) {
            prop_assert!(pair[1].triangles.len() < pair[0].triangles.len());
        }
        for tier in &tiers {
            prop_assert_eq!(tier.starts.last().copied(), Some(tier.triangles.len() as u32));
        }
    }
}
