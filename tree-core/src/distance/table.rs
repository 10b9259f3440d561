//! Zhang's recurrences (1996, section 4): the distances of all pairs of subtrees and of the forests below
//! their roots, children before parents.

use super::costs::EditCosts;
use super::matching::Matcher;
use super::reduce::EditTree;
use crate::control::Control;
use crate::error::Result;
use crate::limits::Resource;
use crate::skeleton::NO_PARENT;

/// Row of a node that is no longer kept.
const NO_ROW: u32 = u32::MAX;

/// Children of every node, and what deleting its tree or its forest costs.
pub(super) struct Side {
    starts: Vec<u32>,
    children: Vec<u32>,
    pub(super) tree: Vec<f64>,
    pub(super) forest: Vec<f64>,
}

/// The distances, and what is needed to follow them back.
pub(super) struct Table<'a, C> {
    pub(super) first: Side,
    pub(super) second: Side,
    pub(super) costs: &'a C,
    /// Where the rows of each node of the first tree stand.
    slots: Vec<u32>,
    trees: Vec<f64>,
    forests: Vec<f64>,
}

impl Side {
    fn new(tree: &EditTree, cost: impl Fn(u32) -> f64) -> Self {
        let parents = tree.parents();
        let n = parents.len();
        let mut starts = vec![0_u32; n + 1];
        for &parent in parents.iter().filter(|&&parent| parent != NO_PARENT) {
            starts[parent as usize + 1] += 1;
        }
        for i in 1..=n {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let mut children = vec![0_u32; n.saturating_sub(1)];
        let (mut trees, mut forests) = (vec![0.0; n], vec![0.0; n]);
        for (node, &parent) in parents.iter().enumerate().skip(1) {
            let slot = &mut next[parent as usize];
            children[*slot as usize] = node as u32;
            *slot += 1;
        }
        for node in (0..n).rev() {
            trees[node] = forests[node] + cost(node as u32);
            if parents[node] != NO_PARENT {
                forests[parents[node] as usize] += trees[node];
            }
        }
        Self { starts, children, tree: trees, forest: forests }
    }

    pub(super) fn len(&self) -> usize {
        self.tree.len()
    }

    pub(super) fn children(&self, node: usize) -> &[u32] {
        &self.children[self.starts[node] as usize..self.starts[node + 1] as usize]
    }

    /// Children before parents, each subtree in one piece, so that few rows wait for a sibling. The
    /// largest subtree comes first: while the others are at work, only its one row waits.
    fn post_order(&self) -> Vec<u32> {
        let mut sizes = vec![1_u32; self.len()];
        for node in (0..self.len()).rev() {
            let below: u32 = self.children(node).iter().map(|&c| sizes[c as usize]).sum();
            sizes[node] += below;
        }
        // The reverse of an order with parents first and the largest child last.
        let mut order = Vec::with_capacity(self.len());
        let mut stack = vec![0_u32];
        while let Some(node) = stack.pop() {
            order.push(node);
            let from = stack.len();
            stack.extend_from_slice(self.children(node as usize));
            stack[from..].sort_by_key(|&child| sizes[child as usize]);
            // The last pushed is visited next, so the smallest must be on top.
            stack[from..].reverse();
        }
        order.reverse();
        order
    }
}

/// Which rows stand where: a row is given back once its parent's is done, unless all are kept.
fn assign_slots(side: &Side, order: &[u32], keep: bool) -> (Vec<u32>, usize) {
    let mut slots = vec![NO_ROW; side.len()];
    let (mut free, mut n_slots) = (Vec::new(), 0_u32);
    for &node in order {
        slots[node as usize] = free.pop().unwrap_or_else(|| {
            n_slots += 1;
            n_slots - 1
        });
        if !keep {
            free.extend(side.children(node as usize).iter().map(|&c| slots[c as usize]));
        }
    }
    (slots, n_slots as usize)
}

impl<'a, C: EditCosts> Table<'a, C> {
    pub(super) fn fill(
        first: &EditTree,
        second: &EditTree,
        costs: &'a C,
        keep: bool,
        control: &Control,
    ) -> Result<Self> {
        control.report("edit distance", 0.0)?;
        let first = Side::new(first, |node| costs.delete(node));
        let second = Side::new(second, |node| costs.insert(node));
        let order = first.post_order();
        let (slots, n_rows) = assign_slots(&first, &order, keep);
        let n_pairs = (n_rows as u64).saturating_mul(second.len() as u64);
        control.limits.check(Resource::Pairs, n_pairs)?;
        let cells = n_rows * second.len();
        let (trees, forests) = (vec![0.0; cells], vec![0.0; cells]);
        let mut table = Self { first, second, costs, slots, trees, forests };
        let mut matcher = Matcher::default();
        for (done, &node) in order.iter().enumerate() {
            if done % 64 == 0 {
                control.report("edit distance", done as f32 / order.len() as f32)?;
            }
            control.check()?;
            table.fill_row(node as usize, &mut matcher);
        }
        Ok(table)
    }

    /// Distance of the whole trees.
    pub(super) fn value(&self) -> f64 {
        self.tree(0, 0)
    }

    /// What deleting the first and inserting the second costs.
    pub(super) fn weights(&self) -> [f64; 2] {
        [self.first.tree[0], self.second.tree[0]]
    }

    #[inline]
    fn at(&self, i: usize, j: usize) -> usize {
        self.slots[i] as usize * self.second.len() + j
    }

    /// D(T₁[i], T₂[j]).
    #[inline]
    pub(super) fn tree(&self, i: usize, j: usize) -> f64 {
        self.trees[self.at(i, j)]
    }

    /// D(F₁[i], F₂[j]).
    #[inline]
    pub(super) fn forest(&self, i: usize, j: usize) -> f64 {
        self.forests[self.at(i, j)]
    }

    fn fill_row(&mut self, i: usize, matcher: &mut Matcher) {
        for j in (0..self.second.len()).rev() {
            let at = self.at(i, j);
            self.forests[at] = self.least_forest(i, j, matcher);
            self.trees[at] = self.least_tree(i, j);
        }
    }

    /// Lemma 4 of the paper: two forests.
    fn least_forest(&self, i: usize, j: usize, matcher: &mut Matcher) -> f64 {
        let (all_first, all_second) = (self.first.forest[i], self.second.forest[j]);
        if self.first.children(i).is_empty() || self.second.children(j).is_empty() {
            return all_first + all_second;
        }
        self.matched(i, j, matcher)
            .min(self.forest_in_second(i, j).0)
            .min(self.forest_in_first(i, j).0)
    }

    /// Lemma 3 of the paper: two trees.
    fn least_tree(&self, i: usize, j: usize) -> f64 {
        let changed = self.forest(i, j) + self.costs.change(i as u32, j as u32);
        changed.min(self.tree_in_second(i, j).0).min(self.tree_in_first(i, j).0)
    }

    /// The siblings below i matched with those below j.
    pub(super) fn matched(&self, i: usize, j: usize, matcher: &mut Matcher) -> f64 {
        let (s, t) = (self.first.children(i), self.second.children(j));
        let saved = matcher.most(s.len(), t.len(), |a, b| self.saving(s[a], t[b]));
        self.first.forest[i] + self.second.forest[j] - saved
    }

    /// What comparing two subtrees saves against deleting one and inserting the other.
    #[inline]
    pub(super) fn saving(&self, s: u32, t: u32) -> f64 {
        let (s, t) = (s as usize, t as usize);
        self.first.tree[s] + self.second.tree[t] - self.tree(s, t)
    }

    /// F₁[i] within the forest of one child of j; all else below j is inserted.
    #[inline]
    pub(super) fn forest_in_second(&self, i: usize, j: usize) -> (f64, u32) {
        least(self.second.children(j), self.second.forest[j], |t| {
            self.forest(i, t) - self.second.forest[t]
        })
    }

    /// F₂[j] within the forest of one child of i; all else below i is deleted.
    #[inline]
    pub(super) fn forest_in_first(&self, i: usize, j: usize) -> (f64, u32) {
        least(self.first.children(i), self.first.forest[i], |s| {
            self.forest(s, j) - self.first.forest[s]
        })
    }

    /// T₁[i] within the tree of one child of j; j and all else below it is inserted.
    #[inline]
    pub(super) fn tree_in_second(&self, i: usize, j: usize) -> (f64, u32) {
        least(self.second.children(j), self.second.tree[j], |t| {
            self.tree(i, t) - self.second.tree[t]
        })
    }

    /// T₂[j] within the tree of one child of i; i and all else below it is deleted.
    #[inline]
    pub(super) fn tree_in_first(&self, i: usize, j: usize) -> (f64, u32) {
        least(self.first.children(i), self.first.tree[i], |s| self.tree(s, j) - self.first.tree[s])
    }
}

/// The least of `all + part(child)`, and which child it is.
#[inline]
fn least(children: &[u32], all: f64, part: impl Fn(usize) -> f64) -> (f64, u32) {
    let mut best = (f64::INFINITY, 0);
    for &child in children {
        let cost = all + part(child as usize);
        if cost < best.0 {
            best = (cost, child);
        }
    }
    best
}
