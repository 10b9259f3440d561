//! The nodes of the parent: where they stand, and which of them bears which drawn branch.
//!
//! The paper counts the nodes between two branches by their distance along the parent over an average node length
//! (equation 1). Drawn branches stand where they were drawn, closer here and wider there, and that count then says that
//! most of them are out of the pattern, or that two stand at one node on the same side. We count real nodes instead:
//!
//! 1. drawn branches that stand close together on different sides share a node, the others have one each;
//! 2. the rest of N/n nodes stands between them, evenly, so many in each gap that the nodes of drawn branches turn
//!    their privileged positions to the sides they were drawn on: the best numbering by dynamic programming, for several
//!    turns of the whole pattern.
//!
//! Without drawn branches the nodes are evenly spaced and the count is the paper's, rounded. O(turns · drawn · shifts²).

use super::arrangement::Arrangement;
use super::domain::{Domain, in_turn};
use std::f32::consts::TAU;
use tree_core::seed::{Rng, uniform};

/// Drawn branches that stand closer than this share of an average node length may share a node.
const SAME_NODE: f32 = 0.5;

/// The number of a drawn branch's node may be this much off from what an even spacing gives.
const MOST_SHIFT: usize = 3;

/// What such a shift by one costs, in radians by which a drawn branch lies out of its privileged position.
const SHIFT_COST: f32 = 0.15;

/// Turns of the whole pattern that are tried.
const ORIGINS: u32 = 16;

/// The nodes of a parent.
pub(super) struct Nodes {
    /// Their places along the parent, ascending.
    pub(super) along: Vec<f32>,
    /// Average distance of two nodes.
    pub(super) length: f32,
    /// Azimuth of a privileged position of node 0.
    pub(super) origin: f32,
    /// The node of each branch whose place along the parent is given.
    pub(super) tied: Vec<Option<u32>>,
}

/// Drawn branches at one node.
struct Group {
    members: Vec<usize>,
    along: f32,
}

impl Nodes {
    /// The nodes for branches in `domains`, of which one at least.
    pub(super) fn of(domains: &[Domain], arrangement: &Arrangement, rng: &mut Rng) -> Self {
        let low = domains.iter().fold(1.0_f32, |low, d| low.min(d.along[0]));
        let high = domains.iter().fold(0.0_f32, |high, d| high.max(d.along[1]));
        let per_node = arrangement.per_node().max(1) as usize;
        let length = (high - low) * per_node as f32 / domains.len() as f32;
        let groups = groups(domains, arrangement, length);
        let n = domains.len().div_ceil(per_node).max(groups.len());
        let even = numbers(&groups, n, low, high);
        let (origin, numbers) = best(&groups, domains, arrangement, &even, n, rng);
        let mut tied = vec![None; domains.len()];
        for (group, &number) in groups.iter().zip(&numbers) {
            group.members.iter().for_each(|&member| tied[member] = Some(number as u32));
        }
        let along = places(&groups, &numbers, n, low, high);
        Self { along, length, origin, tied }
    }

    /// The node nearest to a place. O(log nodes).
    pub(super) fn nearest(&self, along: f32) -> u32 {
        let above = self.along.partition_point(|&a| a < along);
        let below = above.saturating_sub(1);
        let distance = |i: usize| self.along.get(i).map_or(f32::INFINITY, |a| (a - along).abs());
        (if distance(above) < distance(below) { above } else { below }) as u32
    }
}

/// The azimuth of privileged position `m` of a node.
pub(super) fn privileged_at(arrangement: &Arrangement, origin: f32, node: u32, m: u32) -> f32 {
    // In f64: the nodes of a long stem turn many times round.
    let turned = f64::from(node) * f64::from(arrangement.turn()) % std::f64::consts::TAU;
    in_turn(origin + turned as f32 + m as f32 * arrangement.spacing())
}

/// Branches whose place is given, by node, from the base.
fn groups(domains: &[Domain], arrangement: &Arrangement, length: f32) -> Vec<Group> {
    let place = |i: usize| 0.5 * (domains[i].along[0] + domains[i].along[1]);
    let is_tied = |d: &Domain| d.along[1] - d.along[0] <= SAME_NODE * length;
    let mut tied: Vec<usize> = (0..domains.len()).filter(|&i| is_tied(&domains[i])).collect();
    tied.sort_by(|&a, &b| place(a).total_cmp(&place(b)).then(a.cmp(&b)));
    let middle = |i: usize| domains[i].azimuth[0] + 0.5 * domains[i].width();
    // Two that may stand at neighbouring positions of a node are apart by more than half the spacing.
    let apart = |a: usize, b: usize| {
        let turned = in_turn(middle(a) - middle(b));
        turned.min(TAU - turned) > 0.5 * arrangement.spacing()
    };
    let mut groups: Vec<Group> = Vec::new();
    for i in tied {
        match groups.last_mut() {
            Some(group)
                if place(i) - place(group.members[0]) < SAME_NODE * length
                    && group.members.len() < arrangement.per_node() as usize
                    && group.members.iter().all(|&member| apart(i, member)) =>
            {
                group.members.push(i);
            }
            _ => groups.push(Group { members: vec![i], along: place(i) }),
        }
    }
    for group in &mut groups {
        group.along =
            group.members.iter().map(|&i| place(i)).sum::<f32>() / group.members.len() as f32;
    }
    groups
}

/// Numbers of the groups' nodes among `n` as even as may be, strictly ascending.
fn numbers(groups: &[Group], n: usize, low: f32, high: f32) -> Vec<usize> {
    let share = |along: f32| if high > low { (along - low) / (high - low) } else { 0.5 };
    let mut out: Vec<usize> = Vec::with_capacity(groups.len());
    for group in groups {
        let even = (share(group.along) * n as f32) as usize;
        out.push(out.last().map_or(even, |&last: &usize| even.max(last + 1)));
    }
    let mut above = n;
    for number in out.iter_mut().rev() {
        // There are as many nodes as groups at least.
        *number = (*number).min(above.saturating_sub(1));
        above = *number;
    }
    out
}

/// The turn of the pattern and the numbers by which drawn branches lie nearest to privileged positions.
fn best(
    groups: &[Group],
    domains: &[Domain],
    arrangement: &Arrangement,
    even: &[usize],
    n: usize,
    rng: &mut Rng,
) -> (f32, Vec<usize>) {
    let first = uniform(rng, 0.0, arrangement.spacing());
    if let Some(fixed) = arrangement.fixed() {
        return (in_turn(fixed), even.to_vec());
    }
    if groups.is_empty() {
        return (first, Vec::new());
    }
    let mut best: Option<(f32, f32, Vec<usize>)> = None;
    for i in 0..ORIGINS {
        let origin = first + i as f32 / ORIGINS as f32 * arrangement.spacing();
        let off = |group: &Group, number: usize| -> f32 {
            let outside = |&member: &usize| {
                let positions = (0..arrangement.per_node())
                    .map(|m| privileged_at(arrangement, origin, number as u32, m));
                positions.map(|p| domains[member].outside(p)).fold(f32::INFINITY, f32::min)
            };
            group.members.iter().map(outside).sum()
        };
        let (cost, numbers) = shifted(groups, even, n, &off);
        if best.as_ref().is_none_or(|best| cost < best.0) {
            best = Some((cost, origin, numbers));
        }
    }
    best.map_or((first, even.to_vec()), |(_, origin, numbers)| (origin, numbers))
}

/// The strictly ascending numbers near the even ones that cost least, by dynamic programming over the groups.
fn shifted(
    groups: &[Group],
    even: &[usize],
    n: usize,
    off: &dyn Fn(&Group, usize) -> f32,
) -> (f32, Vec<usize>) {
    const SHIFTS: usize = 2 * MOST_SHIFT + 1;
    // For each group and shift the least cost so far, and the shift of the group before.
    let mut table: Vec<[(f32, usize); SHIFTS]> = Vec::with_capacity(groups.len());
    let number = |g: usize, s: usize| (even[g] + s).checked_sub(MOST_SHIFT);
    for (g, group) in groups.iter().enumerate() {
        let mut row = [(f32::INFINITY, 0); SHIFTS];
        for (s, cell) in row.iter_mut().enumerate() {
            let Some(here) = number(g, s).filter(|&here| here < n) else { continue };
            let before = match table.last() {
                None => (0.0, 0),
                Some(last) => (0..SHIFTS)
                    .filter(|&t| number(g - 1, t).is_some_and(|there| there < here))
                    .map(|t| (last[t].0, t))
                    .fold((f32::INFINITY, 0), |best, one| if one.0 < best.0 { one } else { best }),
            };
            let cost = off(group, here) + SHIFT_COST * s.abs_diff(MOST_SHIFT) as f32;
            *cell = (before.0 + cost, before.1);
        }
        table.push(row);
    }
    let last = table.last().copied().unwrap_or([(0.0, 0); SHIFTS]);
    let mut shift =
        (0..SHIFTS).fold(MOST_SHIFT, |best, s| if last[s].0 < last[best].0 { s } else { best });
    let cost = last[shift].0;
    let mut out = even.to_vec();
    for g in (0..groups.len()).rev() {
        out[g] = number(g, shift).unwrap_or(even[g]);
        shift = table[g][shift].1;
    }
    (cost, out)
}

/// Where all nodes stand: those of groups at them, the others evenly between.
fn places(groups: &[Group], numbers: &[usize], n: usize, low: f32, high: f32) -> Vec<f32> {
    // The ends lie half a node beyond the first and the last.
    let mut knots = vec![(-0.5, low)];
    knots.extend(numbers.iter().zip(groups).map(|(&number, group)| (number as f32, group.along)));
    knots.push((n as f32 - 0.5, high));
    let mut out = Vec::with_capacity(n);
    let mut k = 0;
    for i in 0..n {
        let at = i as f32;
        while k + 2 < knots.len() && knots[k + 1].0 <= at {
            k += 1;
        }
        let ((from, a), (to, b)) = (knots[k], knots[k + 1]);
        out.push(a + (at - from) / (to - from) * (b - a));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use tree_core::Seed;

    fn drawn(places: &[(f32, bool)], free: usize) -> Vec<Domain> {
        let drawn = places.iter().map(|&(along, left)| Domain::drawn(along, left));
        drawn.chain((0..free).map(|_| Domain::default())).collect()
    }

    #[test]
    fn nodes_are_even_where_nothing_is_drawn() {
        let nodes = Nodes::of(&drawn(&[], 8), &Arrangement::Decussate, &mut Seed(1).rng());
        assert_eq!(nodes.along, [0.125, 0.375, 0.625, 0.875]);
        assert_eq!((nodes.nearest(0.0), nodes.nearest(0.6), nodes.nearest(1.0)), (0, 2, 3));
    }

    #[test]
    fn a_drawn_pair_shares_a_node_and_two_on_one_side_do_not() {
        let domains = drawn(&[(0.5, false), (0.51, true), (0.52, true)], 17);
        let nodes = Nodes::of(&domains, &Arrangement::Opposite, &mut Seed(1).rng());
        assert_eq!(nodes.tied[0], nodes.tied[1]);
        assert_eq!(nodes.tied[2].unwrap(), nodes.tied[1].unwrap() + 1);
    }

    #[test]
    fn nodes_ascend_and_drawn_branches_stand_at_theirs() {
        for seed in 0..20 {
            let mut rng = Seed(seed).rng();
            let places: Vec<(f32, bool)> =
                (0..30).map(|i| (uniform(&mut rng, 0.2, 0.6), i % 3 == 0)).collect();
            let domains = drawn(&places, seed as usize * 5);
            let nodes = Nodes::of(&domains, &Arrangement::spiral(), &mut rng);
            assert!(nodes.along.is_sorted());
            for (domain, node) in domains.iter().zip(&nodes.tied).take(30) {
                assert_eq!(nodes.along[node.unwrap() as usize], domain.along[0]);
            }
        }
    }

    #[test]
    fn the_pattern_turns_to_the_drawn_sides() {
        let places: Vec<(f32, bool)> =
            (0..10).map(|i| (0.05 + 0.1 * i as f32, i % 2 == 0)).collect();
        let domains = drawn(&places, 15);
        let arrangement = Arrangement::spiral();
        let nodes = Nodes::of(&domains, &arrangement, &mut Seed(1).rng());
        let off = (0..10).map(|i| {
            let at = privileged_at(&arrangement, nodes.origin, nodes.tied[i].unwrap(), 0);
            domains[i].outside(at)
        });
        // By chance it would be 0.56 of π each.
        assert!(off.sum::<f32>() < 10.0 * 0.3);
    }
}
