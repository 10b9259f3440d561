//! Trees as they are compared: parents and weights, perhaps with fewer nodes than the skeleton.

use super::EditParams;
use super::costs::Weight;
use crate::error::{CoreError, Result};
use crate::skeleton::{Continuation, NO_PARENT, Skeleton};

/// What becomes one node before trees are compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Reduction {
    /// Every node stays one.
    None,
    /// An unbranched run, from above a fork up to the next fork or a tip. How finely shoots are divided
    /// no longer matters.
    #[default]
    Runs,
    /// An axis with all its nodes; its laterals are its children, wherever they leave it.
    Axes,
}

/// A rooted tree with a weight for every node; parents come first.
#[derive(Clone, Debug, PartialEq)]
pub struct EditTree {
    parents: Vec<u32>,
    weights: Vec<f64>,
    nodes: Vec<u32>,
}

/// Sums over the nodes that become one.
#[derive(Clone, Copy, Default)]
struct Sums {
    n: f64,
    radius: f64,
    length: f64,
    radius_length: f64,
    radius_squared_length: f64,
}

impl EditTree {
    /// A tree of its own: `parents` as in a [`Skeleton`], weights 0 or more.
    ///
    /// # Errors
    /// [`CoreError::Empty`], [`CoreError::Length`], [`CoreError::NotFinite`],
    /// [`CoreError::OutOfRange`], [`CoreError::RootHasParent`], [`CoreError::SecondRoot`],
    /// [`CoreError::ParentOrder`], each naming the row.
    pub fn new(parents: Vec<u32>, weights: Vec<f64>) -> Result<Self> {
        if parents.len() != weights.len() {
            let (found, expected) = (weights.len(), parents.len());
            return Err(CoreError::Length { field: "weights", found, expected });
        }
        for (index, &found) in weights.iter().enumerate() {
            if !found.is_finite() {
                return Err(CoreError::NotFinite { field: "weights", index });
            }
            if found < 0.0 {
                let (min, max) = (0.0, f64::MAX);
                return Err(CoreError::OutOfRange { field: "weights", index, found, min, max });
            }
        }
        // The skeleton's own checks, on a skeleton of the same shape.
        let n = parents.len();
        Skeleton::from_columns(vec![glam::Vec3::ZERO; n], vec![0.0; n], parents.clone())?;
        Ok(Self { parents, weights, nodes: (0..n as u32).collect() })
    }

    /// Reduces a skeleton and weighs what is left.
    ///
    /// # Complexity
    /// O(nodes).
    #[must_use]
    pub fn of(skeleton: &Skeleton, params: &EditParams) -> Self {
        match params.reduction {
            Reduction::None => Self::gather(skeleton, params.weight, |_, _| false),
            Reduction::Runs => {
                let children = skeleton.children();
                let single = |parent: u32, _| children.of(parent).len() == 1;
                Self::gather(skeleton, params.weight, single)
            }
            Reduction::Axes => {
                let axes = skeleton.axes(Continuation::Thickest);
                let axis = |node: u32| axes.axis_of().get(node as usize);
                Self::gather(skeleton, params.weight, |parent, node| axis(parent) == axis(node))
            }
        }
    }

    /// Joins each node to its parent's group where `joins(parent, node)` says so.
    fn gather(skeleton: &Skeleton, weight: Weight, joins: impl Fn(u32, u32) -> bool) -> Self {
        let lengths = skeleton.segment_lengths();
        let mut group_of = vec![0_u32; skeleton.len()];
        let (mut parents, mut nodes) = (vec![NO_PARENT], vec![0]);
        let mut sums = vec![Sums::default()];
        for node in 0..skeleton.len() {
            let group = match skeleton.parent(node as u32) {
                None => 0,
                Some(parent) if joins(parent, node as u32) => group_of[parent as usize],
                Some(parent) => {
                    parents.push(group_of[parent as usize]);
                    nodes.push(node as u32);
                    sums.push(Sums::default());
                    parents.len() as u32 - 1
                }
            };
            group_of[node] = group;
            nodes[group as usize] = node as u32;
            sums[group as usize].add(skeleton.radii()[node], lengths[node]);
        }
        let weights = sums.iter().map(|sums| sums.weight(weight)).collect();
        Self { parents, weights, nodes }
    }

    /// Number of nodes, at least 1.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a tree is never empty")]
    pub fn len(&self) -> usize {
        self.parents.len()
    }

    /// Parent of each node; [`NO_PARENT`] for node 0.
    #[must_use]
    pub fn parents(&self) -> &[u32] {
        &self.parents
    }

    /// Weight of each node.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Each node's uppermost skeleton node.
    #[must_use]
    pub fn nodes(&self) -> &[u32] {
        &self.nodes
    }
}

impl Sums {
    fn add(&mut self, radius: f32, length: f32) {
        let (radius, length) = (f64::from(radius), f64::from(length));
        self.n += 1.0;
        self.radius += radius;
        self.length += length;
        self.radius_length += radius * length;
        self.radius_squared_length += radius * radius * length;
    }

    fn weight(&self, weight: Weight) -> f64 {
        match weight {
            Weight::Unit => 1.0,
            Weight::RadiusTimesLength => self.radius_length,
            Weight::RadiusSquaredTimesLength => self.radius_squared_length,
            // A single node, or several in one place: the length says nothing.
            Weight::Radius if self.n < 2.0 || self.length <= 0.0 => self.radius / self.n.max(1.0),
            Weight::Radius => self.radius_length / self.length,
        }
    }
}
