use super::*;
use crate::element::{Grain, LeafSurfaces};
use crate::order::{check, stochastic};
use crate::quality::{Scale, Subject, Table, TableParams, mean_quality, scores_at};
use glam::Vec2;
use tree_core::{Control, Seed};
use tree_mesh::{Material, Mesh, Surface};

/// `n` square leaves in a ball of radius 1, on a trunk, all facing different ways.
fn crown(n: u32) -> Mesh {
    let mut leaves = Surface { material: 1, ..Surface::default() };
    let mut rng = Seed(5).stream("leaves").rng();
    for _ in 0..n {
        let mut next = || tree_core::seed::uniform(&mut rng, -1.0, 1.0);
        let center = Vec3::new(next(), next(), next()).clamp_length_max(1.0) + 2.0 * Vec3::Y;
        let normal = Vec3::new(next(), next(), next()).normalize_or(Vec3::Y);
        let x = normal.any_orthonormal_vector() * 0.15;
        let y = normal.cross(x);
        let first = leaves.positions.len() as u32;
        for (u, v) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
            leaves.positions.push(center + (2.0 * u - 1.0) * x + (2.0 * v - 1.0) * y);
            leaves.normals.push(normal);
            leaves.uvs.push(Vec2::new(u, v));
        }
        leaves.indices.extend([0, 1, 2, 0, 2, 3].map(|k| first + k));
    }
    let mut trunk = Surface::default();
    for p in [Vec3::new(-0.1, 0.0, 0.0), Vec3::new(0.1, 0.0, 0.0), 2.0 * Vec3::Y] {
        trunk.positions.push(p);
        trunk.normals.push(Vec3::Z);
        trunk.uvs.push(Vec2::ZERO);
    }
    trunk.indices = vec![0, 1, 2];
    let named = |name: &str| Material { name: name.into(), ..Material::default() };
    Mesh {
        surfaces: vec![trunk, leaves],
        materials: vec![named("bark"), named("leaves")],
        ..Mesh::default()
    }
}

fn quick() -> CoverageParams {
    let around = Around { azimuths: 6, pitches: vec![0.0], size: 96, ..Around::default() };
    CoverageParams { around, ..CoverageParams::default() }
}

fn elements(mesh: &Mesh) -> (Elements, Tier) {
    let elements =
        Elements::of_mesh(mesh, &LeafSurfaces::Found, Grain::Blade, &Control::default()).unwrap();
    let tier = Tier::full(mesh, &elements);
    (elements, tier)
}

fn made(mesh: &Mesh, params: &CoverageParams) -> Ranking {
    let (elements, tier) = elements(mesh);
    coverage(mesh, &elements, &tier, params, &Control::default()).unwrap()
}

#[test]
fn the_order_has_every_element_once_and_every_pivot_is_near_its_element() {
    let mesh = crown(300);
    let ranking = made(&mesh, &quick());
    check(&ranking.order, 300).unwrap();
    let (elements, _) = elements(&mesh);
    for (pivot, center) in ranking.pivots.iter().zip(&elements.centers) {
        assert!(pivot.distance(*center) < 0.25);
    }
}

#[test]
fn views_it_has_not_seen_are_covered_far_better_than_by_chance() {
    let mesh = crown(400);
    let (elements, tier) = elements(&mesh);
    let control = Control::default();
    let ours = made(&mesh, &quick());
    let chance =
        Ranking { order: stochastic(&elements, Seed(1)), pivots: elements.centers.clone() };
    let held = Around { azimuths: 5, turn: 0.4, size: 128, ..Around::default() };
    let quality = |ranking: &Ranking, lambda: f32| {
        let tiers = [tier.clone()];
        let subject =
            Subject { mesh: &mesh, elements: &elements, tiers: &tiers, ranking, kept: &[] };
        let params = TableParams {
            around: Around { azimuths: 4, size: 96, ..Around::default() },
            lambdas: vec![0.1, 0.3, 0.6, 1.0],
            scale: Scale::Best,
        };
        let scale = Table::measure(&subject, &params, &control).unwrap().at(lambda).scale;
        mean_quality(&scores_at(&subject, &[(lambda, scale)], &held, &control).unwrap()[0])
    };
    for lambda in [0.1, 0.3, 0.6] {
        let (a, b) = (quality(&ours, lambda), quality(&chance, lambda));
        assert!(1.0 - a < 0.8 * (1.0 - b), "{lambda}: {a} against {b}");
    }
}

#[test]
fn any_number_of_threads_gives_the_same_order() {
    let mesh = crown(150);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| made(&mesh, &quick()))
    };
    assert_eq!(on(1), on(4));
}

#[test]
fn a_leaf_that_is_there_twice_is_dropped_before_others() {
    let mut mesh = crown(60);
    let leaves = &mut mesh.surfaces[1];
    let n = leaves.positions.len() as u32;
    for column in [&mut leaves.positions, &mut leaves.normals] {
        column.extend_from_within(..);
    }
    leaves.uvs.extend_from_within(..);
    let copies: Vec<u32> = leaves.indices.iter().map(|&i| i + n).collect();
    leaves.indices.extend(copies);
    let order = made(&mesh, &quick()).order;
    let mut first: Vec<u32> = order[..55].iter().map(|&element| element % 60).collect();
    first.sort_unstable();
    first.dedup();
    assert!(first.len() >= 54, "{} different leaves among the first 55", first.len());
}

#[test]
fn one_leaf_and_leaves_without_area_are_ordered_too() {
    check(&made(&crown(1), &quick()).order, 1).unwrap();
    let mut flat = crown(5);
    flat.surfaces[1].positions.fill(Vec3::Y);
    check(&made(&flat, &quick()).order, 5).unwrap();
}

#[test]
fn an_element_over_every_budget_does_not_stop_the_others() {
    let mut mesh = crown(300);
    // One leaf of very many triangles.
    let leaves = &mut mesh.surfaces[1];
    leaves.indices.extend([0, 1, 2].repeat(900));
    let order = made(&mesh, &quick()).order;
    check(&order, 300).unwrap();
    let sorted = order.windows(2).filter(|pair| pair[0] < pair[1]).count();
    assert!(sorted < 240, "{sorted} of 299 pairs rise: that is the order of the mesh");
}

#[test]
fn stages_that_do_not_fall_and_foreign_tiers_are_refused() {
    let mesh = crown(3);
    let (elements, tier) = elements(&mesh);
    let control = Control::default();
    let refused = |params: &CoverageParams, tier: &Tier| {
        coverage(&mesh, &elements, tier, params, &control).is_err()
    };
    for stages in [vec![], vec![0.2, 0.2], vec![1.0], vec![0.0], vec![f32::NAN]] {
        assert!(refused(&CoverageParams { stages, ..quick() }, &tier));
    }
    assert!(refused(&quick(), &Tier::default()));
    let wild = Tier { triangles: vec![[999; 3]; 6], ..tier };
    assert!(refused(&quick(), &wild));
}

#[test]
fn cancelling_stops_the_work() {
    let mesh = crown(50);
    let (elements, tier) = elements(&mesh);
    let flag = tree_core::CancelFlag::default();
    let control = Control::default().with_cancel(flag.clone());
    flag.cancel();
    let found = coverage(&mesh, &elements, &tier, &quick(), &control);
    assert!(matches!(found, Err(crate::LodError::Cancelled(_))));
}
