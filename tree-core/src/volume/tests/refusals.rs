use super::*;

fn field(result: Result<Volume>) -> String {
    match result.unwrap_err() {
        CoreError::Parameter(error) => error.field.into(),
        CoreError::NotFinite { field, .. } | CoreError::OutOfRange { field, .. } => field.into(),
        CoreError::Empty { what } => what.into(),
        CoreError::Volume { solid, .. } => solid.into(),
        other => panic!("{other}"),
    }
}

#[test]
fn a_point_that_is_not_finite_is_refused_by_name() {
    let o = Vec3::ZERO;
    for bad in [Vec3::NAN, Vec3::INFINITY, Vec3::new(0.0, f32::NEG_INFINITY, 0.0)] {
        for (result, name) in [
            (Volume::sphere(bad, 1.0), "sphere.center"),
            (Volume::ellipsoid(bad, Vec3::ONE), "ellipsoid.center"),
            (Volume::ellipsoid(o, bad + Vec3::ONE), "ellipsoid.radii"),
            (Volume::cylinder(bad, o, 1.0), "cylinder.base"),
            (Volume::cylinder(o, bad, 1.0), "cylinder.top"),
            (Volume::cone(bad, o, 1.0), "frustum.base"),
            (Volume::frustum(o, bad, 1.0, 1.0), "frustum.top"),
            (Volume::capsule(bad, o, 1.0), "capsule.start"),
            (Volume::capsule(o, bad, 1.0), "capsule.end"),
            (Volume::box_solid(bad, o), "box.min"),
            (Volume::box_solid(o, bad), "box.max"),
            (Volume::half_space(bad, Vec3::Y), "half_space.point"),
            (Volume::half_space(o, bad), "half_space.normal"),
            (Volume::sector(bad, Vec3::Y, 1.0, 1.0), "sector.apex"),
            (Volume::sector(o, bad, 1.0, 1.0), "sector.axis"),
            (Volume::revolution(bad, Vec3::Y, vec![]), "revolution.base"),
            (Volume::revolution(o, bad, vec![]), "revolution.axis"),
            (Volume::mesh(vec![bad], vec![[0; 3]]), "mesh.positions"),
        ] {
            assert!(matches!(result, Err(CoreError::NotFinite { .. })), "{name}");
            assert_eq!(field(result), name);
        }
    }
}

#[test]
fn a_size_out_of_range_is_refused_by_name() {
    let o = Vec3::ZERO;
    for bad in [0.0, -0.0, -1.0, f32::MIN, f32::NAN, f32::INFINITY, 1e-40] {
        for (result, name) in [
            (Volume::sphere(o, bad), "sphere.radius"),
            (Volume::ellipsoid(o, Vec3::new(1.0, bad, 1.0)), "ellipsoid.radii"),
            (Volume::cylinder(o, Vec3::Y, bad), "cylinder.radius"),
            (Volume::capsule(o, Vec3::Y, bad), "capsule.radius"),
            (Volume::sector(o, Vec3::Y, bad, 1.0), "sector.angle"),
            (Volume::sector(o, Vec3::Y, 1.0, bad), "sector.radius"),
        ] {
            assert_eq!(field(result), name, "{bad}");
        }
    }
    for bad in [-1.0, f32::NAN, f32::INFINITY] {
        assert_eq!(field(Volume::frustum(o, Vec3::Y, bad, 1.0)), "frustum.base_radius");
        assert_eq!(field(Volume::frustum(o, Vec3::Y, 1.0, bad)), "frustum.top_radius");
        assert_eq!(field(Volume::cone(o, Vec3::Y, bad)), "frustum.base_radius");
    }
    assert_eq!(field(Volume::sector(o, Vec3::Y, 3.15, 1.0)), "sector.angle");
}

#[test]
fn a_solid_without_extent_or_direction_is_refused() {
    let o = Vec3::ZERO;
    for (result, name) in [
        (Volume::cylinder(o, o, 1.0), "cylinder"),
        (Volume::cone(o, o, 1.0), "frustum"),
        (Volume::cone(o, Vec3::Y, 0.0), "frustum"),
        (Volume::box_solid(o, Vec3::new(1.0, 0.0, 1.0)), "box"),
        (Volume::box_solid(Vec3::ONE, o), "box"),
        (Volume::half_space(o, o), "half-space"),
        (Volume::sector(o, o, 1.0, 1.0), "sector"),
        (Volume::revolution(o, o, vec![Vec2::ONE]), "revolution"),
    ] {
        assert!(matches!(result, Err(CoreError::Volume { .. })), "{name}");
        assert_eq!(field(result), name);
    }
}

#[test]
fn a_profile_that_bounds_nothing_is_refused() {
    let turn = |profile: &[[f32; 2]]| {
        let profile = profile.iter().copied().map(Vec2::from_array).collect();
        Volume::revolution(Vec3::ZERO, Vec3::Y, profile)
    };
    assert!(matches!(turn(&[]), Err(CoreError::Empty { what: "revolution.profile" })));
    assert_eq!(field(turn(&[[1.0, 0.0]])), "revolution");
    assert_eq!(field(turn(&[[1.0, 2.0], [2.0, 2.0]])), "revolution");
    assert_eq!(field(turn(&[[0.0, 0.0], [0.0, 1.0]])), "revolution");
    for (bad, finite) in [(-1.0, true), (f32::NAN, false), (f32::INFINITY, false)] {
        match turn(&[[1.0, 0.0], [1.0, 0.5], [bad, 1.0]]) {
            Err(CoreError::OutOfRange { index: 2, .. }) => assert!(finite),
            Err(CoreError::NotFinite { index: 2, .. }) => assert!(!finite),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn a_map_that_flattens_is_refused() {
    let ball = Volume::sphere(Vec3::ZERO, 1.0).unwrap();
    let turn = Affine3A::from_rotation_x(0.7) * Affine3A::from_rotation_z(0.3);
    for flat in [
        Affine3A::from_scale(Vec3::ZERO),
        Affine3A::from_scale(Vec3::new(1.0, 0.0, 1.0)),
        // Not exactly singular once rounded.
        turn * Affine3A::from_scale(Vec3::new(1.0, 0.0, 1.0)) * turn,
    ] {
        assert!(matches!(
            ball.transformed(flat),
            Err(CoreError::Volume { solid: "transformed", .. })
        ));
    }
    for bad in [f32::NAN, f32::INFINITY] {
        assert!(matches!(
            ball.transformed(Affine3A::from_translation(bad * Vec3::ONE)),
            Err(CoreError::NotFinite { .. })
        ));
    }
    // Small and strongly stretched is not flat.
    assert!(ball.transformed(Affine3A::from_scale(Vec3::new(1e-6, 1e6, 1.0))).is_ok());
}

#[test]
fn combinations_of_nothing_are_refused() {
    assert_eq!(field(Volume::new(Solid::Union(vec![]))), "union");
    assert_eq!(field(Volume::new(Solid::Intersection(vec![]))), "intersection");
}
