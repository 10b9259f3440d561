//! Leaf clusters: where the foliage is, in pieces of the crown.
//!
//! The crown is cut into pieces of limited extent along its branches, from the root outwards. Many branches cross each cut, so
//! pieces whose middles are less than half an extent apart are put together. What leaves (or, without leaves, nodes) stand in a
//! piece make one cluster: a ball with the spread of an even ball of leaves. Each tip of the main branches owns an equal part of
//! its cluster's volume.

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
        let (mut piece, n_pieces) = pieces(branches, extent);
        let children = branches.children();
        let mut heaps = vec![Heap::default(); n_pieces as usize];
        if tree.foliage().is_empty() {
            for (node, &position) in tree.skeleton().positions().iter().enumerate().skip(1) {
                heaps[piece[main.of[node] as usize] as usize].add(position);
            }
        } else {
            for leaf in tree.foliage().iter() {
                heaps[piece[main.of[leaf.node as usize] as usize] as usize].add(leaf.position);
            }
        }
        let (join, heaps) = joined(&heaps, &middles(branches, &piece, n_pieces), JOINED * extent);
        for piece in &mut piece {
            *piece = join[*piece as usize];
        }
        let n_pieces = heaps.len() as u32;
        let mut tips = vec![0_u32; heaps.len()];
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

/// Share of the extent below which the middles of two pieces are too near each other for two clusters.
const JOINED: f32 = 0.9;

/// Mean of the main nodes of each piece.
fn middles(branches: &Skeleton, piece: &[u32], n_pieces: u32) -> Vec<Vec3> {
    let mut heaps = vec![Heap::default(); n_pieces as usize];
    for (&position, &piece) in branches.positions().iter().zip(piece) {
        heaps[piece as usize].add(position);
    }
    heaps.iter().map(Heap::mean).collect()
}

/// Puts pieces together whose middles are less than `near` apart: the fullest piece first, each to the nearest that came before
/// it, or else one of its own. Returns where each went, and what the new ones hold. `empty` are the middles of pieces that hold
/// nothing. O(pieces · new pieces).
fn joined(heaps: &[Heap], empty: &[Vec3], near: f32) -> (Vec<u32>, Vec<Heap>) {
    let mut order: Vec<usize> = (0..heaps.len()).collect();
    order.sort_by_key(|&piece| std::cmp::Reverse(heaps[piece].n));
    let mut middles: Vec<Vec3> = Vec::new();
    let mut new: Vec<Heap> = Vec::new();
    let mut join = vec![0_u32; heaps.len()];
    for piece in order {
        let heap = &heaps[piece];
        let middle = if heap.n == 0 { empty[piece] } else { heap.mean() };
        let nearest = middles
            .iter()
            .map(|other| other.distance_squared(middle))
            .enumerate()
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .filter(|&(_, squared)| squared < near * near);
        let to = nearest.map_or(new.len(), |(to, _)| to);
        if to == new.len() {
            middles.push(middle);
            new.push(Heap::default());
        }
        new[to].join(heap);
        join[piece] = to as u32;
    }
    (join, new)
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

    fn join(&mut self, other: &Self) {
        self.n += other.n;
        self.sum += other.sum;
        self.squares += other.squares;
    }

    /// Zero without points.
    fn mean(&self) -> Vec3 {
        (self.sum / f64::from(self.n.max(1))).as_vec3()
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
