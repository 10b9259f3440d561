//! Cameras, parameters and strokes.

use super::*;

/// What a case changes.
type Change = fn(&mut PhotoParams, f32);

fn placed(change: impl Fn(&mut Camera)) -> Placing {
    let mut camera = Camera {
        yaw: 0.0,
        pitch: 0.0,
        projection: Projection::Orthographic,
        size: Vec2::new(WIDTH as f32, HEIGHT as f32),
        base: Vec2::new(32.0, 92.0),
        scale: 10.0 / 86.0,
    };
    change(&mut camera);
    Placing::Placed(camera)
}

#[test]
fn cameras_that_are_no_numbers_are_named() {
    let nan = f32::NAN;
    let perspective = Projection::Perspective { fov: nan };
    let aligned = |yaw, pitch, projection| Placing::Aligned { yaw, pitch, projection };
    let cases = [
        (placed(|camera| camera.yaw = nan), "yaw"),
        (placed(|camera| camera.pitch = f32::INFINITY), "pitch"),
        (placed(|camera| camera.scale = nan), "scale"),
        (placed(|camera| camera.scale = 0.0), "scale"),
        (placed(|camera| camera.base.x = nan), "base.x"),
        (placed(|camera| camera.size.y = nan), "size.y"),
        (placed(|camera| camera.projection = perspective), "fov"),
        (aligned(nan, 0.0, Projection::Orthographic), "yaw"),
        (aligned(0.0, nan, Projection::Orthographic), "pitch"),
        (aligned(0.0, 0.0, perspective), "fov"),
    ];
    for (placing, field) in cases {
        let text = error(vec![shot(lollipop()), Shot { placing, ..shot(lollipop()) }]);
        assert!(text.contains(field) && text.contains("shots[1]"), "{field}: {text}");
    }
}

#[test]
fn parameters_that_are_no_numbers_are_named() {
    let nan = f32::NAN;
    let cases: [(Change, &str); 9] = [
        (|params, v| params.height = v, "height"),
        (|params, v| params.seeds.lowest = v, "seeds.lowest"),
        (|params, v| params.livewire.follow = v, "livewire.follow"),
        (|params, v| params.strokes.snap = v, "strokes.snap"),
        (|params, v| params.density.evenness = v, "density.evenness"),
        (|params, v| params.field.margin = v, "field.margin"),
        (|params, v| params.flow.step = v, "step"),
        (|params, v| params.finish.slenderness = v, "slenderness"),
        (|params, v| params.finish.fullness = v, "fullness"),
    ];
    let mut session = session(vec![shot(lollipop())]).unwrap();
    for (change, field) in cases {
        let mut bad = params();
        change(&mut bad, nan);
        let error = Session::new(vec![shot(lollipop())], bad.clone(), Seed(1)).unwrap_err();
        assert!(error.to_string().contains(field), "{field}: {error}");
        assert!(session.set_params(bad).is_err());
        assert_eq!(session.params(), &params());
    }
}

#[test]
fn known_cameras_need_no_trunk_in_their_mattes() {
    // Only foliage from above: no base, no trunk, covered all over.
    let above = placed(|camera| (camera.pitch, camera.base.y) = (1.4, 48.0));
    let full = matte_of(WIDTH, HEIGHT, |_, _| true);
    let other = Shot { placing: above, ..shot(full.clone()) };
    sound(vec![shot(lollipop()), other]);
    let made = sound(vec![Shot { placing: placed(|_| ()), ..shot(full) }]);
    warns(&made, "covered all over");
    // What alignment thinks of a camera that the caller knows does not matter.
    let crown = Shot { placing: placed(|_| ()), ..shot(matte_of(WIDTH, HEIGHT, in_crown)) };
    let made = sound(vec![crown]);
    assert_eq!(made.report.views[0].warnings, []);
    let empty = matte_of(WIDTH, HEIGHT, |_, _| false);
    let text = error(vec![Shot { placing: placed(|_| ()), ..shot(empty) }]);
    assert!(text.contains("views[0]"), "{text}");
}

#[test]
fn known_cameras_anywhere_give_a_tree_or_name_the_view() {
    let changes: [fn(&mut Camera); 10] = [
        |camera| camera.yaw = 1e6,
        |camera| camera.pitch = -1.5,
        |camera| camera.pitch = 1.5,
        |camera| camera.scale = 1e-7,
        |camera| camera.scale = 1e6,
        |camera| camera.base = Vec2::new(-1e6, 1e6),
        |camera| camera.base = Vec2::new(32.0, -50.0),
        |camera| camera.size = Vec2::splat(50.0),
        |camera| camera.projection = Projection::Perspective { fov: 0.017 },
        |camera| camera.projection = Projection::Perspective { fov: 2.8 },
    ];
    for (i, change) in changes.into_iter().enumerate() {
        let odd = Shot { placing: placed(change), ..shot(lollipop()) };
        for shots in [vec![odd.clone()], vec![shot(lollipop()), odd]] {
            match tree(shots) {
                Ok(made) => made.tree.skeleton().check().unwrap(),
                Err(ModelError::View { .. }) => {}
                Err(error) => panic!("camera {i}: {error}"),
            }
        }
    }
}

#[test]
fn no_photographs_and_photographs_of_another_size_are_refused() {
    assert!(matches!(session(vec![]), Err(ModelError::Parameter(_))));
    let photo = Photo::new(3, 2, vec![[9; 4]; 6]).unwrap();
    let odd = Shot { photo: Some(photo), ..shot(lollipop()) };
    let error = session(vec![shot(lollipop()), odd]).unwrap_err().to_string();
    assert!(error.contains("views[1]") && error.contains("3 × 2"), "{error}");
}

#[test]
fn odd_strokes_and_seeds_give_a_tree() {
    let nan = f32::NAN;
    let line = |points: &[(f32, f32)]| points.iter().map(|&p| Vec2::from(p)).collect::<Vec<_>>();
    let good = || line(&[(32.0, 90.0), (32.0, 20.0)]);
    let cases = [
        Attractor::None,
        Attractor::Graph(AttractorGraph::default()),
        Attractor::Graph(
            AttractorGraph::new(line(&[(-3e38, 1.0), (3e38, 2e38)]), vec![NO_PARENT, 0]).unwrap(),
        ),
        Attractor::Strokes(vec![]),
        Attractor::Strokes(vec![vec![], line(&[(3.0, 3.0)]), line(&[(5.0, 5.0), (5.0, 5.0)])]),
        Attractor::Strokes(vec![line(&[(nan, 3.0), (1.0, f32::INFINITY)]), good()]),
        Attractor::Strokes(vec![line(&[(1e9, 1e9), (-1e9, 2e9)]), good()]),
        Attractor::Strokes(vec![line(&[(3e37, 1e37), (-1e37, 2e37)]), good()]),
        Attractor::Strokes(vec![line(&[(-500.0, -500.0), (-400.0, 900.0)])]),
        Attractor::Strokes(vec![good(); 20]),
        Attractor::Seeds(vec![]),
        Attractor::Seeds(line(&[(-50.0, -50.0), (1e30, -1e30), (nan, 1.0), (32.0, 6.0)])),
        Attractor::Seeds(line(&[(32.0, 92.0); 9])),
    ];
    for attractor in cases {
        let name = format!("{attractor:?}");
        println!("{name}");
        let given = Shot { attractor, ..shot(lollipop()) };
        let control = Control::default();
        let mut alone = session(vec![given.clone()]).unwrap();
        let made = alone.tree(&control).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_sound(made);
        alone.picture_of_attractor(0, &control).unwrap();
        alone.picture_of_field(0, &control).unwrap();
        alone.picture_of_traces(0, &control).unwrap();
        assert_sound(&tree(vec![given.clone(), given]).unwrap());
    }
}

#[test]
fn a_stroke_far_away_takes_no_other_with_it() {
    let far = vec![Vec2::splat(1e25), Vec2::splat(2e25)];
    let good = vec![Vec2::new(32.0, 90.0), Vec2::new(32.0, 20.0)];
    let strokes = Attractor::Strokes(vec![far, good]);
    let made = sound(vec![Shot { attractor: strokes, ..shot(lollipop()) }]);
    let report = made.report.views[0].strokes.as_ref().unwrap();
    assert!(report.gaps[1].is_some(), "{report:?}");
}
