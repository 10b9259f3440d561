//! Whether two triangles have a point in common.
//!
//! By signs of determinants, as Guigue & Devillers, "Fast and Robust Triangle-Triangle Overlap Test
//! Using Orientation Predicates", Journal of Graphics Tools 8(1), 2003: planes first, then edges
//! against triangles. Coordinates are f32, so their differences are exact in f64; a determinant that
//! is smaller than its own rounding error counts as 0, that is as contact. So triangles that touch are
//! found, none that cross is missed, and the answer does not depend on the order. Only two triangles
//! that both have no area may be missed, or found without cause.

use glam::{DVec2, DVec3};
use std::cmp::Ordering;

/// Rounding error of a 3×3 determinant of exact entries, as a share of the sum of its terms'
/// magnitudes: 5 operations of 2⁻⁵³ each and some room.
const ROUNDING: f64 = 1e-15;

pub(super) type Triangle = [DVec3; 3];

fn sign(value: f64, magnitude: f64) -> i8 {
    if value.abs() <= ROUNDING * magnitude {
        0
    } else if value > 0.0 {
        1
    } else {
        -1
    }
}

/// On which side of the plane of `a`, `b`, `c` the point `d` lies: 1 where a, b, c turn
/// counter-clockwise seen from it.
fn side([a, b, c]: Triangle, d: DVec3) -> i8 {
    let (u, v, w) = (b - a, c - a, d - a);
    let products = |p: f64, q: f64| (p - q, p.abs() + q.abs());
    let (x, x_size) = products(u.y * v.z, u.z * v.y);
    let (y, y_size) = products(u.z * v.x, u.x * v.z);
    let (z, z_size) = products(u.x * v.y, u.y * v.x);
    let magnitude = x_size * w.x.abs() + y_size * w.y.abs() + z_size * w.z.abs();
    sign(x * w.x + y * w.y + z * w.z, magnitude)
}

fn turn([a, b, c]: [DVec2; 3]) -> i8 {
    let (u, v) = (b - a, c - a);
    let (p, q) = (u.x * v.y, u.y * v.x);
    sign(p - q, p.abs() + q.abs())
}

/// Whether two triangles have a point in common.
pub(super) fn meet(a: Triangle, b: Triangle) -> bool {
    let sides_of_a = a.map(|corner| side(b, corner));
    if apart(sides_of_a) {
        return false;
    }
    let sides_of_b = b.map(|corner| side(a, corner));
    if apart(sides_of_b) {
        return false;
    }
    // A triangle without area has no plane: then only its own edges are asked.
    match (sides_of_a == [0; 3], sides_of_b == [0; 3]) {
        (true, true) => meet_in_plane(a, b),
        (true, false) => (0..3).any(|k| edge_meets(b, sides_of_b, k, a)),
        (false, true) => (0..3).any(|k| edge_meets(a, sides_of_a, k, b)),
        (false, false) => {
            (0..3).any(|k| edge_meets(a, sides_of_a, k, b) || edge_meets(b, sides_of_b, k, a))
        }
    }
}

/// Whether two triangles that share their first corners have another point in common. Those that lie
/// in one plane and overlap count too.
pub(super) fn meet_beyond_corner(a: Triangle, b: Triangle) -> bool {
    // From the shared corner they part at once, or share a line that ends on the far edge of one.
    let sides_of_a = a.map(|corner| side(b, corner));
    let sides_of_b = b.map(|corner| side(a, corner));
    if sides_of_a[1] * sides_of_a[2] > 0 || sides_of_b[1] * sides_of_b[2] > 0 {
        return false;
    }
    match (sides_of_a == [0; 3], sides_of_b == [0; 3]) {
        (true, true) => far_edge_meets_in_plane(a, b) || far_edge_meets_in_plane(b, a),
        (true, false) => edge_meets(b, sides_of_b, 1, a),
        (false, true) => edge_meets(a, sides_of_a, 1, b),
        (false, false) => edge_meets(a, sides_of_a, 1, b) || edge_meets(b, sides_of_b, 1, a),
    }
}

fn apart([a, b, c]: [i8; 3]) -> bool {
    a != 0 && a == b && b == c
}

/// Whether edge k of `a`, whose corners lie on these sides of the plane of `b`, meets `b`.
fn edge_meets(a: Triangle, sides: [i8; 3], k: usize, b: Triangle) -> bool {
    let (from, to) = (k, (k + 1) % 3);
    if sides[from] * sides[to] > 0 {
        return false;
    }
    let (p, q) = (a[from], a[to]);
    if sides[from] == 0 && sides[to] == 0 {
        let drop = Drop::along(b);
        return segment_meets_in_plane([p, q].map(|x| drop.flat(x)), b.map(|x| drop.flat(x)));
    }
    // The line p q passes the edges of b all on the same side.
    let turns = [0, 1, 2].map(|i| side([p, q, b[i]], b[(i + 1) % 3]));
    !(turns.contains(&1) && turns.contains(&-1))
}

/// Leaves out the coordinate in which a triangle is seen best.
#[derive(Clone, Copy)]
struct Drop(usize);

impl Drop {
    fn along([a, b, c]: Triangle) -> Self {
        let normal = (b - a).cross(c - a).abs();
        let larger = |i: usize, j: usize| normal[i].total_cmp(&normal[j]) != Ordering::Less;
        Self(if larger(0, 1) && larger(0, 2) {
            0
        } else if larger(1, 2) {
            1
        } else {
            2
        })
    }

    /// For two triangles of one plane, of which one may have no area.
    fn for_both(a: Triangle, b: Triangle) -> Self {
        let size = |[a, b, c]: Triangle| (b - a).cross(c - a).length_squared();
        Self::along(if size(a) >= size(b) { a } else { b })
    }

    fn flat(self, p: DVec3) -> DVec2 {
        match self.0 {
            0 => DVec2::new(p.y, p.z),
            1 => DVec2::new(p.z, p.x),
            _ => DVec2::new(p.x, p.y),
        }
    }
}

fn meet_in_plane(a: Triangle, b: Triangle) -> bool {
    let drop = Drop::for_both(a, b);
    let (a, b) = (a.map(|p| drop.flat(p)), b.map(|p| drop.flat(p)));
    (0..3).any(|k| segment_meets_in_plane([a[k], a[(k + 1) % 3]], b)) || inside(b[0], a)
}

/// As [`segment_meets_in_plane`] for the edge of `a` opposite the corner it shares with `b`.
fn far_edge_meets_in_plane(a: Triangle, b: Triangle) -> bool {
    let drop = Drop::for_both(a, b);
    segment_meets_in_plane([a[1], a[2]].map(|p| drop.flat(p)), b.map(|p| drop.flat(p)))
}

fn segment_meets_in_plane([p, q]: [DVec2; 2], triangle: [DVec2; 3]) -> bool {
    inside(p, triangle)
        || (0..3).any(|k| segments_meet([p, q], [triangle[k], triangle[(k + 1) % 3]]))
}

fn inside(p: DVec2, t: [DVec2; 3]) -> bool {
    let turns = [0, 1, 2].map(|k| turn([t[k], t[(k + 1) % 3], p]));
    !(turns.contains(&1) && turns.contains(&-1)) && turns != [0; 3]
}

fn segments_meet([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    let (c_side, d_side) = (turn([a, b, c]), turn([a, b, d]));
    let (a_side, b_side) = (turn([c, d, a]), turn([c, d, b]));
    if [a_side, b_side, c_side, d_side] == [0; 4] {
        // On one line: do their boxes overlap?
        let (low, high) = (a.min(b), a.max(b));
        return c.min(d).cmple(high).all() && low.cmple(c.max(d)).all();
    }
    c_side * d_side <= 0 && a_side * b_side <= 0
}
