//! Children of every node, in compressed rows.

use super::{NO_PARENT, Skeleton};

/// The children of every node: one list of indices, and where each node's part of it begins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Children {
    starts: Vec<u32>,
    nodes: Vec<u32>,
}

impl Children {
    /// Where the children of each node begin in [`nodes`](Self::nodes), and at last where they all end:
    /// one more than there are nodes.
    #[must_use]
    pub fn starts(&self) -> &[u32] {
        &self.starts
    }

    /// The children of all nodes, node after node; [`starts`](Self::starts) parts them.
    #[must_use]
    pub fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    /// Children of `node` in rising order; empty for a tip and for a node that does not exist.
    #[must_use]
    pub fn of(&self, node: u32) -> &[u32] {
        let node = node as usize;
        match (self.starts.get(node), self.starts.get(node + 1)) {
            (Some(&start), Some(&end)) => &self.nodes[start as usize..end as usize],
            _ => &[],
        }
    }

    /// Whether `node` has no child.
    #[must_use]
    pub fn is_tip(&self, node: u32) -> bool {
        self.of(node).is_empty()
    }
}

impl Skeleton {
    /// The children of every node.
    ///
    /// # Complexity
    /// O(nodes) time, 8 bytes a node.
    #[must_use]
    pub fn children(&self) -> Children {
        // Counting sort by parent: counts, running sums, then fill from the back of each row.
        let mut starts = vec![0_u32; self.len() + 1];
        for &parent in self.parents.iter().filter(|&&parent| parent != NO_PARENT) {
            starts[parent as usize + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let mut nodes = vec![0_u32; self.len() - 1];
        for (parent, node) in self.segments() {
            let slot = &mut next[parent as usize];
            nodes[*slot as usize] = node;
            *slot += 1;
        }
        Children { starts, nodes }
    }
}
