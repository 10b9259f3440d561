//! Cancelling, limits, seeds, threads and edits.

use super::*;

/// What a case changes.
type Change = fn(&mut Limits);

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
    let cases: [(Change, &str); 4] = [
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
