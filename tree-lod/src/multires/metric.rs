//! What a branch is worth (section 4.1.1).

use super::adt::Adt;
use crate::error::{LodError, Result, check_range};
use tree_core::Seed;

/// How branches are compared.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Metric {
    /// Area shown ([`Adt::areas`]) for each branch that is drawn: a branch comes the earlier, the more it and what it bears show
    /// and the fewer branches that takes. Shows more of the silhouette than all others here. The default.
    #[default]
    Density,
    /// As [`Density`](Self::Density), with these worths in the place of areas, one for each branch, finite and 0 or more.
    DensityOf(Vec<f64>),
    /// Number of children, B(n).
    Children,
    /// Number of descendants, R(n).
    Descendants,
    /// Longest way to a tip, the branch itself included, P(n).
    LongestPath,
    /// Length of the branch and of all that it bears, L(n): what the paper prefers. What has been put
    /// into a path does not count any more (section 4.1.3).
    BranchingLength,
    /// As [`BranchingLength`](Self::BranchingLength), with these worths in the place of lengths, one for each
    /// branch, finite and 0 or more: areas of wood, numbers of leaves.
    Branching(Vec<f64>),
    /// As derivations are undone: branches of low order first, siblings in the order of the chain. For
    /// comparison (section 4.1).
    Generation,
    /// Any branch whose parent is there, by chance. For comparison.
    Random(Seed),
}

/// How the next path is found.
pub(super) enum Worth {
    /// From the root down where most is left; paths are taken off what is left.
    Left(Vec<f64>),
    /// The best of all branches that stem from what is there. `on`: a path goes on to a tip.
    Fixed { worth: Vec<f64>, on: bool },
    /// Most for each branch.
    Density(Vec<f64>),
}

impl Metric {
    /// # Errors
    /// [`LodError::Length`] or [`LodError::Parameter`] for worths that do not fit.
    pub(super) fn worth(&self, adt: &Adt) -> Result<Worth> {
        let n = adt.len();
        let fixed = |worth| Ok(Worth::Fixed { worth, on: true });
        match self {
            Self::Children => fixed((0..n as u32).map(|b| adt.children(b).len() as f64).collect()),
            Self::Descendants => {
                let mut counts = vec![0.0; n];
                upwards(adt, |child, parent| counts[parent] += counts[child] + 1.0);
                fixed(counts)
            }
            Self::LongestPath => {
                let mut longest = vec![0.0_f64; n];
                upwards(adt, |child, parent| {
                    let way = longest[child] + adt.lengths[child];
                    longest[parent] = longest[parent].max(way);
                });
                fixed(longest.iter().zip(&adt.lengths).map(|(below, own)| below + own).collect())
            }
            Self::BranchingLength => Ok(Worth::Left(adt.lengths.clone())),
            Self::Branching(worths) => Ok(Worth::Left(checked(worths, n)?)),
            Self::Density => Ok(Worth::Density(adt.areas.clone())),
            Self::DensityOf(worths) => Ok(Worth::Density(checked(worths, n)?)),
            Self::Generation => {
                let mut orders = vec![0.0; n];
                for branch in 1..n {
                    orders[branch] = orders[adt.parents[branch] as usize] - 1.0;
                }
                Ok(Worth::Fixed { worth: orders, on: false })
            }
            Self::Random(seed) => {
                let seed = seed.stream("multires");
                let worth = (0..n as u64).map(|branch| seed.unit(branch).into()).collect();
                Ok(Worth::Fixed { worth, on: false })
            }
        }
    }
}

/// A worth for each branch.
fn checked(worths: &[f64], n_branches: usize) -> Result<Vec<f64>> {
    if worths.len() != n_branches {
        let (found, expected) = (worths.len(), n_branches);
        return Err(LodError::Length { what: "worths of branches", found, expected });
    }
    for &worth in worths {
        check_range("worth of a branch", worth, 0.0, 1e30)?;
    }
    Ok(worths.to_vec())
}

/// Children before their parents: parents come first in the columns.
pub(super) fn upwards(adt: &Adt, mut visit: impl FnMut(usize, usize)) {
    for child in (1..adt.len()).rev() {
        visit(child, adt.parents[child] as usize);
    }
}
