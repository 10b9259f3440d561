//! Sessions, told by what they do.

use super::*;
use crate::sketch::{Role, Stroke};
use glam::Vec2;

fn cloud(center: Vec2, size: Vec2) -> Stroke {
    let at = |i: i32| {
        let angle = std::f32::consts::TAU * i as f32 / 40.0;
        center + size * Vec2::new(libm::cosf(angle), libm::sinf(angle))
    };
    Stroke { closed: true, ..Stroke::of(Role::Crown, (0..40).map(at).collect()) }
}

fn branch(points: [[f32; 2]; 2]) -> Stroke {
    Stroke::of(Role::Branch, points.map(Vec2::from).to_vec())
}

fn session(strokes: Vec<Stroke>, seed: u64) -> Session {
    Session::new(Drawing { strokes }, SketchParams::default(), Seed(seed)).unwrap()
}

#[test]
fn a_stem_under_a_cloud_is_compared_by_the_cloud_alone() {
    let stem = branch([[50.0, 120.0], [50.0, 90.0]]);
    let mut session = session(vec![stem, cloud(Vec2::new(50.0, 50.0), Vec2::splat(40.0))], 1);
    let choices = session.choices(&Control::default()).unwrap();
    assert!(choices.iter().all(|c| c.branches == 0.0 && c.shape == 0.0 && c.directions == 0.0));
    assert!(choices[0].crown < 0.0);
}

#[test]
fn no_branch_drawn_in_the_crown_sticks_out_of_it_towards_the_viewer() {
    let strokes = || {
        vec![
            branch([[50.0, 120.0], [50.0, 30.0]]),
            branch([[50.0, 80.0], [35.0, 55.0]]),
            branch([[50.0, 75.0], [64.0, 50.0]]),
            branch([[50.0, 55.0], [60.0, 30.0]]),
            cloud(Vec2::new(50.0, 50.0), Vec2::new(18.0, 45.0)),
        ]
    };
    for seed in 0..6 {
        let mut session = session(strokes(), seed);
        let control = Control::default();
        let crown = session.crown(&control).unwrap().unwrap().clone();
        let branches = session.inferred(&control).unwrap().branches.clone();
        for segment in 0..branches.len() {
            let end = branches.end(segment);
            assert!(!crown.contains(end.truncate()) || crown.contains_3d(end), "{seed}: {end}");
        }
    }
}

#[test]
fn no_segment_is_inferred_to_be_more_than_twice_as_long_as_drawn() {
    let strokes = vec![
        branch([[50.0, 120.0], [50.0, 90.0]]),
        branch([[50.0, 90.0], [30.0, 70.0]]),
        branch([[50.0, 90.0], [52.0, 85.0]]),
        branch([[50.0, 90.0], [80.0, 60.0]]),
    ];
    for seed in 0..6 {
        let mut session = session(strokes.clone(), seed);
        let branches = &session.inferred(&Control::default()).unwrap().branches;
        for segment in 0..branches.len() {
            let v = branches.vector(segment);
            assert!(v.length() < 2.01 * v.truncate().length(), "{seed}: {v}");
        }
    }
}

#[test]
fn fronds_of_a_palm_bear_no_branches() {
    let strokes = vec![
        branch([[50.0, 120.0], [50.0, 40.0]]),
        branch([[50.0, 40.0], [20.0, 25.0]]),
        branch([[50.0, 40.0], [80.0, 25.0]]),
        branch([[50.0, 40.0], [45.0, 10.0]]),
    ];
    let params = SketchParams { template: Some("palm".into()), ..Default::default() };
    let mut session = Session::new(Drawing { strokes }, params, Seed(1)).unwrap();
    let branches = &session.propagated(&Control::default()).unwrap().branches;
    assert!(branches.orders().into_iter().max() <= Some(1));
}
