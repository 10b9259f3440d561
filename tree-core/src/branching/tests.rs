use super::*;
use crate::allometry::PipeModel;
use crate::skeleton::tests::any_skeleton;
use crate::skeleton::{Continuation, NO_PARENT, Skeleton};
use glam::Vec3;
use proptest::prelude::*;
use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};

/// Branches each in two halves, `levels` times; a branch is `ratio` times as long and `thinning` times as thick
/// as the one below.
fn dichotomy(levels: u32, ratio: f32, thinning: f32) -> Skeleton {
    let mut builder = Skeleton::builder(Vec3::ZERO, 1.0).unwrap();
    let mut ends = vec![builder.add(0, Vec3::Y, 1.0).unwrap()];
    let (mut length, mut radius, mut height) = (1.0, 1.0, 1.0);
    for level in 0..levels {
        length *= ratio;
        radius *= thinning;
        let side = if level % 2 == 0 { Vec3::X } else { Vec3::Z };
        let mut next = Vec::new();
        for end in ends {
            for sign in [-1.0, 1.0] {
                // Straight up and down, places do not matter but lengths do.
                let step = Vec3::Y * length + side * sign * 1e-4;
                let at = Vec3::Y * height + step;
                next.push(builder.add(end, at, radius).unwrap());
            }
        }
        height += length;
        ends = next;
    }
    builder.finish()
}

/// A trunk of `n` segments of a metre with a level lateral of half a metre at each node between.
fn herringbone(n: u32) -> Skeleton {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
    let mut top = 0;
    for i in 1..=n {
        let at = Vec3::Y * i as f32;
        top = builder.add(top, at, 0.1).unwrap();
        if i < n {
            builder.add(top, at + 0.5 * Vec3::X, 0.05).unwrap();
        }
    }
    builder.finish()
}

#[test]
fn a_lone_node_is_of_order_one_and_has_no_ratios() {
    let strahler = Strahler::of(&Skeleton::builder(Vec3::ZERO, 1.0).unwrap().finish());
    assert_eq!((strahler.highest(), strahler.counts()), (1, &[1][..]));
    assert_eq!((strahler.bifurcation_ratio(), strahler.length_ratio()), (None, None));
}

#[test]
fn a_dichotomy_bifurcates_by_two_and_shortens_by_its_ratio() {
    let strahler = Strahler::of(&dichotomy(4, 0.5, 0.7));
    assert_eq!(strahler.counts(), [16, 8, 4, 2, 1]);
    assert!((strahler.bifurcation_ratio().unwrap() - 2.0).abs() < 1e-9);
    assert!((strahler.length_ratio().unwrap() - 2.0).abs() < 1e-3);
}

#[test]
fn a_herringbone_has_one_branch_of_order_two_however_long_it_is() {
    let strahler = Strahler::of(&herringbone(9));
    // Eight laterals, and the last metre of the trunk.
    assert_eq!(strahler.counts(), [9, 1]);
    assert!((strahler.bifurcation_ratio().unwrap() - 9.0).abs() < 1e-9);
    assert!((strahler.mean_lengths()[0] - 5.0 / 9.0).abs() < 1e-6);
    assert!((strahler.mean_lengths()[1] - 8.0).abs() < 1e-6);
}

#[test]
fn three_children_of_orders_2_2_3_give_order_3_and_2_2_2_give_3_too() {
    for (third, expected) in [(4, 3), (2, 3), (1, 3), (8, 4)] {
        // Above the fork: two with two tips each, and one with `third` tips.
        let mut builder = Skeleton::builder(Vec3::ZERO, 1.0).unwrap();
        for tips in [2, third, 2] {
            let mut ends = vec![builder.add(0, Vec3::Y, 1.0).unwrap()];
            while ends.len() < tips {
                ends = ends
                    .iter()
                    .flat_map(|&end| [(); 2].map(|()| builder.add(end, Vec3::Y, 1.0).unwrap()))
                    .collect();
            }
        }
        let skeleton = builder.finish();
        assert_eq!(Strahler::of(&skeleton).highest(), expected, "third branch of {third} tips");
    }
}

#[test]
fn runs_go_from_fork_to_fork_and_average_over_length() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 9.0).unwrap();
    let a = builder.add(0, Vec3::Y, 4.0).unwrap();
    let fork = builder.add(a, 4.0 * Vec3::Y, 2.0).unwrap();
    let left = builder.add(fork, 5.0 * Vec3::Y, 1.0).unwrap();
    let unknown = builder.add(left, 7.0 * Vec3::Y, 0.0).unwrap();
    let right = builder.add(fork, 4.0 * Vec3::Y, 0.5).unwrap();
    let runs = Runs::of(&builder.finish());
    let run = |parent, end, is_tip, n_segments, length, radius| Run {
        parent,
        end,
        is_tip,
        n_segments,
        length,
        radius,
    };
    let expected = [
        run(NO_PARENT, fork, false, 2, 4.0, (4.0 + 3.0 * 2.0) / 4.0),
        run(0, unknown, true, 2, 3.0, 1.0),
        run(0, right, true, 1, 0.0, 0.5),
    ];
    assert_eq!(runs.as_slice(), expected);
    assert_eq!(runs.run_of(), [0, 0, 0, 1, 1, 2]);
}

#[test]
fn exponents_of_radii_made_by_the_pipe_model_are_its_own() {
    for exponent in [PipeModel::DA_VINCI, PipeModel::MURRAY, 3.0] {
        let mut skeleton = dichotomy(5, 0.8, 1.0);
        let rule = PipeModel { taper: 0.0, ..PipeModel::with_exponent(exponent) };
        rule.apply(&mut skeleton).unwrap();
        for found in pipe_exponents(&skeleton) {
            assert!((found - f64::from(exponent)).abs() < 1e-4, "{found} of {exponent}");
        }
        // Of 31 forks, 16 bear single segments that end in tips.
        assert_eq!(pipe_exponents(&skeleton).len(), 15);
    }
}

#[test]
fn a_branch_as_thick_as_the_one_below_has_an_infinite_exponent_and_unknown_ones_none() {
    let fork = |radii: [f32; 2]| {
        let mut builder = Skeleton::builder(Vec3::ZERO, 1.0).unwrap();
        let fork = builder.add(0, Vec3::Y, 1.0).unwrap();
        for radius in radii {
            let branch = builder.add(fork, 2.0 * Vec3::Y, radius).unwrap();
            builder.add(branch, 3.0 * Vec3::Y, radius).unwrap();
        }
        pipe_exponents(&builder.finish())
    };
    assert_eq!(fork([1.0, 0.1]), [f64::INFINITY]);
    assert_eq!(fork([1.0 - 1e-7, 0.999]), [f64::INFINITY]);
    assert!(fork([0.5, 0.0]).is_empty());
}

#[test]
fn laterals_of_a_herringbone_stand_off_at_a_right_angle() {
    let angles = lateral_angles(&herringbone(5), Continuation::Thickest, 0.3);
    assert_eq!(angles.len(), 4);
    assert!(angles.iter().all(|lateral| (lateral.angle - FRAC_PI_2).abs() < 1e-6), "{angles:?}");
}

#[test]
fn reach_sees_past_the_first_segment_of_a_lateral() {
    let mut builder = Skeleton::builder(Vec3::ZERO, 1.0).unwrap();
    let fork = builder.add(0, Vec3::Y, 1.0).unwrap();
    builder.add(fork, 5.0 * Vec3::Y, 1.0).unwrap();
    let collar = builder.add(fork, Vec3::new(0.1, 1.0, 0.0), 0.5).unwrap();
    builder.add(collar, Vec3::new(0.1, 3.0, 0.0), 0.5).unwrap();
    let skeleton = builder.finish();
    let angle = |reach| lateral_angles(&skeleton, Continuation::Thickest, reach)[0].angle;
    assert!((angle(0.0) - FRAC_PI_2).abs() < 1e-6);
    assert!((angle(0.2) - FRAC_PI_4).abs() < 1e-6);
    // Longer than there is: to the tip, 0.1 beside and 2 above.
    assert!((angle(50.0) - libm::atan2f(0.1, 2.0)).abs() < 1e-6);
}

proptest! {
    #[test]
    fn every_measure_is_in_its_range_on_any_skeleton(skeleton in any_skeleton(60), reach in 0.0_f32..5.0) {
        let strahler = Strahler::of(&skeleton);
        let n_tips = skeleton.tip_counts()[0];
        prop_assert_eq!(strahler.counts()[0], n_tips);
        prop_assert_eq!(*strahler.counts().last().unwrap(), 1);
        for pair in strahler.counts().windows(2) {
            prop_assert!(pair[0] >= 2 * pair[1]);
        }
        for (parent, node) in skeleton.segments() {
            prop_assert!(strahler.orders()[parent as usize] >= strahler.orders()[node as usize]);
        }
        let runs = Runs::of(&skeleton);
        prop_assert_eq!(runs.as_slice().iter().filter(|run| run.is_tip).count(), n_tips as usize);
        prop_assert!(pipe_exponents(&skeleton).iter().all(|&found| found > 0.0));
        for lateral in lateral_angles(&skeleton, Continuation::Longest, reach) {
            prop_assert!((0.0..=std::f32::consts::PI).contains(&lateral.angle));
        }
    }
}
