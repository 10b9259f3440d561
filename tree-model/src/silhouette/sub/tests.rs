//! Sub-silhouettes of constructed crowns.

use super::*;
use crate::silhouette::bump::{BumpParams, bumps};
use proptest::prelude::*;
use std::f32::consts::TAU;

fn turned(angle: f32) -> Vec2 {
    Vec2::new(libm::cosf(angle), libm::sinf(angle))
}

/// A crown of lobes about the origin.
fn crown(lobes: f32, height: f32) -> Outline {
    let angle = |i: usize| TAU * i as f32 / 300.0;
    let radius = |a: f32| 3.0 * (1.0 + height * libm::cosf(lobes * a));
    Outline::of_simple((0..300).map(|i| radius(angle(i)) * turned(angle(i))).collect())
}

fn line(points: &[Vec2]) -> Line {
    Line::new(points.to_vec()).unwrap()
}

fn sub(parent: &Outline, branch: &Line, radius: f32) -> SubOutline {
    sub_outline(parent, branch, radius, None, &SubParams::default())
}

/// Whether sides meet that do not follow each other.
fn crosses(outline: &Outline) -> bool {
    let sides: Vec<(Vec2, Vec2)> = outline.sides().collect();
    let n = sides.len();
    let meet = |(a, b): (Vec2, Vec2), (c, d): (Vec2, Vec2)| {
        let [a, b, c, d] = [a, b, c, d].map(|p| p.as_dvec2());
        (b - a).perp_dot(c - a) * (b - a).perp_dot(d - a) <= 0.0
            && (d - c).perp_dot(a - c) * (d - c).perp_dot(b - c) <= 0.0
    };
    (0..n).any(|i| (i + 2..n).any(|j| (j + 1) % n != i && meet(sides[i], sides[j])))
}

#[test]
fn the_cone_opens_with_the_radius() {
    let params = SubParams::default();
    let degrees = |radius: f32| params.opening(radius, 2.0).to_degrees().round();
    assert_eq!(
        (degrees(0.0), degrees(1.0), degrees(2.0), degrees(9.0)),
        (20.0, 65.0, 110.0, 110.0)
    );
    let crown = crown(0.0, 0.0);
    let branch = line(&[Vec2::ZERO, Vec2::X]);
    // On a circle about the base a part as long as the angle says.
    for (radius, opening) in [(0.0, 20.0_f32), (0.5, 65.0), (1.0, 110.0)] {
        let found = sub(&crown, &branch, radius);
        let angle = (found.shared[1] - found.shared[0]) / 3.0;
        assert!((angle - opening.to_radians()).abs() < 0.02, "{opening}: {}", angle.to_degrees());
    }
}

#[test]
fn curves_go_on_in_the_direction_of_the_outline() {
    let crown = crown(7.0, 0.2);
    for bump in bumps(&crown, &BumpParams::default()) {
        let branch = line(&[Vec2::new(0.1, 0.0), bump.center]);
        let params = SubParams::default();
        let found = sub_outline(&crown, &branch, bump.radius, Some(bump.stretch), &params);
        let directions = [found.curves[0].derivative(1.0), found.curves[1].derivative(0.0)];
        for (join, direction) in found.joins.iter().zip(directions) {
            assert!(join.tangent.angle_to(direction).abs().to_degrees() < 0.1);
            // The join lies on the parent, and the tangent along it.
            assert!(Line::new(crown.points().to_vec()).unwrap().nearest(join.point).1 < 1e-3);
        }
        let within =
            found.shared[0] >= bump.stretch[0] - 1e-3 && found.shared[1] <= bump.stretch[1] + 1e-3;
        let round = crown.perimeter();
        let again = found.shared[0] + round >= bump.stretch[0] - 1e-3
            && found.shared[1] + round <= bump.stretch[1] + 1e-3;
        assert!(within || again, "{:?} {:?}", found.shared, bump.stretch);
    }
}

#[test]
fn a_branch_that_sticks_out_has_an_outline_too() {
    let crown = crown(5.0, 0.1);
    let lines = [
        [Vec2::ZERO, Vec2::new(9.0, 1.0)],
        [Vec2::new(0.0, -9.0), Vec2::new(0.0, 1.0)],
        [Vec2::new(9.0, -9.0), Vec2::new(10.0, 9.0)],
        [Vec2::new(3.3, 0.0), Vec2::new(3.3, 0.1)],
        [Vec2::ZERO, Vec2::new(1e-6, 0.0)],
    ];
    for ends in lines {
        let found = sub(&crown, &line(&ends), 0.3);
        assert!(found.outline.area() > 0.0 && !crosses(&found.outline), "{ends:?}");
    }
}

#[test]
fn params_out_of_range_are_named() {
    let bad = SubParams { wide: 4.0, ..Default::default() };
    assert!(bad.validate().unwrap_err().to_string().contains("subs.wide"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_branch_inside_a_lobed_crown_gets_a_simple_outline_about_it(
        lobes in 3_u32..12,
        height in 0.0_f32..0.4,
        (at, out) in (0.0_f32..TAU, 0.3_f32..0.95),
        (from, low) in (0.0_f32..TAU, 0.0_f32..0.3),
        (bend, radius) in (-0.2_f32..0.2, 0.0_f32..1.5),
    ) {
        let crown = crown(lobes as f32, height);
        let reach = crown.exit(Vec2::ZERO, turned(at)).unwrap();
        let (base, end) = (low * turned(from), out * reach * turned(at));
        prop_assume!(base.distance(end) > 0.3);
        let middle = 0.5 * (base + end) + bend * (end - base).perp();
        let points: Vec<Vec2> = (0..=8)
            .map(|i| i as f32 / 8.0)
            .map(|t| base.lerp(middle, t).lerp(middle.lerp(end, t), t))
            .collect();
        prop_assume!(points.iter().all(|&p| crown.contains(p)));
        let branch = line(&points);
        let found = sub(&crown, &branch, radius);
        prop_assert!(!crosses(&found.outline));
        prop_assert!(found.outline.area() > 0.0);
        prop_assert!(found.outline.contains(branch.at(0.5)));
        prop_assert!(found.outline.area() < 1.02 * crown.area());
    }
}
