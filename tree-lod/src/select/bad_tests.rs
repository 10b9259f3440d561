//! Bad input: typed errors.

use super::tests::{at, eye, frame, model, scene, shown, uniform};
use super::*;
use crate::error::LodError;
use glam::{Mat4, Quat, Vec3};
use tree_core::Control;

#[test]
fn cameras_that_are_none_are_refused() {
    let nan = Mat4::from_cols_array(&[f32::NAN; 16]);
    let mut projective = Mat4::IDENTITY;
    projective.x_axis.w = 0.5;
    let flat = Mat4::from_scale(Vec3::new(1.0, 0.0, -0.1));
    let views = [nan, Mat4::ZERO, projective, Mat4::from_scale(Vec3::splat(2.0))];
    let projections =
        [nan, Mat4::ZERO, projective, flat, Mat4::from_scale(Vec3::new(1.0, 1.0, 0.0))];
    let scene = scene(&[at(Vec3::NEG_Z * 60.0)]);
    let mut state = State::new(&scene, &Control::default()).unwrap();
    let bad = views.map(|view| (Eye { view, ..eye() }, "view")).into_iter();
    let bad = bad.chain(projections.map(|projection| (Eye { projection, ..eye() }, "projection")));
    for (eye, expected) in bad {
        let found = scene.select(&frame(eye, Occlusion::None), &SceneParams::default(), &mut state);
        let named = matches!(found, Err(LodError::Camera { field, .. }) if field == expected);
        assert!(named, "{expected} {eye:?} {found:?}");
    }
}

#[test]
fn depths_of_the_wrong_size_are_refused() {
    let scene = scene(&[at(Vec3::NEG_Z * 60.0)]);
    let mut state = State::new(&scene, &Control::default()).unwrap();
    let depths = uniform(0.5);
    for (width, height) in [(64, 35), (0, 36), (64, 0), (u32::MAX, u32::MAX), (2304, 1 << 16)] {
        let depth = DepthBuffer { depths: &depths, width, height, eye: eye(), y_down: false };
        let frame = frame(eye(), Occlusion::Depth(depth));
        let found = scene.select(&frame, &SceneParams::default(), &mut state);
        assert!(matches!(found, Err(LodError::Scene { what: "depth buffer", .. })));
    }
}

#[test]
fn models_and_instances_that_are_wrong_are_refused() {
    let control = Control::default();
    let models: [fn(&mut Model); 12] = [
        |m| m.center.x = f32::NAN,
        |m| m.radius = 0.0,
        |m| m.radius = f32::INFINITY,
        |m| m.samples = vec![Vec3::ZERO; 65],
        |m| m.samples[3].y = 1e30,
        |m| m.occluders[0].radii.z = -1.0,
        |m| m.far = m.near,
        |m| m.levels.clear(),
        |m| m.levels[0].lambda = 0.0,
        |m| m.levels[5].lambda = m.levels[4].lambda,
        |m| m.levels[5].draws.clear(),
        |m| m.levels[5].draws[0].first_index = u32::MAX,
    ];
    for (i, spoil) in models.iter().enumerate() {
        let mut bad = model();
        spoil(&mut bad);
        let found = Scene::new(&[model(), bad], &[], &control);
        assert!(matches!(found, Err(LodError::Scene { what: "model", row: 1, .. })), "{i}");
    }
    let good = at(Vec3::ZERO);
    let bad = [
        Instance { model: 1, ..good },
        Instance { position: Vec3::NAN, ..good },
        Instance { position: Vec3::X * 1e30, ..good },
        Instance { rotation: Quat::from_xyzw(0.0, 0.0, 0.0, 0.0), ..good },
        Instance { rotation: Quat::from_xyzw(f32::NAN, 0.0, 0.0, 1.0), ..good },
        Instance { scale: 0.0, ..good },
        Instance { scale: f32::NAN, ..good },
    ];
    let mut scene = scene(&[good, good]);
    for (i, bad) in bad.iter().enumerate() {
        let found = Scene::new(&[model()], &[good, *bad], &control);
        assert!(matches!(found, Err(LodError::Scene { what: "instance", row: 1, .. })), "{i}");
        assert!(scene.set_instances(0, &[good, *bad]).is_err());
    }
    assert!(scene.set_instances(1, &[good, good]).is_err());
    assert!(scene.set_instance(usize::MAX, &good).is_err());
}

#[test]
fn parameters_times_and_states_that_are_wrong_are_refused() {
    let trees = scene(&[at(Vec3::NEG_Z * 60.0)]);
    let mut state = State::new(&trees, &Control::default()).unwrap();
    let good = frame(eye(), Occlusion::None);
    let params = SceneParams::default();
    for bad in [
        SceneParams { hidden: 0.0, ..params },
        SceneParams { band: -0.1, ..params },
        SceneParams { time: f32::NAN, ..params },
    ] {
        assert!(matches!(trees.select(&good, &bad, &mut state), Err(LodError::Parameter(_))));
    }
    for seconds in [-1.0, f32::NAN, f32::INFINITY] {
        assert!(trees.select(&Frame { seconds, ..good }, &params, &mut state).is_err());
    }
    let other = scene(&[at(Vec3::ZERO), at(Vec3::ONE)]);
    let found = other.select(&good, &params, &mut state);
    assert!(matches!(found, Err(LodError::Scene { what: "state", .. })));
}

#[test]
fn an_empty_scene_draws_nothing() {
    let scene = Scene::new(&[], &[], &Control::default()).unwrap();
    let (selected, _) = shown(&scene, &frame(eye(), Occlusion::BuiltIn));
    assert_eq!((selected, scene.most_draws()), (Selected::default(), 0));
}

#[test]
fn an_instance_that_was_moved_is_found_where_it_is() {
    let trees: Vec<Instance> = (0..200).map(|i| at(Vec3::Z * (20.0 + i as f32))).collect();
    let mut scene = scene(&trees);
    assert_eq!(shown(&scene, &frame(eye(), Occlusion::None)).0.n_drawn, 0);
    scene.set_instance(77, &at(Vec3::NEG_Z * 50.0)).unwrap();
    let found = shown(&scene, &frame(eye(), Occlusion::None)).1;
    assert!(found.iter().enumerate().all(|(i, tree)| tree.is_some() == (i == 77)));
}
