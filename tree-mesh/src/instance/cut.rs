//! Which nodes and leaves belong to which terminal subtree.

use tree_core::{Skeleton, Tree};

/// Owner of what belongs to no occurrence.
pub(super) const BASE: u32 = u32::MAX;
/// Shortest subtree that is cut off, in metres.
const REACH_MIN: f32 = 1e-4;

/// The tree, cut. Occurrences are rows of nodes and leaves (CSR).
#[derive(Debug)]
pub(super) struct Cut {
    /// Occurrence of each node, or [`BASE`].
    pub(super) owner: Vec<u32>,
    /// The first node of each occurrence; its parent is part of the base.
    pub(super) roots: Vec<u32>,
    nodes: Rows,
    leaves: Rows,
}

/// Numbers in rows.
#[derive(Debug)]
struct Rows {
    starts: Vec<u32>,
    values: Vec<u32>,
}

impl Rows {
    /// Values 0, 1, … by the row each belongs to; those of [`BASE`] are left out.
    fn new(owners: impl Iterator<Item = u32> + Clone, n_rows: usize) -> Self {
        let mut starts = vec![0_u32; n_rows + 1];
        for owner in owners.clone() {
            if let Some(start) = starts.get_mut((owner as usize).saturating_add(1)) {
                *start += 1;
            }
        }
        for row in 0..n_rows {
            starts[row + 1] += starts[row];
        }
        let mut next = starts.clone();
        let mut values = vec![0; starts[n_rows] as usize];
        for (value, owner) in owners.enumerate() {
            if owner != BASE
                && let Some(slot) = next.get_mut(owner as usize)
            {
                values[*slot as usize] = value as u32;
                *slot += 1;
            }
        }
        Self { starts, values }
    }

    fn row(&self, row: usize) -> &[u32] {
        match self.starts.get(row..row + 2) {
            Some(&[from, to]) => &self.values[from as usize..to as usize],
            _ => &[],
        }
    }
}

impl Cut {
    /// Cuts off every largest subtree whose longest path, the segment that bears it included, is at
    /// most `reach` long. Three passes.
    pub(super) fn new(tree: &Tree, to_tip: &[f32], reach: f32) -> Self {
        let skeleton = tree.skeleton();
        let lengths = skeleton.segment_lengths();
        let mut owner = vec![BASE; skeleton.len()];
        let mut roots = Vec::new();
        for (parent, node) in skeleton.segments() {
            let (p, n) = (parent as usize, node as usize);
            let path = to_tip[n] + lengths[n];
            owner[n] = if owner[p] != BASE {
                owner[p]
            } else if path <= reach && path > REACH_MIN {
                roots.push(node);
                roots.len() as u32 - 1
            } else {
                BASE
            };
        }
        let of_leaf = tree.foliage().nodes().iter().map(|&node| owner[node as usize]);
        let leaves = Rows::new(of_leaf, roots.len());
        let nodes = Rows::new(owner.iter().copied(), roots.len());
        Self { owner, roots, nodes, leaves }
    }

    /// Nodes of an occurrence, parents first.
    pub(super) fn nodes(&self, occurrence: usize) -> &[u32] {
        self.nodes.row(occurrence)
    }

    /// Leaves of an occurrence.
    pub(super) fn leaves(&self, occurrence: usize) -> &[u32] {
        self.leaves.row(occurrence)
    }

    /// The node of the base that bears an occurrence.
    pub(super) fn bearer(&self, skeleton: &Skeleton, occurrence: usize) -> u32 {
        self.roots.get(occurrence).and_then(|&root| skeleton.parent(root)).unwrap_or(0)
    }
}
