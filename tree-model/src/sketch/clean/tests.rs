use super::*;
use crate::sketch::Stroke;
use proptest::prelude::*;

fn line(list: &[(f32, f32)]) -> Vec<Vec2> {
    list.iter().map(|&(x, y)| Vec2::new(x, y)).collect()
}

fn branch(list: &[(f32, f32)]) -> Stroke {
    Stroke::of(Role::Branch, line(list))
}

fn circle(center: (f32, f32), radius: f32) -> Vec<Vec2> {
    let angle = |i: u32| std::f32::consts::TAU * i as f32 / 48.0;
    let at =
        |i| Vec2::from(center) + radius * Vec2::new(libm::cosf(angle(i)), libm::sinf(angle(i)));
    (0..48).map(at).collect()
}

fn drawing(strokes: impl IntoIterator<Item = Stroke>) -> Drawing {
    Drawing { strokes: strokes.into_iter().collect() }
}

fn run(strokes: impl IntoIterator<Item = Stroke>) -> Cleaned {
    run_with(strokes, &CleanParams::default())
}

fn run_with(strokes: impl IntoIterator<Item = Stroke>, params: &CleanParams) -> Cleaned {
    clean(&drawing(strokes), params, &Control::default()).unwrap()
}

fn error(strokes: impl IntoIterator<Item = Stroke>, params: &CleanParams) -> String {
    clean(&drawing(strokes), params, &Control::default()).unwrap_err().to_string()
}

fn n_children(plan: &Plan) -> Vec<usize> {
    let mut n = vec![0; plan.len()];
    for &parent in plan.parents().iter().filter(|&&parent| parent != NO_PARENT) {
        n[parent as usize] += 1;
    }
    n
}

fn n_tips(plan: &Plan) -> usize {
    n_children(plan).iter().filter(|&&n| n == 0).count()
}

/// Distance of a point of the drawing from the plan, in units of the drawing.
fn off(plan: &Plan, point: Vec2) -> f32 {
    let at = |node: usize| plan.to_drawing(plan.positions()[node]);
    let edges = (1..plan.len()).map(|node| (at(node), at(plan.parents()[node] as usize)));
    edges.map(|(a, b)| sample::closest(point, a, b).1).fold(f32::INFINITY, f32::min)
}

fn has(cleaned: &Cleaned, is: impl Fn(&RepairKind) -> bool) -> bool {
    cleaned.report.repairs.iter().any(|repair| is(&repair.kind))
}

const TRUNK: [(f32, f32); 2] = [(50.0, 100.0), (50.0, 0.0)];
const LEFT: [(f32, f32); 2] = [(49.0, 60.0), (10.0, 20.0)];
const RIGHT: [(f32, f32); 2] = [(52.0, 40.0), (90.0, 10.0)];

#[test]
fn branches_join_the_trunk_whatever_the_order_and_direction() {
    let strokes = [branch(&TRUNK), branch(&LEFT), branch(&RIGHT)];
    let shape = |order: [usize; 3], turned: [bool; 3]| {
        let cleaned = run(order.map(|i| {
            let mut stroke = strokes[i].clone();
            if turned[i] {
                stroke.points.reverse();
            }
            stroke
        }));
        let plan = cleaned.plan;
        assert_eq!(n_tips(&plan), 3);
        plan.positions().to_vec()
    };
    let same = |a: &[Vec2], b: &[Vec2]| {
        a.len() == b.len() && a.iter().all(|p| b.iter().any(|q| p.distance(*q) < 1e-3))
    };
    let first = shape([0, 1, 2], [false; 3]);
    for order in [[1, 0, 2], [2, 1, 0], [1, 2, 0]] {
        for turned in [[true, false, true], [false, true, true], [true; 3]] {
            assert!(same(&shape(order, turned), &first));
        }
    }
}

#[test]
fn the_base_is_the_origin_and_the_height_as_asked() {
    let crown = Stroke::of(Role::Crown, circle((50.0, 0.0), 50.0));
    let cleaned =
        run_with([branch(&TRUNK), crown], &CleanParams { height: 30.0, ..Default::default() });
    assert_eq!(cleaned.plan.positions()[0], Vec2::ZERO);
    assert_eq!(cleaned.plan.base, Vec2::new(50.0, 100.0));
    let top = cleaned.crown[0].iter().map(|p| p.y).fold(0.0, f32::max);
    assert!((top - 30.0).abs() < 0.01, "{top}");
    assert_eq!(cleaned.crown_strokes, [1]);
}

#[test]
fn a_trunk_drawn_from_the_top_is_turned_round() {
    let trunk = Stroke::of(Role::Trunk, line(&[(50.0, 0.0), (50.0, 100.0)]));
    let cleaned = run([trunk]);
    assert!(has(&cleaned, |kind| *kind == RepairKind::TurnedRound));
    assert_eq!(cleaned.plan.base.y, 100.0);
}

#[test]
fn no_drawn_point_is_farther_than_a_fifth_of_a_percent() {
    let jagged: Vec<(f32, f32)> = (0..60)
        .map(|i| (50.0 + 7.0 * ((i * 37 % 11) as f32 - 5.0) / 5.0, 100.0 - i as f32))
        .collect();
    let strokes = [branch(&jagged), branch(&[(52.0, 41.0), (80.0, 40.0), (80.0, 10.0)])];
    let cleaned = run(strokes.clone());
    for point in strokes.iter().flat_map(|stroke| &stroke.points) {
        let off = off(&cleaned.plan, *point);
        assert!(off < 0.002 * 90.0, "{point} is {off} off");
    }
}

#[test]
fn a_stroke_over_another_is_merged_into_it() {
    let again = [(50.5, 90.0), (50.5, 30.0)];
    let cleaned = run([branch(&TRUNK), branch(&again)]);
    assert!(has(&cleaned, |kind| *kind == RepairKind::Merged(0)));
    assert_eq!(n_tips(&cleaned.plan), 1);
}

#[test]
fn what_goes_beyond_an_overdrawn_stroke_is_a_branch() {
    let along = [(50.5, 90.0), (50.5, 50.0), (90.0, 20.0)];
    let cleaned = run([branch(&TRUNK), branch(&along)]);
    assert!(has(&cleaned, |kind| *kind == RepairKind::MergedPartly(0)));
    assert_eq!(n_tips(&cleaned.plan), 2);
    assert!(off(&cleaned.plan, Vec2::new(90.0, 20.0)) < 1e-3);
}

#[test]
fn an_end_that_sticks_out_beyond_the_trunk_is_cut_off() {
    let cleaned = run([branch(&TRUNK), branch(&[(48.0, 60.0), (90.0, 30.0)])]);
    assert!(has(&cleaned, |kind| matches!(kind, RepairKind::Trimmed(0, _))));
    assert_eq!(n_tips(&cleaned.plan), 2);
}

#[test]
fn gaps_are_snapped_or_bridged_and_told() {
    let cleaned = run([branch(&TRUNK), branch(&[(52.0, 60.0), (90.0, 30.0)])]);
    let gap = |kind: &RepairKind| match kind {
        RepairKind::Snapped(share) | RepairKind::Bridged(share) => Some(*share),
        _ => None,
    };
    let gaps =
        |c: &Cleaned| c.report.repairs.iter().filter_map(|r| gap(&r.kind)).collect::<Vec<_>>();
    assert!((gaps(&cleaned)[0] - 0.02).abs() < 1e-3);
    let cleaned = run([branch(&TRUNK), branch(&[(70.0, 60.0), (90.0, 30.0)])]);
    assert!(has(&cleaned, |kind| matches!(kind, RepairKind::Bridged(_))));
    assert!((gaps(&cleaned)[0] - 0.2).abs() < 1e-3);
    let text = cleaned.report.repairs.last().unwrap().to_string();
    assert_eq!(text, "strokes[1] was joined over a gap of 20.0 % of the height");
}

#[test]
fn strokes_that_merely_cross_do_not_join_there() {
    let a = branch(&[(51.0, 60.0), (90.0, 20.0)]);
    let b = branch(&[(51.0, 20.0), (90.0, 60.0)]);
    let cleaned = run([branch(&TRUNK), a, b]);
    let forks = n_children(&cleaned.plan).iter().filter(|&&n| n > 1).count();
    assert_eq!((n_tips(&cleaned.plan), forks), (3, 2));
    let node = cleaned.plan.from_drawing(Vec2::new(70.5, 40.0));
    let fork_there = n_children(&cleaned.plan)
        .iter()
        .zip(cleaned.plan.positions())
        .any(|(&n, p)| n > 1 && p.distance(node) < 1.0);
    assert!(!fork_there);
}

#[test]
fn a_stroke_from_limb_to_limb_through_the_trunks_top_is_split() {
    let limbs = branch(&[(10.0, -30.0), (50.0, 0.5), (90.0, -30.0)]);
    let cleaned = run([branch(&TRUNK), limbs]);
    assert!(has(&cleaned, |kind| *kind == RepairKind::Split));
    assert_eq!(n_tips(&cleaned.plan), 2);
}

#[test]
fn limbs_drawn_in_one_go_through_the_base_begin_there() {
    let cleaned = run([branch(&[(10.0, 0.0), (50.0, 100.0), (90.0, 0.0)])]);
    assert_eq!(cleaned.plan.base, Vec2::new(50.0, 100.0));
    assert_eq!(n_tips(&cleaned.plan), 2);
}

#[test]
fn a_second_stem_is_joined_to_the_base() {
    let stem = branch(&[(80.0, 99.0), (85.0, 20.0)]);
    let cleaned = run([branch(&TRUNK), stem]);
    assert!(has(&cleaned, |kind| matches!(kind, RepairKind::SecondRoot(_))));
    assert_eq!(n_children(&cleaned.plan)[0], 2);
}

#[test]
fn isolated_strokes_are_bridged_dropped_or_refused() {
    let strokes = || [branch(&TRUNK), branch(&[(90.0, 50.0), (99.0, 30.0)])];
    let with = |isolated| CleanParams { isolated, ..Default::default() };
    assert_eq!(n_tips(&run(strokes()).plan), 2);
    let dropped = run_with(strokes(), &with(Isolated::Drop));
    assert_eq!(n_tips(&dropped.plan), 1);
    assert!(has(&dropped, |kind| matches!(kind, RepairKind::Isolated(_))));
    let refused = error(strokes(), &with(Isolated::Refuse));
    assert!(refused.starts_with("strokes[1]: is 40.0 % "), "{refused}");
}

#[test]
fn the_base_can_be_given() {
    let params = CleanParams { root: Some(Vec2::new(12.0, 19.0)), ..Default::default() };
    let cleaned = run_with([branch(&TRUNK), branch(&LEFT)], &params);
    assert_eq!(cleaned.plan.base, Vec2::new(10.0, 20.0));
}

#[test]
fn a_loop_round_the_branches_is_the_crown() {
    let crown = Stroke { closed: true, ..Stroke::new(circle((50.0, 20.0), 45.0)) };
    let strokes = [TRUNK, LEFT, RIGHT].map(|points| Stroke::new(line(&points)));
    let cleaned = run(strokes.into_iter().chain([crown]));
    assert_eq!(cleaned.crown_strokes, [3]);
    assert_eq!(n_tips(&cleaned.plan), 3);
}

#[test]
fn arcs_round_the_branches_ends_are_the_crown() {
    let round = circle((50.0, 30.0), 45.0);
    let arcs = [26..33, 34..40, 41..46].map(|range| Stroke::new(round[range].to_vec()));
    let strokes = [TRUNK, [(49.0, 60.0), (25.0, 30.0)], [(51.0, 50.0), (75.0, 25.0)]];
    let mut strokes = strokes.map(|points| Stroke::new(line(&points)));
    strokes[0].points[1].y = 10.0;
    let cleaned = run(strokes.into_iter().chain(arcs));
    assert_eq!(cleaned.crown_strokes, [3, 4, 5]);
}

#[test]
fn two_sides_of_a_trunk_become_its_middle() {
    let crown = Stroke { closed: true, ..Stroke::new(circle((50.0, 20.0), 40.0)) };
    let sides = [[(44.0, 100.0), (46.0, 58.0)], [(55.0, 58.0), (57.0, 100.0)]];
    let cleaned = run(sides.map(|side| Stroke::new(line(&side))).into_iter().chain([crown]));
    assert!(has(&cleaned, |kind| *kind == RepairKind::MiddleOfSides(0)));
    assert_eq!(n_tips(&cleaned.plan), 1);
    assert!((cleaned.plan.base - Vec2::new(50.5, 100.0)).length() < 0.1);
}

#[test]
fn without_guessing_what_is_not_marked_is_a_branch() {
    let circle = Stroke::new(circle((50.0, 20.0), 40.0)[2..40].to_vec());
    let strokes = [Stroke::new(line(&TRUNK)), circle];
    let params = CleanParams { guess: false, ..Default::default() };
    assert!(run_with(strokes, &params).crown.is_empty());
}

#[test]
fn of_a_filled_branch_the_middle_line_is_taken() {
    let outline = line(&[(45.0, 100.0), (47.0, 0.0), (53.0, 0.0), (55.0, 100.0)]);
    let filled = Stroke { closed: true, filled: true, ..Stroke::of(Role::Trunk, outline) };
    let cleaned = run([filled]);
    assert!(has(&cleaned, |kind| *kind == RepairKind::MiddleOfOutline));
    assert!((cleaned.plan.base.x - 50.0).abs() < 6.0, "{}", cleaned.plan.base);
}

#[test]
fn a_crown_alone_gets_a_trunk() {
    let cleaned =
        run([Stroke { closed: true, ..Stroke::of(Role::Crown, circle((50.0, 50.0), 30.0)) }]);
    assert!(has(&cleaned, |kind| *kind == RepairKind::ImaginedTrunk));
    let top = cleaned.plan.positions().iter().map(|p| p.y).fold(0.0, f32::max);
    assert!((top - 10.0 * 2.0 / 3.0).abs() < 0.05, "{top}");
}

#[test]
fn what_is_no_drawing_says_so() {
    let params = CleanParams::default();
    assert!(error([], &params).contains("no strokes"));
    let dots = || [Stroke::default(), branch(&[(3.0, 3.0)]), branch(&[(5.0, 5.0), (5.0, 5.0)])];
    assert!(error(dots(), &params).contains("none of the 3 strokes"));
    assert!(
        error([branch(&[(f32::NAN, 1.0), (f32::INFINITY, 2.0), (1e30, 3.0)])], &params)
            .contains("none of the 1 strokes")
    );
}

#[test]
fn bad_points_and_empty_strokes_are_told() {
    let bad = branch(&[(50.0, 100.0), (f32::NAN, 5.0), (1e30, 2.0), (50.0, 0.0)]);
    let named = Stroke { name: "dot".into(), ..branch(&[(5.0, 5.0)]) };
    let cleaned = run([bad, named]);
    let told: Vec<String> = cleaned.report.repairs.iter().map(ToString::to_string).collect();
    assert!(told.contains(&"strokes[0] had 2 bad points, which were left out".into()), "{told:?}");
    assert!(told.contains(&"strokes[1] 'dot' has no length and was left out".into()), "{told:?}");
}

#[test]
fn parameters_out_of_range_are_named() {
    let bad = CleanParams { snap: f32::NAN, ..Default::default() };
    assert!(error([branch(&TRUNK)], &bad).starts_with("clean.snap"));
    let bad = CleanParams { root: Some(Vec2::NAN), ..Default::default() };
    assert!(error([branch(&TRUNK)], &bad).starts_with("clean.root"));
}

#[test]
fn limits_and_cancelling_are_kept() {
    let limits = tree_core::Limits { nodes: 1, ..Default::default() };
    let limited = clean(
        &drawing([branch(&TRUNK)]),
        &CleanParams::default(),
        &Control::default().with_limits(limits),
    );
    assert!(matches!(limited, Err(ModelError::Limit(_))));
    let flag = tree_core::CancelFlag::default();
    flag.cancel();
    let control = Control::default().with_cancel(flag);
    let cancelled = clean(&drawing([branch(&TRUNK)]), &CleanParams::default(), &control);
    assert!(matches!(cancelled, Err(ModelError::Cancelled(_))));
}

#[test]
fn strokes_without_height_make_a_tree() {
    let cleaned = run([branch(&[(0.0, 5.0), (100.0, 5.0)])]);
    assert!(cleaned.plan.positions().iter().all(|p| p.x.abs() <= 100.1), "{:?}", cleaned.plan);
}

#[test]
fn a_hundred_thousand_points_are_cleaned() {
    let stroke = |k: u32| {
        let (x, y) = ((k % 50) as f32 * 20.0, (k / 50) as f32 * 25.0);
        let point = |i: u32| (x + (i % 7) as f32 * 0.3 + i as f32 * 0.2, y + i as f32);
        branch(&(0..50).map(point).collect::<Vec<_>>())
    };
    let cleaned = run((0..2000).map(stroke));
    assert!(cleaned.plan.len() > 2000);
}

#[cfg(all(feature = "svg", feature = "json"))]
#[test]
fn real_sketches_become_trees() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/data/sketches");
    let folder = std::env::var("TREE_SKETCHES").unwrap_or(folder.into());
    let Ok(files) = std::fs::read_dir(&folder) else {
        eprintln!("notice: no sketches in {folder}, nothing to check");
        return;
    };
    let mut paths: Vec<_> = files.map(|file| file.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        let text = std::fs::read_to_string(&path).unwrap();
        let drawings = match path.extension().and_then(|e| e.to_str()) {
            Some("svg") => vec![crate::sketch::read::from_svg(&text).unwrap()],
            Some("ndjson") => crate::sketch::read::from_ndjson(&text).unwrap(),
            _ => continue,
        };
        for (row, drawing) in drawings.iter().enumerate() {
            let cleaned = clean(drawing, &CleanParams::default(), &Control::default());
            let cleaned =
                cleaned.unwrap_or_else(|error| panic!("{} {row}: {error}", path.display()));
            assert!(cleaned.plan.len() > 5, "{} {row}", path.display());
        }
    }
}

fn any_stroke() -> impl Strategy<Value = Stroke> {
    let coordinate =
        prop_oneof![20 => -50.0_f32..150.0, 1 => Just(f32::NAN), 1 => Just(1e30), 2 => Just(0.0)];
    let points = prop::collection::vec((coordinate.clone(), coordinate), 0..12);
    let role = prop_oneof![
        Just(None),
        Just(Some(Role::Trunk)),
        Just(Some(Role::Branch)),
        Just(Some(Role::Crown))
    ];
    (points, role, any::<bool>(), any::<bool>()).prop_map(|(points, role, closed, filled)| Stroke {
        points: line(&points),
        role,
        closed,
        filled,
        name: String::new(),
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn any_strokes_make_one_tree_and_always_the_same(
        strokes in prop::collection::vec(any_stroke(), 0..10),
    ) {
        let drawing = drawing(strokes);
        let params = CleanParams::default();
        if let Ok(cleaned) = clean(&drawing, &params, &Control::default()) {
            prop_assert_eq!(cleaned.plan.positions()[0], Vec2::ZERO);
            let n = drawing.strokes.len() as u32;
            prop_assert!(cleaned.plan.strokes().iter().all(|&stroke| stroke < n));
            prop_assert!(cleaned.crown.iter().flatten().all(|p| p.is_finite()));
            prop_assert_eq!(&clean(&drawing, &params, &Control::default()).unwrap(), &cleaned);
        }
    }

    #[test]
    fn marked_branches_stay_where_they_were_drawn(
        strokes in prop::collection::vec(prop::collection::vec((0.0_f32..100.0, 0.0_f32..100.0), 2..8), 1..6),
    ) {
        let drawn = drawing(strokes.iter().map(|points| branch(points)));
        let params = CleanParams { snap: 0.0, merge: 0.0, ..Default::default() };
        if let Ok(cleaned) = clean(&drawn, &params, &Control::default()) {
            let empty: Vec<u32> = cleaned.report.repairs.iter()
                .filter(|repair| repair.kind == RepairKind::Empty).map(|repair| repair.stroke).collect();
            let unit = Extent::of(drawn.strokes.iter().flat_map(|s| &s.points)).unit();
            for (index, stroke) in drawn.strokes.iter().enumerate() {
                // A loop is an outline.
                let (first, last) = shape::ends(&stroke.points);
                let closed = first.distance(last) < 0.04 * tidy::length(&stroke.points);
                if closed || empty.contains(&(index as u32)) {
                    continue;
                }
                for point in &stroke.points {
                    let off = off(&cleaned.plan, *point);
                    prop_assert!(off <= 0.002 * unit, "{point} of stroke {index} is {off} off");
                }
            }
        }
    }
}

#[test]
fn a_stroke_that_crosses_another_at_a_shallow_angle_stays_whole() {
    let across = branch(&[(47.0, 40.0), (53.0, 10.0)]);
    let cleaned = run([branch(&TRUNK), across]);
    assert!(!has(&cleaned, |kind| matches!(kind, RepairKind::MergedPartly(_))));
}

#[test]
fn a_lateral_at_an_acute_angle_keeps_its_beginning() {
    let cleaned = run([branch(&TRUNK), branch(&[(50.0, 60.0), (62.0, 10.0)])]);
    let plan = &cleaned.plan;
    let fork = n_children(plan).iter().position(|&n| n == 2).unwrap();
    let at = plan.to_drawing(plan.positions()[fork]);
    assert!((at.y - 60.0).abs() < 1.5, "{at}");
}

#[test]
fn opposite_branches_drawn_almost_at_one_place_have_one_fork() {
    let strokes = || {
        let left = branch(&[(50.0, 60.0), (10.0, 30.0)]);
        [branch(&TRUNK), left, branch(&[(50.0, 59.4), (90.0, 30.0)])]
    };
    let forks = |gather| {
        let cleaned = run_with(strokes(), &CleanParams { gather, ..Default::default() });
        n_children(&cleaned.plan).into_iter().filter(|&n| n > 1).collect::<Vec<_>>()
    };
    assert_eq!(forks(0.01), [3]);
    assert_eq!(forks(0.0), [2, 2]);
}

#[test]
fn flares_of_roots_are_not_the_base() {
    let trunk = Stroke::new(line(&[(44.0, 100.0), (50.0, 90.0), (50.0, 0.0)]));
    let flare = Stroke::new(line(&[(50.0, 90.0), (57.0, 99.0)]));
    let limb = Stroke::new(line(&RIGHT));
    let cleaned = run([trunk, flare, limb]);
    assert!(has(&cleaned, |kind| *kind == RepairKind::RootFlare), "{:?}", cleaned.report);
    assert!((cleaned.plan.base - Vec2::new(50.0, 100.0)).length() < 0.5, "{}", cleaned.plan.base);
    assert_eq!(n_tips(&cleaned.plan), 2);
}

#[test]
fn drawn_branches_low_on_the_trunk_are_no_flares() {
    let low = branch(&[(50.0, 90.0), (70.0, 95.0)]);
    let cleaned = run([branch(&TRUNK), low, branch(&RIGHT)]);
    assert!(!has(&cleaned, |kind| *kind == RepairKind::RootFlare));
}

#[test]
fn a_stem_below_a_cloud_is_drawn_on_into_it() {
    let cloud = Stroke::of(Role::Crown, circle((50.0, 50.0), 40.0));
    for stem in [line(&[(50.0, 120.0), (50.0, 92.0)]), line(&[(50.0, 120.0), (50.0, 85.0)])] {
        let cleaned = run([Stroke::new(stem), cloud.clone()]);
        assert!(has(&cleaned, |kind| *kind == RepairKind::DrawnOn(1)), "{:?}", cleaned.report);
        let top = cleaned.plan.positions().iter().map(|p| p.y).fold(0.0, f32::max);
        assert!((7.5..8.0).contains(&top), "{top}");
    }
}

#[test]
fn branches_that_fill_a_crown_are_left_as_they_are() {
    let cloud = Stroke::of(Role::Crown, circle((50.0, 40.0), 50.0));
    let cleaned = run([branch(&TRUNK), branch(&LEFT), branch(&RIGHT), cloud]);
    assert!(!has(&cleaned, |kind| matches!(kind, RepairKind::DrawnOn(_))));
}

#[test]
fn a_short_trunk_below_the_ink_of_a_crown_is_no_ink() {
    // Ink all round the crown and, below, a trunk: one filled area.
    let crown = Stroke { closed: true, ..Stroke::of(Role::Crown, circle((50.0, 50.0), 40.0)) };
    let outline = line(&[(47.0, 90.0), (53.0, 90.0), (53.0, 101.0), (47.0, 101.0)]);
    let trunk = Stroke { points: outline, closed: true, filled: true, ..Stroke::default() };
    let cleaned = run([crown, trunk]);
    assert!(!has(&cleaned, |kind| *kind == RepairKind::ImaginedTrunk), "{:?}", cleaned.report);
}
