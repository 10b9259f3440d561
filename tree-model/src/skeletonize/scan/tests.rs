use super::*;
use crate::error::ModelError;
use proptest::prelude::*;
use std::f64::consts::TAU;
use tree_core::{CancelFlag, Limits, UpAxis};

/// Points on the side of a cone from `a` to `b`, as scanners see it: no ends. Deterministic, without
/// pattern (R2 sequence, Roberts 2018).
fn cone(a: DVec3, b: DVec3, radii: [f64; 2], n: u32) -> Vec<DVec3> {
    let along = (b - a).normalize();
    let (x, y) = along.any_orthonormal_pair();
    (0..n)
        .map(|i| {
            let share = (0.754_877_666_246_693 * f64::from(i)).fract();
            let turn = TAU * (0.569_840_290_998_053 * f64::from(i)).fract();
            let radius = radii[0] + share * (radii[1] - radii[0]);
            a.lerp(b, share) + radius * (libm::cos(turn) * x + libm::sin(turn) * y)
        })
        .collect()
}

/// A trunk of 4 m with two branches, z up.
fn tree(at: DVec3) -> Vec<DVec3> {
    let mut points = cone(at, at + DVec3::new(0.0, 0.0, 4.0), [0.1, 0.05], 6000);
    let fork = at + DVec3::new(0.0, 0.0, 2.0);
    points.extend(cone(fork, fork + DVec3::new(1.2, 0.0, 0.8), [0.04, 0.02], 1200));
    points.extend(cone(fork, fork + DVec3::new(0.0, -1.0, 1.0), [0.04, 0.02], 1200));
    points
}

fn scan(points: &[DVec3]) -> Scanned {
    skeletonize_scan(points, &ScanParams::default(), &Control::default()).unwrap()
}

fn length(skeleton: &Skeleton) -> f32 {
    skeleton.segment_lengths().iter().sum()
}

#[test]
fn a_tree_of_three_cones_comes_back() {
    let at = DVec3::new(512_345.0, 5_412_345.0, 120.0);
    let made = scan(&tree(at));
    let tree = &made.trees[0];
    let skeleton = &tree.skeleton;
    assert_eq!(skeleton.tip_counts()[0], 3);
    assert!((length(skeleton) - 6.86).abs() < 0.5, "{}", length(skeleton));
    assert!((skeleton.radii()[0] - 0.1).abs() < 0.01, "{}", skeleton.radii()[0]);
    assert!(tree.base.distance(at) < 0.1, "{}", tree.base);
    // (x, y, z) became (x, z, -y): the branch towards -y goes towards +z.
    let far = skeleton.bounds().max;
    assert!((far.z - 1.0).abs() < 0.1 && (far.x - 1.2).abs() < 0.1 && (far.y - 4.0).abs() < 0.1);
    assert!(tree.in_foliage.iter().all(|leafy| !leafy));
}

#[test]
fn a_trunk_seen_from_one_side_keeps_its_centre_and_radius() {
    let points: Vec<DVec3> = cone(DVec3::ZERO, DVec3::Z * 3.0, [0.15, 0.15], 8000)
        .into_iter()
        .filter(|p| p.x > 0.03)
        .collect();
    let made = scan(&points);
    let tree = &made.trees[0];
    let (skeleton, middle) = (&tree.skeleton, tree.skeleton.len() / 2);
    assert!((skeleton.radii()[middle] - 0.15).abs() < 0.01, "{}", skeleton.radii()[middle]);
    let x = tree.base.x + f64::from(skeleton.positions()[middle].x);
    assert!(x.abs() < 0.01, "{x}: the mean of the points is at 0.11");
}

#[test]
fn the_ground_is_taken_away_and_a_gap_bridged() {
    let mut points = tree(DVec3::ZERO);
    points.retain(|p| !(1.0..1.25).contains(&p.z));
    let ground = (0..9000).map(|i| {
        let share = |f: f64| (f * f64::from(i)).fract() * 4.0 - 2.0;
        let (x, y) = (share(0.754_877_666_246_693), share(0.569_840_290_998_053));
        DVec3::new(x, y, 0.1 * x)
    });
    points.extend(ground);
    let made = scan(&points);
    assert!((8500..9700).contains(&made.report.n_ground), "{}", made.report.n_ground);
    assert!(made.report.bridges.iter().any(|b| (b.length - 0.25).abs() < 0.05));
    let skeleton = &made.trees[0].skeleton;
    assert_eq!(skeleton.tip_counts()[0], 3);
    assert!((length(skeleton) - 6.7).abs() < 0.6, "{}", length(skeleton));
    assert!(made.trees[0].base.truncate().length() < 0.05);
}

#[test]
fn several_trees_are_told_apart() {
    let stands = [DVec3::ZERO, DVec3::new(3.5, 0.0, 0.2), DVec3::new(0.0, 4.0, -0.2)];
    let points: Vec<DVec3> = stands.iter().flat_map(|&at| tree(at)).collect();
    let params = ScanParams { several: true, ..ScanParams::default() };
    let made = skeletonize_scan(&points, &params, &Control::default()).unwrap();
    assert_eq!(made.trees.len(), 3);
    for at in stands {
        assert!(made.trees.iter().any(|tree| tree.base.distance(at) < 0.1), "{at}");
    }
    assert!(made.trees.iter().all(|tree| tree.skeleton.tip_counts()[0] == 3));
}

#[test]
fn what_is_too_far_is_left_out_and_counted() {
    let mut points = tree(DVec3::ZERO);
    points.extend(cone(DVec3::new(1.0, 1.5, 3.0), DVec3::new(1.6, 1.5, 3.3), [0.03, 0.03], 500));
    let made = scan(&points);
    assert!(made.report.n_left_out > 300, "{:?}", made.report);
    let params = ScanParams { bridge: 0.5, ..ScanParams::default() };
    let joined = skeletonize_scan(&points, &params, &Control::default()).unwrap();
    assert_eq!(joined.report.n_left_out, 0);
    assert!(length(&joined.trees[0].skeleton) > length(&made.trees[0].skeleton) + 0.4);
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let points = tree(DVec3::ZERO);
    let with = |n| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
        pool.install(|| scan(&points))
    };
    assert_eq!(with(1), with(3));
}

#[test]
fn clouds_that_are_no_trees_are_refused_with_the_reason() {
    let refused = |points: &[DVec3]| {
        skeletonize_scan(points, &ScanParams::default(), &Control::default()).unwrap_err()
    };
    let line: Vec<DVec3> = (0..100).map(|i| DVec3::new(1.0, 2.0, 3.0) * f64::from(i)).collect();
    let nan = vec![DVec3::NAN; 100];
    let far = [&line[..], &[DVec3::splat(1e30)]].concat();
    for (points, reason) in [
        (&[][..], "0 finite"),
        (&line[..5], "5 finite"),
        (&nan, "0 finite"),
        (&[DVec3::ONE; 50], "one place"),
        (&line, "one line"),
        (&far, "unit"),
    ] {
        let error = refused(points);
        assert!(matches!(error, ModelError::Cloud { .. }), "{error}");
        assert!(error.to_string().contains(reason), "{error}");
    }
    let params = ScanParams { several: true, ..ScanParams::default() };
    let ball: Vec<DVec3> = (0..500)
        .map(|i| {
            let a = f64::from(i);
            DVec3::new(libm::sin(a), libm::cos(1.3 * a), libm::sin(0.7 * a))
        })
        .collect();
    let error = skeletonize_scan(&ball, &params, &Control::default()).unwrap_err();
    assert!(matches!(error, ModelError::NoBase { .. }), "{error}");
}

#[test]
fn limits_and_cancelling_hold() {
    let points = tree(DVec3::ZERO);
    for limits in [
        Limits { graph_nodes: 100, ..Limits::default() },
        Limits { graph_arcs: 100, ..Limits::default() },
        Limits { nodes: 5, ..Limits::default() },
    ] {
        let control = Control::default().with_limits(limits);
        let error = skeletonize_scan(&points, &ScanParams::default(), &control).unwrap_err();
        assert!(matches!(error, ModelError::Limit(_)), "{error}");
    }
    let flag = CancelFlag::default();
    flag.cancel();
    let control = Control::default().with_cancel(flag);
    let error = skeletonize_scan(&points, &ScanParams::default(), &control).unwrap_err();
    assert!(matches!(error, ModelError::Cancelled(_)), "{error}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    #[test]
    fn any_cloud_gives_valid_trees_or_a_typed_error(
        places in prop::collection::vec([-3_i8..4, -3_i8..4, 0_i8..12], 0..300),
        scale in prop::sample::select(vec![1e-12_f64, 1e-3, 1.0, 1e4, 1e300]),
        several: bool,
        foliage: bool,
        y_up: bool,
    ) {
        let points: Vec<DVec3> =
            places.iter().map(|p| scale * DVec3::from(p.map(f64::from))).collect();
        let up = if y_up { UpAxis::Y } else { UpAxis::Z };
        let params = ScanParams { several, foliage, up, ..ScanParams::default() };
        if let Ok(made) = skeletonize_scan(&points, &params, &Control::default()) {
            prop_assert!(!made.trees.is_empty());
            for tree in &made.trees {
                tree.skeleton.check().unwrap();
                prop_assert_eq!(tree.in_foliage.len(), tree.skeleton.len());
                prop_assert!(tree.base.is_finite());
            }
        }
    }
}
