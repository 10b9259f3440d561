use super::*;

proptest! {
    #[test]
    fn combinations_follow_logic(a in any_volume(), b in any_volume(), p in point_in(6.0)) {
        let (in_a, in_b) = (a.contains(p), b.contains(p));
        prop_assert_eq!(a.union(&b).unwrap().contains(p), in_a || in_b);
        prop_assert_eq!(a.intersection(&b).unwrap().contains(p), in_a && in_b);
        prop_assert_eq!(a.difference(&b).unwrap().contains(p), in_a && !in_b);
        let both = Volume::union_all([a, b]).unwrap();
        prop_assert_eq!(both.contains(p), in_a || in_b);
    }

    #[test]
    fn repeated_combinations_follow_logic(
        parts in proptest::collection::vec(any_plain(), 3),
        p in point_in(4.0),
    ) {
        let [a, b, c] = &parts[..] else { unreachable!() };
        let [in_a, in_b, in_c] = [a, b, c].map(|v| v.contains(p));
        let less = a.difference(b).unwrap().difference(c).unwrap();
        prop_assert_eq!(less.contains(p), in_a && !in_b && !in_c);
        prop_assert_eq!(less.0.depth, 2);
        let shared = a.intersection(b).unwrap().intersection(c).unwrap();
        prop_assert_eq!(shared.contains(p), in_a && in_b && in_c);
        prop_assert_eq!(shared.0.depth, 1);
    }

    #[test]
    fn a_moved_volume_holds_the_moved_points(volume in any_volume(), map in any_map(), p in point_in(5.0)) {
        // Away from the surface, where rounding in the map cannot decide.
        if volume.distance(p).unwrap().abs() > 1e-4 {
            let moved = volume.transformed(map).unwrap();
            prop_assert_eq!(moved.contains(map.transform_point3(p)), volume.contains(p));
            let back = moved.transformed(map.inverse()).unwrap();
            prop_assert_eq!(back.contains(p), volume.contains(p));
        }
    }
}

#[test]
fn a_transform_of_a_transform_is_one_transform() {
    let ball = Volume::sphere(Vec3::ZERO, 1.0).unwrap();
    let mut moved = ball.clone();
    for _ in 0..200 {
        moved = moved.transformed(Affine3A::from_translation(Vec3::X)).unwrap();
    }
    assert_eq!(moved.0.depth, 1);
    assert_eq!(moved.bounds(), Aabb::new(Vec3::new(199.0, -1.0, -1.0), Vec3::new(201.0, 1.0, 1.0)));
}

#[test]
fn an_intersection_may_bound_half_spaces() {
    let slab = |normal| Volume::half_space(0.5 * normal, normal).unwrap();
    let mut cube = slab(Vec3::X);
    for normal in [Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z] {
        assert!(!cube.is_bounded());
        cube = cube.intersection(&slab(normal)).unwrap();
    }
    assert_eq!(cube.bounds(), Aabb::new(Vec3::splat(-0.5), Vec3::splat(0.5)));
    assert_eq!(cube.estimate_measure(1000, &Control::default()).unwrap(), 1.0);
    // Quarter turns may leave infinite sides infinite, but not make NaN of them.
    let turned =
        slab(Vec3::X).transformed(Affine3A::from_rotation_z(std::f32::consts::FRAC_PI_2)).unwrap();
    assert!(!turned.bounds().min.is_nan() && !turned.bounds().max.is_nan());
    assert!(turned.contains(Vec3::NEG_Y) && !turned.contains(Vec3::Y));
}

#[test]
fn one_volume_united_is_that_volume() {
    let ball = Volume::sphere(Vec3::ZERO, 1.0).unwrap();
    assert_eq!(Volume::union_all([ball.clone()]).unwrap(), ball);
    assert!(matches!(Volume::union_all([]), Err(CoreError::Empty { what: "union" })));
    assert_eq!(Volume::intersection_all([ball.clone()]).unwrap(), ball);
    assert!(matches!(Volume::intersection_all([]), Err(CoreError::Empty { .. })));
    let many = (0..100_u8).map(|i| Volume::sphere(f32::from(i) * Vec3::X, 0.4).unwrap());
    let row = Volume::union_all(many).unwrap();
    assert!(row.contains(50.3 * Vec3::X) && !row.contains(50.5 * Vec3::X));
    assert!((row.distance(Vec3::new(50.5, 0.0, 0.0)).unwrap() - 0.1).abs() < 1e-5);
}

#[test]
fn nesting_beyond_the_cap_is_an_error_and_below_it_works() {
    let ball = Volume::sphere(Vec3::ZERO, 1.0).unwrap();
    let hole = Volume::sphere(Vec3::ZERO, 0.5).unwrap();
    let mut deep = ball.clone();
    let error = loop {
        let next = match deep.0.depth % 2 {
            0 => deep.union(&ball),
            _ => deep.difference(&hole),
        };
        match next {
            Ok(next) => deep = next,
            Err(error) => break error,
        }
    };
    assert_eq!(deep.0.depth, MAX_DEPTH);
    assert!(matches!(error, CoreError::Parameter(error) if error.field == "volume.depth"));
    assert!(!deep.contains(Vec3::ZERO) && deep.contains(0.7 * Vec3::X));
    assert!(deep.distance(Vec3::X).is_some());
}

#[test]
fn doubling_beyond_the_cap_is_an_error() {
    let mut many = Volume::sphere(Vec3::ZERO, 1.0).unwrap();
    let error = loop {
        match many.union(&many) {
            Ok(more) => many = more,
            Err(error) => break error,
        }
    };
    assert!(matches!(error, CoreError::Parameter(error) if error.field == "volume.solids"));
}

#[test]
fn volumes_cross_threads() {
    fn shareable<T: Send + Sync + Clone + fmt::Debug>(_: &T) {}
    shareable(&Volume::sphere(Vec3::ZERO, 1.0).unwrap());
}

#[test]
fn an_odd_number_of_volumes_keeps_all_of_them() {
    let ball = |x: f32| Volume::sphere(Vec3::new(x, 0.0, 0.0), 1.0).unwrap();
    let three = [ball(0.0), ball(1.0), ball(5.0)];
    let union = Volume::union_all(three.clone()).unwrap();
    assert!(union.contains(Vec3::ZERO) && union.contains(Vec3::new(5.0, 0.0, 0.0)));
    let lens = Volume::intersection_all([ball(0.0), ball(1.0), ball(0.5)]).unwrap();
    assert!(lens.contains(Vec3::new(0.5, 0.0, 0.0)) && !lens.contains(Vec3::new(1.2, 0.0, 0.0)));
    assert!(!Volume::intersection_all(three).unwrap().contains(Vec3::new(0.5, 0.0, 0.0)));
}
