use super::*;

proptest! {
    #[test]
    fn no_distance_is_too_long(volume in any_volume(), p in point_in(5.0), q in point_in(5.0)) {
        // Between a point inside and one outside there is a surface.
        if volume.contains(p) != volume.contains(q) {
            let found = volume.distance(p).unwrap();
            prop_assert!(found.abs() <= p.distance(q) * 1.000_01 + 1e-4, "{found} {volume:?}");
        }
    }

    #[test]
    fn an_exact_distance_leads_to_the_surface(volume in any_plain(), p in point_in(5.0)) {
        prop_assert!(volume.distance_is_exact());
        let at = |p| f64::from(volume.distance(p).unwrap());
        let step = 4e-3;
        let slope = glam::DVec3::from_array(
            [Vec3::X, Vec3::Y, Vec3::Z]
                .map(|axis| (at(p + step * axis) - at(p - step * axis)) / f64::from(2.0 * step)),
        );
        // Elsewhere two surfaces are equally near, or the surface itself has an edge.
        if (slope.length() - 1.0).abs() < 1e-3 {
            let foot = p - (at(p) * slope.normalize()).as_vec3();
            prop_assert!(at(foot).abs() < 0.02 * at(p).abs() + 1e-3, "{} {volume:?}", at(foot));
        }
    }

    #[test]
    fn turning_and_uniform_scale_keep_distances_exact(
        volume in any_plain(),
        axis in direction(),
        angle in -3.0_f32..3.0,
        factor in 0.3_f32..3.0,
        shift in point_in(2.0),
        p in point_in(4.0),
    ) {
        let turn = Quat::from_axis_angle(axis.normalize(), angle);
        let map = Affine3A::from_scale_rotation_translation(Vec3::splat(factor), turn, shift);
        let moved = volume.transformed(map).unwrap();
        prop_assert!(moved.distance_is_exact());
        let expected = factor * volume.distance(p).unwrap();
        let found = moved.distance(map.transform_point3(p)).unwrap();
        prop_assert!((found - expected).abs() < 1e-4 * (1.0 + expected.abs()), "{found} {expected}");
    }

    #[test]
    fn a_union_of_exact_parts_is_exact_outside(a in any_plain(), b in any_plain(), p in point_in(5.0)) {
        let nearest = a.distance(p).unwrap().min(b.distance(p).unwrap());
        let union = a.union(&b).unwrap();
        prop_assert!(!union.distance_is_exact());
        prop_assert_eq!(union.distance(p).unwrap(), nearest);
    }
}

#[test]
fn a_bound_under_stretching_is_as_long_as_it_can_be() {
    let ball = Volume::sphere(Vec3::ZERO, 1.0).unwrap();
    let map = Affine3A::from_scale(Vec3::new(3.0, 0.5, 2.0));
    let egg = ball.transformed(map).unwrap();
    assert!(!egg.distance_is_exact());
    // Along the direction of least stretch the bound is the distance itself, less 1 %.
    let found = egg.distance(Vec3::new(0.0, 2.5, 0.0)).unwrap();
    assert!((1.98..=2.0).contains(&found), "{found}");
}

#[test]
fn an_ellipsoid_has_the_distance_of_its_nearest_surface_point() {
    let shares: Vec<Vec3> = (0..=120)
        .flat_map(|i| {
            let theta = std::f32::consts::PI * i as f32 / 120.0;
            (0..240).map(move |j| {
                let phi = std::f32::consts::TAU * j as f32 / 240.0;
                let ring = libm::sinf(theta);
                Vec3::new(ring * libm::cosf(phi), libm::cosf(theta), ring * libm::sinf(phi))
            })
        })
        .collect();
    // Points on planes and axes of symmetry, at the middle, on and next to the evolute.
    let coordinates = [0.0, 1e-30, 0.2, -1.0, 3.0];
    for radii in
        [Vec3::new(1.0, 2.0, 4.0), Vec3::new(3.0, 3.0, 1.0), Vec3::new(1.0, 3.0, 3.0), Vec3::ONE]
    {
        let egg = Volume::ellipsoid(Vec3::ZERO, radii).unwrap();
        let surface: Vec<Vec3> = shares.iter().map(|&s| s * radii).collect();
        for x in coordinates {
            for y in coordinates {
                for z in coordinates {
                    let p = Vec3::new(x, y, z);
                    let nearest = surface.iter().map(|q| q.distance(p)).fold(f32::MAX, f32::min);
                    let found = egg.distance(p).unwrap();
                    assert!(found.abs() <= nearest + 1e-5, "{radii} {p} {found} {nearest}");
                    // The samples lie up to 0.07 apart, which counts in full next to the surface.
                    let slack = 0.01 * (1.0 + 4.0 * found.abs());
                    assert!(
                        found * found >= nearest * nearest - slack,
                        "{radii} {p} {found} {nearest}"
                    );
                }
            }
        }
    }
}

#[test]
fn the_nearest_triangle_of_many_is_found() {
    let (positions, triangles) = icosphere(3);
    let corners: Vec<[glam::DVec3; 3]> =
        triangles.iter().map(|t| t.map(|i| positions[i as usize].as_dvec3())).collect();
    let mesh = Volume::mesh(positions, triangles).unwrap();
    for p in scattered(200, 2.0).chain([Vec3::ZERO, Vec3::Y, 100.0 * Vec3::ONE]) {
        let nearest = corners
            .iter()
            .map(|&t| math::triangle_distance_squared(p.as_dvec3(), t))
            .fold(f64::INFINITY, f64::min)
            .sqrt();
        assert_eq!(mesh.distance(p).unwrap().abs(), nearest as f32, "{p}");
    }
}
