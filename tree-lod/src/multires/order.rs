//! Paths in the order of their worth (section 4.1.3).

use super::adt::Adt;
use super::density::by_density;
use super::metric::{Metric, Worth, upwards};
use crate::error::Result;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use tree_core::{Control, NO_PARENT};

/// Paths between which cancellation is asked for.
const PATHS_A_CHECK: usize = 4096;

/// All branches, cut into paths: each begins at the root, or stems from a path before it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Paths {
    starts: Vec<u32>,
    branches: Vec<u32>,
}

impl Paths {
    /// None yet, with room for some branches.
    pub(super) fn with_room(n_branches: usize) -> Self {
        Self { starts: vec![0], branches: Vec::with_capacity(n_branches) }
    }

    /// Adds a branch to the path that is being made.
    pub(super) fn push(&mut self, branch: u32) {
        self.branches.push(branch);
    }

    /// The path that is being made ends.
    pub(super) fn end(&mut self) {
        self.starts.push(self.branches.len() as u32);
    }

    /// Asks for cancellation now and then; `n_branches` in all.
    pub(super) fn report(&self, n_branches: usize, control: &Control) -> Result<()> {
        if self.len().is_multiple_of(PATHS_A_CHECK) {
            control.report("paths", self.branches.len() as f32 / n_branches as f32)?;
        }
        Ok(())
    }

    /// Number of paths: levels of detail.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "there is always a path")]
    pub fn len(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// The branches of all paths one after another: those of the first `k` paths are a prefix.
    #[must_use]
    pub fn branches(&self) -> &[u32] {
        &self.branches
    }

    /// The branches of a path, from its fork up; empty for one that is not there.
    #[must_use]
    pub fn path(&self, path: usize) -> &[u32] {
        match (self.starts.get(path), self.starts.get(path + 1)) {
            (Some(&start), Some(&end)) => &self.branches[start as usize..end as usize],
            _ => &[],
        }
    }

    /// The paths in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        (0..self.len()).map(|path| self.path(path))
    }
}

/// Cuts a tree into paths and sorts them.
///
/// With a branching metric as in the paper: from the root the branch of which most is left is followed
/// until one is met that is in no path; from there a path leads to a tip, always into the child of which most
/// is left; then it is taken off what is left of all branches on the way. Of equals the first in the chain
/// is taken. By density, at each fork a path goes on the way to a tip that has the most worth a branch, and the paths are sorted
/// such that prefixes hold the most worth, on average over their numbers of branches (Horn 1972). With the other metrics
/// the next path begins at the best branch of all that stem from what is there.
///
/// # Errors
/// [`LodError::Length`](crate::LodError::Length) or [`LodError::Parameter`](crate::LodError::Parameter) for worths
/// that do not fit, [`LodError::Cancelled`](crate::LodError::Cancelled).
///
/// # Complexity
/// O(branches + paths · depth · log children) for branching metrics, O(branches · log branches) for the others.
pub fn paths(adt: &Adt, metric: &Metric, control: &Control) -> Result<Paths> {
    match metric.worth(adt)? {
        Worth::Left(worth) => by_what_is_left(adt, &worth, control),
        Worth::Fixed { worth, on } => best_first(adt, &worth, on, control),
        Worth::Density(worth) => by_density(adt, &worth, control),
    }
}

/// Children of each branch in heaps: the one of which most is left comes first.
struct Heaps<'a> {
    adt: &'a Adt,
    /// Children, a heap for each branch.
    children: Vec<u32>,
    /// Worth that is left of each branch and all it bears.
    left: Vec<f64>,
    /// Branches of these that are in no path yet.
    open: Vec<u32>,
}

impl<'a> Heaps<'a> {
    fn new(adt: &'a Adt, worth: &[f64]) -> Self {
        let mut left = worth.to_vec();
        upwards(adt, |child, parent| left[parent] += left[child]);
        let mut open = vec![1_u32; adt.len()];
        upwards(adt, |child, parent| open[parent] += open[child]);
        let mut heaps = Self { adt, children: adt.children.clone(), left, open };
        for branch in 0..adt.len() {
            for at in (0..heaps.row(branch).len() / 2).rev() {
                heaps.sift(branch, at);
            }
        }
        heaps
    }

    fn row(&self, branch: usize) -> std::ops::Range<usize> {
        self.adt.child_starts[branch] as usize..self.adt.child_starts[branch + 1] as usize
    }

    /// The child of which most is left, if any is.
    fn best(&self, branch: u32) -> Option<u32> {
        let best = self.children[self.row(branch as usize)].first().copied()?;
        (self.open[best as usize] > 0).then_some(best)
    }

    /// Whether `a` goes before `b`: some of it is left, more is left, it comes first.
    fn before(&self, a: u32, b: u32) -> bool {
        let of = |branch: u32| (self.open[branch as usize] > 0, self.left[branch as usize]);
        let ((open_a, a_left), (open_b, b_left)) = (of(a), of(b));
        open_b.cmp(&open_a).then(b_left.total_cmp(&a_left)).then(a.cmp(&b)).is_lt()
    }

    /// Lets a child that has become worth less sink in its parent's heap.
    fn sift(&mut self, parent: usize, mut at: usize) {
        let row = self.row(parent);
        let place = |i: usize| row.start + i;
        loop {
            let mut first = at;
            for child in [2 * at + 1, 2 * at + 2] {
                let is_there = child < row.len();
                if is_there && self.before(self.children[place(child)], self.children[place(first)])
                {
                    first = child;
                }
            }
            if first == at {
                return;
            }
            self.children.swap(place(at), place(first));
            at = first;
        }
    }
}

fn by_what_is_left(adt: &Adt, worth: &[f64], control: &Control) -> Result<Paths> {
    let mut heaps = Heaps::new(adt, worth);
    let mut taken = vec![false; adt.len()];
    let mut found = Paths::with_room(adt.len());
    // From the root to the end of the path, all firsts of their heaps.
    let mut way = Vec::new();
    while heaps.open[0] > 0 {
        found.report(adt.len(), control)?;
        way.clear();
        way.push(0);
        let mut at = 0;
        while taken[at as usize] {
            // What is open has an open child, or is not taken.
            let Some(best) = heaps.best(at) else { break };
            way.push(best);
            at = best;
        }
        let first = way.len() - 1;
        taken[at as usize] = true;
        while let Some(next) = heaps.best(at).filter(|&next| adt.is_at_end(next)) {
            taken[next as usize] = true;
            way.push(next);
            at = next;
        }
        found.branches.extend_from_slice(&way[first..]);
        found.end();
        let (mut n, mut sum) = (0, 0.0);
        for (i, &branch) in way.iter().enumerate().rev() {
            if i >= first {
                n += 1;
                sum += worth[branch as usize];
            }
            heaps.open[branch as usize] -= n;
            heaps.left[branch as usize] -= sum;
            let parent = adt.parents[branch as usize];
            if parent != NO_PARENT {
                heaps.sift(parent as usize, 0);
            }
        }
    }
    Ok(found)
}

/// A worth that sorts.
#[derive(PartialEq)]
pub(super) struct Key(pub(super) f64);

impl Eq for Key {}

impl PartialOrd for Key {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Key {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

fn best_first(adt: &Adt, worth: &[f64], on: bool, control: &Control) -> Result<Paths> {
    let mut found = Paths::with_room(adt.len());
    let key = |branch: u32| (Key(worth[branch as usize]), Reverse(branch));
    let mut heap = BinaryHeap::from([key(0)]);
    while let Some((_, Reverse(branch))) = heap.pop() {
        found.report(adt.len(), control)?;
        let mut at = Some(branch);
        while let Some(branch) = at {
            found.push(branch);
            let children = adt.children(branch);
            let fits = |child: &&u32| on && adt.is_at_end(**child);
            at = children.iter().filter(fits).copied().max_by_key(|&child| key(child));
            heap.extend(children.iter().filter(|&&child| at != Some(child)).map(|&c| key(c)));
        }
        found.end();
    }
    Ok(found)
}
