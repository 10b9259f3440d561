//! The plan's branches split into segments, from fork to fork (Neubert 2012, section 4.4).

use crate::sketch::plan::Plan;
use glam::DVec2;
use std::collections::BTreeMap;
use tree_core::NO_PARENT;

/// Share of the height by which an imagined root reaches below the base.
const ROOT_SHARE: f64 = 0.1;

/// No depth is sought that makes a segment steeper than this tangent against the drawing's plane: it is at most twice as
/// long as drawn. Nobody draws a branch that points at the eye, or not as a branch.
pub const STEEPEST: f64 = 1.732;

/// Segments in the plane, in columns. Parents come first, generation by generation.
#[derive(Clone, Debug)]
pub(in crate::sketch) struct Segments {
    pub(in crate::sketch) parents: Vec<u32>,
    /// Where each segment ends.
    pub(in crate::sketch) ends: Vec<DVec2>,
    /// Where segment 0 begins.
    pub(in crate::sketch) base: DVec2,
    /// Children of segment `i`: `children[starts[i]..starts[i + 1]]`.
    starts: Vec<u32>,
    children: Vec<u32>,
    /// Plan nodes of segment `i`, that of its parent's end first: `nodes[node_starts[i]..node_starts[i + 1]]`.
    node_starts: Vec<u32>,
    nodes: Vec<u32>,
    /// Whether the segment lies on the stroke of its parent.
    pub(in crate::sketch) through: Vec<bool>,
    /// The stroke it lies on, and which of the stroke's segments it is counted from its end: names that stay when other
    /// branches are drawn or erased.
    pub(in crate::sketch) keys: Vec<[u64; 2]>,
    /// Height of the plan in metres, and the larger of height and width.
    pub(in crate::sketch) height: f64,
    pub(in crate::sketch) extent: f64,
    pub(in crate::sketch) imagined_root: bool,
}

impl Segments {
    /// Splits a plan. O(nodes).
    pub(in crate::sketch) fn of(plan: &Plan) -> Self {
        let n = plan.len();
        let mut fan = vec![0_u32; n];
        for &parent in &plan.parents()[1..] {
            fan[parent as usize] += 1;
        }
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for position in plan.positions() {
            (low, high) = (low.min(position.as_dvec2()), high.max(position.as_dvec2()));
        }
        let size = high - low;
        let imagined_root = fan[0] != 1;
        let mut chains = Chains {
            plan,
            fan: &fan,
            nodes: Vec::new(),
            node_starts: vec![0],
            parents: Vec::new(),
        };
        let heirs = chains.run(imagined_root);
        let Chains { nodes, node_starts, parents, .. } = chains;
        let position = |node: u32| plan.positions()[node as usize].as_dvec2();
        let row = |i: usize| &nodes[node_starts[i] as usize..node_starts[i + 1] as usize];
        let stroke = |i: usize| row(i).get(1).map(|&node| plan.strokes()[node as usize]);
        let through = (0..parents.len())
            .map(|i| {
                parents[i] != NO_PARENT
                    && stroke(i).is_some()
                    && stroke(i) == stroke(parents[i] as usize)
            })
            .collect();
        let ends = (0..parents.len())
            .map(|i| row(i).last().map_or(DVec2::ZERO, |&node| position(node)))
            .collect();
        let mut keys = vec![[u64::MAX; 2]; parents.len()];
        let mut counts: BTreeMap<u32, u64> = BTreeMap::new();
        for i in (0..parents.len()).rev() {
            if let Some(stroke) = stroke(i) {
                let count = counts.entry(stroke).or_default();
                keys[i] = [u64::from(stroke), *count];
                *count += 1;
            }
        }
        let base = position(0)
            - if imagined_root { DVec2::Y * ROOT_SHARE * size.y.max(1e-6) } else { DVec2::ZERO };
        let (starts, children) = heirs;
        Self {
            parents,
            ends,
            base,
            starts,
            children,
            node_starts,
            nodes,
            through,
            keys,
            imagined_root,
            height: size.y.max(1e-6),
            extent: size.max_element().max(1e-6),
        }
    }

    pub(in crate::sketch) fn len(&self) -> usize {
        self.parents.len()
    }

    pub(in crate::sketch) fn parent(&self, segment: usize) -> Option<usize> {
        self.parents
            .get(segment)
            .filter(|&&parent| parent != NO_PARENT)
            .map(|&parent| parent as usize)
    }

    pub(in crate::sketch) fn children(&self, segment: usize) -> &[u32] {
        &self.children[self.starts[segment] as usize..self.starts[segment + 1] as usize]
    }

    /// The plan's nodes along a segment, its parent's end first. An imagined root has the base alone.
    pub(in crate::sketch) fn nodes(&self, segment: usize) -> &[u32] {
        &self.nodes[self.node_starts[segment] as usize..self.node_starts[segment + 1] as usize]
    }

    /// The rows of [`nodes`](Self::nodes), one after the other.
    pub(in crate::sketch) fn all_nodes(&self) -> &[u32] {
        &self.nodes
    }

    pub(in crate::sketch) fn start(&self, segment: usize) -> DVec2 {
        self.parent(segment).map_or(self.base, |parent| self.ends[parent])
    }

    /// From a segment's beginning to its end, in the plane.
    pub(in crate::sketch) fn chord(&self, segment: usize) -> DVec2 {
        self.ends[segment] - self.start(segment)
    }
}

/// Walks the plan, generation by generation.
struct Chains<'a> {
    plan: &'a Plan,
    fan: &'a [u32],
    nodes: Vec<u32>,
    node_starts: Vec<u32>,
    parents: Vec<u32>,
}

impl Chains<'_> {
    /// Fills the rows; returns the children in compressed rows.
    fn run(&mut self, imagined_root: bool) -> (Vec<u32>, Vec<u32>) {
        let n = self.plan.len();
        let mut starts = vec![0_u32; n + 1];
        for &parent in &self.plan.parents()[1..] {
            starts[parent as usize + 1] += 1;
        }
        for i in 0..n {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut kids = vec![0_u32; n - 1];
        for (node, &parent) in self.plan.parents().iter().enumerate().skip(1) {
            let slot = &mut next[parent as usize];
            kids[*slot as usize] = node as u32;
            *slot += 1;
        }
        let kids_of =
            |node: u32| &kids[starts[node as usize] as usize..starts[node as usize + 1] as usize];
        // Segments still to be followed: the one below, the fork, the first node beyond.
        let mut queue: Vec<(u32, u32, u32)> = Vec::new();
        if imagined_root {
            self.nodes.push(0);
            self.close(NO_PARENT);
        }
        let below = if imagined_root { 0 } else { NO_PARENT };
        queue.extend(kids_of(0).iter().map(|&kid| (below, 0, kid)));
        let mut done = 0;
        let mut rows = (vec![0_u32], Vec::new());
        if imagined_root {
            rows.1.extend((0..queue.len() as u32).map(|i| 1 + i));
            rows.0.push(rows.1.len() as u32);
        }
        let mut n_segments = queue.len() as u32 + u32::from(imagined_root);
        while done < queue.len() {
            let (below, fork, first) = queue[done];
            done += 1;
            self.nodes.push(fork);
            let mut node = first;
            self.nodes.push(node);
            while self.fan[node as usize] == 1 {
                node = kids_of(node)[0];
                self.nodes.push(node);
            }
            let segment = self.parents.len() as u32;
            self.close(below);
            for &kid in kids_of(node) {
                queue.push((segment, node, kid));
                rows.1.push(n_segments);
                n_segments += 1;
            }
            rows.0.push(rows.1.len() as u32);
        }
        rows
    }

    fn close(&mut self, parent: u32) {
        self.parents.push(parent);
        self.node_starts.push(self.nodes.len() as u32);
    }
}
