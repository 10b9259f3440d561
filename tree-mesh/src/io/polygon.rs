//! Polygons to triangles.
//!
//! Convex ones become fans. Others are cut ear by ear (Meisters 1975) in the plane of their Newell
//! normal; what has no ear left (it crosses itself, or has no area) becomes a fan.
//!
//! Cost: O(corners) for convex ones, O(corners²) per cut otherwise, O(corners³) at worst; polygons with
//! more than [`CORNERS_MAX`] corners are not cut but fanned.

use glam::{Vec2, Vec3};

/// Most corners of a polygon that is cut ear by ear.
const CORNERS_MAX: usize = 256;

/// Calls `triangle` with places in `corners`, counter-clockwise as the polygon is.
pub(super) fn triangulate(corners: &[Vec3], mut triangle: impl FnMut([usize; 3])) {
    let n = corners.len();
    if n < 3 {
        return;
    }
    if n == 3 {
        return triangle([0, 1, 2]);
    }
    let points = flatten(corners);
    if n > CORNERS_MAX || is_convex(&points) {
        return fan(n, triangle);
    }
    let mut left: Vec<usize> = (0..n).collect();
    while left.len() > 3 {
        let m = left.len();
        let around = |i: usize| [left[(i + m - 1) % m], left[i], left[(i + 1) % m]];
        let ear = (0..m).find(|&i| is_ear(&points, &left, around(i)));
        // Without an ear the polygon is no simple one; the first corner is as good as any.
        let ear = ear.unwrap_or(0);
        triangle(around(ear));
        left.remove(ear);
    }
    if let [a, b, c] = left[..] {
        triangle([a, b, c]);
    }
}

fn fan(n: usize, mut triangle: impl FnMut([usize; 3])) {
    for i in 1..n - 1 {
        triangle([0, i, i + 1]);
    }
}

/// The polygon in its own plane, where it turns counter-clockwise.
fn flatten(corners: &[Vec3]) -> Vec<Vec2> {
    let origin = corners.first().copied().unwrap_or_default();
    let next = corners.iter().cycle().skip(1);
    let normal: Vec3 =
        corners.iter().zip(next).map(|(&a, &b)| (a - origin).cross(b - origin)).sum();
    let size = normal.abs();
    // Drop the axis the polygon faces most; swap the others where that turns it over.
    let pick = |v: Vec3| {
        if size.x >= size.y && size.x >= size.z {
            if normal.x >= 0.0 { Vec2::new(v.y, v.z) } else { Vec2::new(v.z, v.y) }
        } else if size.y >= size.z {
            if normal.y >= 0.0 { Vec2::new(v.z, v.x) } else { Vec2::new(v.x, v.z) }
        } else if normal.z >= 0.0 {
            Vec2::new(v.x, v.y)
        } else {
            Vec2::new(v.y, v.x)
        }
    };
    corners.iter().map(|&corner| pick(corner - origin)).collect()
}

/// Twice the area of the triangle, positive when counter-clockwise.
fn turn(a: Vec2, b: Vec2, c: Vec2) -> f32 {
    (b - a).perp_dot(c - b)
}

fn is_convex(points: &[Vec2]) -> bool {
    let n = points.len();
    (0..n).all(|i| turn(points[i], points[(i + 1) % n], points[(i + 2) % n]) >= 0.0)
}

/// Whether the triangle lies inside the polygon and no other corner in it.
fn is_ear(points: &[Vec2], left: &[usize], [a, b, c]: [usize; 3]) -> bool {
    let [pa, pb, pc] = [points[a], points[b], points[c]];
    if turn(pa, pb, pc) <= 0.0 {
        return false;
    }
    left.iter().filter(|&&i| i != a && i != b && i != c).all(|&i| {
        let p = points[i];
        // Corners that only touch one of the triangle's do not count: seams of cut-in holes.
        p == pa || p == pb || p == pc || {
            let inside = turn(pa, pb, p) >= 0.0 && turn(pb, pc, p) >= 0.0 && turn(pc, pa, p) >= 0.0;
            !inside
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn areas(corners: &[Vec3]) -> Vec<Vec3> {
        let mut areas = Vec::new();
        triangulate(corners, |[a, b, c]| {
            areas.push(0.5 * (corners[b] - corners[a]).cross(corners[c] - corners[a]));
        });
        areas
    }

    #[test]
    fn a_concave_polygon_is_covered_once_in_every_direction() {
        // An arrow head: the fan from corner 0 would reach outside.
        let arrow = [(0.0, 0.0), (2.0, 1.0), (0.0, 2.0), (0.8, 1.0)];
        for start in 0..4 {
            for turn in [Vec3::Z, Vec3::X, Vec3::Y, -Vec3::X, -Vec3::Y] {
                let rotation = glam::Quat::from_rotation_arc(Vec3::Z, turn);
                let corners: Vec<Vec3> = (0..4)
                    .map(|i| arrow[(i + start) % 4])
                    .map(|(x, y)| rotation * Vec3::new(x, y, 0.0))
                    .collect();
                let areas = areas(&corners);
                assert_eq!(areas.len(), 2);
                for area in &areas {
                    assert!(area.dot(turn) > 0.1, "{start} {turn}: {area}");
                }
                let sum: Vec3 = areas.iter().sum();
                assert!((sum - turn * 1.2).length() < 1e-5, "{sum}");
            }
        }
    }

    #[test]
    fn a_comb_is_cut_ear_by_ear() {
        let teeth = 9;
        let mut corners = vec![Vec3::new(0.0, 3.0, 0.0), Vec3::ZERO];
        for i in 0..teeth {
            let x = i as f32;
            corners.push(Vec3::new(x + 0.3, 2.0, 0.0));
            corners.push(Vec3::new(x + 1.0, 0.0, 0.0));
        }
        corners.push(Vec3::new(teeth as f32, 3.0, 0.0));
        let areas = areas(&corners);
        assert_eq!(areas.len(), corners.len() - 2);
        assert!(areas.iter().all(|area| area.z > 0.0), "{areas:?}");
        let sum: f32 = areas.iter().map(|area| area.z).sum();
        assert!((sum - (27.0 - 9.0)).abs() < 1e-4, "{sum}");
    }

    proptest! {
        #[test]
        fn any_polygon_gives_two_triangles_fewer_than_corners(
            corners in prop::collection::vec(prop::array::uniform3(-1e3_f32..1e3), 0..40),
        ) {
            let corners: Vec<Vec3> = corners.into_iter().map(Vec3::from).collect();
            let mut seen = vec![0; corners.len()];
            let mut n = 0;
            triangulate(&corners, |places| {
                n += 1;
                for place in places {
                    seen[place] += 1;
                }
            });
            prop_assert_eq!(n, corners.len().saturating_sub(2));
            prop_assert!(corners.len() < 3 || seen.iter().all(|&times| times > 0));
        }
    }
}
