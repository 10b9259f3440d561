//! What grew.

use tree_core::Tree;

/// How a plan became a tree.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct GrowReport {
    /// Branches of every level, the trunk first.
    pub branches: Vec<u64>,
    /// Of those on the trunk, how many were sketched. The others were added in space.
    pub n_sketched: u64,
    /// Leaves.
    pub n_leaves: u64,
    /// Branches without room in the outline of their parent, which were left out.
    pub n_without_room: u64,
    /// Branches and leaves left out because they would be seen outside the outlines.
    pub n_fenced: u64,
    /// Leaves added where the outlines were empty.
    pub n_filled: u64,
    /// Different patterns that were made.
    pub n_patterns: u64,
}

impl GrowReport {
    /// Leaves and branches together: the paper's count of elements.
    #[must_use]
    pub fn elements(&self) -> u64 {
        self.n_leaves + self.branches.iter().sum::<u64>()
    }
}

/// A tree and how it grew.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Grown {
    /// The tree.
    pub tree: Tree,
    /// Counts.
    pub report: GrowReport,
}
