//! Arrangement and bearing of simple leaves; what the other files share.

mod density;
mod forms;
mod robust;
mod twigs;

use super::*;
use crate::ModelError;
use glam::Vec3;
use std::f32::consts::TAU;
use tree_core::Limits;
use tree_core::{Control, Foliage, Seed, Skeleton};

/// A straight upright shoot of `length` metres in segments of 5 cm.
fn shoot(length: f32) -> Skeleton {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.01).unwrap();
    for i in 1..=(length / 0.05) as u32 {
        builder.add(i - 1, Vec3::Y * (0.05 * i as f32), 0.01).unwrap();
    }
    builder.finish()
}

fn calm(arrangement: Phyllotaxis) -> LeafParams {
    LeafParams {
        arrangement,
        spacing: 0.1,
        bearing: 10.0,
        jitter: 0.0,
        size_variation: 0.0,
        terminal: false,
        ..LeafParams::default()
    }
}

fn grow(skeleton: &Skeleton, params: &LeafParams) -> Foliage {
    grow_leaves(skeleton, params, Seed(4), &Control::default()).unwrap()
}

/// Compass direction of each leaf's base round the shoot.
fn angles(foliage: &Foliage) -> Vec<f32> {
    foliage.positions().iter().map(|p| libm::atan2f(p.z, p.x)).collect()
}

#[test]
fn each_arrangement_turns_by_its_divergence() {
    let spiral = |divergence| Phyllotaxis::Spiral { divergence };
    let cases = [
        (Phyllotaxis::default(), 2.399_963),
        (spiral(2.513), 2.513),
        (Phyllotaxis::Distichous, TAU / 2.0),
        (Phyllotaxis::Opposite, 0.0),
        (Phyllotaxis::Decussate, TAU / 4.0),
        (Phyllotaxis::Whorled { count: 3 }, TAU / 6.0),
    ];
    for ((arrangement, divergence), petiole) in
        cases.into_iter().flat_map(|case| [(case, 0.0), (case, 1.5)])
    {
        let params = LeafParams { petiole, ..calm(arrangement) };
        let foliage = grow(&shoot(2.0), &params);
        let per_node = arrangement.per_node() as usize;
        let angles = angles(&foliage);
        for pair in angles.chunks(per_node).collect::<Vec<_>>().windows(2) {
            let turn = (pair[1][0] - pair[0][0]).rem_euclid(TAU);
            let turn = turn.min(TAU - turn);
            let expected = divergence.min(TAU - divergence);
            assert!((turn - expected).abs() < 1e-3, "{arrangement:?}: {turn}");
            for mates in pair[0].windows(2) {
                let between = (mates[1] - mates[0]).rem_euclid(TAU);
                let between = between.min(TAU - between);
                assert!((between - TAU / per_node as f32).abs() < 1e-3, "{arrangement:?}");
            }
        }
    }
}

#[test]
fn leaves_stand_at_even_distances_across_segments() {
    let foliage = grow(&shoot(2.0), &calm(Phyllotaxis::default()));
    let heights: Vec<f32> = foliage.positions().iter().map(|p| p.y).collect();
    assert!(heights.len() >= 19);
    for pair in heights.windows(2) {
        assert!((pair[1] - pair[0] - 0.1).abs() < 1e-4, "{heights:?}");
    }
}

#[test]
fn only_the_bearing_zone_bears() {
    let params = LeafParams { bearing: 0.5, ..calm(Phyllotaxis::default()) };
    let foliage = grow(&shoot(2.0), &params);
    assert!(!foliage.is_empty());
    assert!(foliage.positions().iter().all(|p| p.y >= 1.49));
    let none = grow(&shoot(2.0), &LeafParams { bearing: 0.0, ..params });
    assert!(none.is_empty());
}

#[test]
fn phototropism_turns_upper_faces_to_the_sky() {
    let facing_up = |phototropism| {
        let params = LeafParams { phototropism, ..calm(Phyllotaxis::default()) };
        let mut builder = Skeleton::builder(Vec3::ZERO, 0.01).unwrap();
        builder.add(0, Vec3::X * 2.0, 0.01).unwrap();
        let foliage = grow(&builder.finish(), &params);
        let sum: f32 = foliage.rotations().iter().map(|&r| (r * Vec3::Z).y).sum();
        sum / foliage.len() as f32
    };
    assert!(facing_up(1.0) > facing_up(0.0) + 0.3);
}

#[test]
fn a_lone_node_bears_nothing_and_a_segment_without_length_is_passed_over() {
    let lone = Skeleton::builder(Vec3::ZERO, 0.1).unwrap().finish();
    assert!(grow(&lone, &LeafParams::default()).is_empty());
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
    builder.add(0, Vec3::ZERO, 0.1).unwrap();
    let foliage = grow(&builder.finish(), &LeafParams::default());
    assert_eq!(foliage.len(), 1, "the terminal leaf");
}

#[test]
fn bad_parameters_and_too_many_leaves_are_refused() {
    let control = Control::default();
    for bad in [
        LeafParams { spacing: 0.0, ..LeafParams::default() },
        LeafParams { size: f32::NAN, ..LeafParams::default() },
        LeafParams { arrangement: Phyllotaxis::Whorled { count: 0 }, ..LeafParams::default() },
    ] {
        let error = grow_leaves(&shoot(1.0), &bad, Seed(1), &control).unwrap_err();
        assert!(matches!(error, ModelError::Parameter(_)), "{error}");
    }
    let limits = Limits { leaves: 5, ..Limits::default() };
    let control = control.with_limits(limits);
    let error = grow_leaves(&shoot(2.0), &LeafParams::default(), Seed(1), &control).unwrap_err();
    assert!(matches!(error, ModelError::Limit(_)), "{error}");
}

#[test]
fn short_spacing_on_a_long_shoot_ends_and_keeps_its_number() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
    builder.add(0, Vec3::Y * 2060.0, 0.1).unwrap();
    let params = LeafParams { spacing: 1e-3, bearing: 1e6, ..calm(Phyllotaxis::default()) };
    let foliage = grow(&builder.finish(), &params);
    assert!((2_059_000..2_061_000).contains(&foliage.len()), "{}", foliage.len());
}

#[test]
fn nodes_too_far_apart_for_single_precision_are_refused_by_the_limit() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
    builder.add(0, Vec3::Y * 1e20, 0.1).unwrap();
    let params = LeafParams { bearing: 1e6, ..LeafParams::default() };
    let control = Control::default();
    let error = grow_leaves(&builder.finish(), &params, Seed(1), &control).unwrap_err();
    assert!(matches!(error, ModelError::Limit(_)), "{error}");
}
