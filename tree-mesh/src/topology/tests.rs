use super::shapes::{ball, both, cube, cylinder, surface, torus};
use super::triangles::{meet, meet_beyond_corner};
use super::*;
use crate::error::MeshError;
use crate::mesh::Surface;
use glam::{DVec3, Vec3};
use std::f64::consts::PI;
use tree_core::seed::uniform;
use tree_core::{CancelFlag, Control, Limits, Seed};

#[test]
fn known_shapes_have_their_counts_volume_and_area() {
    let found = examine(&cube()).unwrap();
    assert_eq!((found.n_points, found.n_edges, found.n_triangles), (8, 18, 12));
    assert!(found.is_closed() && found.euler() == 2 && found.components == 1);
    assert!((found.volume - 8.0).abs() < 1e-12 && (found.area - 24.0).abs() < 1e-12);
    assert!((found.smallest_area - 2.0).abs() < 1e-12);
    assert!((found.smallest_angle - PI / 4.0).abs() < 1e-9);

    let found = examine(&ball(40)).unwrap();
    assert!(found.is_closed() && found.euler() == 2, "{found:?}");
    assert!((found.volume / (4.0 / 3.0 * PI) - 1.0).abs() < 0.01);
    let found = examine(&torus(60, 30, 0.3)).unwrap();
    assert!(found.is_closed() && found.euler() == 0 && found.components == 1, "{found:?}");
    assert!((found.volume / (2.0 * PI * PI * 0.09) - 1.0).abs() < 0.02);
    let found = examine(&cylinder(12, 3)).unwrap();
    assert!(found.is_closed() && found.euler() == 2, "{found:?}");
    let found = examine(&both(&cube(), &ball(8), 5.0 * Vec3::X)).unwrap();
    assert!(found.is_closed() && found.euler() == 4 && found.components == 2);
    let found = examine(&Surface::default()).unwrap();
    assert!(!found.is_closed() && found.euler() == 0 && found.smallest_area.is_infinite());
}

#[test]
fn each_flaw_is_counted_as_what_it_is() {
    let spoil = |change: fn(&mut Surface)| {
        let mut shape = torus(8, 6, 0.3);
        change(&mut shape);
        let found = examine(&shape).unwrap();
        assert!(!found.is_closed(), "{found:?}");
        found
    };
    let found = spoil(|s| s.indices.truncate(s.indices.len() - 3));
    assert_eq!((found.boundary_edges, found.euler()), (3, -1));
    let found = spoil(|s| s.indices.swap(0, 1));
    assert_eq!((found.misoriented_edges, found.boundary_edges), (3, 0));
    let found = spoil(|s| {
        // A fin on the first edge.
        s.positions.push(Vec3::splat(9.0));
        s.normals.push(Vec3::Y);
        s.uvs.push(glam::Vec2::ZERO);
        let (a, b) = (s.indices[0], s.indices[1]);
        s.indices.extend([a, b, s.positions.len() as u32 - 1]);
    });
    assert_eq!((found.non_manifold_edges, found.boundary_edges), (1, 2));
    let found = spoil(|s| {
        s.welds = (0..s.positions.len() as u32).collect();
        s.positions.push(s.positions[0] + 1e-6 * Vec3::X);
        s.normals.push(Vec3::Y);
        s.uvs.push(glam::Vec2::ZERO);
        s.welds.push(0);
    });
    assert_eq!(found.cracks, 1);

    // Two cubes that share a corner: two fans at one point.
    let found = examine(&both(&cube(), &cube(), Vec3::splat(2.0))).unwrap();
    assert_eq!((found.non_manifold_points, found.components), (1, 1));
    assert!(found.non_manifold_edges == 0 && !found.is_closed());
    let mut inward = cube();
    inward.indices.reverse();
    let found = examine(&inward).unwrap();
    assert!(found.is_closed() && found.volume < -7.9);
    let mut collapsed = cube();
    collapsed.indices.extend([0, 0, 1, 5, 5, 5]);
    let found = examine(&collapsed).unwrap();
    assert!(found.is_closed() && found.collapsed_triangles == 2);
    let mut flat = cube();
    flat.positions.extend([Vec3::ZERO, 1e-14 * Vec3::X, Vec3::Y]);
    flat.normals.extend([Vec3::Y; 3]);
    flat.uvs.extend([glam::Vec2::ZERO; 3]);
    flat.indices.extend([24, 25, 26]);
    assert_eq!(examine(&flat).unwrap().flat_triangles, 1);
}

#[test]
fn surfaces_that_are_not_valid_are_refused() {
    let spoil = |change: fn(&mut Surface)| {
        let mut shape = cube();
        change(&mut shape);
        let error = examine(&shape).unwrap_err();
        assert!(weld(&shape).is_err() && self_intersections(&shape, &Control::default()).is_err());
        error
    };
    assert!(matches!(spoil(|s| s.indices[3] = 99), MeshError::Dangling { found: 99, .. }));
    assert!(matches!(
        spoil(|s| s.positions[3].x = f32::NAN),
        MeshError::NotFinite { index: 3, .. }
    ));
    assert!(matches!(spoil(|s| s.welds = vec![0; 3]), MeshError::Length { field: "welds", .. }));
    let error = spoil(|s| s.welds = vec![1; 24]);
    assert_eq!(error.to_string(), "the surface: welds[0] is 1, must be 0 itself or less");
    assert!(matches!(
        spoil(|s| s.indices.truncate(4)),
        MeshError::PartialTriangle { found: 4, .. }
    ));
}

#[test]
fn welding_leaves_one_vertex_a_point() {
    let mut shape = cube();
    shape.indices.extend([0, 0, 1]);
    shape.positions[3] += 0.0 * Vec3::NEG_Y;
    let welded = weld(&shape).unwrap();
    assert_eq!((welded.positions.len(), welded.n_triangles()), (8, 12));
    let out = |(p, n): (&Vec3, &Vec3)| n.distance(p.normalize()) < 1e-6;
    assert!(welded.positions.iter().zip(&welded.normals).all(out));
    assert_eq!(examine(&welded).unwrap().volume, examine(&cube()).unwrap().volume);
}

/// Welds as a builder would write them.
fn with_welds(mut shape: Surface) -> Surface {
    let points = welded(&shape).unwrap();
    shape.welds = points.of_vertex.iter().map(|&p| points.first[p as usize]).collect();
    shape
}

#[test]
fn welds_and_places_tell_the_same() {
    for shape in [cube(), ball(7), cylinder(5, 2)] {
        let by_place = examine(&shape).unwrap();
        assert_eq!(by_place, examine(&with_welds(shape)).unwrap());
    }
}

fn random_triangle(rng: &mut tree_core::Rng, on_grid: bool) -> [DVec3; 3] {
    let mut number = |_| {
        let x = uniform(rng, -1.0, 1.0);
        f64::from(if on_grid { (2.0 * x).round() } else { x })
    };
    [(); 3].map(|()| DVec3::from_array([0, 1, 2].map(&mut number)))
}

/// Whether two triangles meet, by the distances of many points: slow, and wrong only near contact.
fn meet_by_separation(a: [DVec3; 3], b: [DVec3; 3]) -> Option<bool> {
    // Separating axes: normals, crosses of edges, in-plane normals. Gap > 0 on any: apart.
    let edges = |t: [DVec3; 3]| [t[1] - t[0], t[2] - t[1], t[0] - t[2]];
    let (ea, eb) = (edges(a), edges(b));
    let (na, nb) = (ea[0].cross(ea[1]), eb[0].cross(eb[1]));
    let mut axes = vec![na, nb];
    axes.extend(ea.iter().flat_map(|&u| eb.map(|v| u.cross(v))));
    axes.extend(ea.map(|u| u.cross(na)));
    axes.extend(eb.map(|v| v.cross(nb)));
    let mut gap = f64::NEG_INFINITY;
    for axis in axes.into_iter().filter_map(DVec3::try_normalize) {
        let span = |t: [DVec3; 3]| {
            let d = t.map(|p| p.dot(axis));
            (d[0].min(d[1]).min(d[2]), d[0].max(d[1]).max(d[2]))
        };
        let ((a0, a1), (b0, b1)) = (span(a), span(b));
        gap = gap.max(b0 - a1).max(a0 - b1);
    }
    (gap.abs() > 1e-9).then_some(gap < 0.0)
}

#[test]
fn triangles_meet_where_no_plane_separates_them() {
    let mut rng = Seed(11).rng();
    let mut n = [0; 2];
    for _ in 0..20_000 {
        let (a, b) = (random_triangle(&mut rng, false), random_triangle(&mut rng, false));
        if let Some(expected) = meet_by_separation(a, b) {
            n[usize::from(expected)] += 1;
            assert_eq!(meet(a, b), expected, "{a:?} {b:?}");
        }
    }
    assert!(n[0] > 2000 && n[1] > 2000, "{n:?}");
}

#[test]
fn contact_counts_and_the_order_does_not_matter() {
    let mut rng = Seed(12).rng();
    for _ in 0..20_000 {
        // On a coarse grid touching, coplanar and flat triangles are common.
        let (a, b) = (random_triangle(&mut rng, true), random_triangle(&mut rng, true));
        let flat = |t: [DVec3; 3]| (t[1] - t[0]).cross(t[2] - t[0]) == DVec3::ZERO;
        if flat(a) && flat(b) {
            continue;
        }
        let met = meet(a, b);
        assert_eq!(met, meet(b, a), "{a:?} {b:?}");
        if flat(a) || flat(b) {
            continue;
        }
        assert_eq!(met, meet([a[1], a[2], a[0]], [b[0], b[2], b[1]]), "{a:?} {b:?}");
        if let Some(expected) = meet_by_separation(a, b) {
            assert_eq!(met, expected, "{a:?} {b:?}");
        }
        if a.iter().any(|p| b.contains(p)) {
            assert!(met, "a shared corner is contact");
        }
    }
}

#[test]
fn triangles_at_a_corner_meet_again_only_when_one_stabs_the_other() {
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    let floor = [DVec3::ZERO, at(4.0, -2.0, 0.0), at(4.0, 2.0, 0.0)];
    let stab = [DVec3::ZERO, at(2.0, 0.0, -1.0), at(2.0, 0.0, 1.0)];
    let beside = [DVec3::ZERO, at(-2.0, 0.0, -1.0), at(-2.0, 0.0, 1.0)];
    let above = [DVec3::ZERO, at(2.0, 0.0, 1.0), at(2.0, 1.0, 1.0)];
    let flat_over = [DVec3::ZERO, at(2.0, 0.0, 0.0), at(2.0, 5.0, 0.0)];
    let flat_beside = [DVec3::ZERO, at(-2.0, 0.0, 0.0), at(-2.0, 5.0, 0.0)];
    for (other, expected) in
        [(stab, true), (beside, false), (above, false), (flat_over, true), (flat_beside, false)]
    {
        assert_eq!(meet_beyond_corner(floor, other), expected, "{other:?}");
        assert_eq!(meet_beyond_corner(other, floor), expected, "{other:?}");
    }
}

#[test]
fn crossing_pairs_are_those_of_testing_all() {
    let control = Control::default();
    for shape in [ball(9), torus(20, 9, 0.4), cylinder(8, 4), cube()] {
        let found = self_intersections(&shape, &control).unwrap();
        assert_eq!(found, Crossings::default(), "a shape that does not cross itself");
    }
    let crossed = both(&ball(9), &torus(20, 9, 0.4), Vec3::new(0.3, 0.1, 0.2));
    let found = self_intersections(&crossed, &control).unwrap();
    let points = welded(&crossed).unwrap();
    let triangles = points.triangles(&crossed);
    let place = |p: u32| crossed.positions[points.first[p as usize] as usize].as_dvec3();
    let mut expected = Vec::new();
    for a in 0..triangles.len() {
        for b in a + 1..triangles.len() {
            let shared = triangles[a].iter().any(|p| triangles[b].contains(p));
            if !shared && meet(triangles[a].map(place), triangles[b].map(place)) {
                expected.push([a as u32, b as u32]);
            }
        }
    }
    assert!(expected.len() > 50);
    assert_eq!(found.pairs, expected);
    assert!(found.n_triangles > 50 && found.n_triangles <= 2 * expected.len() as u64);
}

#[test]
fn too_many_pairs_are_refused_and_the_work_can_be_cancelled() {
    // All triangles at one place cross each other.
    let mut shape = surface(Vec::new(), Vec::new());
    for i in 0..300_u32 {
        shape.positions.extend(
            [0.0, 1.0, 2.0].map(|x| {
                Vec3::new(x, if x == 1.0 { 1.0 } else { 0.0 }, 1e-3 * i as f32 * (x - 1.0))
            }),
        );
        shape.indices.extend([0, 1, 2].map(|k| 3 * i + k));
    }
    shape.normals = vec![Vec3::Y; 900];
    shape.uvs = vec![glam::Vec2::ZERO; 900];
    // Each its own point, so that none are neighbours.
    shape.welds = (0..900).collect();
    let all = self_intersections(&shape, &Control::default()).unwrap();
    assert_eq!((all.pairs.len(), all.n_triangles), (300 * 299 / 2, 300));
    let limits = Limits { triangles: 1000, ..Default::default() };
    let error = self_intersections(&shape, &Control::default().with_limits(limits)).unwrap_err();
    assert!(matches!(error, MeshError::Limit(_)), "{error}");
    let stop = CancelFlag::default();
    stop.cancel();
    let error = self_intersections(&shape, &Control::default().with_cancel(stop)).unwrap_err();
    assert!(matches!(error, MeshError::Cancelled(_)));
}
