//! Densities: proportional, whole whorls, bounded, reported.

use super::{calm, grow, shoot};
use crate::ModelError;
use crate::foliage::*;
use glam::Vec3;
use tree_core::{Control, Limits, Seed};

fn many(arrangement: Phyllotaxis) -> LeafParams {
    LeafParams { spacing: 0.002, ..calm(arrangement) }
}

fn grow_at(params: &LeafParams, density: f32) -> Leaves {
    let field = |_: Vec3| density;
    grow_leaves_in(&shoot(10.0), params, &field, Seed(4), &Control::default()).unwrap()
}

#[test]
fn the_number_of_leaves_is_proportional_to_the_density_up_to_the_cap() {
    let params = many(Phyllotaxis::GOLDEN);
    let full = grow(&shoot(10.0), &params).len() as f32;
    for density in [0.1, 0.5, 1.0, 1.7, 2.0, 3.0, DENSITY_CAP] {
        let share = grow_at(&params, density).foliage.len() as f32 / full;
        assert!((share - density).abs() < 0.05 * density.max(0.5), "{density}: {share}");
    }
    let beyond = grow_at(&params, f32::INFINITY);
    assert_eq!(beyond.foliage, grow_at(&params, DENSITY_CAP).foliage);
    assert_eq!(grow_at(&params, 0.0).foliage.len(), 0);
}

#[test]
fn a_density_of_one_is_as_good_as_none() {
    let params = calm(Phyllotaxis::Decussate);
    let (with, without) = (grow_at(&params, 1.0).foliage, grow(&shoot(10.0), &params));
    assert_eq!(with.len(), without.len());
    for (a, b) in with.positions().iter().zip(without.positions()) {
        assert!((a.y - b.y).abs() < 1e-3, "{a} {b}");
    }
}

#[test]
fn a_report_changes_no_leaf() {
    let (shoot, control) = (shoot(10.0), Control::default());
    let params = calm(Phyllotaxis::Decussate);
    let plain = grow_leaves(&shoot, &params, Seed(4), &control).unwrap();
    let told = grow_leaves_and_report(&shoot, &params, None, Seed(4), &control).unwrap();
    assert_eq!(told.foliage, plain);
    assert_eq!(told.report.n_blades, plain.len() as u64);
    let half = |_: Vec3| 0.5;
    let told = grow_leaves_and_report(&shoot, &params, Some(&half), Seed(4), &control).unwrap();
    assert_eq!(told, grow_at(&params, 0.5));
}

#[test]
fn whorls_stay_whole() {
    let params = many(Phyllotaxis::Whorled { count: 3 });
    let leaves = grow_at(&params, 0.4);
    assert_eq!(leaves.foliage.len() % 3, 0);
    for whorl in leaves.foliage.positions().chunks(3) {
        assert!((whorl[0].y - whorl[2].y).abs() < 1e-4);
    }
    assert_eq!(leaves.report.n_leaves, 3 * leaves.report.n_bearing);
}

#[test]
fn leaves_grow_where_the_field_is() {
    let field = |at: Vec3| if at.y > 5.0 { 1.0 } else { 0.0 };
    let params = many(Phyllotaxis::GOLDEN);
    let leaves =
        grow_leaves_in(&shoot(10.0), &params, &field, Seed(3), &Control::default()).unwrap();
    assert!(!leaves.foliage.is_empty());
    assert!(leaves.foliage.positions().iter().all(|p| p.y > 5.0));
    assert!(leaves.report.n_thinned > 2000);
}

#[test]
fn thinning_leaves_out_leaves_and_changes_no_other() {
    let params = LeafParams { jitter: 0.4, ..many(Phyllotaxis::GOLDEN) };
    let (full, half) = (grow_at(&params, 1.0).foliage, grow_at(&params, 0.5).foliage);
    let mut all = full.iter();
    for leaf in half.iter() {
        assert!(all.any(|other| other == leaf), "{leaf:?} is not among all");
    }
}

#[test]
fn bad_densities_count_as_none_and_are_reported() {
    for bad in [f32::NAN, -1.0, f32::NEG_INFINITY] {
        let leaves = grow_at(&calm(Phyllotaxis::GOLDEN), bad);
        assert!(leaves.foliage.is_empty());
        assert!(leaves.report.n_bad_density >= 99, "{:?}", leaves.report);
        assert_eq!(leaves.report.n_thinned, leaves.report.n_bad_density);
    }
}

#[test]
fn twigs_follow_the_density_too() {
    let params = TwigParams { per_metre: 100.0, bearing: 20.0, crowd: 64, ..TwigParams::DEFAULT };
    let count = |density: f32| {
        let field = move |_: Vec3| density;
        let twigs = grow_twigs_in(&shoot(10.0), &params, &field, Seed(3), &Control::default());
        twigs.unwrap().report.n_twigs as f32
    };
    let full = count(1.0);
    assert!(full > 900.0);
    assert!((count(0.5) / full - 0.5).abs() < 0.06);
    assert!((count(2.0) / full - 2.0).abs() < 0.1);
    assert!(count(f32::NAN) < 0.5);
}

#[test]
fn the_limit_holds_for_what_the_density_leaves() {
    let params = calm(Phyllotaxis::GOLDEN);
    let n = grow(&shoot(10.0), &params).len() as u64;
    let limits = Limits { leaves: 2 * n, ..Limits::default() };
    let control = Control::default().with_limits(limits);
    let grow = |density: f32| {
        let field = move |_: Vec3| density;
        grow_leaves_in(&shoot(10.0), &params, &field, Seed(3), &control)
    };
    assert!(grow(1.5).is_ok());
    assert!(matches!(grow(3.0), Err(ModelError::Limit(_))));
}
