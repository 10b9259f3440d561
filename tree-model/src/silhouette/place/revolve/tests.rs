//! Tests of the surface.

use super::*;
use proptest::prelude::*;
use std::f32::consts::TAU;
use tree_core::Seed;

/// A lobed outline about a centre, different left and right.
fn lobed(center: Vec2, size: f32, lobes: u32, seed: u64) -> Outline {
    let seed = Seed(seed);
    let point = |i: u32| {
        let angle = i as f32 / 300.0 * TAU;
        let wave = 1.0 + 0.15 * libm::sinf(lobes as f32 * angle + seed.unit(1));
        let lean = 1.0 + 0.3 * libm::cosf(angle + TAU * seed.unit(2));
        center + size * wave * lean * Vec2::new(libm::cosf(angle), 1.3 * libm::sinf(angle))
    };
    Outline::of_simple((0..300).map(point).collect())
}

fn polygon(points: &[(f32, f32)]) -> Outline {
    Outline::of_simple(points.iter().map(|&(x, y)| Vec2::new(x, y)).collect())
}

fn line(points: &[(f32, f32)]) -> Line {
    Line::new(points.iter().map(|&(x, y)| Vec2::new(x, y)).collect()).unwrap()
}

fn single(axis: &Line, outline: &Outline) -> Revolved {
    Revolved::of(axis, &[Section { azimuth: 0.0, outline }])
}

/// A crown as wide to the left as 1, to the right as 3.
fn askew() -> Outline {
    polygon(&[(0.0, 1.0), (3.0, 2.0), (3.0, 4.0), (0.0, 5.0), (-1.0, 4.0), (-1.0, 2.0)])
}

#[test]
fn the_drawing_plane_shows_the_drawn_outline() {
    let surface = single(&line(&[(0.0, 0.0), (0.0, 4.0)]), &askew());
    let (there, back) = (surface.profile(0.0).unwrap(), surface.profile(PI).unwrap());
    assert!((there.area() / askew().area() - 1.0).abs() < 0.01);
    assert!((there.bounds().1.x - 3.0).abs() < 0.05 && (back.bounds().1.x - 1.0).abs() < 0.05);
}

#[test]
fn halfway_round_the_surface_reaches_halfway() {
    let surface = single(&line(&[(0.0, 0.0), (0.0, 4.0)]), &askew());
    let reach = |azimuth| surface.exit(Vec2::new(0.0, 3.0), Vec2::X, azimuth).unwrap();
    for (azimuth, expected) in [(0.0, 3.0), (PI / 2.0, 2.0), (PI, 1.0), (1.5 * PI, 2.0)] {
        assert!((reach(azimuth) - expected).abs() < 0.02, "{azimuth}: {}", reach(azimuth));
    }
    // And on the way it falls steadily.
    let all: Vec<f32> = (0..=20).map(|i| reach(i as f32 / 20.0 * PI)).collect();
    assert!(all.windows(2).all(|pair| pair[1] <= pair[0]));
}

#[test]
fn a_symmetric_outline_gives_a_surface_of_revolution() {
    let outline =
        polygon(&[(0.0, 0.0), (2.0, 1.0), (1.0, 4.0), (0.0, 6.0), (-1.0, 4.0), (-2.0, 1.0)]);
    let surface = single(&line(&[(0.0, -1.0), (0.0, 3.0)]), &outline);
    let first = surface.half(0.0);
    for i in 0..30 {
        let half = surface.half(i as f32);
        assert!(half.iter().zip(&first).all(|(a, b)| a.distance(*b) < 1e-4));
    }
}

#[test]
fn further_planes_are_met_exactly() {
    let axis = line(&[(0.0, 0.0), (0.0, 5.0)]);
    let wide = lobed(Vec2::new(0.3, 3.0), 2.5, 5, 1);
    let narrow = lobed(Vec2::new(0.0, 3.0), 1.0, 3, 2);
    let sections = [
        Section { azimuth: PI / 2.0, outline: &narrow },
        Section { azimuth: 0.0, outline: &wide },
        Section { azimuth: -0.6, outline: &wide },
    ];
    let surface = Revolved::of(&axis, &sections);
    for section in &sections {
        let profile = surface.profile(section.azimuth).unwrap();
        assert!((profile.area() / section.outline.area() - 1.0).abs() < 0.02);
    }
}

#[test]
fn a_plane_drawn_twice_counts_as_drawn_last() {
    let axis = line(&[(0.0, 0.0), (0.0, 5.0)]);
    let (old, new) = (lobed(Vec2::Y, 2.0, 4, 1), lobed(Vec2::Y, 1.0, 4, 2));
    let sections = [0.0, 0.001].map(|azimuth| (azimuth, if azimuth > 0.0 { &new } else { &old }));
    let surface =
        Revolved::of(&axis, &sections.map(|(azimuth, outline)| Section { azimuth, outline }));
    assert_eq!(surface.halves.len(), 2);
    assert!((surface.profile(0.0).unwrap().area() / new.area() - 1.0).abs() < 0.02);
}

#[test]
fn the_exit_is_none_from_outside() {
    let surface = single(&line(&[(0.0, 0.0), (0.0, 4.0)]), &askew());
    assert_eq!(surface.exit(Vec2::new(0.0, 0.5), Vec2::Y, 0.0), None);
    assert_eq!(surface.exit(Vec2::new(3.5, 3.0), Vec2::NEG_X, 0.0), None);
    // Across the axis to the other side.
    let way = surface.exit(Vec2::new(2.0, 3.0), Vec2::NEG_X, 0.0).unwrap();
    assert!((way - 3.0).abs() < 0.02);
}

#[test]
fn points_inside_are_told_from_those_outside() {
    let surface = single(&line(&[(0.0, 0.0), (0.0, 4.0)]), &askew());
    assert!(
        surface.contains(Vec3::new(2.8, 3.0, 0.0)) && !surface.contains(Vec3::new(-1.2, 3.0, 0.0))
    );
    assert!(
        surface.contains(Vec3::new(0.0, 3.0, 1.9)) && !surface.contains(Vec3::new(0.0, 3.0, -2.1))
    );
    assert!(!surface.contains(Vec3::NAN));
}

#[test]
fn the_frame_follows_a_leaning_axis() {
    let axis = line(&[(1.0, 1.0), (3.0, 3.0)]);
    let outline = lobed(Vec2::new(3.0, 3.0), 1.0, 4, 3);
    let surface = single(&axis, &outline);
    assert!(surface.to_frame(Vec2::new(2.0, 0.0)).distance(Vec2::new(2.0_f32.sqrt(), 0.0)) < 1e-6);
    let profile = surface.profile(0.0).unwrap();
    assert!((profile.area() / outline.area() - 1.0).abs() < 0.02);
    assert!(surface.contains(Vec3::new(0.0, 8.0_f32.sqrt(), 0.0)));
}

#[test]
fn axes_that_miss_the_outline_split_it_top_to_bottom() {
    let outline = lobed(Vec2::new(5.0, 3.0), 1.0, 4, 3);
    let surface = single(&line(&[(0.0, 0.0), (0.0, 4.0)]), &outline);
    assert!((surface.profile(0.0).unwrap().area() / outline.area() - 1.0).abs() < 0.02);
    assert!(
        surface.contains(Vec3::new(5.0, 3.0, 0.0)) && !surface.contains(Vec3::new(0.0, 3.0, 3.0))
    );
    // Across the drawing it is as thick as it is wide.
    let across = surface.profile(PI / 2.0).unwrap().bounds();
    assert!((across.1.x - across.0.x) / (outline.bounds().1.x - outline.bounds().0.x) > 0.8);
}

#[test]
fn any_axis_keeps_the_drawn_outline() {
    let outline = lobed(Vec2::new(0.0, 3.0), 1.5, 6, 4);
    for axis in [
        line(&[(0.0, 2.5), (0.1, 3.0)]),
        line(&[(0.0, -9.0), (0.1, -8.0)]),
        line(&[(0.0, 7.0), (0.1, 9.0)]),
        line(&[(0.0, 0.0), (0.8, 1.5), (-0.8, 3.0), (0.3, 7.0)]),
        line(&[(-3.0, 0.0), (3.0, 1.9), (-3.0, 3.5), (3.0, 4.0), (0.0, 6.0)]),
        line(&[(0.0, 4.0), (0.0, 1.0)]),
    ] {
        let profile = single(&axis, &outline).profile(0.0).unwrap();
        assert!((profile.area() / outline.area() - 1.0).abs() < 0.02, "{axis:?}");
    }
}

#[test]
fn a_leaning_axis_is_upright_where_its_lean_is_not_seen() {
    let axis = line(&[(0.0, 0.0), (2.0, 4.0)]);
    let drawn = lobed(Vec2::new(1.5, 3.0), 1.2, 4, 3);
    let side = polygon(&[(0.0, 1.0), (1.0, 3.0), (0.0, 4.0), (-1.0, 3.0)]);
    let sections = [(0.0, &drawn), (PI / 2.0, &side)];
    let surface =
        Revolved::of(&axis, &sections.map(|(azimuth, outline)| Section { azimuth, outline }));
    // As long along the axis as it is high, over the cosine of the lean.
    let (low, high) = surface.profile(PI / 2.0).unwrap().bounds();
    let length = 20.0_f32.sqrt() / 4.0;
    assert!((low.x + 1.0).abs() < 0.02 && (high.x - 1.0).abs() < 0.02);
    assert!((low.y - length).abs() < 0.02 && (high.y - 4.0 * length).abs() < 0.02);
}

#[test]
fn no_outline_gives_no_surface() {
    let axis = line(&[(0.0, 0.0), (0.0, 4.0)]);
    let outline = askew();
    for sections in [&[][..], &[Section { azimuth: f32::NAN, outline: &outline }]] {
        let surface = Revolved::of(&axis, sections);
        assert!(surface.is_empty() && surface.half(0.0).is_empty());
        assert!(surface.profile(0.0).is_none() && surface.exit(Vec2::Y, Vec2::X, 0.0).is_none());
    }
}

#[test]
fn huge_and_tiny_drawings_do_no_harm() {
    for size in [1e-30_f32, 1e-6, 1e6, 1e18, 1e30] {
        let points = [(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)];
        let outline = polygon(&points.map(|(x, y)| (size * x, size * y)));
        for axis in [line(&[(0.0, 0.0), (0.0, 1.0)]), line(&[(0.0, 0.0), (1e15, 1e15)])] {
            let surface = single(&axis, &outline);
            let _ = (surface.profile(0.4), surface.exit(Vec2::ZERO, Vec2::X, f32::NAN));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn profiles_keep_area_and_lie_between(lobes in 2_u32..10, seed in 0_u64..1000) {
        let outline = lobed(Vec2::new(0.2, 3.0), 2.0, lobes, seed);
        let surface = single(&line(&[(0.0, 0.0), (0.0, 4.0)]), &outline);
        for azimuth in [0.0, PI] {
            let area = surface.profile(azimuth).unwrap().area();
            prop_assert!((area / outline.area() - 1.0).abs() < 0.02);
        }
        let doubled = |half: Vec<Vec2>| {
            let closed = half.iter().copied().zip(half.iter().copied().cycle().skip(1));
            closed.map(|(a, b)| a.perp_dot(b)).sum::<f32>().abs()
        };
        let (right, left) = (doubled(surface.half(0.0)), doubled(surface.half(PI)));
        let across = surface.profile(PI / 2.0).unwrap().area();
        prop_assert!(across > 0.95 * right.min(left) && across < 1.05 * right.max(left));
    }

    #[test]
    fn the_exit_is_that_of_the_profile(
        seed in 0_u64..1000,
        azimuth in -7.0_f32..7.0,
        heading in 0.0_f32..TAU,
        x in -3.0_f32..3.0,
        y in 0.0_f32..6.0,
    ) {
        let outline = lobed(Vec2::new(0.2, 3.0), 2.0, 5, seed);
        let surface = single(&line(&[(0.0, 0.0), (0.3, 4.0)]), &outline);
        let (from, way) = (Vec2::new(x, y), Vec2::new(libm::cosf(heading), libm::sinf(heading)));
        let (found, profile) = (surface.exit(from, way, azimuth), surface.profile(azimuth).unwrap());
        if profile.contains(from) {
            let expected = profile.exit(from, way).unwrap_or(0.0);
            prop_assert!((found.unwrap_or(0.0) - expected).abs() < 1e-2);
        } else {
            prop_assert!(found.is_none_or(|found| found < 1e-3));
        }
    }

    #[test]
    fn profiles_are_simple_and_against_the_clock(
        seed in 0_u64..1000,
        azimuth in 0.0_f32..TAU,
        x in -4.0_f32..4.0,
    ) {
        let (one, two) = (lobed(Vec2::new(x, 3.0), 2.0, 7, seed), lobed(Vec2::Y, 1.0, 3, seed + 1));
        let sections =
            [(0.0, &one), (1.3, &two)].map(|(azimuth, outline)| Section { azimuth, outline });
        let axis = line(&[(0.0, 0.0), (0.5, 2.0), (-0.5, 3.0), (0.3, 4.0)]);
        let profile = Revolved::of(&axis, &sections).profile(azimuth).unwrap();
        let (_, contours) = Frame::of(&[profile.points().to_vec()]).unwrap();
        prop_assert_eq!(crossings(&contours, 1), 0);
        prop_assert!(profile.area() > 0.0);
    }
}
