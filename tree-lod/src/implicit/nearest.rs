//! Which triangle is nearest to a point: a binary tree of boxes.
//!
//! Triangles are halved at the median of their middles along the longest side of the box around them,
//! down to a few, and put in that order. Each node has half of the triangles of the one above, so the
//! tree is an array of boxes. A search goes into the nearer half first, and into the other one only if
//! its box is nearer than what was found, by more than [`ENOUGH`]: deep inside, many places are about as
//! near, and telling them apart would cost several times as much as finding one of them.

use glam::Vec3;
use tree_core::Aabb;

/// Triangles at a leaf, at most.
const GROUP: usize = 4;
/// Squared distance of a box, times this, that is not worth a visit: what is found is at most 1 % farther
/// away than the nearest place.
const ENOUGH: f32 = 1.02;
/// Triangles that are worth a thread of their own.
const PARALLEL: usize = 4096;

/// Boxes: node 1 is the top, node i has the children 2i and 2i + 1.
#[derive(Clone, Debug)]
pub(super) struct Nearest {
    boxes: Vec<Aabb>,
}

struct Item {
    middle: Vec3,
    triangle: [u32; 3],
}

impl Nearest {
    /// Sorts the triangles and makes the tree.
    pub(super) fn new(positions: &[Vec3], triangles: &mut [[u32; 3]]) -> Self {
        let corners = |t: &[u32; 3]| t.map(|v| positions[v as usize]);
        let middle = |[a, b, c]: [Vec3; 3]| (a + b + c) / 3.0;
        let mut items: Vec<Item> = triangles
            .iter()
            .map(|&triangle| Item { middle: middle(corners(&triangle)), triangle })
            .collect();
        let n_leaves = triangles.len().div_ceil(GROUP).max(1).next_power_of_two();
        halve(&mut items, n_leaves);
        for (triangle, item) in triangles.iter_mut().zip(&items) {
            *triangle = item.triangle;
        }
        let mut boxes = vec![Aabb::EMPTY; 2 * n_leaves];
        leaves(1, triangles, n_leaves, &mut |node, few| {
            boxes[node] =
                Aabb::of_points(few.iter().map(corners).collect::<Vec<_>>().as_flattened());
        });
        for node in (1..n_leaves).rev() {
            boxes[node] = boxes[2 * node].union(boxes[2 * node + 1]);
        }
        Self { boxes }
    }

    /// The row of the nearest triangle.
    pub(super) fn find(
        &self,
        positions: &[Vec3],
        triangles: &[[u32; 3]],
        point: Vec3,
    ) -> Option<usize> {
        if !point.is_finite() {
            return None;
        }
        let n_leaves = self.boxes.len() / 2;
        let (mut best, mut found) = (f32::INFINITY, None);
        let mut stack = [(0, 0, 0, 0.0); 64];
        let mut depth = 1;
        stack[0] = (1_usize, 0, triangles.len(), 0.0_f32);
        while depth > 0 {
            depth -= 1;
            let (node, begin, end, square) = stack[depth];
            if ENOUGH * square >= best {
                continue;
            }
            if node >= n_leaves {
                for (row, triangle) in triangles[begin..end].iter().enumerate() {
                    let corners = triangle.map(|v| positions[v as usize]);
                    let [a, b, c] = closest(corners, point);
                    let place = a * corners[0] + b * corners[1] + c * corners[2];
                    let square = place.distance_squared(point);
                    if square < best {
                        (best, found) = (square, Some(begin + row));
                    }
                }
                continue;
            }
            let middle = begin + (end - begin) / 2;
            let left = (2 * node, begin, middle, self.square(2 * node, point));
            let right = (2 * node + 1, middle, end, self.square(2 * node + 1, point));
            // At most one entry stays behind per level, and there are fewer than 60 levels.
            (stack[depth], stack[depth + 1]) =
                if left.3 <= right.3 { (right, left) } else { (left, right) };
            depth += 2;
        }
        found
    }

    /// Squared distance to a box; infinite for an empty one.
    fn square(&self, node: usize, point: Vec3) -> f32 {
        let Aabb { min, max } = self.boxes[node];
        (min - point).max(point - max).max(Vec3::ZERO).length_squared()
    }
}

/// Sorts items into `n_leaves` groups, a power of two.
fn halve(items: &mut [Item], n_leaves: usize) {
    if n_leaves < 2 || items.len() < 2 {
        return;
    }
    let (low, high) = items
        .iter()
        .fold((Vec3::MAX, Vec3::MIN), |(low, high), i| (low.min(i.middle), high.max(i.middle)));
    let size = high - low;
    let axis = (0..3).fold(0, |best, axis| if size[axis] > size[best] { axis } else { best });
    let half = items.len() / 2;
    items.select_nth_unstable_by(half, |a, b| {
        a.middle[axis].total_cmp(&b.middle[axis]).then(a.triangle.cmp(&b.triangle))
    });
    let (left, right) = items.split_at_mut(half);
    if left.len() < PARALLEL {
        halve(left, n_leaves / 2);
        halve(right, n_leaves / 2);
    } else {
        rayon::join(|| halve(left, n_leaves / 2), || halve(right, n_leaves / 2));
    }
}

/// Visits the groups that [`halve`] made.
fn leaves<T>(node: usize, items: &[T], n_leaves: usize, visit: &mut impl FnMut(usize, &[T])) {
    if n_leaves < 2 {
        return visit(node, items);
    }
    let (left, right) = items.split_at(items.len() / 2);
    leaves(2 * node, left, n_leaves / 2, visit);
    leaves(2 * node + 1, right, n_leaves / 2, visit);
}

/// Weights of the corners at the place of a triangle that is nearest to a point.
///
/// Source: Ericson, "Real-Time Collision Detection", 2005, §5.1.5.
pub(super) fn closest([a, b, c]: [Vec3; 3], point: Vec3) -> [f32; 3] {
    let (ab, ac, ap) = (b - a, c - a, point - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let bp = point - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return [0.0, 1.0, 0.0];
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let v = d1 / (d1 - d3);
        return [1.0 - v, v, 0.0];
    }
    let cp = point - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return [0.0, 0.0, 1.0];
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let w = d2 / (d2 - d6);
        return [1.0 - w, 0.0, w];
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return [0.0, 1.0 - w, w];
    }
    let scale = 1.0 / (va + vb + vc);
    [1.0 - (vb + vc) * scale, vb * scale, vc * scale]
}
