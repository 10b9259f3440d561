//! Attractor graphs: polylines in a picture that lead to the tree's base.

use crate::error::{ModelError, Result};
use glam::Vec2;
use tree_core::NO_PARENT;

/// Main branches in one picture, as a forest whose roots are at the tree's base. Coordinates are pixels
/// from the top left, as in a [`Matte`](crate::particle::Matte).
///
/// Parents come before their children, so that one pass visits the graph from the base outwards.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AttractorGraph {
    nodes: Vec<Vec2>,
    parents: Vec<u32>,
}

impl AttractorGraph {
    /// A graph of `nodes`, each with the row of the node that it leads to, or [`NO_PARENT`] at the base.
    ///
    /// # Errors
    /// [`ModelError::NotFinite`] for a node, [`ModelError::Attractor`] where lengths differ or a
    /// parent does not come before its node.
    pub fn new(nodes: Vec<Vec2>, parents: Vec<u32>) -> Result<Self> {
        let bad = |problem: String| Err(ModelError::Attractor { problem });
        if nodes.len() != parents.len() {
            return bad(format!("{} nodes have {} parents", nodes.len(), parents.len()));
        }
        if let Some(index) = nodes.iter().position(|node| !node.is_finite()) {
            return Err(ModelError::NotFinite { field: format!("attractor.nodes[{index}]") });
        }
        for (node, &parent) in parents.iter().enumerate() {
            if parent != NO_PARENT && parent as usize >= node {
                return bad(format!(
                    "node {node} has parent {parent}, which does not come before it"
                ));
            }
        }
        Ok(Self { nodes, parents })
    }

    /// Where the nodes are, in pixels.
    #[must_use]
    pub fn nodes(&self) -> &[Vec2] {
        &self.nodes
    }

    /// The node each node leads to, one nearer to the base; [`NO_PARENT`] at the base.
    #[must_use]
    pub fn parents(&self) -> &[u32] {
        &self.parents
    }

    /// Whether there is no segment.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.parents.iter().all(|&parent| parent == NO_PARENT)
    }

    /// Every segment as (nearer to the base, farther from it).
    pub fn segments(&self) -> impl Iterator<Item = (Vec2, Vec2)> + '_ {
        self.nodes
            .iter()
            .zip(&self.parents)
            .filter(|&(_, &parent)| parent != NO_PARENT)
            .map(|(&node, &parent)| (self.nodes[parent as usize], node))
    }

    /// The nodes that none leads to, roots without children included.
    pub fn tips(&self) -> impl Iterator<Item = u32> + '_ {
        let mut is_parent = vec![false; self.nodes.len()];
        for &parent in self.parents.iter().filter(|&&parent| parent != NO_PARENT) {
            is_parent[parent as usize] = true;
        }
        (0..self.nodes.len() as u32).filter(move |&node| !is_parent[node as usize])
    }
}
