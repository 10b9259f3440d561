//! The chordal axis: middles of chords, joined through the triangles of a filled area.

use super::fill::{Fill, NONE};
use glam::DVec2;

/// A tree of nodes, once cycles are cut; before that a graph.
pub(crate) struct Axis {
    pub(crate) at: Vec<DVec2>,
    /// The chord a node is the middle of; zero at tips and forks.
    pub(crate) chords: Vec<DVec2>,
    /// Half the width about each node; 0 at tips.
    pub(crate) radii: Vec<f64>,
    /// Nodes joined to each node.
    pub(crate) joined: Vec<Vec<u32>>,
    /// Length of what was pruned beyond a node.
    pub(crate) lost: Vec<f64>,
    /// Length of everything that hangs on each node, seen from the first node of its tree, and that of the tree.
    weights: Vec<(f64, f64)>,
    /// The neighbour towards the first node of the tree; [`NONE`] for that one.
    towards: Vec<u32>,
}

impl Axis {
    /// The axis of an area. O(triangles).
    pub(crate) fn of(fill: &Fill) -> Self {
        let mut axis = Self {
            at: Vec::new(),
            chords: Vec::new(),
            radii: Vec::new(),
            joined: Vec::new(),
            lost: Vec::new(),
            weights: Vec::new(),
            towards: Vec::new(),
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

    pub(crate) fn join(&mut self, a: u32, b: u32) {
        self.joined[a as usize].push(b);
        self.joined[b as usize].push(a);
    }

    /// Number of nodes joined to a node.
    pub(crate) fn degree(&self, node: u32) -> usize {
        self.joined[node as usize].len()
    }

    /// Distance of two nodes.
    pub(crate) fn length(&self, a: u32, b: u32) -> f64 {
        self.at[a as usize].distance(self.at[b as usize])
    }

    /// The nodes from `from` by way of `next` on to the first that is no mere passage.
    pub(crate) fn chain(&self, from: u32, next: u32) -> Vec<u32> {
        let mut out = vec![from, next];
        let (mut before, mut at) = (from, next);
        while let &[a, b] = self.joined[at as usize].as_slice() {
            (before, at) = (at, if a == before { b } else { a });
            out.push(at);
        }
        out
    }

    /// Prepares [`beyond`](Self::beyond), once the axis is a forest. O(n).
    pub(crate) fn weigh(&mut self) {
        let n = self.at.len();
        self.weights = vec![(-1.0, 0.0); n];
        self.towards = vec![NONE; n];
        for first in 0..n as u32 {
            if self.weights[first as usize].0 >= 0.0 {
                continue;
            }
            let mut order = vec![first];
            let mut i = 0;
            while let Some(&node) = order.get(i) {
                i += 1;
                self.weights[node as usize].0 = 0.0;
                for &next in &self.joined[node as usize] {
                    if next != self.towards[node as usize] {
                        self.towards[next as usize] = node;
                        order.push(next);
                    }
                }
            }
            for &node in order[1..].iter().rev() {
                let below = self.towards[node as usize];
                let length = self.length(node, below);
                self.weights[below as usize].0 += self.weights[node as usize].0 + length;
            }
            let all = self.weights[first as usize].0;
            order.iter().for_each(|&node| self.weights[node as usize].1 = all);
        }
    }

    /// Length of all lines that are reached from `node` by way of its neighbour `next`.
    pub(crate) fn beyond(&self, node: u32, next: u32) -> f64 {
        let (here, there) = (self.weights[node as usize], self.weights[next as usize]);
        if self.towards[next as usize] == node { there.0 } else { here.1 - here.0 }
    }
}
