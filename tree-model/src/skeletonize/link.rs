//! Step 5: separate pieces of wood become one, over the cheapest links from ends of pieces to
//! segments of others (a minimum spanning tree by O. Borůvka's rounds, 1926).
//!
//! A link costs the gap between the end and the other's bark, and some of the distance to its axis.
//! It costs more at the thin end of a piece, and where the other is thinner than the end: branches
//! grow from their thick end out of something thicker.

use super::near::{Near, Segment};
use super::rows::Sets;
use super::slices::NONE;
use super::stages::Piece;
use crate::error::Result;
use glam::Vec3;
use tree_core::Control;

/// Cost of distance to the axis, against 1 for the gap.
const AXIS_COST: f32 = 0.1;
/// Cost of how much thinner an end is than the thickest end of its piece.
const THIN_END_COST: f32 = 0.25;
/// Cost of how much thinner the other piece is than the end.
const THIN_HOST_COST: f32 = 0.5;
/// How much thicker the root must be for each length it stands higher.
const HEIGHT_COST: f32 = 0.1;

/// From an end to a place on a segment. Nodes are numbered through all pieces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Link {
    pub(super) end: u32,
    /// Upper node of the segment.
    pub(super) node: u32,
    /// Share of the way from the segment's lower node.
    pub(super) share: f32,
}

/// All pieces as one forest.
#[derive(Debug, Default)]
pub(super) struct Forest {
    pub(super) positions: Vec<Vec3>,
    pub(super) radii: Vec<f32>,
    pub(super) parents: Vec<u32>,
    pub(super) piece_of: Vec<u32>,
    pub(super) links: Vec<Link>,
    pub(super) root: u32,
    /// Whether each piece hangs together with the root.
    pub(super) reached: Vec<bool>,
}

struct End {
    node: u32,
    piece: u32,
    extra: f32,
    /// No link from here costs less than this.
    least: f32,
}

/// Links pieces whose gaps are at most `bridge`.
pub(super) fn link(pieces: &[Piece], bridge: f32, control: &Control) -> Result<Forest> {
    let mut forest = Forest::default();
    for (piece, number) in pieces.iter().zip(0..) {
        let skeleton = &piece.skeleton;
        let first = forest.parents.len() as u32;
        forest.positions.extend(skeleton.positions());
        forest.radii.extend(skeleton.radii());
        let shift = |&p: &u32| if p == NONE { NONE } else { first + p };
        forest.parents.extend(skeleton.parents().iter().map(shift));
        forest.piece_of.extend(skeleton.parents().iter().map(|_| number));
    }
    let mut ends = forest.ends(pieces.len());
    forest.root = forest.lowest_thick(&ends);
    let (near, nodes) = forest.segments(pieces);
    let mut sets = Sets::new(pieces.len());
    let thickest = forest.radii.iter().fold(0.0_f32, |a, &b| a.max(b));
    loop {
        control.check()?;
        let best = forest.round(&near, &nodes, &mut ends, &mut sets, (bridge, thickest));
        let before = forest.links.len();
        for (_, link) in best.into_iter().flatten() {
            let (a, b) = (forest.piece_of[link.end as usize], forest.piece_of[link.node as usize]);
            if sets.find(a) != sets.find(b) {
                sets.join(a, b);
                forest.links.push(link);
            }
        }
        if forest.links.len() == before {
            break;
        }
    }
    let home = sets.find(forest.piece_of[forest.root as usize]);
    forest.reached = (0..pieces.len() as u32).map(|piece| sets.find(piece) == home).collect();
    Ok(forest)
}

impl Forest {
    /// Nodes with at most one neighbour.
    fn ends(&self, n_pieces: usize) -> Vec<End> {
        let mut neighbours = vec![0_u32; self.parents.len()];
        for (node, &parent) in self.parents.iter().enumerate() {
            if parent != NONE {
                neighbours[node] += 1;
                neighbours[parent as usize] += 1;
            }
        }
        let is_end = |&node: &usize| neighbours[node] <= 1;
        let mut thickest = vec![0.0_f32; n_pieces];
        for node in (0..neighbours.len()).filter(is_end) {
            let slot = &mut thickest[self.piece_of[node] as usize];
            *slot = slot.max(self.radii[node]);
        }
        (0..neighbours.len())
            .filter(is_end)
            .map(|node| {
                let piece = self.piece_of[node];
                let extra = THIN_END_COST * (thickest[piece as usize] - self.radii[node]);
                End { node: node as u32, piece, extra, least: 0.0 }
            })
            .collect()
    }

    fn lowest_thick(&self, ends: &[End]) -> u32 {
        let score = |end: &&End| {
            let node = end.node as usize;
            self.radii[node] - HEIGHT_COST * self.positions[node].y
        };
        ends.iter()
            .reduce(|best, end| if score(&end) > score(&best) { end } else { best })
            .map_or(0, |end| end.node)
    }

    /// All segments, and the upper node of each. A lone node is a segment without length.
    fn segments(&self, pieces: &[Piece]) -> (Near, Vec<u32>) {
        let (mut segments, mut nodes) = (Vec::new(), Vec::new());
        for (node, &parent) in self.parents.iter().enumerate() {
            let alone = || pieces[self.piece_of[node] as usize].skeleton.len() == 1;
            if parent != NONE || alone() {
                let lower = if parent == NONE { node } else { parent as usize };
                segments.push(Segment {
                    a: (self.positions[lower], self.radii[lower]),
                    b: (self.positions[node], self.radii[node]),
                });
                nodes.push(node as u32);
            }
        }
        (Near::new(segments), nodes)
    }

    /// The cheapest link of each set of joined pieces to any other.
    fn round(
        &self,
        near: &Near,
        nodes: &[u32],
        ends: &mut [End],
        sets: &mut Sets,
        (bridge, thickest): (f32, f32),
    ) -> Vec<Option<(f32, Link)>> {
        let n_pieces = self.piece_of.last().map_or(0, |&last| last as usize + 1);
        let set_of: Vec<u32> = (0..n_pieces as u32).map(|piece| sets.find(piece)).collect();
        let most = 2.0 * bridge + (1.0 + AXIS_COST + THIN_HOST_COST) * thickest;
        let mut best: Vec<Option<(f32, Link)>> = vec![None; n_pieces];
        for end in ends {
            let own = set_of[end.piece as usize];
            let slot = &mut best[own as usize];
            let mut bound = slot.map_or(most, |(cost, _)| cost);
            if end.least >= bound {
                continue;
            }
            let (point, radius) =
                (self.positions[end.node as usize], self.radii[end.node as usize]);
            // The distance beyond which nothing costs less.
            let reach = |bound: f32| {
                let left = bound - end.extra;
                (left / AXIS_COST).min((left + thickest) / (1.0 + AXIS_COST))
            };
            near.search(point, reach(bound), |number| {
                let node = nodes[number as usize];
                if set_of[self.piece_of[node as usize] as usize] == own {
                    return reach(bound);
                }
                let segment = near.segments[number as usize];
                let share = segment.nearest(point);
                let (place, host) = segment.at(share);
                let distance = place.distance(point);
                let gap = (distance - host).max(0.0);
                let thin = THIN_HOST_COST * (radius - host).max(0.0);
                let cost = gap + AXIS_COST * distance + thin + end.extra;
                let link = Link { end: end.node, node, share };
                if gap <= bridge && cost < bound {
                    bound = cost;
                    *slot = Some((cost, link));
                }
                reach(bound)
            });
            end.least = bound;
        }
        best
    }
}
