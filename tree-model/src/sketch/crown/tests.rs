use super::*;
use crate::sketch::Footprint;
use proptest::prelude::*;
use std::f32::consts::TAU;

fn points(list: &[(f32, f32)]) -> Vec<Vec2> {
    list.iter().map(|&(x, y)| Vec2::new(x, y)).collect()
}

/// Points on a circle about (0, 5), from and to in turns.
fn arc(radius: f32, from: f32, to: f32) -> Vec<Vec2> {
    let at = |i: usize| {
        let angle = TAU * (from + (to - from) * i as f32 / 40.0);
        Vec2::new(radius * libm::cosf(angle), 5.0 + radius * libm::sinf(angle))
    };
    (0..=40).map(at).collect()
}

fn close(strokes: &[Vec<Vec2>], branches: &[Vec2]) -> (Crown, CrownReport) {
    Crown::close(strokes, branches, &CrownParams::default(), &Control::default()).unwrap()
}

fn error(strokes: &[Vec<Vec2>]) -> String {
    let result = Crown::close(strokes, &[], &CrownParams::default(), &Control::default());
    result.unwrap_err().to_string()
}

/// Whether all drawn points are corners of the crown.
fn keeps(crown: &Crown, stroke: &[Vec2]) -> bool {
    let corners = crown.corners();
    stroke.iter().all(|point| corners.contains(point))
}

#[test]
fn a_complete_convex_crown_stays_as_drawn() {
    let drawn = arc(3.0, 0.0, 0.98);
    let (crown, report) = close(std::slice::from_ref(&drawn), &[]);
    assert!(keeps(&crown, &drawn));
    assert!(matches!(report.repairs[..], [CrownRepair::Closed { stroke: 0, .. }]), "{report}");
    assert!((crown.area() - 28.2).abs() < 0.3, "{}", crown.area());
}

#[test]
fn an_incomplete_crown_is_closed_round_the_branches_in_its_gap() {
    let drawn = arc(3.0, 0.9, 1.6);
    let branches = points(&[(0.0, 5.0), (-1.5, 2.2), (1.0, 1.5)]);
    let (crown, report) = close(std::slice::from_ref(&drawn), &branches);
    assert!(keeps(&crown, &drawn));
    assert!(crown.corners().contains(&Vec2::new(1.0, 1.5)));
    let closed = CrownRepair::GapClosed { gap: drawn[0].distance(drawn[40]), round_branches: true };
    assert!(report.repairs.contains(&closed), "{report}");
    // A chord would have cut the branches off.
    assert!(branches.iter().all(|&b| crown.contains(b.lerp(Vec2::new(0.0, 5.0), 0.01))));
}

#[test]
fn several_strokes_in_any_order_and_direction_are_one_crown() {
    let mut back = arc(3.0, 0.4, 0.6);
    back.reverse();
    let strokes = [arc(3.0, 0.7, 0.9), arc(3.0, 0.0, 0.25), back];
    let (crown, report) = close(&strokes, &points(&[(0.0, 5.0), (-2.4, 7.2)]));
    assert_eq!(crown.polygons().len(), 1, "{report}");
    assert!(strokes.iter().all(|stroke| keeps(&crown, stroke)));
    let gaps = report.repairs.iter().filter(|r| matches!(r, CrownRepair::GapClosed { .. })).count();
    assert_eq!(gaps, 3, "{report}");
    assert!(crown.area() > 24.0);
}

#[test]
fn a_concave_crown_keeps_its_corners() {
    let drawn = points(&[
        (0.0, 0.0),
        (2.0, 2.0),
        (1.0, 2.0),
        (2.0, 4.0),
        (0.0, 6.0),
        (-2.0, 4.0),
        (-1.0, 2.0),
        (-2.0, 2.0),
    ]);
    let (crown, _) = close(&[drawn[..3].to_vec(), drawn[3..].to_vec()], &points(&[(0.0, 3.0)]));
    assert!(keeps(&crown, &drawn));
    assert!(!crown.contains(Vec2::new(1.4, 2.4)));
}

#[test]
fn clouds_of_foliage_stay_apart() {
    let right: Vec<Vec2> = arc(1.0, 0.0, 0.99).iter().map(|&p| p + Vec2::new(4.0, 0.0)).collect();
    let (crown, report) = close(&[arc(2.0, 0.0, 0.99), right], &[]);
    assert_eq!(crown.polygons().len(), 2, "{report}");
    assert!(crown.contains(Vec2::new(4.0, 5.0)) && !crown.contains(Vec2::new(2.5, 5.0)));
    assert!(!crown.contains_3d(Vec3::new(4.0, 5.0, 1.5)));
    assert!(crown.contains_3d(Vec3::new(0.0, 5.0, 1.5)));
}

#[test]
fn overlapping_loops_are_united_whichever_way_they_run() {
    let mut right: Vec<Vec2> =
        arc(2.0, 0.0, 1.0).iter().map(|&p| p + Vec2::new(2.0, 0.0)).collect();
    right.reverse();
    let (crown, report) = close(&[arc(2.0, 0.0, 1.0), right], &[]);
    assert_eq!(crown.polygons().len(), 1);
    assert!(report.repairs.contains(&CrownRepair::United { before: 2, after: 1 }), "{report}");
    assert!(crown.contains(Vec2::new(1.0, 5.0)) && (20.0..21.0).contains(&crown.area()));
}

#[test]
fn loops_and_strokes_inside_are_details() {
    let strokes = [arc(3.0, 0.0, 1.0), arc(1.0, 0.0, 1.0), points(&[(0.0, 5.0), (0.5, 5.5)])];
    let (crown, report) = close(&strokes, &[]);
    assert_eq!(crown.polygons().len(), 1);
    assert!(report.repairs.contains(&CrownRepair::NestedDropped { count: 1 }), "{report}");
    assert!(report.repairs.contains(&CrownRepair::DetailDropped { stroke: 2 }), "{report}");
}

#[test]
fn a_figure_of_eight_keeps_both_its_loops() {
    let eight = points(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]);
    let (crown, report) = close(&[eight], &[]);
    assert!(report.repairs.contains(&CrownRepair::CrossingUndone { part: 0 }), "{report}");
    assert!((crown.area() - 2.0).abs() < 1e-4, "{}", crown.area());
    assert!(crown.contains(Vec2::new(0.2, 1.0)) && crown.contains(Vec2::new(1.8, 1.0)));
}

#[test]
fn an_open_spiral_is_filled() {
    let spiral: Vec<Vec2> = (0..80)
        .map(|i| {
            let angle = TAU * i as f32 / 40.0;
            (3.0 - 0.02 * i as f32) * Vec2::new(libm::cosf(angle), libm::sinf(angle))
        })
        .collect();
    let (crown, report) = close(&[spiral], &[]);
    assert_eq!(crown.polygons().len(), 1, "{report}");
    assert!(crown.contains(Vec2::ZERO) && crown.area() > 20.0, "{}", crown.area());
}

#[test]
fn strokes_that_overlap_at_their_ends_make_one_crown() {
    let (crown, report) = close(&[arc(3.0, 0.0, 0.6), arc(3.05, 0.5, 1.08)], &[]);
    assert_eq!(crown.polygons().len(), 1, "{report}");
    assert!((27.5..30.0).contains(&crown.area()), "{}", crown.area());
}

#[test]
fn a_crown_smaller_than_the_branches_is_kept_and_says_so() {
    let branches = points(&[(0.0, 5.0), (9.0, 5.0), (0.0, 14.0), (-9.0, 5.0)]);
    let (crown, report) = close(&[arc(3.0, 0.0, 1.0)], &branches);
    assert_eq!(report.outside, 0.75);
    assert!(report.to_string().contains("75 %"), "{report}");
    assert!(crown.area() < 29.0);
}

#[test]
fn a_crown_beside_the_tree_is_reported_or_refused() {
    let (strokes, far) = ([arc(3.0, 0.0, 1.0)], points(&[(50.0, 0.0)]));
    let (_, report) = close(&strokes, &far);
    assert!(report.repairs.contains(&CrownRepair::NoBranchInside));
    let params = CrownParams { refuse: true, ..CrownParams::default() };
    let error = Crown::close(&strokes, &far, &params, &Control::default()).unwrap_err();
    assert!(error.to_string().contains("no branch"), "{error}");
}

#[test]
fn what_encloses_nothing_is_an_error() {
    let line = points(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)]);
    for strokes in [
        vec![],
        vec![vec![]],
        vec![vec![Vec2::ONE]],
        vec![vec![Vec2::ONE; 9]],
        vec![line.clone()],
        vec![vec![Vec2::NAN, Vec2::INFINITY, Vec2::splat(1e30)]],
    ] {
        assert!(error(&strokes).contains("no area"), "{strokes:?}");
    }
}

#[test]
fn bad_points_are_left_out_and_named() {
    let mut drawn = arc(3.0, 0.0, 1.0);
    drawn.insert(5, Vec2::NAN);
    drawn.push(Vec2::splat(1e30));
    let (_, report) = close(&[vec![Vec2::ONE], drawn], &[]);
    assert!(report.repairs.contains(&CrownRepair::PointsDropped { stroke: 1, count: 2 }));
    assert!(report.repairs.contains(&CrownRepair::StrokeDropped { stroke: 0 }), "{report}");
}

#[test]
fn a_wild_scribble_becomes_a_crown() {
    let mut state = 1_u32;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 / 16_777_216.0
    };
    let scribble: Vec<Vec2> = (0..100_000).map(|_| Vec2::new(next(), next())).collect();
    let (crown, _) = close(&[scribble], &[]);
    assert!(crown.area() > 0.5 && crown.area() <= 1.0, "{}", crown.area());
}

#[test]
fn a_ball_has_the_volume_and_the_levels_of_a_ball() {
    let (crown, _) = close(&[arc(3.0, 0.0, 1.0)], &[]);
    assert!((crown.volume() / (4.0 / 3.0 * std::f32::consts::PI * 27.0) - 1.0).abs() < 0.01);
    assert!((crown.level(Vec3::new(0.0, 5.0, 1.5)) - 0.5).abs() < 0.01);
    assert!(crown.level(Vec3::new(0.0, 5.0, 3.3)) > 1.0);
    let exit = crown.exit(Vec3::new(0.0, 5.0, 0.0), Vec3::new(4.0, 7.0, 4.0)).unwrap();
    assert!((exit - 0.5).abs() < 0.01, "{exit}");
}

#[test]
fn a_flat_crown_is_as_deep_as_asked() {
    let crown = Crown::from_polygons(&[arc(3.0, 0.0, 1.0)], 0.5).unwrap();
    assert!(crown.contains_3d(Vec3::new(0.0, 5.0, 1.4)));
    assert!(!crown.contains_3d(Vec3::new(0.0, 5.0, 1.6)));
}

#[test]
fn an_outline_goes_round_the_leaves_and_not_into_the_gaps_between() {
    let mut state = 7_u32;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 / 16_777_216.0 - 0.5
    };
    let leaves: Vec<Vec2> =
        (0..4000).map(|_| 8.0 * Vec2::new(next(), next())).filter(|p| p.length() < 4.0).collect();
    let outlines = outline_of(&leaves, &OutlineParams::default());
    assert_eq!(outlines.len(), 1);
    assert!(outlines[0].len() <= 120);
    assert!((unite::area(&outlines[0]) / 50.3 - 1.0).abs() < 0.06, "{}", unite::area(&outlines[0]));
    let crown = Crown::from_polygons(&outlines, 1.0).unwrap();
    let inside = leaves.iter().filter(|&&leaf| crown.contains(leaf)).count();
    assert!(inside as f32 > 0.98 * leaves.len() as f32);
    let (drawn, disc) = (Footprint::of(&outlines[0]), Footprint::of(&arc(4.0, 0.0, 1.0)));
    assert!(drawn.unwrap().distance(&disc.unwrap()) < 0.02);
}

#[test]
fn too_few_points_have_no_outline() {
    for cloud in [vec![], vec![Vec2::ONE; 5], points(&[(0.0, 0.0), (1.0, 1.0)]), vec![Vec2::NAN; 9]]
    {
        assert!(outline_of(&cloud, &OutlineParams::default()).is_empty(), "{cloud:?}");
    }
}

#[test]
fn params_out_of_range_are_named() {
    let bad = CrownParams { depth: 0.0, ..CrownParams::default() };
    assert!(bad.validate().unwrap_err().to_string().contains("crown.depth"));
    let bad = OutlineParams { closing: f32::NAN, ..OutlineParams::default() };
    assert!(bad.validate().unwrap_err().to_string().contains("outline.closing"));
}

/// Star-shaped loops: simple, but as jagged as can be.
fn star() -> impl Strategy<Value = Vec<Vec2>> {
    prop::collection::vec(0.3_f32..3.0, 3..40).prop_map(|radii| {
        let n = radii.len() as f32;
        let at = |(i, r): (usize, &f32)| {
            let angle = TAU * i as f32 / n;
            *r * Vec2::new(libm::cosf(angle), libm::sinf(angle))
        };
        radii.iter().enumerate().map(at).collect()
    })
}

fn within(size: f32) -> impl Strategy<Value = f32> {
    -size..size
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn contains_agrees_with_even_and_odd(star in star(), x in within(3.0), y in within(3.0)) {
        let crown = Crown::from_polygons(std::slice::from_ref(&star), 1.0).unwrap();
        let point = Vec2::new(x, y);
        prop_assert_eq!(crown.contains(point), unite::contains(&star, point));
        prop_assert_eq!(crown.contains_3d(point.extend(0.0)), crown.contains(point));
    }

    #[test]
    fn exit_is_the_first_way_out(
        star in star(),
        from in (within(0.5), within(0.5), within(0.5)),
        to in (within(4.0), within(4.0), within(4.0)),
        depth in 0.3_f32..3.0,
    ) {
        let crown = Crown::from_polygons(&[star], depth).unwrap();
        let (from, to) = (Vec3::from(from), Vec3::from(to));
        let exit = crown.exit(from, to);
        if !crown.contains_3d(from) {
            prop_assert_eq!(exit, Some(0.0));
            return Ok(());
        }
        let until = exit.unwrap_or(1.0) - 1e-4;
        for i in 0..200 {
            let t = until * i as f32 / 199.0;
            prop_assert!(t < 0.0 || crown.contains_3d(from.lerp(to, t)), "{} of {}", t, until);
        }
        if let Some(exit) = exit && exit < 0.999 {
            let beyond = (1..20).any(|i| !crown.contains_3d(from.lerp(to, exit + 1e-5 * i as f32)));
            prop_assert!(beyond, "{}", exit);
        }
    }

    #[test]
    fn any_strokes_give_a_crown_or_an_error(
        strokes in prop::collection::vec(
            prop::collection::vec((-9_i32..9, -9_i32..9), 0..12), 0..6),
        branches in prop::collection::vec((-9_i32..9, -9_i32..9), 0..12),
    ) {
        let vector = |list: &Vec<(i32, i32)>| -> Vec<Vec2> {
            list.iter().map(|&(x, y)| Vec2::new(x as f32, y as f32)).collect()
        };
        let strokes: Vec<Vec<Vec2>> = strokes.iter().map(vector).collect();
        let params = CrownParams::default();
        let Ok((crown, report)) =
            Crown::close(&strokes, &vector(&branches), &params, &Control::default()) else { return Ok(()) };
        prop_assert!(crown.area() > 0.0 && crown.volume() > 0.0);
        prop_assert!((0.0..=1.0).contains(&report.outside));
        let (low, high) = crown.bounds();
        prop_assert!(low.min_element() >= -9.01 && high.max_element() <= 9.01);
        for polygon in crown.polygons() {
            prop_assert!(unite::area(polygon) > 0.0);
        }
    }
}
