//! Orders of branches, and worths for them.

use super::Outcome;
use super::parts::{Masks, Parts};
use rayon::prelude::*;
use std::collections::BinaryHeap;
use tree_core::{Control, NO_PARENT, Seed, Tree};
use tree_lod::cover::Around;
use tree_lod::multires::{Adt, Metric, paths};

/// An order of the branches of a tree: what a prefix of it draws.
pub(super) struct Order {
    pub(super) name: &'static str,
    pub(super) branches: Vec<u32>,
}

/// Views that worths by pixels are measured with; none of those that quality is measured with.
fn training() -> Around {
    Around { azimuths: 4, turn: 0.1, size: 256, ..Around::default() }
}

/// The paper's metrics and those it is compared with, then ours.
pub(super) fn all(tree: &Tree, adt: &Adt, parts: &Parts) -> Outcome<Vec<Order>> {
    let control = Control::default();
    let by = |name, metric: &Metric| -> Outcome<Order> {
        Ok(Order { name, branches: paths(adt, metric, &control)?.branches().to_vec() })
    };
    let area = areas(tree, adt);
    let (shared, lists) = pixels(adt, parts)?;
    let leafy = leaf_areas(tree, adt, &area);
    let between: Vec<f64> =
        area.iter().zip(adt.lengths()).map(|(a, length)| (a * length).sqrt()).collect();
    let mut orders = vec![
        by("branching length", &Metric::BranchingLength)?,
        by("children", &Metric::Children)?,
        by("descendants", &Metric::Descendants)?,
        by("longest path", &Metric::LongestPath)?,
        by("undone derivations", &Metric::Generation)?,
        by("random", &Metric::Random(Seed(5)))?,
        by("branching area", &Metric::Branching(area.clone()))?,
        by("branching area + leaves", &Metric::Branching(leafy.clone()))?,
        by("branching visible pixels", &Metric::Branching(shared.clone()))?,
    ];
    let mut ours = |name, branches| orders.push(Order { name, branches });
    ours("densest, length", densest(adt, adt.lengths()));
    ours("densest, between", densest(adt, &between));
    ours("densest, area", densest(adt, &area));
    ours("densest, area + leaves", densest(adt, &leafy));
    ours("densest, visible pixels", densest(adt, &shared));
    ours("paths of most between", best_paths(adt, &between, false));
    ours("paths of densest area", best_paths(adt, &area, true));
    ours("paths of densest area + leaves", best_paths(adt, &leafy, true));
    ours("densest, area, tips", to_tips(adt, &densest(adt, &area)));
    ours("greedy by new pixels", greedy(adt, &lists));
    Ok(orders)
}

/// Projected area of the wood of each branch in m², seen from the side: length × diameter.
fn areas(tree: &Tree, adt: &Adt) -> Vec<f64> {
    let skeleton = tree.skeleton();
    let of = |&node: &u32| {
        let node = node as usize;
        let parent = skeleton.parents()[node];
        if parent == NO_PARENT {
            return 0.0;
        }
        let length = skeleton.positions()[node].distance(skeleton.positions()[parent as usize]);
        f64::from(length * (skeleton.radii()[node] + skeleton.radii()[parent as usize]))
    };
    (0..adt.len() as u32).map(|branch| adt.modules(branch).iter().map(of).sum()).collect()
}

/// Areas of wood with those of the leaves each branch bears.
fn leaf_areas(tree: &Tree, adt: &Adt, wood: &[f64]) -> Vec<f64> {
    let mut branch_of = vec![0_u32; tree.skeleton().len()];
    for branch in 0..adt.len() as u32 {
        adt.modules(branch).iter().for_each(|&node| branch_of[node as usize] = branch);
    }
    let mut areas = wood.to_vec();
    for leaf in tree.foliage().iter() {
        areas[branch_of[leaf.node as usize] as usize] += 0.25 * f64::from(leaf.size * leaf.size);
    }
    areas
}

/// Pixels of each branch in the training views: a list for each, and the sum in which a pixel that `n`
/// branches cover counts 1/n for each.
fn pixels(adt: &Adt, parts: &Parts) -> Outcome<(Vec<f64>, Vec<Vec<u32>>)> {
    let around = training();
    let masks = Masks::new(&parts.mesh, &around)?;
    let of = |branch: u32| -> Result<Vec<u32>, String> {
        let Some(mesh) = parts.one(branch) else { return Ok(Vec::new()) };
        let bits = masks.of(&mesh).map_err(|error| error.to_string())?;
        let mut list = Vec::new();
        let mut at = 0;
        for row in bits.iter().flat_map(tree_lod::cover::Bits::rows) {
            for &word in row {
                let mut word = word;
                while word != 0 {
                    list.push(at + word.trailing_zeros());
                    word &= word - 1;
                }
                at += 64;
            }
        }
        Ok(list)
    };
    let lists: Result<Vec<_>, String> = (0..adt.len() as u32).into_par_iter().map(of).collect();
    let lists = lists?;
    let mut counts = vec![0_u32; (around.azimuths * around.size * around.size) as usize];
    lists.iter().flatten().for_each(|&pixel| counts[pixel as usize] += 1);
    let share = |list: &Vec<u32>| list.iter().map(|&p| 1.0 / f64::from(counts[p as usize])).sum();
    Ok((lists.iter().map(share).collect(), lists))
}

#[derive(Clone, Copy, PartialEq)]
struct Key(f64, u32);

impl Eq for Key {}
impl PartialOrd for Key {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Key {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0).then(other.1.cmp(&self.1))
    }
}

/// The order in which prefixes hold the most worth, on average over their lengths (Horn 1972, "Single-machine
/// job sequencing with treelike precedence ordering"): the block of most worth per branch is joined to the
/// block that bears it, again and again.
fn densest(adt: &Adt, worth: &[f64]) -> Vec<u32> {
    let n = adt.len();
    let (mut sum, mut count) = (worth.to_vec(), vec![1.0_f64; n]);
    let mut block: Vec<u32> = (0..n as u32).collect();
    let (mut next, mut last) = (vec![u32::MAX; n], (0..n as u32).collect::<Vec<_>>());
    let mut heap: BinaryHeap<Key> = (1..n as u32).map(|b| Key(worth[b as usize], b)).collect();
    let mut joined = vec![false; n];
    while let Some(Key(density, first)) = heap.pop() {
        let at = first as usize;
        if joined[at] || density.total_cmp(&(sum[at] / count[at])).is_ne() {
            continue;
        }
        joined[at] = true;
        let mut head = adt.parents()[at];
        while block[head as usize] != head {
            let up = block[block[head as usize] as usize];
            block[head as usize] = up;
            head = up;
        }
        let to = head as usize;
        block[at] = head;
        next[last[to] as usize] = first;
        last[to] = last[at];
        sum[to] += sum[at];
        count[to] += count[at];
        if head != 0 {
            heap.push(Key(sum[to] / count[to], head));
        }
    }
    let mut order = Vec::with_capacity(n);
    let mut at = 0;
    while at != u32::MAX {
        order.push(at);
        at = next[at as usize];
    }
    order
}

/// As an order, but each path goes on to a tip, along what comes first in the order.
fn to_tips(adt: &Adt, order: &[u32]) -> Vec<u32> {
    let mut rank = vec![0_usize; adt.len()];
    order.iter().enumerate().for_each(|(i, &branch)| rank[branch as usize] = i);
    let mut taken = vec![false; adt.len()];
    let mut found = Vec::with_capacity(adt.len());
    for &branch in order {
        let mut at = Some(branch).filter(|&b| !taken[b as usize]);
        while let Some(branch) = at {
            taken[branch as usize] = true;
            found.push(branch);
            at = adt.children(branch).iter().copied().min_by_key(|&b| rank[b as usize]);
        }
    }
    found
}

/// Paths that an order is cut into: runs in which each branch stems from the one before.
pub(super) fn n_runs(adt: &Adt, order: &[u32]) -> usize {
    let cut = |pair: &&[u32]| adt.parents()[pair[1] as usize] != pair[0];
    1 + order.windows(2).filter(cut).count()
}

/// Paths to tips, the best first: a path has the most worth in all, or for each of its branches (the
/// densest beginning of it).
fn best_paths(adt: &Adt, worth: &[f64], mean: bool) -> Vec<u32> {
    let n = adt.len();
    // Worth, branches and next branch of the best way from each branch on.
    let mut best: Vec<(f64, f64)> = worth.iter().map(|&w| (w, 1.0)).collect();
    let mut on = vec![u32::MAX; n];
    let value = |(sum, count): (f64, f64)| if mean { sum / count } else { sum };
    for branch in (0..n).rev() {
        let children = adt.children(branch as u32).iter().copied();
        let key = |b: u32| Key(value(best[b as usize]), b);
        let Some(child) = children.max_by_key(|&b| key(b)) else { continue };
        on[branch] = child;
        let (sum, count) = best[child as usize];
        let longer = (worth[branch] + sum, 1.0 + count);
        if !mean || value(longer) > value((worth[branch], 1.0)) {
            best[branch] = longer;
        }
    }
    let key = |b: u32| Key(value(best[b as usize]), b);
    let mut heap = BinaryHeap::from([key(0)]);
    let mut order = Vec::with_capacity(n);
    while let Some(Key(_, mut branch)) = heap.pop() {
        loop {
            order.push(branch);
            let next = on[branch as usize];
            heap.extend(adt.children(branch).iter().filter(|&&c| c != next).map(|&c| key(c)));
            if next == u32::MAX {
                break;
            }
            branch = next;
        }
    }
    order
}

/// The branch that covers the most pixels that none before does, of all whose parent is there. Looks at the
/// pictures: what a metric may come near to.
fn greedy(adt: &Adt, lists: &[Vec<u32>]) -> Vec<u32> {
    let most = lists.iter().flatten().copied().max().unwrap_or(0) as usize;
    let mut covered = vec![false; most + 1];
    let mut order = Vec::with_capacity(adt.len());
    let mut heap = BinaryHeap::from([Key(f64::INFINITY, 0)]);
    while let Some(Key(gain, branch)) = heap.pop() {
        let list = &lists[branch as usize];
        let now = list.iter().filter(|&&p| !covered[p as usize]).count() as f64;
        // Gains only shrink: what has shrunk goes back, as long as another may be better.
        if now < gain && heap.peek().is_some_and(|next| next.0 > now) {
            heap.push(Key(now, branch));
            continue;
        }
        list.iter().for_each(|&p| covered[p as usize] = true);
        order.push(branch);
        heap.extend(adt.children(branch).iter().map(|&c| Key(lists[c as usize].len() as f64, c)));
    }
    order
}
