//! Leaf clusters: where the foliage is, in pieces of the crown.
//!
//! The crown is cut into pieces of limited extent along its branches, from the root outwards; what leaves (or, without
//! leaves, tips) stand in a piece make one cluster: a ball with the spread of an even ball of leaves.
//! Each tip of the main branches owns an equal part of its cluster's volume.

use glam::Vec3;
use tree_core::{Skeleton, Tree};

use super::main_branches::Main;

/// The pieces and what the tips own, in the order of the main nodes.
pub(super) struct Lobes {
    /// Piece of each main node.
    pub piece: Vec<u32>,
    /// Cubed radius that each tip of the main branches owns; 0 for others.
    pub volume: Vec<f32>,
    /// Number of pieces.
    pub n_pieces: u32,
}

/// Cuts the main branches into pieces no longer than `extent`. O(n).
fn pieces(skeleton: &Skeleton, extent: f32) -> (Vec<u32>, u32) {
    let lengths = skeleton.segment_lengths();
    let to_tip = skeleton.distances_to_tip();
    let mut piece = vec![0_u32; skeleton.len()];
    let mut way = vec![0.0_f32; skeleton.len()];
    let mut n_pieces = 1;
    for (parent, node) in skeleton.segments() {
        let (p, s) = (parent as usize, node as usize);
        way[s] = way[p] + lengths[s];
        // A new piece begins where this one is full, unless what is left is hardly worth one.
        if way[s] > extent && to_tip[s] + lengths[s] > 0.25 * extent {
            piece[s] = n_pieces;
            n_pieces += 1;
            way[s] = 0.0;
        } else {
            piece[s] = piece[p];
        }
    }
    (piece, n_pieces)
}

impl Lobes {
    /// `main` of `tree`, and the same as a skeleton of its own. Clusters are at least `least` in radius.
    pub(super) fn new(
        tree: &Tree,
        main: &Main,
        branches: &Skeleton,
        extent: f32,
        least: f32,
    ) -> Self {
        let (piece, n_pieces) = pieces(branches, extent);
        let children = branches.children();
        let n = n_pieces as usize;
        let mut heaps = vec![Heap::default(); n];
        if tree.foliage().is_empty() {
            for (node, &position) in tree.skeleton().positions().iter().enumerate().skip(1) {
                heaps[piece[main.of[node] as usize] as usize].add(position);
            }
        } else {
            for leaf in tree.foliage().iter() {
                heaps[piece[main.of[leaf.node as usize] as usize] as usize].add(leaf.position);
            }
        }
        let mut tips = vec![0_u32; n];
        for node in 0..branches.len() {
            if children.is_tip(node as u32) {
                tips[piece[node] as usize] += 1;
            }
        }
        let volume = (0..branches.len())
            .map(|node| {
                let of = piece[node] as usize;
                if !children.is_tip(node as u32) {
                    return 0.0;
                }
                let radius = heaps[of].radius().max(least);
                radius * radius * radius / tips[of] as f32
            })
            .collect();
        Self { piece, volume, n_pieces }
    }
}

/// Points, summed up.
#[derive(Clone, Copy, Default)]
struct Heap {
    n: u32,
    sum: glam::DVec3,
    squares: f64,
}

impl Heap {
    fn add(&mut self, point: Vec3) {
        let p = point.as_dvec3();
        self.n += 1;
        self.sum += p;
        self.squares += p.length_squared();
    }

    /// Radius of the even ball that is spread as far as the points: its mean squared distance from the middle is 3/5 of the
    /// squared radius.
    fn radius(&self) -> f32 {
        if self.n == 0 {
            return 0.0;
        }
        let n = f64::from(self.n);
        let spread = self.squares / n - (self.sum / n).length_squared();
        (spread.max(0.0) * 5.0 / 3.0).sqrt() as f32
    }
}
