//! Twigs: branching, bending, tropisms, radii, report.

use super::shoot;
use crate::ModelError;
use crate::foliage::*;
use glam::Vec3;
use std::f32::consts::PI;
use tree_core::{Control, Limits, Resource, Seed, Skeleton};

/// Twigs without chance: one level, nothing that bends.
fn calm() -> TwigParams {
    TwigParams {
        levels: 1,
        jitter: 0.0,
        length_variation: 0.0,
        taper: 0.0,
        terminal: 0.0,
        stiffness: 1e6,
        phototropism: 0.0,
        arrangement: Phyllotaxis::Distichous,
        per_metre: 5.0,
        ..TwigParams::DEFAULT
    }
}

fn grow(skeleton: &Skeleton, params: &TwigParams) -> Twigs {
    grow_twigs(skeleton, params, Seed(4), &Control::default()).unwrap()
}

/// The internodes of each twig of one level as unit vectors.
fn twigs_of(skeleton: &Skeleton, twigs: &Twigs) -> Vec<Vec<Vec3>> {
    let n = skeleton.len() as u32;
    let mut all: Vec<Vec<Vec3>> = Vec::new();
    for (parent, node) in twigs.skeleton.segments().filter(|&(_, node)| node >= n) {
        let [a, b] = [parent, node].map(|i| twigs.skeleton.positions()[i as usize]);
        if parent < n {
            all.push(Vec::new());
        }
        all.last_mut().unwrap().push((b - a).normalize());
    }
    all
}

fn mean_tip_height(params: &TwigParams) -> f32 {
    let skeleton = shoot(1.0);
    let twigs = grow(&skeleton, params);
    let (children, n) = (twigs.skeleton.children(), skeleton.len());
    let tips: Vec<f32> = (n..twigs.skeleton.len())
        .filter(|&node| children.is_tip(node as u32))
        .map(|node| twigs.skeleton.positions()[node].y)
        .collect();
    tips.iter().sum::<f32>() / tips.len() as f32
}

#[test]
fn old_nodes_stay_as_they_are_and_new_ones_come_after() {
    let skeleton = shoot(1.0);
    let twigs = grow(&skeleton, &TwigParams::DEFAULT);
    let n = skeleton.len();
    assert_eq!(twigs.skeleton.positions()[..n], *skeleton.positions());
    assert_eq!(twigs.skeleton.radii()[..n], *skeleton.radii());
    assert_eq!(twigs.skeleton.parents()[..n], *skeleton.parents());
    assert_eq!(twigs.skeleton.len() as u64, n as u64 + twigs.report.n_nodes);
    assert!(twigs.report.n_twigs > 3 && twigs.report.n_laterals > twigs.report.n_twigs);
    assert!(twigs.report.moved <= 0.026, "half a segment: {}", twigs.report.moved);
}

#[test]
fn monopodial_twigs_are_straight_and_leave_at_their_angle() {
    let skeleton = shoot(1.0);
    let params = calm();
    let all = twigs_of(&skeleton, &grow(&skeleton, &params));
    assert!(all.len() >= 3);
    for twig in all {
        assert_eq!(twig.len(), 8, "0.25 m in internodes of 0.03 m");
        for internode in twig {
            assert!((internode.angle_between(Vec3::Y) - params.angle).abs() < 1e-3);
        }
    }
}

#[test]
fn twigs_follow_their_phyllotaxis() {
    let skeleton = shoot(1.0);
    let all =
        |arrangement| twigs_of(&skeleton, &grow(&skeleton, &TwigParams { arrangement, ..calm() }));
    for pair in all(Phyllotaxis::Distichous).windows(2) {
        assert!(pair[0][0].x * pair[1][0].x + pair[0][0].z * pair[1][0].z < 0.0, "other side");
    }
    let whorls = all(Phyllotaxis::Whorled { count: 3 });
    assert!(whorls.len().is_multiple_of(3) && whorls.len() >= 9);
    let sum: Vec3 = whorls[..3].iter().map(|twig| twig[0] * Vec3::new(1.0, 0.0, 1.0)).sum();
    assert!(sum.length() < 1e-3, "evenly round: {sum}");
}

#[test]
fn a_zigzag_turns_at_every_module_to_the_other_side_and_keeps_its_course() {
    let skeleton = shoot(1.0);
    let params = TwigParams { branching: Branching::zigzag(0.7), ..calm() };
    for twig in twigs_of(&skeleton, &grow(&skeleton, &params)) {
        for i in 1..twig.len() {
            assert!((twig[i].angle_between(twig[i - 1]) - 0.7).abs() < 1e-3);
            if i > 1 {
                assert!(twig[i].distance(twig[i - 2]) < 1e-3, "back on course");
            }
        }
        let course: Vec3 = twig.iter().sum();
        assert!((course.angle_between(Vec3::Y) - params.angle).abs() < 1e-2);
    }
}

#[test]
fn a_helicoid_twig_turns_to_one_side_after_each_module() {
    let skeleton = shoot(1.0);
    let params = TwigParams { branching: Branching::helicoid(3, 0.4), ..calm() };
    for twig in twigs_of(&skeleton, &grow(&skeleton, &params)) {
        let mut side = None;
        for i in 1..twig.len() {
            let turn = twig[i - 1].cross(twig[i]);
            if i % 3 != 0 {
                assert!(turn.length() < 1e-3, "straight within a module");
                continue;
            }
            assert!((twig[i].angle_between(twig[i - 1]) - 0.4).abs() < 1e-3);
            assert!(side.is_none_or(|side: Vec3| side.dot(turn) > 0.0));
            side = Some(turn);
        }
        assert!(side.is_some());
    }
}

#[test]
fn a_module_that_ends_may_leave_its_tip() {
    let skeleton = shoot(1.0);
    let stub = |stub| {
        let branching = Branching::Sympodial { internodes: 2, turn: 0.5, divergence: PI, stub };
        grow(&skeleton, &TwigParams { branching, ..calm() })
    };
    let (shed, kept) = (stub(0.0), stub(0.5));
    // 8 internodes are 4 modules, of which 3 end.
    assert_eq!(kept.report.n_nodes - shed.report.n_nodes, 3 * shed.report.n_twigs);
    assert_eq!(kept.report.n_twigs, shed.report.n_twigs);
}

#[test]
fn limper_twigs_hang_lower() {
    let height =
        |stiffness| mean_tip_height(&TwigParams { stiffness, length: 0.5, load: 0.1, ..calm() });
    let heights = [1e5, 50.0, 10.0, 2.0, 0.5, 0.1, 1e-3].map(height);
    assert!(heights.windows(2).all(|pair| pair[1] < pair[0]), "{heights:?}");
    assert!(heights[0] - heights[6] > 0.4);
}

#[test]
fn thin_and_loaded_twigs_droop_more() {
    let params = TwigParams { stiffness: 4.0, length: 0.5, radius_taper: 0.0, ..calm() };
    let height =
        |load, tip_radius| mean_tip_height(&TwigParams { load, tip_radius, ..params.clone() });
    assert!(height(0.05, 0.001) < height(0.05, 0.002));
    assert!(height(0.2, 0.001) < height(0.05, 0.001));
}

#[test]
fn a_stiff_level_twig_bends_as_a_beam_does() {
    // Deflection of a cantilever of even load: w L⁴ / (8 E I).
    let (length, radius, load) = (0.4_f32, 0.003_f32, 0.2_f32);
    let params = TwigParams {
        length,
        internode: 0.01,
        angle: PI / 2.0,
        tip_radius: radius,
        radius_taper: 0.0,
        radius_share: 1.0,
        stiffness: 20.0,
        load,
        ..calm()
    };
    let skeleton = shoot(1.0);
    let twigs = grow(&skeleton, &params);
    let (n, n_twig) = (skeleton.len(), 40);
    let weight = 9.81 * (load + 900.0 * PI * radius * radius);
    let inertia = 0.25 * PI * radius * radius * radius * radius;
    let expected = weight * length * length * length * length / (8.0 * 20e9 * inertia);
    for tip in (n + n_twig - 1..twigs.skeleton.len()).step_by(n_twig) {
        let base = twigs.skeleton.positions()[twigs.skeleton.parents()[tip + 1 - n_twig] as usize];
        let sag = base.y - twigs.skeleton.positions()[tip].y;
        assert!((sag / expected - 1.0).abs() < 0.08, "{sag} against {expected}");
    }
}

#[test]
fn tropisms_turn_growth_up_and_down_and_to_the_light() {
    let height = |gravitropism, phototropism| {
        mean_tip_height(&TwigParams { gravitropism, phototropism, ..calm() })
    };
    assert!(height(3.0, 0.0) < height(0.0, 0.0));
    assert!(height(-3.0, 0.0) > height(0.0, 0.0));
    assert!(height(0.0, 3.0) > height(0.0, 0.0));
    assert!((height(-2.0, 0.0) - height(0.0, 2.0)).abs() < 1e-4, "up is where the light is");
    let skeleton = shoot(1.0);
    let lit = TwigParams { phototropism: 500.0, light: Vec3::new(1.0, 0.0, 0.5), ..calm() };
    for twig in twigs_of(&skeleton, &grow(&skeleton, &lit)) {
        let end = twig[twig.len() - 1];
        assert!(end.dot(lit.light.normalize()) > 0.99, "{end}");
    }
}

#[test]
fn twigs_shorten_towards_the_end_that_the_taper_says() {
    let skeleton = shoot(1.0);
    let lengths = |taper| {
        let params = TwigParams { taper, bearing: 1.0, per_metre: 10.0, ..calm() };
        twigs_of(&skeleton, &grow(&skeleton, &params)).iter().map(Vec::len).collect::<Vec<_>>()
    };
    let (down, up) = (lengths(0.8), lengths(-0.8));
    assert!(down.windows(2).all(|pair| pair[1] <= pair[0]) && down[0] > down[down.len() - 1]);
    assert!(up.windows(2).all(|pair| pair[1] >= pair[0]) && up[0] < up[up.len() - 1]);
}

#[test]
fn levels_are_what_the_parameters_say() {
    let skeleton = shoot(1.0);
    for levels in 1..=3 {
        let params = TwigParams { levels, length: 0.5, ..TwigParams::DEFAULT };
        let twigs = grow(&skeleton, &params);
        let axes = twigs.skeleton.axes(tree_core::Continuation::Thickest);
        let deepest = axes.orders().iter().copied().max();
        assert_eq!(deepest, Some(levels));
    }
}

#[test]
fn a_twig_is_never_thicker_than_what_bears_it() {
    let mut skeleton = shoot(1.0);
    let thin: Vec<f32> = (0..skeleton.len()).map(|i| 1e-3 / (1.0 + i as f32)).collect();
    skeleton.set_radii(thin).unwrap();
    let twigs = grow(&skeleton, &TwigParams { levels: 3, ..TwigParams::DEFAULT });
    let radii = twigs.skeleton.radii();
    for (parent, node) in twigs.skeleton.segments() {
        assert!(radii[node as usize] <= radii[parent as usize]);
    }
    assert!(radii[skeleton.len()..].iter().all(|&radius| radius > 0.0));
}

#[test]
fn laterals_join_by_the_pipe_model() {
    let params = TwigParams { radius_taper: 0.0, pipe_exponent: 2.0, ..TwigParams::DEFAULT };
    let mut skeleton = shoot(1.0);
    skeleton.set_radii(vec![1.0; skeleton.len()]).unwrap();
    let twigs = grow(&skeleton, &params);
    let (radii, children) = (twigs.skeleton.radii(), twigs.skeleton.children());
    for node in skeleton.len()..radii.len() {
        let above: f32 =
            children.of(node as u32).iter().map(|&c| radii[c as usize] * radii[c as usize]).sum();
        let here = radii[node] * radii[node];
        assert!(children.is_tip(node as u32) || (above / here - 1.0).abs() < 1e-4);
    }
}

#[test]
fn a_crowded_node_refuses_more_and_refining_makes_room() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.02).unwrap();
    builder.add(0, Vec3::Y * 2.0, 0.01).unwrap();
    let coarse = builder.finish();
    let control = Control::default();
    let crowded = grow(&coarse, &calm());
    assert!(crowded.report.n_crowded == 0 && crowded.report.moved > 0.3);
    let params = TwigParams { per_metre: 50.0, ..calm() };
    assert!(grow(&coarse, &params).report.n_crowded > 20);
    let fine = refine(&coarse, params.bearing, 0.02, &control).unwrap();
    let twigs = grow(&fine.skeleton, &params);
    assert_eq!(twigs.report.n_crowded, 0);
    assert!(twigs.report.moved <= 0.0101);
}

#[test]
fn refining_keeps_the_shape_and_the_order() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.2).unwrap();
    let fork = builder.add(0, Vec3::Y, 0.1).unwrap();
    builder.add(fork, Vec3::new(0.5, 1.5, 0.0), 0.05).unwrap();
    builder.add(fork, Vec3::new(-0.4, 1.8, 0.3), 0.05).unwrap();
    let skeleton = builder.finish();
    let fine = refine(&skeleton, 100.0, 0.1, &Control::default()).unwrap();
    fine.skeleton.check().unwrap();
    assert!(fine.skeleton.segment_lengths().iter().all(|&length| length <= 0.1001));
    let reach = |skeleton: &Skeleton| skeleton.distances_to_tip()[0];
    assert!((reach(&fine.skeleton) - reach(&skeleton)).abs() < 1e-4);
    assert_eq!(fine.skeleton.tip_counts()[0], 2);
    // The last node of each old segment is the old node.
    for old in 0..4 {
        let last = fine.rows.iter().rposition(|&row| row == old).unwrap();
        assert_eq!(fine.skeleton.positions()[last], skeleton.positions()[old as usize]);
    }
    assert_eq!(refine(&skeleton, 0.0, 0.1, &Control::default()).unwrap().skeleton, skeleton);
}

#[test]
fn twigs_beyond_the_limit_are_refused_and_at_the_limit_are_not() {
    let skeleton = shoot(1.0);
    let params = TwigParams { levels: 3, ..TwigParams::DEFAULT };
    let n = grow(&skeleton, &params).skeleton.len() as u64;
    let grow = |nodes| {
        let control = Control::default().with_limits(Limits { nodes, ..Limits::default() });
        grow_twigs(&skeleton, &params, Seed(4), &control)
    };
    assert!(grow(n).is_ok());
    match grow(n - 1) {
        Err(ModelError::Limit(error)) => {
            assert_eq!(error.resource, Resource::Nodes);
            assert!(error.requested > error.cap);
        }
        other => panic!("{other:?}"),
    }
    let endless = TwigParams { length: 1e6, internode: 1e-5, ..TwigParams::DEFAULT };
    let error = grow_twigs(&skeleton, &endless, Seed(4), &Control::default()).unwrap_err();
    assert!(matches!(error, ModelError::Limit(_)), "{error}");
}
