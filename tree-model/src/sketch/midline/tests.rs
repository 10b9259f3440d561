use super::*;
use proptest::prelude::*;

fn points(list: &[(f32, f32)]) -> Vec<Vec2> {
    list.iter().map(|&(x, y)| Vec2::new(x, y)).collect()
}

fn of(outline: &[Vec2]) -> Vec<Midline> {
    midlines(outline, &MidlineParams::default())
}

/// The outline of a T with a long stem: stem 1 wide from y = 0 to 10, arm 0.6 wide to x = 6 at y = 7.
fn trunk_with_an_arm() -> Vec<Vec2> {
    points(&[
        (-0.5, 0.0),
        (0.5, 0.0),
        (0.5, 6.7),
        (6.0, 6.7),
        (6.0, 7.3),
        (0.5, 7.3),
        (0.5, 10.0),
        (-0.5, 10.0),
    ])
}

#[test]
fn a_bar_has_its_middle_as_line_from_end_to_end() {
    let lines = of(&points(&[(0.0, 0.0), (1.0, 0.0), (1.0, 10.0), (0.0, 10.0)]));
    assert_eq!(lines.len(), 1);
    let line = &lines[0];
    let (first, last) = (line.points[0], line.points[line.points.len() - 1]);
    let (low, high) = (first.y.min(last.y), first.y.max(last.y));
    assert!(low < 0.05 && high > 9.95, "{low} {high}");
    assert!(line.points.iter().all(|p| (p.x - 0.5).abs() < 0.12), "{line:?}");
    let middle = line.half_widths[line.half_widths.len() / 2];
    assert!((middle - 0.5).abs() < 0.05, "{middle}");
}

#[test]
fn an_arm_begins_on_the_trunk_and_ends_at_its_tip() {
    let lines = of(&trunk_with_an_arm());
    assert_eq!(lines.len(), 2, "{lines:?}");
    let (trunk, arm) = (&lines[0], &lines[1]);
    let height = trunk.points.iter().map(|p| p.y).fold(0.0, f32::max)
        - trunk.points.iter().map(|p| p.y).fold(10.0, f32::min);
    assert!(height > 9.9, "the stem goes straight on: {height}");
    assert!(trunk.points.contains(&arm.points[0]));
    assert!(arm.points[arm.points.len() - 1].distance(Vec2::new(6.0, 7.0)) < 0.1);
    let half = arm.half_widths[arm.half_widths.len() / 2];
    assert!((half - 0.3).abs() < 0.05, "{half}");
}

#[test]
fn between_opposite_limbs_the_trunk_goes_on() {
    // Limbs nearly as wide as the trunk, longer than it and a little rising; above, a thinner top.
    let right = [(0.5, 0.0), (0.5, 4.0), (8.0, 6.5), (8.0, 7.3), (0.4, 4.9), (0.3, 9.0)];
    let mut outline = points(&right);
    outline.extend(right.iter().rev().map(|&(x, y)| Vec2::new(-x, y)));
    let lines = of(&outline);
    let main = &lines[0].points;
    assert!(main.iter().all(|p| p.x.abs() < 0.6), "{main:?}");
    assert!(main.iter().any(|p| p.y < 0.5) && main.iter().any(|p| p.y > 8.5), "{main:?}");
}

#[test]
fn no_arm_is_lost_where_a_thick_trunk_ends_at_a_fork() {
    // A T: the arms are the straightest pair, the trunk is the strongest line.
    let right = [(1.5, 0.0), (1.2, 8.0), (6.0, 8.0), (6.0, 9.0)];
    let mut outline = points(&right);
    outline.extend(right.iter().rev().map(|&(x, y)| Vec2::new(-x, y)));
    let lines = of(&outline);
    assert_eq!(lines.len(), 2, "{lines:?}");
    for x in [-6.0_f32, 6.0] {
        let near = |p: &Vec2| p.distance(Vec2::new(x, 8.5)) < 0.6;
        assert!(lines.iter().any(|line| line.points.iter().any(near)), "{x}");
    }
}

#[test]
fn the_ends_of_a_pointed_shape_are_its_points() {
    let lines = of(&points(&[(-1.0, 0.0), (1.0, 0.0), (0.0, 12.0)]));
    assert_eq!(lines.len(), 1, "{lines:?}");
    let (line, last) = (&lines[0], lines[0].points.len() - 1);
    assert!(line.points[last].distance(Vec2::new(0.0, 12.0)) < 1e-3);
    assert_eq!(line.half_widths[last], 0.0);
}

#[test]
fn bumps_are_no_branches() {
    let mut bar = points(&[(0.0, 0.0), (1.0, 0.0), (1.0, 4.0), (1.3, 4.2), (1.0, 4.4)]);
    bar.extend(points(&[(1.0, 10.0), (0.0, 10.0)]));
    assert_eq!(of(&bar).len(), 1);
}

#[test]
fn a_larger_spur_leaves_longer_branches_out() {
    let stub = points(&[
        (0.0, 0.0),
        (1.0, 0.0),
        (1.0, 4.0),
        (1.8, 4.0),
        (1.8, 4.8),
        (1.0, 4.8),
        (1.0, 10.0),
        (0.0, 10.0),
    ]);
    let count = |spur: f32| midlines(&stub, &MidlineParams { spur, ..Default::default() }).len();
    assert_eq!((count(0.8), count(2.0)), (2, 1));
}

#[test]
fn short_limbs_on_a_thick_trunk_are_branches() {
    let mut outline = points(&[(-2.0, 0.0), (2.0, 0.0), (2.0, 8.0)]);
    outline.extend(points(&[(4.0, 8.0), (4.0, 8.3), (2.0, 8.3), (2.0, 14.0), (-2.0, 14.0)]));
    assert_eq!(of(&outline).len(), 2);
}

#[test]
fn the_direction_of_the_outline_does_not_matter() {
    let forth = of(&trunk_with_an_arm());
    let back: Vec<Vec2> = trunk_with_an_arm().into_iter().rev().collect();
    assert_eq!(forth.len(), of(&back).len());
}

#[test]
fn a_trunk_drawn_across_itself_is_one_area() {
    // Two crossing bars in one go: a plus sign, with the lobes overlapping in the middle.
    let plus = points(&[
        (-5.0, -0.5),
        (5.0, -0.5),
        (5.0, 0.5),
        (-0.5, 0.5),
        (-0.5, -5.0),
        (0.5, -5.0),
        (0.5, 5.0),
        (-0.5, 5.0),
        (-0.5, 0.5),
        (-5.0, 0.5),
    ]);
    let lines = of(&plus);
    let total: f32 = lines
        .iter()
        .flat_map(|line| line.points.windows(2).map(|pair| pair[0].distance(pair[1])))
        .sum();
    assert!((18.0..21.5).contains(&total), "{total}");
}

#[test]
fn a_hole_is_left_out_and_the_ring_is_cut_once() {
    let circle = |radius: f32, turn: f32| -> Vec<Vec2> {
        let angle = |i: usize| turn * std::f32::consts::TAU * i as f32 / 60.0;
        (0..60).map(|i| radius * Vec2::new(libm::cosf(angle(i)), libm::sinf(angle(i)))).collect()
    };
    let params = MidlineParams::default();
    let ring = midlines_of(&[circle(5.0, 1.0), circle(4.0, -1.0)], &params);
    assert_eq!(ring.len(), 1);
    let even = MidlineParams { rule: FillRule::EvenOdd, ..params };
    assert_eq!(midlines_of(&[circle(5.0, 1.0), circle(4.0, 1.0)], &even).len(), 1);
    assert!(ring[0].points.iter().all(|p| (p.length() - 4.5).abs() < 0.2));
}

#[test]
fn separate_areas_have_lines_of_their_own() {
    let bar = |x: f32| points(&[(x, 0.0), (x + 1.0, 0.0), (x + 1.0, 9.0), (x, 9.0)]);
    assert_eq!(midlines_of(&[bar(0.0), bar(5.0)], &MidlineParams::default()).len(), 2);
}

#[test]
fn what_has_no_area_has_no_line() {
    let far = Vec2::splat(1e30);
    for outline in [
        vec![],
        vec![Vec2::ONE],
        vec![Vec2::ONE; 100],
        vec![Vec2::ZERO, Vec2::ONE],
        vec![Vec2::ZERO, Vec2::ONE, 2.0 * Vec2::ONE, Vec2::ONE],
        vec![Vec2::NAN, Vec2::INFINITY, Vec2::ZERO, far],
    ] {
        assert_eq!(of(&outline), Vec::new(), "{outline:?}");
    }
}

#[test]
fn a_wild_scribble_comes_to_an_end() {
    let mut state = 1_u32;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 / 16_777_216.0
    };
    let scribble: Vec<Vec2> = (0..20_000).map(|_| Vec2::new(next(), next())).collect();
    assert!(!of(&scribble).is_empty());
}

#[test]
fn params_out_of_range_are_named() {
    let bad = MidlineParams { spur: f32::NAN, ..MidlineParams::default() };
    assert!(bad.validate().unwrap_err().to_string().contains("midline.spur"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn any_outline_gives_finite_lines_within_its_box(
        list in prop::collection::vec((-20_i32..20, -20_i32..20), 0..24),
    ) {
        let outline: Vec<Vec2> =
            list.iter().map(|&(x, y)| 0.37 * Vec2::new(x as f32, y as f32)).collect();
        for line in of(&outline) {
            prop_assert!(line.points.len() >= 2);
            prop_assert_eq!(line.points.len(), line.half_widths.len());
            for (point, half) in line.points.iter().zip(&line.half_widths) {
                prop_assert!(point.abs().max_element() < 7.5, "{}", point);
                prop_assert!(*half >= 0.0 && *half < 15.0);
            }
        }
    }
}
