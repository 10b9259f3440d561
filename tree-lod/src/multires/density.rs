//! Paths by density: most worth for each branch that is drawn.
//!
//! The mean worth of all prefixes is the largest when branches come as Horn (1972, "Single-machine job sequencing with
//! treelike precedence ordering and linear delay penalties", SIAM Journal on Applied Mathematics 23) sorts jobs: the
//! block of most worth a branch is joined to the block that bears it, again and again. So a thin twig that bears a dense
//! crown comes before a thicker one that bears nothing. Each path then goes on to a tip.

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

/// Paths to tips in the order of [`densest`], each along what comes first in it.
pub(super) fn by_density(adt: &Adt, worth: &[f64], control: &Control) -> Result<Paths> {
    let order = densest(adt, worth, control)?;
    let mut rank = vec![0_u32; adt.len()];
    order.iter().zip(0..).for_each(|(&branch, at)| rank[branch as usize] = at);
    let mut taken = vec![false; adt.len()];
    let mut found = Paths::with_room(adt.len());
    for first in order {
        if taken[first as usize] {
            continue;
        }
        found.report(adt.len(), control)?;
        let mut at = Some(first);
        while let Some(branch) = at {
            taken[branch as usize] = true;
            found.push(branch);
            let on = adt.children(branch).iter().copied().filter(|&child| adt.is_at_end(child));
            at = on.min_by_key(|&child| rank[child as usize]);
        }
        found.end();
    }
    Ok(found)
}

/// Branches, parents before their children, so that prefixes hold the most worth on average over their lengths.
fn densest(adt: &Adt, worth: &[f64], control: &Control) -> Result<Vec<u32>> {
    let mut blocks = Blocks::new(adt, worth);
    let mut heap: BinaryHeap<_> = (1..adt.len() as u32).map(|b| blocks.key(b)).collect();
    let mut n_joined = 0;
    while let Some((density, Reverse(head))) = heap.pop() {
        // A block that has grown since is there once more.
        if blocks.is_joined(head) || blocks.key(head).0 != density {
            continue;
        }
        if n_joined % BLOCKS_A_CHECK == 0 {
            control.report("density", n_joined as f32 / adt.len() as f32)?;
        }
        n_joined += 1;
        let to = blocks.join(adt, head);
        if to != 0 {
            heap.push(blocks.key(to));
        }
    }
    Ok(blocks.order(adt.len()))
}

/// Branches that are drawn one right after another; each block is named by its first.
struct Blocks {
    sums: Vec<f64>,
    counts: Vec<f64>,
    /// The block that a branch is in, or on the way to it.
    heads: Vec<u32>,
    /// What comes next in the block.
    next: Vec<u32>,
    /// The last of each block.
    last: Vec<u32>,
}

impl Blocks {
    /// Each branch for itself.
    fn new(adt: &Adt, worth: &[f64]) -> Self {
        let alone: Vec<u32> = (0..adt.len() as u32).collect();
        let counts = vec![1.0; adt.len()];
        let next = vec![NONE; adt.len()];
        Self { sums: worth.to_vec(), counts, heads: alone.clone(), next, last: alone }
    }

    /// The densest comes first, of equals the first in the chain.
    fn key(&self, head: u32) -> (Key, Reverse<u32>) {
        let at = head as usize;
        (Key(self.sums[at] / self.counts[at]), Reverse(head))
    }

    fn is_joined(&self, head: u32) -> bool {
        self.heads[head as usize] != head
    }

    /// The block that a branch is in.
    fn head(&mut self, mut branch: u32) -> u32 {
        while self.is_joined(branch) {
            let up = self.heads[self.heads[branch as usize] as usize];
            self.heads[branch as usize] = up;
            branch = up;
        }
        branch
    }

    /// Puts a block right behind the one that bears it, and tells which that is.
    fn join(&mut self, adt: &Adt, head: u32) -> u32 {
        let to = self.head(adt.parents[head as usize]);
        let (block, bearer) = (head as usize, to as usize);
        self.heads[block] = to;
        self.next[self.last[bearer] as usize] = head;
        self.last[bearer] = self.last[block];
        self.sums[bearer] += self.sums[block];
        self.counts[bearer] += self.counts[block];
        to
    }

    /// The branches of the root's block.
    fn order(&self, n: usize) -> Vec<u32> {
        let mut order = Vec::with_capacity(n);
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
        let order = densest(&adt, &[1.0, 0.1, 5.0, 4.0, 2.0], &Control::default()).unwrap();
        assert_eq!(order, [0, 1, 2, 3, 4]);
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
            let order = densest(&adt, &worth, &Control::default()).unwrap();
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
