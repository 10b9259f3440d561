//! The chordal axis: middles of chords, joined through the triangles of a filled area.

use super::fill::{Fill, NONE};
use glam::DVec2;

/// A tree of nodes, once cycles are cut; before that a graph.
pub(super) struct Axis {
    pub(super) at: Vec<DVec2>,
    /// The chord a node is the middle of; zero at tips and forks.
    pub(super) chords: Vec<DVec2>,
    /// Half the width about each node; 0 at tips.
    pub(super) radii: Vec<f64>,
    /// Nodes joined to each node.
    pub(super) joined: Vec<Vec<u32>>,
    /// Length of what was pruned beyond a node.
    pub(super) lost: Vec<f64>,
}

impl Axis {
    /// The axis of an area. O(triangles).
    pub(super) fn of(fill: &Fill) -> Self {
        let mut axis = Self {
            at: Vec::new(),
            chords: Vec::new(),
            radii: Vec::new(),
            joined: Vec::new(),
            lost: Vec::new(),
        };
        let corner = |t: usize, i: usize| fill.points[fill.triangles[t][i % 3] as usize];
        // The node of each triangle's sides.
        let mut nodes = vec![[NONE; 3]; fill.triangles.len()];
        for t in 0..fill.triangles.len() {
            for side in 0..3 {
                let across = fill.neighbours[t][side];
                if across == NONE || nodes[t][side] != NONE {
                    continue;
                }
                let (a, b) = (corner(t, side), corner(t, side + 1));
                let node = axis.add(0.5 * (a + b), b - a, 0.5 * a.distance(b));
                nodes[t][side] = node;
                let back = fill.neighbours[across as usize].iter().position(|&n| n == t as u32);
                if let Some(back) = back {
                    nodes[across as usize][back] = node;
                }
            }
        }
        for (t, sides) in nodes.iter().enumerate() {
            let chords: Vec<usize> = (0..3).filter(|&side| sides[side] != NONE).collect();
            match chords[..] {
                [] => axis.lone([0, 1, 2].map(|i| corner(t, i))),
                [side] => {
                    let tip = axis.add(corner(t, side + 2), DVec2::ZERO, 0.0);
                    axis.join(sides[side], tip);
                }
                [a, b] => axis.join(sides[a], sides[b]),
                _ => {
                    let middle = (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3.0;
                    let radius = sides.iter().map(|&n| axis.radii[n as usize]).fold(0.0, f64::max);
                    let fork = axis.add(middle, DVec2::ZERO, radius);
                    sides.iter().for_each(|&node| axis.join(node, fork));
                }
            }
        }
        axis
    }

    /// An area of one triangle: from the middle of its shortest side to the corner across.
    fn lone(&mut self, corners: [DVec2; 3]) {
        let length = |i: usize| corners[i].distance(corners[(i + 1) % 3]);
        let short = (1..3).fold(0, |best, i| if length(i) < length(best) { i } else { best });
        let (a, b) = (corners[short], corners[(short + 1) % 3]);
        let foot = self.add(0.5 * (a + b), b - a, 0.5 * a.distance(b));
        let tip = self.add(corners[(short + 2) % 3], DVec2::ZERO, 0.0);
        self.join(foot, tip);
    }

    fn add(&mut self, at: DVec2, chord: DVec2, radius: f64) -> u32 {
        self.at.push(at);
        self.chords.push(chord);
        self.radii.push(radius);
        self.joined.push(Vec::new());
        self.lost.push(0.0);
        (self.at.len() - 1) as u32
    }

    pub(super) fn join(&mut self, a: u32, b: u32) {
        self.joined[a as usize].push(b);
        self.joined[b as usize].push(a);
    }

    /// Number of nodes joined to a node.
    pub(super) fn degree(&self, node: u32) -> usize {
        self.joined[node as usize].len()
    }

    /// Distance of two nodes.
    pub(super) fn length(&self, a: u32, b: u32) -> f64 {
        self.at[a as usize].distance(self.at[b as usize])
    }

    /// The nodes from `from` by way of `next` on to the first that is no mere passage.
    pub(super) fn chain(&self, from: u32, next: u32) -> Vec<u32> {
        let mut out = vec![from, next];
        let (mut before, mut at) = (from, next);
        while let &[a, b] = self.joined[at as usize].as_slice() {
            (before, at) = (at, if a == before { b } else { a });
            out.push(at);
        }
        out
    }
}
