//! From photographs to a tree with what people really bring along: each gives a sound tree or a typed error that
//! says what to do, and never a panic.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use tree_core::glam::Vec2;
use tree_core::{CancelFlag, Control, Limits, NO_PARENT, Seed, Tree};
use tree_model::ModelError;
use tree_model::particle::attractor::AttractorGraph;
use tree_model::particle::density::{DensityBrush, DensityStroke};
use tree_model::particle::session::{
    Attractor, PhotoParams, PhotoTree, Placing, Session, Shot, Stage,
};
use tree_model::particle::{Camera, Matte, Photo, Projection};

const WIDTH: u32 = 64;
const HEIGHT: u32 = 96;

/// A matte that covers the pixels whose centres `covered` tells.
fn matte_of(width: u32, height: u32, covered: impl Fn(f32, f32) -> bool) -> Matte {
    let pixel = |i: u32| covered((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
    let alpha = (0..width * height).map(|i| if pixel(i) { 1.0 } else { 0.0 });
    Matte::new(width, height, alpha.collect()).unwrap()
}

fn in_crown(x: f32, y: f32) -> bool {
    let (dx, dy) = ((x - 32.0) / 24.0, (y - 36.0) / 30.0);
    dx * dx + dy * dy < 1.0
}

fn in_trunk(x: f32, y: f32) -> bool {
    (x - 32.0).abs() < 3.0 && (36.0..92.0).contains(&y)
}

/// A round crown on a trunk.
fn lollipop() -> Matte {
    matte_of(WIDTH, HEIGHT, |x, y| in_crown(x, y) || in_trunk(x, y))
}

fn shot(matte: Matte) -> Shot {
    Shot::new(matte, None, 0.0)
}

/// So few particles and voxels that a tree takes a moment.
fn params() -> PhotoParams {
    let mut params = PhotoParams { branches: 8, ..PhotoParams::default() };
    params.flow.particles = 60;
    params.density.resolution = 16;
    params.field.rows = 30;
    params.livewire.rows = 64;
    params
}

fn session(shots: Vec<Shot>) -> Result<Session, ModelError> {
    Session::new(shots, params(), Seed(1))
}

fn tree(shots: Vec<Shot>) -> Result<PhotoTree, ModelError> {
    session(shots)?.tree(&Control::default()).cloned()
}

/// A tree that any consumer can take.
fn assert_sound(made: &PhotoTree) {
    let skeleton = made.tree.skeleton();
    skeleton.check().unwrap();
    assert!(skeleton.len() > 1, "a tree of one node");
    assert!(skeleton.positions().iter().all(|p| p.is_finite()));
    assert!(skeleton.radii().iter().all(|&r| r.is_finite() && r > 0.0));
    let height = skeleton.bounds().size().y;
    assert!((0.5..40.0).contains(&height), "{height} m high");
    for leaf in made.tree.foliage().iter() {
        let sizes = leaf.size.is_finite() && leaf.size > 0.0;
        assert!(leaf.position.is_finite() && leaf.rotation.is_finite() && sizes, "{leaf:?}");
    }
    let doubts = made.report.warnings();
    assert!(doubts.iter().all(|line| !line.contains("NaN") && !line.contains("inf")), "{doubts:?}");
    // A report that holds a NaN is unequal to itself.
    assert_eq!(made.report, made.report.clone());
}

fn sound(shots: Vec<Shot>) -> PhotoTree {
    let made = tree(shots).unwrap();
    assert_sound(&made);
    made
}

/// The text of an error that must come.
fn error(shots: Vec<Shot>) -> String {
    tree(shots).map(|made| made.report).unwrap_err().to_string()
}

fn warns(made: &PhotoTree, of: &str) {
    let doubts = made.report.warnings();
    assert!(doubts.iter().any(|line| line.contains(of)), "none of {doubts:?} tells of '{of}'");
}

// --- What the pictures show -----------------------------------------------------------------------------

#[test]
fn one_clean_photograph_gives_a_tree_without_warnings() {
    let made = sound(vec![shot(lollipop())]);
    assert_eq!(made.report.warnings(), Vec::<String>::new());
}

#[test]
fn views_may_be_of_different_sizes() {
    let small = matte_of(32, 48, |x, y| in_crown(2.0 * x, 2.0 * y) || in_trunk(2.0 * x, 2.0 * y));
    let wide =
        matte_of(200, 120, |x, y| in_crown(x - 68.0, y - 12.0) || in_trunk(x - 68.0, y - 12.0));
    let shots = [lollipop(), small, wide].map(|matte| shot(matte)).into_iter().enumerate();
    sound(shots.map(|(i, shot)| Shot { placing: Placing::at(2.1 * i as f32), ..shot }).collect());
}

#[test]
fn identical_and_opposite_views_give_a_tree() {
    sound(vec![shot(lollipop()), shot(lollipop())]);
    let back = Shot::new(lollipop().mirrored(), None, std::f32::consts::PI);
    sound(vec![shot(lollipop()), back]);
}

#[test]
fn empty_and_full_pictures_are_refused_with_advice() {
    for (full, says) in [(false, "no pixel is covered"), (true, "all pixels are covered")] {
        let bad = matte_of(WIDTH, HEIGHT, |_, _| full);
        let text = error(vec![shot(lollipop()), shot(bad)]);
        assert!(
            text.contains("views[1]") && text.contains(says) && text.contains("matt"),
            "{text}"
        );
    }
}

#[test]
fn tiny_pictures_are_refused() {
    for (width, height) in [(1, 1), (1, 2), (2, 1), (40, 1), (1, 40), (2, 2), (3, 3)] {
        for covered in [0, 1] {
            let matte = matte_of(width, height, |x, _| covered == 1 && x < width as f32 - 0.5);
            match tree(vec![shot(matte)]) {
                Ok(made) => assert_sound(&made),
                Err(error) => assert!(matches!(error, ModelError::View { view: 0, .. }), "{error}"),
            }
        }
    }
    let one = Matte::new(1, 1, vec![1.0]).unwrap();
    assert!(error(vec![shot(one)]).contains("views[0]"));
}

#[test]
fn a_crown_without_a_trunk_gives_a_tree_and_a_warning() {
    warns(&sound(vec![shot(matte_of(WIDTH, HEIGHT, in_crown))]), "no bare trunk");
}

#[test]
fn disconnected_crowns_give_a_tree_and_a_warning() {
    let tufts = |x: f32, y: f32| in_trunk(x, y) || (in_crown(x, y) && (y as u32) % 20 < 8);
    warns(&sound(vec![shot(matte_of(WIDTH, HEIGHT, tufts))]), "parts");
    let two = |x: f32, y: f32| {
        let beside = (x - 10.0).hypot(y - 12.0) < 7.0 || (x - 54.0).hypot(y - 12.0) < 7.0;
        beside || (in_trunk(x, y) && y > 50.0)
    };
    warns(&sound(vec![shot(matte_of(WIDTH, HEIGHT, two))]), "parts");
}

#[test]
fn lines_noise_haze_and_cut_off_trees_give_a_tree() {
    let noise = |x: f32, y: f32| (x as u32 * 7919 + y as u32 * 104_729) % 97 < 9;
    let cases: [(&str, Matte); 7] = [
        ("line", matte_of(WIDTH, HEIGHT, |x, y| x as u32 == 30 && y > 5.0)),
        ("level line", matte_of(WIDTH, HEIGHT, |_, y| (40.0..43.0).contains(&y))),
        ("noise", matte_of(WIDTH, HEIGHT, noise)),
        ("leaning line", matte_of(WIDTH, HEIGHT, |x, y| (x - 0.6 * y).abs() < 1.0)),
        ("cut off", matte_of(40, 50, |x, y| in_crown(x + 20.0, y + 20.0) || in_trunk(x, y))),
        ("all but a pixel", matte_of(WIDTH, HEIGHT, |x, y| x > 1.0 || y > 1.0)),
        (
            "haze",
            Matte::new(
                WIDTH,
                HEIGHT,
                lollipop().alpha().iter().map(|&alpha| 0.32 * alpha + 0.01).collect(),
            )
            .unwrap(),
        ),
    ];
    for (name, matte) in cases {
        let made = tree(vec![shot(matte)]).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_sound(&made);
    }
    // Too little for the threshold, with a view imagined or without.
    let dots = matte_of(WIDTH, HEIGHT, |x, y| x as u32 % 9 == 0 && y as u32 % 9 == 0);
    let text = error(vec![shot(dots)]);
    assert!(text.contains("views[0]") && text.contains("threshold"), "{text}");
    // A single pixel is no tree.
    assert!(
        error(vec![shot(matte_of(WIDTH, HEIGHT, |x, y| x < 1.0 && y < 1.0))]).contains("views[0]")
    );
}

#[test]
fn views_that_contradict_each_other_are_named() {
    let bush = matte_of(WIDTH, HEIGHT, |x, y| y > 80.0 && (10.0..60.0).contains(&x));
    let side = Shot { placing: Placing::at(1.5), ..shot(bush) };
    let made = sound(vec![shot(lollipop()), side]);
    assert!(!made.report.warnings().is_empty());
}

// --- Files -----------------------------------------------------------------------------------------------

#[test]
fn broken_files_are_refused() {
    let n = 20 * 30;
    let pixels: Vec<[u8; 4]> = (0..n).map(|i| [i as u8, (i * 7) as u8, 90, 255]).collect();
    let png = Photo::new(20, 30, pixels).unwrap().to_png().unwrap();
    let mut jpeg = Vec::new();
    let grey = image::GrayImage::from_fn(20, 30, |x, y| image::Luma([(x * y) as u8]));
    image::codecs::jpeg::JpegEncoder::new(&mut jpeg).encode_image(&grey).unwrap();
    let limits = Limits { pixels: 1 << 20, ..Limits::default() };
    let judge = |bytes: &[u8], what: &str| match Photo::decode(bytes, &limits) {
        // Some damage leaves a picture.
        Ok(photo) => assert_eq!(
            photo.pixels().len(),
            photo.width() as usize * photo.height() as usize,
            "{what}"
        ),
        Err(ModelError::Picture { .. } | ModelError::Limit(_)) => {}
        Err(error) => panic!("{what}: {error}"),
    };
    for (name, whole) in [("PNG", &png), ("JPEG", &jpeg)] {
        assert!(Photo::decode(whole, &limits).is_ok());
        for length in 0..whole.len() {
            judge(&whole[..length], &format!("{name} of {length} bytes"));
            for value in [0, 0x7f, 0xff, whole[length] ^ 0x10] {
                let mut broken = whole.clone();
                broken[length] = value;
                judge(&broken, &format!("{name} with byte {length} as {value}"));
            }
        }
        // Half a picture is none.
        assert!(matches!(
            Photo::decode(&whole[..whole.len() / 2], &limits),
            Err(ModelError::Picture { .. })
        ));
    }
    let mut state = 1_u32;
    for length in 0..300 {
        let bytes = |_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        };
        let mut random: Vec<u8> = (0..length).map(bytes).collect();
        judge(&random, "random bytes");
        random.splice(0..0, png[..33].iter().copied());
        judge(&random, "random bytes behind a header");
    }
}

// --- Numbers ---------------------------------------------------------------------------------------------

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
    let cases: [(fn(&mut PhotoParams, f32), &str); 9] = [
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
    assert!(matches!(session(vec![]), Err(ModelError::Parameter { .. })));
    let photo = Photo::new(3, 2, vec![[9; 4]; 6]).unwrap();
    let odd = Shot { photo: Some(photo), ..shot(lollipop()) };
    let error = session(vec![shot(lollipop()), odd]).unwrap_err().to_string();
    assert!(error.contains("views[1]") && error.contains("3 × 2"), "{error}");
}

// --- Branches by hand ------------------------------------------------------------------------------------

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

// --- Cancelling and limits -------------------------------------------------------------------------------

#[test]
fn work_stops_when_cancelled_and_goes_on_after() {
    let flag = CancelFlag::default();
    flag.cancel();
    let mut session = session(vec![shot(lollipop())]).unwrap();
    let result = session.tree(&Control::default().with_cancel(flag)).map(|_| ());
    assert!(matches!(result, Err(ModelError::Cancelled(_))), "{result:?}");
    assert_eq!(Stage::ALL.map(|stage| session.runs(stage)), [0; 7]);
    let whole = sound(vec![shot(lollipop())]);
    // Stopped at many places, one after another, the same session ends with the same tree.
    for most in [3, 10, 30, 60, 100, 200, 400] {
        let asked = Arc::new(AtomicU32::new(0));
        let stop = move || asked.fetch_add(1, Ordering::Relaxed) >= most;
        match session.tree(&Control::default().with_stop(stop)) {
            Ok(made) => assert_eq!(made, &whole),
            Err(error) => assert!(matches!(error, ModelError::Cancelled(_)), "{error}"),
        }
    }
    assert_eq!(session.tree(&Control::default()).unwrap(), &whole);
}

#[test]
fn limits_are_kept() {
    let cases: [(fn(&mut Limits), &str); 4] = [
        (|limits| limits.pixels = 100, "pixels"),
        (|limits| limits.voxels = 100, "voxels"),
        (|limits| limits.nodes = 50, "nodes"),
        (|limits| limits.leaves = 10, "leaves"),
    ];
    for (change, field) in cases {
        let mut limits = Limits::default();
        change(&mut limits);
        let mut session = session(vec![shot(lollipop())]).unwrap();
        let control = Control::default().with_limits(limits);
        match session.tree(&control).map(|_| ()) {
            Err(ModelError::Limit(limit)) => assert_eq!(limit.resource.field(), field),
            other => panic!("{field}: {other:?}"),
        }
        // The session is none the worse.
        assert_sound(session.tree(&Control::default()).unwrap());
    }
}

// --- The same again --------------------------------------------------------------------------------------

#[test]
fn one_and_three_threads_give_the_same_tree() {
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let side = Shot { placing: Placing::at(1.3), ..shot(lollipop()) };
        pool.install(|| tree(vec![shot(lollipop()), side]).unwrap())
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn five_seeds_give_five_trees() {
    let mut session = session(vec![shot(lollipop())]).unwrap();
    let mut trees: Vec<Tree> = Vec::new();
    for seed in 1..=5 {
        session.set_seed(Seed(seed));
        let made = session.tree(&Control::default()).unwrap();
        assert!(!trees.contains(&made.tree));
        trees.push(made.tree.clone());
    }
    assert_eq!(Stage::ALL.map(|stage| session.runs(stage)), [1, 1, 1, 1, 5, 5, 5]);
}

/// A session's tree after a change, with the stages done anew, against one made from the start as it is now.
fn changed(change: impl Fn(&mut Session), runs: [u32; 7], is_as_fresh: bool) {
    let mut session = session(vec![shot(lollipop())]).unwrap();
    let control = Control::default();
    session.tree(&control).unwrap();
    change(&mut session);
    let made = session.tree(&control).unwrap().clone();
    assert_sound(&made);
    assert_eq!(Stage::ALL.map(|stage| session.runs(stage)), runs);
    if is_as_fresh {
        let shots = session.shots().to_vec();
        let mut fresh = Session::new(shots, session.params().clone(), session.seed()).unwrap();
        assert_eq!(fresh.tree(&control).unwrap().tree, made.tree);
        assert_eq!(fresh.tree(&control).unwrap().report.warnings(), made.report.warnings());
    }
}

#[test]
fn a_change_redoes_what_depends_on_it_and_gives_what_a_new_session_gives() {
    let with = |change: fn(&mut PhotoParams)| {
        move |session: &mut Session| {
            let mut params = session.params().clone();
            change(&mut params);
            session.set_params(params).unwrap();
        }
    };
    changed(|_| (), [1, 1, 1, 1, 1, 1, 1], true);
    changed(with(|params| params.height = 3.0), [2; 7], true);
    changed(with(|params| params.imagine = false), [2; 7], true);
    changed(with(|params| params.branches = 3), [1, 2, 1, 2, 2, 2, 2], true);
    changed(with(|params| params.density.rounding = 0.5), [1, 1, 2, 1, 2, 2, 2], true);
    changed(with(|params| params.field.rows = 20), [1, 1, 1, 2, 2, 2, 2], true);
    changed(with(|params| params.flow.stem = 0.9), [1, 1, 1, 1, 2, 2, 2], true);
    changed(with(|params| params.flow.particles = 50), [1, 1, 1, 1, 2, 2, 2], true);
    changed(with(|params| params.finish.smoothing += 1), [1, 1, 1, 1, 1, 2, 2], true);
    changed(|session| session.set_placing(0, Placing::at(0.5)).unwrap(), [2; 7], true);
    changed(
        |session| session.set_attractor(0, Attractor::None).unwrap(),
        [1, 2, 1, 2, 2, 2, 2],
        true,
    );
}

#[test]
fn branches_changed_by_hand_are_those_of_the_imagined_side_too() {
    let erase = |session: &mut Session| {
        let keep = |graph: &AttractorGraph| {
            graph.erase(&[Vec2::new(10.0, 20.0)], 20.0, Default::default()).map(|(graph, _)| graph)
        };
        session.edit_attractor(0, &Control::default(), keep).unwrap();
    };
    changed(erase, [1, 1, 1, 2, 2, 2, 2], true);
}

#[test]
fn painting_keeps_what_was_found_before() {
    let stroke = |value, at: Vec2| DensityStroke {
        points: vec![at, at + Vec2::new(0.0, 12.0)],
        width: 14.0,
        value,
        ..DensityStroke::default()
    };
    let paint = |session: &mut Session| {
        let strokes = [stroke(1.0, Vec2::new(58.0, 30.0)), stroke(0.0, Vec2::new(14.0, 30.0))];
        session.paint(0, &strokes).unwrap();
    };
    changed(paint, [1, 1, 2, 1, 2, 2, 2], false);
    let brush = |session: &mut Session| {
        let brush = DensityBrush::default();
        session.paint_volume(&[brush], &Control::default()).unwrap();
    };
    changed(brush, [1, 1, 1, 1, 2, 2, 2], false);
}

#[test]
fn a_tree_erased_to_nothing_is_refused_and_comes_back() {
    let mut session = session(vec![shot(lollipop())]).unwrap();
    let control = Control::default();
    let before = session.tree(&control).unwrap().clone();
    session.set_matte(0, matte_of(WIDTH, HEIGHT, |_, _| false)).unwrap();
    let error = session.tree(&control).map(|_| ()).unwrap_err();
    assert!(matches!(error, ModelError::View { view: 0, .. }), "{error}");
    session.set_matte(0, lollipop()).unwrap();
    assert_eq!(session.tree(&control).unwrap().tree, before.tree);
    // A density of nothing, too.
    let mut empty = session.density(&control).unwrap().clone();
    empty.values_mut().fill(0.0);
    session.set_density(empty.clone());
    assert!(session.tree(&control).is_err());
    empty.values_mut().fill(f32::NAN);
    session.set_density(empty);
    assert!(session.tree(&control).is_err());
    assert!(session.set_placing(7, Placing::at(0.0)).is_err());
    assert!(session.strokes(7, &control).is_err());
}
