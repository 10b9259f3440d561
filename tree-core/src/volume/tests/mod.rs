use super::*;
use crate::control::Control;
use glam::{Affine3A, Quat, Vec2};
use proptest::prelude::*;

mod combinations;
mod distances;
mod meshes;
mod refusals;
#[cfg(feature = "serde")]
mod serial;
mod solids;

fn point_in(half: f32) -> impl Strategy<Value = Vec3> {
    // Leans to coordinates that line up with corners, axes and planes of symmetry.
    let coordinate = prop_oneof![
        3 => -half..half,
        1 => (-4_i8..=4).prop_map(move |i| f32::from(i) * half / 4.0),
    ];
    [coordinate.clone(), coordinate.clone(), coordinate].prop_map(Vec3::from_array)
}

fn direction() -> impl Strategy<Value = Vec3> {
    point_in(1.0).prop_filter("no direction", |v| v.length() > 0.1)
}

fn size() -> impl Strategy<Value = f32> {
    prop_oneof![0.2_f32..2.0, Just(1.0)]
}

/// Profile whose heights rise all the way, so that it cannot cross itself.
fn rising_profile() -> impl Strategy<Value = Vec<Vec2>> {
    let radius = prop_oneof![0.0_f32..2.0, Just(0.0)];
    proptest::collection::vec((radius, 0.1_f32..1.0), 2..8).prop_map(|rows| {
        let mut height = -2.0;
        let point = |(radius, rise)| {
            height += rise;
            Vec2::new(radius, height)
        };
        rows.into_iter().map(point).collect()
    })
}

/// Any plain solid with a volume; their closed forms hold.
fn any_plain() -> impl Strategy<Value = Volume> {
    let p = || point_in(2.0);
    prop_oneof![
        (p(), size()).prop_map(|(c, r)| Volume::sphere(c, r)),
        (p(), [size(), size(), size()])
            .prop_map(|(c, r)| Volume::ellipsoid(c, Vec3::from_array(r))),
        (p(), direction(), size()).prop_map(|(a, d, r)| Volume::cylinder(a, a + d, r)),
        (p(), direction(), size()).prop_map(|(a, d, r)| Volume::cone(a, a + d, r)),
        (p(), direction(), size(), size()).prop_map(|(a, d, r, s)| Volume::frustum(a, a + d, r, s)),
        (p(), p(), size()).prop_map(|(a, b, r)| Volume::capsule(a, b, r)),
        (p(), [size(), size(), size()])
            .prop_map(|(a, s)| Volume::box_solid(a, a + Vec3::from_array(s))),
        (p(), direction(), prop_oneof![0.2_f32..3.1, Just(std::f32::consts::PI)], size())
            .prop_map(|(a, d, angle, r)| Volume::sector(a, d, angle, r)),
        (p(), direction(), rising_profile())
            .prop_map(|(a, d, profile)| Volume::revolution(a, d, profile)),
        (p(), size()).prop_map(|(c, r)| {
            let (positions, triangles) = icosphere(1);
            Volume::mesh(positions.iter().map(|&q| c + r * q).collect(), triangles)
        }),
    ]
    .prop_filter_map("refused", Result::ok)
}

/// Turned, moved, and scaled by 0.4 to 2 along each axis, mirrored or not.
fn any_map() -> impl Strategy<Value = Affine3A> {
    let factor = || prop_oneof![0.4_f32..2.0, -2.0_f32..-0.4, Just(1.0)];
    (direction(), -3.0_f32..3.0, [factor(), factor(), factor()], point_in(1.0)).prop_map(
        |(axis, angle, factors, shift)| {
            Affine3A::from_scale_rotation_translation(
                Vec3::from_array(factors),
                Quat::from_axis_angle(axis.normalize(), angle),
                shift,
            )
        },
    )
}

/// Combinations up to four deep, half-spaces and all.
fn any_volume() -> impl Strategy<Value = Volume> {
    let half_space = (point_in(2.0), direction())
        .prop_filter_map("refused", |(p, n)| Volume::half_space(p, n).ok());
    prop_oneof![6 => any_plain(), 1 => half_space].prop_recursive(4, 12, 2, |inner| {
        let pair = || (inner.clone(), inner.clone());
        prop_oneof![
            pair().prop_map(|(a, b)| a.union(&b)),
            pair().prop_map(|(a, b)| a.intersection(&b)),
            pair().prop_map(|(a, b)| a.difference(&b)),
            (inner.clone(), any_map()).prop_map(|(a, map)| a.transformed(map)),
        ]
        .prop_filter_map("refused", Result::ok)
    })
}

/// A unit sphere of `20 * 4^n` triangles, outwards.
fn icosphere(n: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let g = 0.5 * (1.0 + 5.0_f32.sqrt());
    let mut positions: Vec<Vec3> = [
        [-1.0, g, 0.0],
        [1.0, g, 0.0],
        [-1.0, -g, 0.0],
        [1.0, -g, 0.0],
        [0.0, -1.0, g],
        [0.0, 1.0, g],
        [0.0, -1.0, -g],
        [0.0, 1.0, -g],
        [g, 0.0, -1.0],
        [g, 0.0, 1.0],
        [-g, 0.0, -1.0],
        [-g, 0.0, 1.0],
    ]
    .map(|p| Vec3::from_array(p).normalize())
    .to_vec();
    let mut triangles: Vec<[u32; 3]> = vec![
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    for _ in 0..n {
        triangles = triangles
            .iter()
            .flat_map(|&[a, b, c]| {
                // Each triangle makes its own middles: welding has to join them.
                let mut middle = |i: u32, j: u32| {
                    positions.push(
                        (positions[i.min(j) as usize] + positions[i.max(j) as usize]).normalize(),
                    );
                    positions.len() as u32 - 1
                };
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
            })
            .collect();
    }
    (positions, triangles)
}

/// Points spread evenly over a cube of half-width `half`, none of them special.
fn scattered(n: u64, half: f32) -> impl Iterator<Item = Vec3> {
    let seed = crate::Seed(11);
    (0..n).map(move |i| {
        let along = |axis| half * (2.0 * seed.child(axis).unit(i) - 1.0);
        Vec3::new(along(0), along(1), along(2))
    })
}
