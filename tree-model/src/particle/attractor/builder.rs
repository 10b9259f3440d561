//! A graph under construction: nodes in any order, and points in the middle of segments.

use super::AttractorGraph;
use super::graph::nearest_on;
use crate::error::Result;
use glam::Vec2;
use tree_core::NO_PARENT;

/// Nodes and the node each leads to, in any order.
#[derive(Clone, Debug, Default)]
pub(super) struct Builder {
    pub(super) nodes: Vec<Vec2>,
    pub(super) parents: Vec<u32>,
}

/// Where something can be attached.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// The node itself, or the upper end of the segment.
    node: u32,
    /// On the segment: 0 at the parent, 1 at the node.
    share: f32,
    pub(super) point: Vec2,
    pub(super) distance: f32,
}

impl Builder {
    pub(super) fn from_graph(graph: &AttractorGraph) -> Self {
        Self { nodes: graph.nodes().to_vec(), parents: graph.parents().to_vec() }
    }

    /// Adds a node; its row.
    pub(super) fn push(&mut self, point: Vec2, parent: u32) -> u32 {
        self.nodes.push(point);
        self.parents.push(parent);
        self.nodes.len() as u32 - 1
    }

    /// The place nearest to `point` among the nodes that `may` tell and the segments above them.
    pub(super) fn nearest(&self, point: Vec2, may: impl Fn(usize) -> bool) -> Option<Place> {
        let mut best: Option<Place> = None;
        for node in (0..self.nodes.len()).filter(|&node| may(node)) {
            let above = self.nodes[node];
            let below = match self.parents[node] {
                NO_PARENT => above,
                parent => self.nodes[parent as usize],
            };
            let (share, on) = nearest_on(below, above, point);
            let distance = on.distance(point);
            if best.is_none_or(|best| distance < best.distance) {
                best = Some(Place { node: node as u32, share, point: on, distance });
            }
        }
        best
    }

    /// A node at a place: one that is there, or a new one that splits the segment.
    pub(super) fn split(&mut self, place: Place) -> u32 {
        let parent = self.parents[place.node as usize];
        if parent == NO_PARENT || place.point == self.nodes[place.node as usize] {
            return place.node;
        }
        if place.share == 0.0 || place.point == self.nodes[parent as usize] {
            return parent;
        }
        let row = self.push(place.point, parent);
        self.parents[place.node as usize] = row;
        row
    }

    /// The graph: parents first, without what leads to no root.
    ///
    /// # Errors
    /// As [`AttractorGraph::new`].
    pub(super) fn finish(self) -> Result<AttractorGraph> {
        let n = self.nodes.len();
        let mut children = vec![Vec::new(); n];
        let mut open = Vec::new();
        for (node, &parent) in self.parents.iter().enumerate().rev() {
            match children.get_mut(parent as usize) {
                Some(list) => list.push(node as u32),
                None => open.push((node as u32, NO_PARENT)),
            }
        }
        let (mut nodes, mut parents) = (Vec::with_capacity(n), Vec::with_capacity(n));
        while let Some((node, parent)) = open.pop() {
            let row = nodes.len() as u32;
            nodes.push(self.nodes[node as usize]);
            parents.push(parent);
            open.extend(children[node as usize].iter().map(|&child| (child, row)));
        }
        AttractorGraph::new(nodes, parents)
    }
}
