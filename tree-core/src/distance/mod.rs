//! How different two trees are: the constrained edit distance between unordered rooted trees.
//!
//! The least cost of deleting, inserting and changing nodes that turns one tree into the other, where
//! disjoint subtrees must go to disjoint subtrees (Zhang 1996, *A constrained edit distance between
//! unordered labeled trees*). Plants are compared so since Ferraro & Godin (2000); Pirk et al. (2012,
//! section 6) make each operation cost as much as the branch is thick. Without the constraint the
//! problem is NP-hard.
//!
//! 1. [`EditTree`]: a skeleton, or what is left of it when each unbranched run or each axis becomes one
//!    node ([`Reduction`]), with a weight for every node ([`Weight`]).
//! 2. [`distance_of`]: Zhang's recurrences over all pairs of nodes, children first. What two forests
//!    of siblings cost is a matching of least cost ([`assignment`](crate::assignment)).
//! 3. The pairs of nodes that are changed into one another, by following the choices back.
//!
//! Deleting and inserting cost a node's weight, changing costs the difference of the weights, so the
//! distance is a metric on trees with weights. Any other cost comes in by [`EditCosts`].
//!
//! Departures: the matching is solved on the dense matrix of the children, and directly where one side
//! has at most two. That stays within the bound of the paper's min-cost flow and is faster for trees.
//! The normalised distance is Steinhaus' transform, which keeps the triangle inequality; Ferraro &
//! Godin divide by the sum of the sizes, which does not.

mod costs;
mod matching;
mod reduce;
mod table;
#[cfg(test)]
mod tests;
mod trace;

pub use costs::{EditCosts, Weight};
pub use reduce::{EditTree, Reduction};

use crate::control::Control;
use crate::error::Result;
use crate::skeleton::Skeleton;
use costs::Difference;
use table::Table;

/// How trees are compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct EditParams {
    /// What a node weighs. Default [`Weight::Radius`].
    pub weight: Weight,
    /// What becomes one node. Default [`Reduction::Runs`].
    pub reduction: Reduction,
    /// Whether the pairs of nodes are wanted: takes memory for every pair of nodes, without them a few
    /// rows are enough. Default false.
    pub mapping: bool,
}

/// How far apart two trees are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EditDistance {
    /// The least cost, in the unit of the weights.
    pub value: f64,
    /// 2 d / (a + b + d) for the weights a and b of the trees, 0 to 1: 0 for equal trees, 1 where nothing
    /// of one is left in the other. A metric, too.
    pub normalized: f64,
    /// What deleting the first tree and what inserting the second costs.
    pub weights: [f64; 2],
    /// Nodes compared, after the reduction.
    pub n_nodes: [usize; 2],
    /// The nodes changed into one another, as indices into the two skeletons (of [`EditTree`]s into
    /// these), by the first; empty unless asked for.
    pub mapping: Vec<[u32; 2]>,
}

/// The distance between two skeletons.
///
/// ```
/// use tree_core::distance::{EditParams, distance};
/// use tree_core::{Control, Skeleton, glam::Vec3};
/// let mut builder = Skeleton::builder(Vec3::ZERO, 0.2)?;
/// let fork = builder.add(0, Vec3::Y, 0.2)?;
/// builder.add(fork, Vec3::new(1.0, 2.0, 0.0), 0.1)?;
/// let one = builder.clone().finish();
/// builder.add(fork, Vec3::new(-1.0, 2.0, 0.0), 0.1)?;
/// let two = builder.finish();
/// let found = distance(&one, &two, &EditParams::default(), &Control::default())?;
/// assert!(found.value > 0.0 && found.normalized < 1.0);
/// # Ok::<(), tree_core::CoreError>(())
/// ```
///
/// # Errors
/// [`CoreError::Limit`](crate::CoreError::Limit) where more pairs of nodes would be kept than
/// [`Limits::pairs`](crate::Limits::pairs) allows; [`CoreError::Cancelled`](crate::CoreError::Cancelled).
///
/// # Complexity
/// O(n₁ n₂ min(d₁, d₂)) time for n nodes after the reduction with at most d children, within Zhang's
/// O(n₁ n₂ (d₁ + d₂) log(d₁ + d₂)). 16 bytes for each node of the second tree times the nodes of the first
/// that wait for a sibling; for every pair of nodes when the mapping is asked for.
pub fn distance(
    first: &Skeleton,
    second: &Skeleton,
    params: &EditParams,
    control: &Control,
) -> Result<EditDistance> {
    let first = EditTree::of(first, params);
    let second = EditTree::of(second, params);
    let mut found = distance_of(&first, &second, params.mapping, control)?;
    for [a, b] in &mut found.mapping {
        *a = first.nodes().get(*a as usize).copied().unwrap_or(*a);
        *b = second.nodes().get(*b as usize).copied().unwrap_or(*b);
    }
    found.mapping.sort_unstable();
    Ok(found)
}

/// The distance between two trees with weights: for many comparisons with the same tree, or trees that are
/// no skeletons.
///
/// # Errors
/// As [`distance`].
///
/// # Complexity
/// As [`distance`].
pub fn distance_of(
    first: &EditTree,
    second: &EditTree,
    mapping: bool,
    control: &Control,
) -> Result<EditDistance> {
    let costs = Difference { first: first.weights(), second: second.weights() };
    distance_with(first, second, &costs, mapping, control)
}

/// The distance under any local costs; the weights of the trees are not looked at.
///
/// With costs that are negative or not finite the value is what the recurrences make of them.
///
/// # Errors
/// As [`distance`].
///
/// # Complexity
/// As [`distance`]; `costs` is asked once for every pair of nodes.
pub fn distance_with(
    first: &EditTree,
    second: &EditTree,
    costs: &impl EditCosts,
    mapping: bool,
    control: &Control,
) -> Result<EditDistance> {
    let table = Table::fill(first, second, costs, mapping, control)?;
    let value = table.value();
    let weights = table.weights();
    let sum = weights[0] + weights[1] + value;
    Ok(EditDistance {
        value,
        normalized: if sum > 0.0 { 2.0 * value / sum } else { 0.0 },
        weights,
        n_nodes: [first.len(), second.len()],
        mapping: if mapping { table.trace() } else { Vec::new() },
    })
}
