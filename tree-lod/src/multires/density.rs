//! Paths by density: most worth for each branch that is drawn.
//!
//! At each fork a path goes on the way to a tip that has the most worth a branch. Paths then come as Horn (1972,
//! "Single-machine job sequencing with treelike precedence ordering and linear delay penalties", SIAM Journal on Applied
//! Mathematics 23) sorts jobs: the block of most worth a branch is joined to the block that bears it, again and again. Of all
//! orders of these paths this one has the largest mean worth of its prefixes, where branches are counted: a thin limb that
//! bears a dense crown comes before a thicker one that bears nothing.

use super::adt::Adt;
use super::order::{Key, Paths};
use crate::error::Result;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use tree_core::Control;

/// No branch.
const NONE: u32 = u32::MAX;
/// Blocks between which cancellation is asked for.
const BLOCKS_A_CHECK: usize = 65_536;

/// Paths to tips, along the way of most worth a branch at each fork, in the order of [`densest`].
pub(super) fn by_density(adt: &Adt, worth: &[f64], control: &Control) -> Result<Paths> {
    let on = ways(adt, worth);
    // Jobs are paths, named in the order of their first branches.
    let (mut firsts, mut parents) = (Vec::new(), Vec::new());
    let (mut sums, mut counts) = (Vec::new(), Vec::new());
    let mut job_of = vec![NONE; adt.len()];
    for (branch, &parent) in (0..).zip(&adt.parents) {
        let job = match on.get(parent as usize) {
            Some(&next) if next == branch => job_of[parent as usize],
            _ => {
                firsts.push(branch);
                parents.push(job_of.get(parent as usize).copied().unwrap_or(NONE));
                sums.push(0.0);
                counts.push(0.0);
                firsts.len() as u32 - 1
            }
        };
        job_of[branch as usize] = job;
        sums[job as usize] += worth[branch as usize];
        counts[job as usize] += 1.0;
    }
    let mut found = Paths::with_room(adt.len());
    for job in densest(&parents, sums, counts, control)? {
        found.report(adt.len(), control)?;
        let mut at = firsts[job as usize];
        while at != NONE {
            found.push(at);
            at = on[at as usize];
        }
        found.end();
    }
    Ok(found)
}

/// For each branch the child at its end from which the way to a tip has the most worth a branch.
fn ways(adt: &Adt, worth: &[f64]) -> Vec<u32> {
    let mut on = vec![NONE; adt.len()];
    // Worth and number of branches of the way on from each branch.
    let mut beyond = vec![(0.0, 0.0); adt.len()];
    for branch in (1..adt.len()).rev() {
        let parent = adt.parents[branch] as usize;
        if !adt.is_at_end(branch as u32) {
            continue;
        }
        let (sum, count) = beyond[branch];
        let (sum, count): (f64, f64) = (sum + worth[branch], count + 1.0);
        // Of equals the first in the chain.
        if on[parent] == NONE || sum / count >= beyond[parent].0 / beyond[parent].1 {
            on[parent] = branch as u32;
            beyond[parent] = (sum, count);
        }
    }
    on
}

/// Jobs, parents before their children, so that beginnings of the sequence hold the most worth (`sums`) on average over
/// their lengths (`counts`).
fn densest(
    parents: &[u32],
    sums: Vec<f64>,
    counts: Vec<f64>,
    control: &Control,
) -> Result<Vec<u32>> {
    let n = parents.len();
    let mut blocks = Blocks::new(sums, counts);
    let mut heap: BinaryHeap<_> = (1..n as u32).map(|job| blocks.key(job)).collect();
    let mut n_joined = 0;
    while let Some((density, Reverse(head))) = heap.pop() {
        // A block that has grown since is there once more.
        if blocks.is_joined(head) || blocks.key(head).0 != density {
            continue;
        }
        if n_joined % BLOCKS_A_CHECK == 0 {
            control.report("density", n_joined as f32 / n as f32)?;
        }
        n_joined += 1;
        let to = blocks.join(parents[head as usize], head);
        if to != 0 {
            heap.push(blocks.key(to));
        }
    }
    Ok(blocks.order())
}

/// Jobs that are done one right after another; each block is named by its first.
struct Blocks {
    sums: Vec<f64>,
    counts: Vec<f64>,
    /// The block that a job is in, or on the way to it.
    heads: Vec<u32>,
    /// What comes next in the block.
    next: Vec<u32>,
    /// The last of each block.
    last: Vec<u32>,
}

impl Blocks {
    /// Each job for itself.
    fn new(sums: Vec<f64>, counts: Vec<f64>) -> Self {
        let alone: Vec<u32> = (0..sums.len() as u32).collect();
        let next = vec![NONE; sums.len()];
        Self { sums, counts, heads: alone.clone(), next, last: alone }
    }

    /// The densest comes first, of equals the first in the chain.
    fn key(&self, head: u32) -> (Key, Reverse<u32>) {
        let at = head as usize;
        (Key(self.sums[at] / self.counts[at]), Reverse(head))
    }

    fn is_joined(&self, head: u32) -> bool {
        self.heads[head as usize] != head
    }

    /// The block that a job is in.
    fn head(&mut self, mut job: u32) -> u32 {
        while self.is_joined(job) {
            let up = self.heads[self.heads[job as usize] as usize];
            self.heads[job as usize] = up;
            job = up;
        }
        job
    }

    /// Puts a block right behind that of the parent, and tells which that is.
    fn join(&mut self, parent: u32, head: u32) -> u32 {
        let to = self.head(parent);
        let (block, bearer) = (head as usize, to as usize);
        self.heads[block] = to;
        self.next[self.last[bearer] as usize] = head;
        self.last[bearer] = self.last[block];
        self.sums[bearer] += self.sums[block];
        self.counts[bearer] += self.counts[block];
        to
    }

    /// The jobs of the root's block.
    fn order(&self) -> Vec<u32> {
        let mut order = Vec::with_capacity(self.next.len());
        let mut at = 0;
        while at != NONE {
            order.push(at);
            at = self.next[at as usize];
        }
        order
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::multires::Token;
    use proptest::prelude::*;

    /// A tree of branches; each stems from the end of its parent. `parents` are taken modulo what is there.
    fn tree(parents: &[usize]) -> Adt {
        let mut children = vec![Vec::new(); parents.len() + 1];
        for (child, parent) in (1..).zip(parents) {
            children[parent % child].push(child);
        }
        fn write(branch: usize, children: &[Vec<usize>], tokens: &mut Vec<Token>) {
            tokens.push(Token::Module(1.0));
            for &child in &children[branch] {
                tokens.push(Token::Push);
                write(child, children, tokens);
                tokens.push(Token::Pop);
            }
        }
        let mut tokens = Vec::new();
        write(0, &children, &mut tokens);
        Adt::of_tokens(tokens).unwrap()
    }

    /// Each branch a job.
    fn order(adt: &Adt, worth: &[f64]) -> Vec<u32> {
        let counts = vec![1.0; adt.len()];
        densest(&adt.parents, worth.to_vec(), counts, &Control::default()).unwrap()
    }

    /// Worths of all prefixes together.
    fn of_prefixes(order: &[u32], worth: &[f64]) -> f64 {
        let held = order.iter().scan(0.0, |held, &branch| {
            *held += worth[branch as usize];
            Some(*held)
        });
        held.sum()
    }

    /// The most that any order can have, parents first.
    fn best(adt: &Adt, worth: &[f64], order: &mut Vec<u32>) -> f64 {
        if order.len() == adt.len() {
            return of_prefixes(order, worth);
        }
        let mut most = f64::MIN;
        for branch in 0..adt.len() as u32 {
            let parent = adt.parents[branch as usize];
            if !order.contains(&branch) && (branch == 0 || order.contains(&parent)) {
                order.push(branch);
                most = most.max(best(adt, worth, order));
                order.pop();
            }
        }
        most
    }

    #[test]
    fn a_twig_that_bears_much_comes_before_a_thick_one_that_bears_nothing() {
        // The root bears 1, which bears 2 and 3, and 4.
        let adt = tree(&[0, 1, 1, 0]);
        assert_eq!(order(&adt, &[1.0, 0.1, 5.0, 4.0, 2.0]), [0, 1, 2, 3, 4]);
        let paths = by_density(&adt, &[1.0, 0.1, 5.0, 1.0, 2.0], &Control::default()).unwrap();
        assert_eq!(paths.iter().collect::<Vec<_>>(), [&[0, 1, 2][..], &[4], &[3]]);
    }

    proptest! {
        #[test]
        fn no_order_has_more_in_its_prefixes(
            parents in proptest::collection::vec(0..8_usize, 0..7),
            worth in proptest::collection::vec(0..20_u32, 8),
        ) {
            let adt = tree(&parents);
            let worth: Vec<f64> = worth[..adt.len()].iter().map(|&w| w.into()).collect();
            let order = order(&adt, &worth);
            let mut sorted = order.clone();
            sorted.sort_unstable();
            prop_assert!(sorted.iter().copied().eq(0..adt.len() as u32));
            let at = |branch: u32| order.iter().position(|&b| b == branch);
            for branch in 1..adt.len() as u32 {
                prop_assert!(at(adt.parents[branch as usize]) < at(branch));
            }
            prop_assert_eq!(of_prefixes(&order, &worth), best(&adt, &worth, &mut Vec::new()));
        }

        #[test]
        fn paths_go_on_to_tips(parents in proptest::collection::vec(0..60_usize, 0..60)) {
            let adt = tree(&parents);
            let worth: Vec<f64> = (0..adt.len()).map(|b| (b % 7) as f64).collect();
            let paths = by_density(&adt, &worth, &Control::default()).unwrap();
            for path in paths.iter() {
                prop_assert!(adt.children(*path.last().unwrap()).is_empty());
                prop_assert!(path.windows(2).all(|pair| adt.parents[pair[1] as usize] == pair[0]));
            }
        }
    }
}
