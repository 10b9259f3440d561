//! Axes: the unbroken shoots a tree consists of, with their Gravelius order.
//!
//! An axis starts where it leaves its parent axis and runs to a tip. At every fork one child
//! continues the axis and all others start laterals. The trunk has order 0, its laterals order 1
//! and so on: the ordering of Gravelius (1914), counted from 0 as botanists do.

use super::Skeleton;

/// Which child continues the axis at a fork. Ties go to the child with the lower index.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Continuation {
    /// The child with the largest radius, by length to the tip where radii are equal.
    #[default]
    Thickest,
    /// The child with the longest path to a tip.
    Longest,
    /// The child that bends least from the segment below; at the root, the longest.
    Straightest,
}

/// All axes of a skeleton. Axes are numbered so that parent axes come first; axis 0 is the trunk.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axes {
    axis_of: Vec<u32>,
    starts: Vec<u32>,
    nodes: Vec<u32>,
    orders: Vec<u32>,
}

/// One axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axis<'a> {
    /// Number of this axis.
    pub index: u32,
    /// Gravelius order: 0 for the trunk, one more than the parent axis for a lateral.
    pub order: u32,
    /// Its nodes from base to tip. A lateral's first node is the first one *above* the fork; the
    /// fork itself belongs to the parent axis and is that node's parent.
    pub nodes: &'a [u32],
}

impl Axes {
    /// Number of axes, at least 1.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "the trunk is always there")]
    pub fn len(&self) -> usize {
        self.orders.len()
    }

    /// The axis with this number.
    #[must_use]
    pub fn get(&self, index: u32) -> Option<Axis<'_>> {
        let i = index as usize;
        let order = *self.orders.get(i)?;
        let nodes = &self.nodes[self.starts[i] as usize..self.starts[i + 1] as usize];
        Some(Axis { index, order, nodes })
    }

    /// All axes, parents first.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Axis<'_>> + '_ {
        (0..self.len()).map(|i| Axis {
            index: i as u32,
            order: self.orders[i],
            nodes: &self.nodes[self.starts[i] as usize..self.starts[i + 1] as usize],
        })
    }

    /// The axis each node belongs to.
    #[must_use]
    pub fn axis_of(&self) -> &[u32] {
        &self.axis_of
    }

    /// Where the nodes of each axis begin in [`nodes`](Self::nodes), and at last where they all end: one
    /// more than there are axes.
    #[must_use]
    pub fn starts(&self) -> &[u32] {
        &self.starts
    }

    /// The nodes of all axes, axis after axis, each from base to tip; [`starts`](Self::starts) parts them.
    #[must_use]
    pub fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    /// The Gravelius order of each axis.
    #[must_use]
    pub fn orders(&self) -> &[u32] {
        &self.orders
    }

    /// The Gravelius order of the axis that `node` lies on; `None` for a node that does not exist.
    #[must_use]
    pub fn order_of(&self, node: u32) -> Option<u32> {
        self.axis_of.get(node as usize).map(|&axis| self.orders[axis as usize])
    }
}

impl Skeleton {
    /// Splits the skeleton into axes.
    ///
    /// # Complexity
    /// O(nodes) time, three passes, even with all nodes at one fork.
    #[must_use]
    pub fn axes(&self, rule: Continuation) -> Axes {
        let heirs = self.heirs(rule);
        let mut axis_of = vec![0_u32; self.len()];
        let mut orders = vec![0_u32];
        let mut lengths = vec![1_u32];
        for (parent, node) in self.segments() {
            let parent_axis = axis_of[parent as usize];
            axis_of[node as usize] = if heirs[parent as usize] == node {
                lengths[parent_axis as usize] += 1;
                parent_axis
            } else {
                orders.push(orders[parent_axis as usize] + 1);
                lengths.push(1);
                orders.len() as u32 - 1
            };
        }
        let mut starts = Vec::with_capacity(lengths.len() + 1);
        let mut start = 0;
        for length in lengths {
            starts.push(start);
            start += length;
        }
        starts.push(start);
        let mut next = starts.clone();
        let mut nodes = vec![0_u32; self.len()];
        for (node, &axis) in axis_of.iter().enumerate() {
            let slot = &mut next[axis as usize];
            nodes[*slot as usize] = node as u32;
            *slot += 1;
        }
        Axes { axis_of, starts, nodes, orders }
    }

    /// For each node the child that continues its axis; `u32::MAX` at tips.
    fn heirs(&self, rule: Continuation) -> Vec<u32> {
        let lengths = self.segment_lengths();
        let to_tip = self.distances_to_tip();
        let reach = |node: usize| to_tip[node] + lengths[node];
        let mut heirs = vec![u32::MAX; self.len()];
        let mut best = vec![(f32::NEG_INFINITY, f32::NEG_INFINITY); self.len()];
        for (parent, child) in self.segments() {
            let (p, c) = (parent as usize, child as usize);
            let key = match rule {
                Continuation::Thickest => (self.radii[c], reach(c)),
                Continuation::Longest => (reach(c), 0.0),
                Continuation::Straightest => (self.straightness(p, c).unwrap_or(0.0), reach(c)),
            };
            if key > best[p] {
                best[p] = key;
                heirs[p] = child;
            }
        }
        heirs
    }

    /// Cosine of the bend at `parent` on the way to `child`; `None` at the root or without length.
    fn straightness(&self, parent: usize, child: usize) -> Option<f32> {
        let grandparent = self.parent(parent as u32)? as usize;
        let below = (self.positions[parent] - self.positions[grandparent]).try_normalize()?;
        let above = (self.positions[child] - self.positions[parent]).try_normalize()?;
        Some(below.dot(above))
    }
}
