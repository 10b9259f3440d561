//! A tree whose levels are prefixes of its columns.

use super::adt::Adt;
use super::metric::Metric;
use super::order::{Paths, paths};
use crate::error::{LodError, Result};
use glam::{Quat, Vec3};
use tree_core::{Control, Foliage, NO_PARENT, Skeleton, Tree};

/// A tree with its nodes and leaves sorted path by path: the first levels are its coarser forms.
///
/// Its size is that of the tree and 16 bytes a level. A level is found in O(1), nothing is copied.
///
/// ```
/// use tree_core::{Control, Skeleton, Species, Tree, glam::Vec3};
/// use tree_lod::multires::{Metric, Multires};
/// let mut skeleton = Skeleton::builder(Vec3::ZERO, 0.3)?;
/// let fork = skeleton.add(0, Vec3::Y, 0.2)?;
/// skeleton.add(fork, Vec3::new(0.1, 1.5, 0.0), 0.1)?;
/// skeleton.add(fork, Vec3::new(-1.0, 2.0, 0.0), 0.1)?;
/// let tree = Tree::bare(skeleton.finish(), Species::default());
/// let multires = Multires::new(&tree, &Metric::default(), &Control::default())?;
/// // The trunk goes on into the longer branch.
/// assert_eq!(multires.n_levels(), 2);
/// assert_eq!(multires.level(1).positions, [Vec3::ZERO, Vec3::Y, Vec3::new(-1.0, 2.0, 0.0)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Multires {
    tree: Tree,
    ends: Vec<End>,
}

/// Where a level ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct End {
    pub(super) nodes: u32,
    pub(super) leaves: u32,
}

/// What is drawn of a tree: slices of its columns. The nodes are a skeleton, the leaves stand on them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level<'a> {
    /// Node positions in metres.
    pub positions: &'a [Vec3],
    /// Node radii in metres.
    pub radii: &'a [f32],
    /// Parent of each node; [`NO_PARENT`] for node 0.
    pub parents: &'a [u32],
    /// The node that bears each leaf.
    pub leaf_nodes: &'a [u32],
    /// Base of each blade in metres.
    pub leaf_positions: &'a [Vec3],
    /// Each leaf's turn from its own frame into the tree's.
    pub leaf_rotations: &'a [Quat],
    /// Length of each leaf in metres.
    pub leaf_sizes: &'a [f32],
    /// Kind of each leaf.
    pub leaf_kinds: &'a [u16],
}

/// Which rows of the tree that came in became which.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Rows {
    /// For each node its number in the tree that came in.
    pub nodes: Vec<u32>,
    /// For each leaf its number in the tree that came in.
    pub leaves: Vec<u32>,
}

impl Multires {
    /// Sorts a tree by a metric. The branches of [`Metric::Branching`] are those of [`Adt::of_skeleton`].
    ///
    /// # Errors
    /// As [`paths`].
    ///
    /// # Complexity
    /// As [`paths`], and O(nodes + leaves).
    pub fn new(tree: &Tree, metric: &Metric, control: &Control) -> Result<Self> {
        let adt = Adt::of_tree(tree);
        let paths = paths(&adt, metric, control)?;
        Ok(Self::of_paths(tree, &adt, &paths)?.0)
    }

    /// Sorts a tree by paths of its branches, which must all be there; tells with it where rows went.
    ///
    /// # Errors
    /// [`LodError::Order`] when the paths are those of another tree.
    ///
    /// # Complexity
    /// O(nodes + leaves).
    pub fn of_paths(tree: &Tree, adt: &Adt, paths: &Paths) -> Result<(Self, Rows)> {
        let skeleton = tree.skeleton();
        let mut nodes = Vec::with_capacity(skeleton.len());
        let mut node_ends = Vec::with_capacity(paths.len());
        for path in paths.iter() {
            path.iter().for_each(|&branch| nodes.extend_from_slice(adt.modules(branch)));
            node_ends.push(nodes.len() as u32);
        }
        let mut now = vec![NO_PARENT; skeleton.len()];
        for (new, &old) in nodes.iter().enumerate() {
            match now.get_mut(old as usize) {
                Some(place) if *place == NO_PARENT => *place = new as u32,
                _ => return Err(LodError::Order { row: new, problem: "of another tree" }),
            }
        }
        if nodes.len() != skeleton.len() {
            return Err(LodError::Order { row: nodes.len(), problem: "a branch is missing" });
        }
        let old = skeleton.parents();
        check_paths(&nodes, &node_ends, old, &now)?;
        let parents = nodes.iter().map(|&node| match old[node as usize] {
            NO_PARENT => NO_PARENT,
            parent => now[parent as usize],
        });
        let sorted = Skeleton::from_columns(
            nodes.iter().map(|&node| skeleton.positions()[node as usize]).collect(),
            nodes.iter().map(|&node| skeleton.radii()[node as usize]).collect(),
            parents.collect(),
        )?;
        let (foliage, leaves) = sorted_leaves(tree.foliage(), &now)?;
        let ends = ends(&node_ends, foliage.nodes());
        let tree = Tree::new(sorted, foliage, tree.species().clone())?;
        Ok((Self { tree, ends }, Rows { nodes, leaves }))
    }

    /// Of parts that are in order already.
    pub(super) fn of_parts(tree: Tree, ends: Vec<End>) -> Self {
        Self { tree, ends }
    }

    /// The whole tree, nodes and leaves sorted.
    #[must_use]
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// Number of levels: of tips, at least 1.
    #[must_use]
    pub fn n_levels(&self) -> usize {
        self.ends.len()
    }

    /// Nodes and leaves of the first `n` levels, at least one, at most all.
    #[must_use]
    pub fn counts(&self, n: usize) -> (usize, usize) {
        let last = n.clamp(1, self.ends.len().max(1)) - 1;
        let end = self.ends.get(last).copied().unwrap_or_default();
        (end.nodes as usize, end.leaves as usize)
    }

    /// The first `n` levels, at least one, at most all.
    ///
    /// # Complexity
    /// O(1).
    #[must_use]
    pub fn level(&self, n: usize) -> Level<'_> {
        let (nodes, leaves) = self.counts(n);
        let (skeleton, foliage) = (self.tree.skeleton(), self.tree.foliage());
        Level {
            positions: &skeleton.positions()[..nodes],
            radii: &skeleton.radii()[..nodes],
            parents: &skeleton.parents()[..nodes],
            leaf_nodes: &foliage.nodes()[..leaves],
            leaf_positions: &foliage.positions()[..leaves],
            leaf_rotations: &foliage.rotations()[..leaves],
            leaf_sizes: &foliage.sizes()[..leaves],
            leaf_kinds: &foliage.kinds()[..leaves],
        }
    }

    /// A copy of the first `n` levels as a tree of its own.
    ///
    /// # Errors
    /// None that is known; the columns are checked again.
    ///
    /// # Complexity
    /// O(nodes + leaves).
    pub fn tree_at(&self, n: usize) -> Result<Tree> {
        let level = self.level(n);
        let skeleton = Skeleton::from_columns(
            level.positions.to_vec(),
            level.radii.to_vec(),
            level.parents.to_vec(),
        )?;
        let mut foliage = Foliage::with_capacity(level.leaf_nodes.len());
        for leaf in self.tree.foliage().iter().take(level.leaf_nodes.len()) {
            foliage.push(leaf)?;
        }
        Ok(Tree::new(skeleton, foliage, self.tree.species().clone())?)
    }

    /// The level with the most nodes of those with at most `nodes`; the first if none has so few.
    ///
    /// # Complexity
    /// O(log levels).
    #[must_use]
    pub fn level_of_nodes(&self, nodes: usize) -> usize {
        self.ends.partition_point(|end| end.nodes as usize <= nodes).max(1)
    }
}

/// Checks that every path is a line of nodes, and stems from a node before it.
fn check_paths(nodes: &[u32], ends: &[u32], parents: &[u32], now: &[u32]) -> Result<()> {
    let mut first = 0;
    for &end in ends {
        if end <= first {
            return Err(LodError::Order { row: first as usize, problem: "a path without nodes" });
        }
        for new in first..end {
            let stands = match now.get(parents[nodes[new as usize] as usize] as usize) {
                None => new == 0,
                Some(&parent) if new == first => parent < new,
                Some(&parent) => parent + 1 == new,
            };
            if !stands {
                let problem = "a node does not follow its parent: these are paths of another tree";
                return Err(LodError::Order { row: new as usize, problem });
            }
        }
        first = end;
    }
    Ok(())
}

/// Leaves in the order of their nodes, those of one node as they were; and where they come from.
fn sorted_leaves(foliage: &Foliage, now: &[u32]) -> Result<(Foliage, Vec<u32>)> {
    let mut rows: Vec<u32> = (0..foliage.len() as u32).collect();
    rows.sort_by_key(|&row| now[foliage.nodes()[row as usize] as usize]);
    let mut sorted = Foliage::with_capacity(foliage.len());
    for leaf in rows.iter().filter_map(|&row| foliage.get(row as usize)) {
        sorted.push(tree_core::Leaf { node: now[leaf.node as usize], ..leaf })?;
    }
    Ok((sorted, rows))
}

fn ends(node_ends: &[u32], leaf_nodes: &[u32]) -> Vec<End> {
    let leaves = |nodes: u32| leaf_nodes.partition_point(|&node| node < nodes) as u32;
    node_ends.iter().map(|&nodes| End { nodes, leaves: leaves(nodes) }).collect()
}
