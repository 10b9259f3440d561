//! Nearest triangle through a binary tree of boxes, halved at the median of the longest axis.

use super::Corners;
use crate::bounds::Aabb;
use crate::volume::math::{Box64, triangle_distance_squared};
use glam::{DVec3, Vec3};

/// Triangles in a leaf: fewer cost more boxes than they save triangles.
const LEAF: usize = 4;

/// Open branches at once: one per level, and halving at the median makes log2 of
/// [`MAX_TRIANGLES`](super::MAX_TRIANGLES) levels, that is 27, and one for good measure.
const MAX_OPEN: usize = 32;

/// A box with either children (the next node, and `other`) or triangles.
#[derive(Debug)]
struct Node {
    bounds: Aabb,
    /// Second child, or first triangle of a leaf.
    other: u32,
    /// 0 for an inner node.
    n_triangles: u32,
}

/// Nodes in the order of a walk that goes to the first child first.
#[derive(Debug)]
pub(super) struct Nearest {
    nodes: Vec<Node>,
}

impl Nearest {
    /// Brings the triangles into the order of the leaves. O(n log n).
    pub(super) fn new(triangles: &mut [Corners]) -> Self {
        let mut nodes = Vec::with_capacity(triangles.len());
        build(&mut nodes, triangles, 0);
        Self { nodes }
    }

    /// Squared distance to the nearest triangle.
    pub(super) fn distance_squared(&self, triangles: &[Corners], p: DVec3) -> f64 {
        let mut best = f64::INFINITY;
        let mut open = [(0_u32, 0.0_f64); MAX_OPEN];
        let mut n_open = 1;
        while n_open > 0 {
            n_open -= 1;
            let (mut at, mut bound) = open[n_open];
            while bound < best {
                let node = &self.nodes[at as usize];
                if node.n_triangles > 0 {
                    let first = node.other as usize;
                    for corners in &triangles[first..first + node.n_triangles as usize] {
                        let square = triangle_distance_squared(p, corners.map(|c| c.as_dvec3()));
                        best = best.min(square);
                    }
                    break;
                }
                let (mut near, mut far) = (at + 1, node.other);
                let mut near_bound = self.bound(near, p);
                let mut far_bound = self.bound(far, p);
                if far_bound < near_bound {
                    std::mem::swap(&mut near, &mut far);
                    std::mem::swap(&mut near_bound, &mut far_bound);
                }
                open[n_open] = (far, far_bound);
                n_open += 1;
                (at, bound) = (near, near_bound);
            }
        }
        best
    }

    fn bound(&self, node: u32, p: DVec3) -> f64 {
        Box64::new(self.nodes[node as usize].bounds).distance_squared(p)
    }
}

/// Recursion is as deep as the tree, at most 27.
fn build(nodes: &mut Vec<Node>, triangles: &mut [Corners], first: usize) {
    let bounds = Aabb::of_points(triangles.as_flattened());
    let this = nodes.len();
    nodes.push(Node { bounds, other: first as u32, n_triangles: triangles.len() as u32 });
    if triangles.len() <= LEAF {
        return;
    }
    let centers =
        triangles.iter().fold(Aabb::EMPTY, |aabb, corners| aabb.including(center(corners)));
    let axis = longest(centers.size());
    let half = triangles.len() / 2;
    triangles.select_nth_unstable_by(half, |a, b| center(a)[axis].total_cmp(&center(b)[axis]));
    let (left, right) = triangles.split_at_mut(half);
    build(nodes, left, first);
    nodes[this].other = nodes.len() as u32;
    nodes[this].n_triangles = 0;
    build(nodes, right, first + half);
}

fn center([a, b, c]: &Corners) -> Vec3 {
    // Shares first: the plain sum of three may overflow.
    *a / 3.0 + *b / 3.0 + *c / 3.0
}

fn longest(size: Vec3) -> usize {
    if size.x >= size.y && size.x >= size.z {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    }
}
