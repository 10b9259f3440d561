use super::*;
use proptest::prelude::*;

fn close(points: &[Vec2]) -> Result<(Outline, Vec<OutlineRepair>), ModelError> {
    Outline::close(points, "crown", &OutlineParams::default())
}

fn square() -> Outline {
    Outline::from_points(vec![Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y]).unwrap()
}

fn ring(n: usize, radius: impl Fn(f32) -> f32) -> Vec<Vec2> {
    let at = |i: usize| {
        let angle = std::f32::consts::TAU * i as f32 / n as f32;
        radius(angle) * Vec2::new(libm::cosf(angle), libm::sinf(angle))
    };
    (0..n).map(at).collect()
}

#[test]
fn a_good_stroke_stays_point_for_point() {
    let points = ring(500, |a| 3.0 + libm::sinf(7.0 * a));
    let (outline, repairs) = close(&points).unwrap();
    assert_eq!(outline.points(), points);
    assert!(repairs.is_empty(), "{repairs:?}");
}

#[test]
fn a_stroke_with_the_clock_is_turned() {
    let mut points = square().points().to_vec();
    points.reverse();
    let (outline, repairs) = close(&points).unwrap();
    assert_eq!(repairs, [OutlineRepair::Turned]);
    assert_eq!((outline.area(), outline.points()[0]), (1.0, Vec2::Y));
}

#[test]
fn gaps_are_closed_and_wide_ones_said_to_be() {
    let points = ring(100, |_| 1.0);
    assert!(matches!(close(&points[..95]).unwrap().1[..], [OutlineRepair::Closed { .. }]));
    let (half, repairs) = close(&points[..51]).unwrap();
    assert!(matches!(repairs[..], [OutlineRepair::WideGapClosed { .. }]), "{repairs:?}");
    assert!((half.area() - 1.57).abs() < 0.01);
    // Here the first point is drawn again.
    let again = [&points[..], &points[..1]].concat();
    assert!(close(&again).unwrap().1.is_empty());
}

#[test]
fn of_a_figure_of_eight_the_larger_part_is_kept() {
    let p = Vec2::new;
    let (outline, repairs) =
        close(&[p(0.0, 0.0), p(2.0, 2.0), p(2.0, 0.0), p(0.0, 2.0), p(-2.0, 1.0)]).unwrap();
    assert!((outline.area() - 3.0).abs() < 1e-5, "{outline:?}");
    assert_eq!(repairs[0], OutlineRepair::CrossingUndone);
    assert!(
        matches!(repairs[1], OutlineRepair::PartsDropped { count: 1, share } if (share - 0.25).abs() < 1e-5)
    );
}

#[test]
fn spikes_and_bad_points_are_left_out() {
    let p = Vec2::new;
    let points = [
        p(0.0, 0.0),
        p(1.0, 0.0),
        p(1.0, 0.0),
        p(f32::NAN, 0.0),
        p(1e30, 4.0),
        p(1.0, 0.5),
        p(3.0, 0.5),
        p(1.0, 0.5),
        p(1.0, 1.0),
        p(0.0, 1.0),
    ];
    let (outline, repairs) = close(&points).unwrap();
    assert_eq!((outline.area(), outline.bounds().1), (1.0, Vec2::ONE));
    let expected = [
        OutlineRepair::PointsDropped { count: 2 },
        OutlineRepair::DuplicatesDropped { count: 1 },
        OutlineRepair::SpikesDropped { count: 2 },
    ];
    assert_eq!(repairs, expected);
}

#[test]
fn very_many_points_are_thinned_and_keep_the_shape() {
    let points = ring(100_000, |a| 3.0 + libm::sinf(9.0 * a));
    let (outline, repairs) = close(&points).unwrap();
    assert!(outline.points().len() <= 2000, "{repairs:?}");
    assert!(matches!(repairs[..], [OutlineRepair::Thinned { before: 100_000, .. }]));
    assert!((outline.area() / 29.845 - 1.0).abs() < 1e-3, "{}", outline.area());
}

#[test]
fn what_encloses_nothing_is_refused_by_name() {
    let p = Vec2::new;
    for (points, problem) in [
        (vec![], "0 different points"),
        (vec![Vec2::ONE; 9], "1 different points"),
        (vec![Vec2::NAN; 9], "0 different points"),
        (vec![p(0.0, 0.0), p(5.0, 5.0)], "2 different points"),
        (ring(9, |_| 1e-7), "it must be at least"),
        (vec![p(0.0, 0.0), p(1.0, 0.0), p(2.0, 0.0)], "encloses"),
        (vec![p(0.0, 0.0), p(1.0, 0.0), p(1.0, 1e-6)], "encloses"),
    ] {
        let error = close(&points).unwrap_err();
        assert!(matches!(error, ModelError::Silhouette { .. }));
        assert!(error.to_string().starts_with("crown: it"), "{error}");
        assert!(error.to_string().contains(problem), "{error}");
    }
}

#[test]
fn parameters_are_checked_by_name() {
    for params in [
        OutlineParams { gap: f32::NAN, ..OutlineParams::default() },
        OutlineParams { corners: 3, ..OutlineParams::default() },
    ] {
        assert!(matches!(
            Outline::close(&ring(9, |_| 1.0), "crown", &params),
            Err(ModelError::Parameter(error)) if error.field.starts_with("outline.")
        ));
    }
}

#[test]
fn points_taken_as_they_are_must_be_an_outline() {
    let p = Vec2::new;
    for (points, problem) in [
        (vec![Vec2::ZERO, Vec2::X], "at least three"),
        (vec![Vec2::ZERO, Vec2::X, Vec2::NAN], "points[2]"),
        (vec![Vec2::ZERO, Vec2::X, Vec2::X, Vec2::Y], "points[1] is repeated"),
        (vec![Vec2::ZERO, Vec2::X, Vec2::Y, Vec2::ZERO], "points[3] is repeated"),
        (vec![Vec2::ZERO, Vec2::Y, Vec2::X], "with the clock"),
        (vec![p(0.0, 0.0), p(2.0, 2.0), p(2.0, 0.0), p(0.0, 2.0)], "crosses"),
        (ring(5000, |_| 1.0), "5000 points"),
    ] {
        let error = Outline::from_points(points).unwrap_err().to_string();
        assert!(error.contains(problem), "{error}");
    }
}

#[test]
fn lengths_along_go_on_round() {
    let square = square();
    assert_eq!(square.perimeter(), 4.0);
    for (length, point) in [
        (0.5, [0.5, 0.0]),
        (4.5, [0.5, 0.0]),
        (-0.5, [0.0, 0.5]),
        (2.0, [1.0, 1.0]),
        (4.0, [0.0; 2]),
    ] {
        assert_eq!(square.along(length), Vec2::from(point), "{length}");
    }
    assert_eq!(square.tangent(0.5), Vec2::X);
    assert!(square.tangent(1.0).distance(Vec2::ONE.normalize()) < 1e-6);
    assert_eq!(square.nearest(Vec2::new(3.0, 0.25)), (1.25, 2.0));
    assert!(square.along(f32::NAN).is_finite() && square.along(f32::INFINITY).is_finite());
}

#[test]
fn a_part_may_pass_the_first_corner() {
    let square = square();
    let p = Vec2::new;
    assert_eq!(square.part(0.5, 1.5), [p(0.5, 0.0), p(1.0, 0.0), p(1.0, 0.5)]);
    assert_eq!(square.part(3.5, 4.5), [p(0.0, 0.5), p(0.0, 0.0), p(0.5, 0.0)]);
    assert_eq!(square.part(1.5, 0.5), [p(1.0, 0.5)]);
    assert_eq!(square.part(0.5, 99.0).len(), 6);
}

#[test]
fn a_mirrored_outline_still_runs_against_the_clock() {
    let mirrored = square().transformed(|p| p * Vec2::new(-2.0, 1.0)).unwrap();
    assert_eq!(mirrored.area(), 2.0);
    assert!(square().transformed(|p| p * Vec2::X).is_none());
    assert!(square().transformed(|p| p / 0.0).is_none());
}

#[test]
fn few_points_at_even_lengths_keep_the_shape() {
    let round = Outline::from_points(ring(1000, |_| 1.0)).unwrap();
    let few = round.resampled(100);
    assert_eq!(few.points().len(), 100);
    assert!(few.iou(&round) > 0.99);
}

#[test]
fn overlaps_are_areas_in_common() {
    let square = square();
    let shifted = square.transformed(|p| p + Vec2::new(0.25, 0.5)).unwrap();
    assert!((square.overlap(&shifted) - 0.375).abs() < 1e-4);
    assert!((square.iou(&shifted) - 0.375 / 1.625).abs() < 5e-3);
    assert_eq!((square.iou(&square), square.overlap(&square)), (1.0, 1.0));
    let apart = square.transformed(|p| p + Vec2::splat(3.0)).unwrap();
    assert_eq!((square.overlap(&apart), square.iou(&apart)), (0.0, 0.0));
}

#[test]
fn a_mask_holds_the_cells_with_their_centres_inside() {
    let mask = square().mask(Vec2::new(-1.0, 0.0), Vec2::new(3.0, 2.0), 4, 2);
    assert_eq!(mask, [false, true, false, false, false, false, false, false]);
    assert!(square().mask(Vec2::ZERO, Vec2::ONE, 0, 0).is_empty());
    let lobes = Outline::from_points(ring(300, |a| 3.0 + libm::sinf(7.0 * a))).unwrap();
    let (low, high) = lobes.bounds();
    for (i, inside) in lobes.mask(low, high, 50, 40).into_iter().enumerate() {
        let center = Vec2::new((i % 50) as f32 + 0.5, (i / 50) as f32 + 0.5);
        let point = low + (high - low) * center / Vec2::new(50.0, 40.0);
        assert_eq!(inside, lobes.contains(point), "{point}");
    }
}

#[test]
fn a_leaf_stands_on_its_base_with_its_tip_at_one() {
    let blade = ring(400, |a| 0.3 + 0.7 * libm::sinf(a).abs());
    let outline = Outline::close(&blade, "leaf", &OutlineParams::default()).unwrap().0;
    let leaf = LeafOutline::of(&outline, Vec2::new(0.0, -1.0), Vec2::new(0.0, 1.0)).unwrap();
    assert!(leaf.points.len() <= 64 && leaf.triangles.len() == leaf.points.len() - 2);
    let (low, high) = leaf.bounds();
    assert!(low.y.abs() < 0.01 && (high.y - 1.0).abs() < 0.01, "{low} {high}");
    assert!((leaf.area() / (0.25 * outline.area()) - 1.0).abs() < 0.06);
    assert!(LeafOutline::of(&outline, Vec2::ONE, Vec2::ONE).is_err());
    assert!(LeafOutline::of(&outline, Vec2::NAN, Vec2::ONE).is_err());
}

#[test]
fn a_leaf_is_attached_by_its_stalk_however_it_lies() {
    // A round blade at (0, 2) on a stalk from the origin.
    let mut points: Vec<Vec2> =
        ring(60, |_| 0.8).into_iter().map(|p| p.perp() + 2.0 * Vec2::Y).collect();
    points.rotate_left(30);
    points.retain(|p| p.y > 1.25 || p.x.abs() > 0.1);
    points.extend([
        Vec2::new(-0.03, 1.2),
        Vec2::new(-0.03, 0.0),
        Vec2::new(0.03, 0.0),
        Vec2::new(0.03, 1.2),
    ]);
    let outline = close(&points).unwrap().0;
    for turn in 0..12 {
        let angle = 0.5 * turn as f32;
        let (sin, cos) = (libm::sinf(angle), libm::cosf(angle));
        let turned = outline.transformed(|p| Vec2::new(cos, sin).rotate(p)).unwrap();
        assert!(
            LeafOutline::base_of(&turned).length() < 0.05,
            "{turn}: {}",
            LeafOutline::base_of(&turned)
        );
    }
}

#[test]
fn a_leaf_without_a_stalk_stands_on_its_lowest_point() {
    let outline = close(&ring(40, |a| 0.4 + 0.6 * libm::sinf(a).abs())).unwrap().0;
    assert!(LeafOutline::base_of(&outline).distance(Vec2::NEG_Y) < 0.05);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn what_is_closed_is_an_outline(
        list in prop::collection::vec((-9.0_f32..9.0, -9.0_f32..9.0), 0..60),
        offset in 0.0_f32..2000.0,
    ) {
        let points: Vec<Vec2> = list.iter().map(|&p| Vec2::from(p) + offset).collect();
        if let Ok((outline, _)) = close(&points) {
            prop_assert_eq!(Outline::from_points(outline.points().to_vec()).unwrap(), outline);
        }
    }

    #[test]
    fn what_is_on_a_coarse_grid_is_closed_too(
        list in prop::collection::vec((-4_i16..4, -4_i16..4), 0..40),
    ) {
        let points: Vec<Vec2> = list.iter().map(|&(x, y)| Vec2::new(x.into(), y.into())).collect();
        if let Ok((outline, _)) = close(&points) {
            prop_assert_eq!(Outline::from_points(outline.points().to_vec()).unwrap(), outline);
        }
    }
}
