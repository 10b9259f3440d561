//! Propagation, told by what it does.

use super::fixtures::{Builder, crown, ellipse, omega, one_stroke, palm, palm_omega, sketch};
use super::*;
use crate::sketch::Label;
use glam::Vec3;
use proptest::prelude::*;
use tree_core::Limits;

fn grown(branches: &Branches, crown: Option<&Crown>, params: &PropagateParams) -> Propagated {
    propagate(branches, &omega(), crown, None, params, Seed(1), &Control::default()).unwrap()
}

/// Length of all new segments, and of their pieces whose middle lies in the crown.
fn lengths(grown: &Propagated, crown: &Crown) -> (f32, f32) {
    let (mut all, mut inside) = (0.0, 0.0);
    for segment in grown.n_sketched..grown.branches.len() {
        for pair in grown.branches.points(segment).windows(2) {
            for i in 0..8 {
                let piece = pair[0].distance(pair[1]) / 8.0;
                all += piece;
                let middle = pair[0].lerp(pair[1], (i as f32 + 0.5) / 8.0);
                inside += if crown.contains_3d(middle) { piece } else { 0.0 };
            }
        }
    }
    (all, inside)
}

#[test]
fn sketched_segments_stay_as_they_are() {
    let sketch = sketch();
    let grown = grown(&sketch, None, &PropagateParams::default());
    assert_eq!(grown.n_sketched, sketch.len());
    for segment in 0..sketch.len() {
        assert_eq!(grown.branches.points(segment), sketch.points(segment));
        assert_eq!(grown.branches.parents()[segment], sketch.parents()[segment]);
        assert_eq!(grown.branches.labels()[segment], sketch.labels()[segment]);
        assert_eq!(grown.generations[segment], 0);
    }
}

#[test]
fn a_sketch_of_eight_strokes_becomes_a_full_tree() {
    let grown = grown(&sketch(), None, &PropagateParams::default());
    assert!((500..20_000).contains(&grown.branches.len()), "{:?}", grown.report);
    assert!(grown.report.n_forks > 10 && grown.report.generations == 5, "{:?}", grown.report);
}

#[test]
fn every_new_segment_begins_on_its_parent() {
    let grown = grown(&sketch(), Some(&crown()), &PropagateParams::default());
    for segment in 1..grown.branches.len() {
        let parent = grown.branches.parents()[segment] as usize;
        assert!(parent < segment);
        let fork = point_at(grown.branches.points(parent), grown.forks[segment]);
        assert!(fork.distance(grown.branches.start(segment)) < 1e-4, "{segment}");
    }
}

#[test]
fn what_grows_stays_in_the_crown() {
    let grown = grown(&sketch(), Some(&crown()), &PropagateParams::default());
    let (all, inside) = lengths(&grown, &crown());
    assert!(all > 100.0 && inside >= 0.995 * all, "{inside} of {all}");
    assert!(grown.report.n_touched > 20, "{:?}", grown.report);
}

#[test]
fn what_grows_stays_in_a_crown_with_deep_bays() {
    let corners = [[4.0, 3.0], [0.6, 5.0], [3.5, 6.0], [0.8, 7.5], [2.0, 9.0], [0.0, 10.5]];
    let mirrored = corners.iter().rev().map(|[x, y]| [-x, *y]);
    let corners = corners.iter().copied().chain(mirrored).map(glam::Vec2::from).collect();
    let crown = Crown::from_polygons(&[corners], 1.0).unwrap();
    let grown = grown(&sketch(), Some(&crown), &PropagateParams::default());
    let (all, inside) = lengths(&grown, &crown);
    assert!(all > 50.0 && inside >= 0.995 * all, "{inside} of {all}");
}

#[test]
fn a_crown_without_any_branch_lets_nothing_grow() {
    let far = ellipse([50.0, 5.0], [1.0, 1.0]);
    let grown = grown(&sketch(), Some(&far), &PropagateParams::default());
    assert_eq!(grown.report.n_new, 0);
    assert!(grown.report.n_ends_outside > 0);
}

#[test]
fn one_stroke_becomes_a_tree() {
    for crown in [None, Some(ellipse([0.0, 5.5], [3.0, 3.0]))] {
        let grown = grown(&one_stroke(), crown.as_ref(), &PropagateParams::default());
        assert!(grown.report.n_new > 200, "{:?}", grown.report);
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| grown(&sketch(), Some(&crown()), &PropagateParams::default()))
    };
    assert_eq!(run(1), run(3));
}

#[test]
fn there_are_never_more_segments_than_allowed() {
    let params = PropagateParams { max_segments: 300, generations: 12, ..Default::default() };
    let grown = grown(&sketch(), None, &params);
    assert_eq!(grown.branches.len(), 300);
    assert!(grown.report.n_over_cap > 0);
}

#[test]
fn limits_are_asked_before_memory_is_taken() {
    let control = Control::default().with_limits(Limits { nodes: 100, ..Limits::default() });
    let params = PropagateParams::default();
    let error = propagate(&sketch(), &omega(), None, None, &params, Seed(1), &control).unwrap_err();
    assert!(error.to_string().contains("limit `nodes`"), "{error}");
}

#[test]
fn no_new_segment_enters_an_obstacle() {
    let wall = Volume::box_solid(Vec3::new(1.0, 0.0, -9.0), Vec3::new(1.3, 20.0, 9.0)).unwrap();
    let params = PropagateParams::default();
    let run = |obstacle| {
        propagate(&sketch(), &omega(), None, obstacle, &params, Seed(1), &Control::default())
            .unwrap()
    };
    let grown = run(Some(&wall));
    let guard = Obstacle { volume: wall.clone(), clearance: 0.99 * params.clearance };
    for segment in grown.n_sketched..grown.branches.len() {
        for pair in grown.branches.points(segment).windows(2) {
            assert!(guard.is_free(pair[0], pair[1]), "{segment}");
        }
    }
    let report = grown.report;
    assert!(report.n_turned_aside > 0 && report.n_new > 300, "{report:?}");
    assert_eq!(run(None).report.n_turned_aside, 0);
}

#[test]
fn drawing_on_at_one_branch_leaves_what_grew_on_others() {
    let before = sketch();
    let limb = before.len() - 1;
    let mut b = Builder::on(&before);
    b.add(Some(limb as u32), Label::Apical, [2.6, 9.2, 1.8]);
    let [a, b] = [before, b.build()].map(|s| grown(&s, None, &PropagateParams::default()));
    let elsewhere = |grown: &Propagated| -> Vec<Vec3> {
        let mut on_limb = vec![false; grown.branches.len()];
        let mut ends = Vec::new();
        for segment in 1..grown.branches.len() {
            on_limb[segment] =
                segment == limb || on_limb[grown.branches.parents()[segment] as usize];
            if segment >= grown.n_sketched && !on_limb[segment] {
                ends.push(grown.branches.end(segment));
            }
        }
        ends
    };
    assert!(elsewhere(&a).len() > 300);
    assert!(a.branches.len() - elsewhere(&a).len() > 10);
    assert_eq!(elsewhere(&a), elsewhere(&b));
}

#[test]
fn fronds_do_not_branch() {
    let (control, params) = (Control::default(), PropagateParams::default());
    let grown = propagate(&palm(), &palm_omega(), None, None, &params, Seed(1), &control);
    assert_eq!(grown.unwrap().report.n_new, 0);
}

#[test]
fn nothing_grows_into_the_ground() {
    let mut b = Builder::default();
    let trunk = b.add(None, Label::Apical, [0.0, 0.8, 0.0]);
    b.add(Some(trunk), Label::Apical, [0.0, 6.0, 0.0]);
    b.add(Some(trunk), Label::Lateral(0), [3.0, 0.6, 0.0]);
    let grown = grown(&b.build(), None, &PropagateParams::default());
    let low = |s: usize| grown.branches.points(s).iter().any(|point| point.y < 0.0);
    assert!(grown.report.n_new > 100);
    assert!(!(grown.n_sketched..grown.branches.len()).any(low));
}

#[test]
fn no_generation_grows_nothing() {
    let params = PropagateParams { generations: 0, ..Default::default() };
    assert_eq!(grown(&sketch(), None, &params).report.n_new, 0);
}

#[test]
fn bad_parameters_are_named() {
    let run = |omega: &Omega, params: &PropagateParams| {
        let control = Control::default();
        propagate(&sketch(), omega, None, None, params, Seed(1), &control).unwrap_err().to_string()
    };
    let params = PropagateParams { long: 0.5, ..Default::default() };
    assert!(run(&omega(), &params).starts_with("propagate.long is 0.5"));
    let mut bad = omega();
    bad.orders[0].beta.mean = f32::NAN;
    assert!(run(&bad, &PropagateParams::default()).starts_with("omega.orders[0].beta.mean"));
    bad.orders.clear();
    assert!(run(&bad, &PropagateParams::default()).contains("no order"));
}

#[test]
fn points_beyond_all_measure_are_refused() {
    let mut b = Builder::default();
    b.add(None, Label::Apical, [0.0, 1e9, 0.0]);
    let (branches, control) = (b.build(), Control::default());
    let error =
        propagate(&branches, &omega(), None, None, &PropagateParams::default(), Seed(1), &control);
    assert!(error.unwrap_err().to_string().contains("give metres"));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn any_sketch_grows_into_sound_segments(
        ends in prop::collection::vec((prop::array::uniform3(-4.0_f32..4.0), any::<u32>(), any::<bool>()), 1..12),
        scale in -3.0_f32..2.0,
        seed: u64,
    ) {
        let mut b = Builder::default();
        b.add(None, Label::Apical, [0.0, 3.0, 0.0]);
        for (i, &(end, parent, apical)) in ends.iter().enumerate() {
            let label = if apical { Label::Apical } else { Label::Lateral(i as u16) };
            b.add(Some(parent % (i as u32 + 1)), label, end);
        }
        let mut omega = omega();
        omega.orders[0].scale.mean = scale;
        omega.orders[0].lateral_scale.mean = scale;
        let params = PropagateParams { max_segments: 2000, ..Default::default() };
        let control = Control::default();
        let grown =
            propagate(&b.build(), &omega, Some(&crown()), None, &params, Seed(seed), &control).unwrap();
        let branches = &grown.branches;
        prop_assert_eq!(branches.starts.len(), branches.len() + 1);
        for segment in 1..branches.len() {
            prop_assert!(branches.points(segment).iter().all(|p| p.is_finite()));
            prop_assert!((branches.parents()[segment] as usize) < segment);
        }
    }
}
