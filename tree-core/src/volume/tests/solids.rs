use super::*;

/// Points on a surface are left out where rounding may decide.
const SURFACE: f32 = 1e-4;

proptest! {
    #[test]
    fn bounds_hold_every_point_inside(volume in any_volume(), p in point_in(6.0)) {
        // The shape is asked directly: `contains` consults the bounds first.
        if volume.shape().contains(p.as_dvec3()) {
            prop_assert!(volume.bounds().grown(1e-5).contains(p), "{p} {:?}", volume.bounds());
        }
        if volume.contains(p) {
            prop_assert!(volume.bounds().contains(p));
        }
    }

    #[test]
    fn bounds_of_plain_solids_are_tight(volume in any_plain()) {
        // Every face of the box is touched: the solid cut down by a little has a smaller measure.
        let bounds = volume.bounds();
        let size = bounds.size();
        for axis in 0..3 {
            for side in [bounds.min, bounds.max] {
                let mut nearest = f32::INFINITY;
                for u in 0..=40 {
                    for v in 0..=40 {
                        let share = Vec2::new(u as f32, v as f32) / 40.0;
                        let mut p = bounds.min;
                        p[axis] = side[axis];
                        p[(axis + 1) % 3] += share.x * size[(axis + 1) % 3];
                        p[(axis + 2) % 3] += share.y * size[(axis + 2) % 3];
                        nearest = nearest.min(volume.distance(p).unwrap());
                    }
                }
                prop_assert!(nearest < 0.05 * size.length(), "{nearest} {volume:?}");
            }
        }
    }

    #[test]
    fn inside_is_where_the_distance_is_negative(volume in any_volume(), p in point_in(6.0)) {
        let distance = volume.distance(p).unwrap();
        if distance.abs() > SURFACE {
            prop_assert_eq!(volume.contains(p), distance < 0.0, "{} {:?}", distance, volume);
        }
    }

    #[test]
    fn any_finite_point_gets_an_answer(volume in any_volume(), bits in any::<[u32; 3]>()) {
        let p = Vec3::from_array(bits.map(f32::from_bits));
        let distance = volume.distance(p);
        prop_assert_eq!(distance.is_some(), p.is_finite());
        prop_assert!(distance.is_none_or(f32::is_finite));
        prop_assert!(p.is_finite() || !volume.contains(p));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    #[test]
    fn sampling_agrees_with_the_closed_form(volume in any_plain(), map in any_map()) {
        for volume in [volume.transformed(map).unwrap(), volume] {
            let found = volume.estimate_measure(27_000, &Control::default()).unwrap();
            let size = volume.bounds().size();
            let expected = volume.measure().unwrap();
            prop_assert!(
                (found - expected).abs() < 0.012 * size.element_product(),
                "{found} {expected} {volume:?}"
            );
        }
    }

    #[test]
    fn samples_lie_inside_and_repeat_with_the_seed(volume in any_plain(), seed in any::<u64>()) {
        let draw = || volume.sample(&mut crate::Seed(seed).rng(), 10_000);
        let p = draw().unwrap();
        prop_assert!(volume.contains(p));
        prop_assert_eq!(draw(), Some(p));
    }
}

#[test]
fn samples_fill_a_half_ball_evenly() {
    let half = Volume::sector(Vec3::ZERO, Vec3::Y, std::f32::consts::FRAC_PI_2, 1.0).unwrap();
    let mut rng = crate::Seed(2).rng();
    let mean = (0..20_000).map(|_| half.sample(&mut rng, 64).unwrap()).sum::<Vec3>() / 20_000.0;
    // The centroid of a half ball lies at 3/8 of its radius.
    assert!((mean - 0.375 * Vec3::Y).length() < 0.01, "{mean}");
}

#[test]
fn what_cannot_be_sampled_gives_none() {
    let mut rng = crate::Seed(2).rng();
    let below = Volume::half_space(Vec3::ZERO, Vec3::Y).unwrap();
    assert_eq!(below.sample(&mut rng, 10), None);
    assert_eq!(below.estimate_measure(10, &Control::default()).unwrap(), f32::INFINITY);
    assert!(!below.is_bounded() && below.measure().is_none());
    assert_eq!(below.bounds().max.y, 0.0);
    let above = Volume::box_solid(Vec3::ONE, Vec3::splat(2.0)).unwrap();
    let nothing = above.intersection(&below).unwrap();
    assert!(nothing.is_bounded());
    assert_eq!(nothing.sample(&mut rng, 10), None);
    assert_eq!(nothing.estimate_measure(10, &Control::default()).unwrap(), 0.0);
    assert_eq!(above.sample(&mut rng, 0), None);
}

#[test]
fn plain_solids_hold_their_surface() {
    let v = Vec3::new;
    let angle = std::f32::consts::FRAC_PI_2;
    for (volume, p) in [
        (Volume::sphere(Vec3::ZERO, 2.0), v(2.0, 0.0, 0.0)),
        (Volume::ellipsoid(Vec3::ZERO, v(1.0, 2.0, 4.0)), v(0.0, 2.0, 0.0)),
        (Volume::cylinder(Vec3::ZERO, Vec3::Y, 1.0), v(1.0, 1.0, 0.0)),
        (Volume::cone(Vec3::ZERO, Vec3::Y, 1.0), v(0.0, 1.0, 0.0)),
        (Volume::frustum(Vec3::ZERO, Vec3::Y, 1.0, 0.5), v(0.75, 0.5, 0.0)),
        (Volume::capsule(Vec3::ZERO, Vec3::Y, 1.0), v(0.0, 2.0, 0.0)),
        (Volume::box_solid(Vec3::ZERO, Vec3::ONE), v(1.0, 0.0, 1.0)),
        (Volume::half_space(Vec3::ZERO, v(0.0, 3.0, 0.0)), v(5.0, 0.0, 1.0)),
        (Volume::sector(Vec3::ZERO, Vec3::Y, 1.0, 1.0), Vec3::ZERO),
        (Volume::sector(Vec3::ZERO, Vec3::Y, angle, 1.0), Vec3::Y),
    ] {
        let volume = volume.unwrap();
        assert!(volume.contains(p), "{p} {volume:?}");
        assert_eq!(volume.distance(p), Some(0.0), "{p} {volume:?}");
    }
}

#[test]
fn a_sector_of_pi_is_the_whole_ball() {
    let ball = Volume::sphere(Vec3::ONE, 2.0).unwrap();
    let sector = Volume::sector(Vec3::ONE, Vec3::Y, std::f32::consts::PI, 2.0).unwrap();
    for p in scattered(2000, 4.0).chain([Vec3::ONE, Vec3::ONE - Vec3::Y, Vec3::ONE - 2.0 * Vec3::Y])
    {
        assert_eq!(sector.contains(p), ball.contains(p), "{p}");
        assert!((sector.distance(p).unwrap() - ball.distance(p).unwrap()).abs() < 1e-6);
    }
    assert!((sector.measure().unwrap() - ball.measure().unwrap()).abs() < 1e-4);
}

#[test]
fn a_wide_sector_leaves_out_only_the_cone_behind() {
    let wide = Volume::sector(Vec3::ZERO, Vec3::Y, 0.75 * std::f32::consts::PI, 1.0).unwrap();
    assert!(wide.contains(Vec3::new(0.9, -0.1, 0.0)));
    assert!(!wide.contains(Vec3::new(0.1, -0.9, 0.0)));
    assert!((wide.distance(Vec3::NEG_Y).unwrap() - 0.5_f32.sqrt()).abs() < 1e-6);
}

#[test]
fn the_distance_of_a_frustum_counts_the_nearest_of_side_and_ends() {
    let cone = Volume::cone(Vec3::ZERO, Vec3::Y, 1.0).unwrap();
    let near = |p, expected: f32| {
        let found = cone.distance(p).unwrap();
        assert!((found - expected).abs() < 1e-6, "{p} {found} {expected}");
    };
    near(2.0 * Vec3::Y, 1.0);
    near(-Vec3::Y, 1.0);
    near(Vec3::new(3.0, 0.0, 0.0), 2.0);
    near(Vec3::new(0.0, 0.1, 0.0), -0.1);
    near(Vec3::new(1.0, 1.0, 0.0), 0.5_f32.sqrt());
}

#[test]
fn a_profile_with_an_overhang_keeps_its_hollow() {
    // An umbrella: a stem, and a cap whose rim hangs down below its middle.
    let profile = [[0.2, 0.0], [0.2, 2.0], [1.5, 1.0], [2.0, 1.0], [1.0, 3.0], [0.0, 3.0]]
        .map(Vec2::from_array)
        .to_vec();
    let umbrella = Volume::revolution(Vec3::ZERO, Vec3::Y, profile).unwrap();
    assert!(umbrella.contains(Vec3::new(0.1, 0.5, 0.0)), "stem");
    assert!(!umbrella.contains(Vec3::new(0.8, 1.1, 0.0)), "under the cap");
    assert!(umbrella.contains(Vec3::new(0.0, 1.2, -1.6)), "rim");
    assert!(umbrella.contains(Vec3::new(0.0, 2.5, 0.0)), "cap");
    let estimate = umbrella.estimate_measure(125_000, &Control::default()).unwrap();
    assert!((umbrella.measure().unwrap() / estimate - 1.0).abs() < 0.02);
    assert!((umbrella.distance(Vec3::new(0.0, 0.5, 0.0)).unwrap() + 0.2).abs() < 1e-6);
}

#[test]
fn a_closed_profile_turns_into_a_ring() {
    let ring: Vec<Vec2> = (0..=64)
        .map(|i| {
            let angle = std::f32::consts::TAU * (i % 64) as f32 / 64.0;
            Vec2::new(2.0 + 0.5 * libm::cosf(angle), 0.5 * libm::sinf(angle))
        })
        .collect();
    let torus = Volume::revolution(Vec3::ZERO, Vec3::Z, ring).unwrap();
    assert!(!torus.contains(Vec3::ZERO) && torus.contains(Vec3::new(0.0, -2.0, 0.1)));
    // The closing lines to the axis cancel: the nearest surface is the inside of the ring.
    assert!((torus.distance(Vec3::ZERO).unwrap() - 1.5).abs() < 1e-6);
    let exact = 2.0 * std::f32::consts::PI * std::f32::consts::PI * 2.0 * 0.25;
    assert!((torus.measure().unwrap() / exact - 1.0).abs() < 0.01);
}

#[test]
fn a_profile_is_the_same_drawn_up_or_down() {
    let up: Vec<Vec2> = (0..500_u16)
        .map(|i| Vec2::new(1.0 + f32::from(i % 7) * 0.1, f32::from(i) * 0.01 + f32::from(i % 3)))
        .collect();
    let down = up.iter().rev().copied().collect();
    let up = Volume::revolution(Vec3::ZERO, Vec3::Y, up).unwrap();
    let down = Volume::revolution(Vec3::ZERO, Vec3::Y, down).unwrap();
    for p in scattered(5000, 2.5).map(|p| p + 2.5 * Vec3::Y) {
        assert_eq!(up.contains(p), down.contains(p), "{p}");
    }
    assert_eq!(up.measure(), down.measure());
}

#[test]
fn tiny_and_huge_solids_still_answer() {
    for radius in [f32::MIN_POSITIVE, 1e-20, 1e20, f32::MAX] {
        let ball = Volume::sphere(Vec3::ZERO, radius).unwrap();
        assert!(ball.contains(Vec3::ZERO) && ball.contains(0.9 * radius * Vec3::X));
        assert!(!ball.contains(0.9 * radius * Vec3::ONE));
        let egg = Volume::ellipsoid(Vec3::ZERO, Vec3::new(radius, 1.0, 1.0)).unwrap();
        for p in [Vec3::ZERO, Vec3::Y, radius * Vec3::X, Vec3::MAX, Vec3::splat(1e-30)] {
            assert!(egg.distance(p).unwrap().is_finite());
        }
    }
    assert_eq!(Volume::sphere(Vec3::ZERO, 1e20).unwrap().measure(), None);
}
