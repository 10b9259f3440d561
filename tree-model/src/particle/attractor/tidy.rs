//! From pixels to a graph: stubs off, zigzag out, fewer nodes.

use super::AttractorGraph;
use crate::error::Result;
use glam::Vec2;
use tree_core::NO_PARENT;

/// How far a node moves in one pass towards the middle between its neighbours.
const STEP: f32 = 0.5;

/// Nodes and parents as they are worked on; parents come first.
pub(super) struct Draft {
    pub(super) nodes: Vec<Vec2>,
    pub(super) parents: Vec<u32>,
}

impl Draft {
    /// Length of the longest way from each node up to a tip.
    fn reaches(&self) -> Vec<f32> {
        let mut reach = vec![0.0_f32; self.nodes.len()];
        for node in (0..self.nodes.len()).rev() {
            if let Some(parent) = self.parent(node) {
                let length = self.nodes[node].distance(self.nodes[parent]);
                reach[parent] = reach[parent].max(reach[node] + length);
            }
        }
        reach
    }

    fn parent(&self, node: usize) -> Option<usize> {
        let parent = self.parents[node];
        (parent != NO_PARENT).then_some(parent as usize)
    }

    /// Keeps the nodes that `keep` marks, each led to its next kept ancestor.
    fn retain(&mut self, keep: &[bool]) {
        let mut new_row = vec![NO_PARENT; self.nodes.len()];
        let (mut nodes, mut parents) = (Vec::new(), Vec::new());
        for node in 0..self.nodes.len() {
            // The row of the node itself, or of its next kept ancestor.
            let above = self.parent(node).map_or(NO_PARENT, |parent| new_row[parent]);
            if keep[node] {
                new_row[node] = nodes.len() as u32;
                nodes.push(self.nodes[node]);
                parents.push(above);
            } else {
                new_row[node] = above;
            }
        }
        (self.nodes, self.parents) = (nodes, parents);
    }

    /// Takes off side branches shorter than `length`; how many. The longest branch of a fork stays.
    pub(super) fn prune(&mut self, length: f32) -> u32 {
        let reach = self.reaches();
        let total = |node: usize| {
            let step = self.parent(node).map_or(0.0, |p| self.nodes[node].distance(self.nodes[p]));
            reach[node] + step
        };
        let mut longest = vec![usize::MAX; self.nodes.len()];
        for node in 0..self.nodes.len() {
            if let Some(parent) = self.parent(node) {
                let best = &mut longest[parent];
                if *best == usize::MAX || total(node) > total(*best) {
                    *best = node;
                }
            }
        }
        let mut keep = vec![true; self.nodes.len()];
        let mut stubs = 0;
        for node in 0..self.nodes.len() {
            let Some(parent) = self.parent(node) else { continue };
            let is_stub = longest[parent] != node && total(node) < length;
            keep[node] = keep[parent] && !is_stub;
            stubs += u32::from(is_stub && keep[parent]);
        }
        self.retain(&keep);
        stubs
    }

    /// Moves every node but roots and tips towards the middle between its parent and its children,
    /// `passes` times. Children count by the square of their reach, so that a limb is not drawn aside
    /// by its twigs.
    pub(super) fn smooth(&mut self, passes: u32) {
        let n = self.nodes.len();
        let reach = self.reaches();
        // One pixel more, so that tips count.
        let weight = |node: usize| (reach[node] + 1.0) * (reach[node] + 1.0);
        let mut sums = vec![(Vec2::ZERO, 0.0); n];
        for _ in 0..passes {
            sums.fill((Vec2::ZERO, 0.0));
            for node in 0..n {
                if let Some(parent) = self.parent(node) {
                    sums[parent].0 += weight(node) * self.nodes[node];
                    sums[parent].1 += weight(node);
                }
            }
            let before = self.nodes.clone();
            for node in 0..n {
                let (sum, weight) = sums[node];
                if let Some(parent) = self.parent(node)
                    && weight > 0.0
                {
                    let middle = 0.5 * (before[parent] + sum / weight);
                    self.nodes[node] = before[node].lerp(middle, STEP);
                }
            }
        }
    }

    /// Keeps roots, tips, forks, and between them a node about every `spacing`.
    pub(super) fn thin(&mut self, spacing: f32) {
        let n = self.nodes.len();
        let mut children = vec![0_u32; n];
        for node in 0..n {
            if let Some(parent) = self.parent(node) {
                children[parent] += 1;
            }
        }
        let mut keep = vec![false; n];
        // Length since the last node kept.
        let mut since = vec![0.0_f32; n];
        for node in 0..n {
            let Some(parent) = self.parent(node) else {
                keep[node] = true;
                continue;
            };
            let so_far = if keep[parent] { 0.0 } else { since[parent] };
            since[node] = so_far + self.nodes[node].distance(self.nodes[parent]);
            keep[node] = children[node] != 1 || since[node] >= spacing;
        }
        self.retain(&keep);
    }

    /// The graph. Nodes at the place of their parent are left out.
    ///
    /// # Errors
    /// As [`AttractorGraph::new`].
    pub(super) fn finish(mut self) -> Result<AttractorGraph> {
        let keep: Vec<bool> = (0..self.nodes.len())
            .map(|node| self.parent(node).is_none_or(|p| self.nodes[p] != self.nodes[node]))
            .collect();
        self.retain(&keep);
        AttractorGraph::new(self.nodes, self.parents)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A stem of 20 pixels with a side branch of `side` from its middle.
    fn stem(side: u32) -> Draft {
        let mut draft = Draft { nodes: vec![Vec2::ZERO], parents: vec![NO_PARENT] };
        for i in 1..=20 {
            draft.nodes.push(Vec2::new((i % 2) as f32, -(i as f32)));
            draft.parents.push(i - 1);
        }
        for i in 0..side {
            draft.nodes.push(Vec2::new(i as f32 + 1.0, -10.0));
            draft.parents.push(if i == 0 { 10 } else { 20 + i });
        }
        draft
    }

    #[test]
    fn short_side_branches_are_taken_off_and_long_ones_stay() {
        let (mut short, mut long) = (stem(3), stem(8));
        assert_eq!((short.prune(5.0), long.prune(5.0)), (1, 0));
        assert_eq!((short.nodes.len(), long.nodes.len()), (21, 29));
    }

    #[test]
    fn smoothing_takes_out_zigzag_and_holds_ends() {
        let mut draft = stem(0);
        draft.smooth(20);
        assert_eq!((draft.nodes[0], draft.nodes[20]), (Vec2::ZERO, Vec2::new(0.0, -20.0)));
        let turn = (draft.nodes[10].x - draft.nodes[9].x).abs();
        assert!(turn < 0.01, "{turn}");
    }

    #[test]
    fn thinning_keeps_forks_and_tips() {
        let mut draft = stem(8);
        draft.thin(100.0);
        let graph = draft.finish().unwrap();
        assert_eq!(graph.nodes().len(), 4);
        assert_eq!(graph.parents(), [NO_PARENT, 0, 1, 1]);
    }
}
