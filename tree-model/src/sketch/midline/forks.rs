//! Which two ways of a fork are one line: the straightest pair.
//!
//! Opposite limbs give two forks close together, and seen from one of them alone the two limbs are a straighter pair
//! than the trunk and what goes on above. So forks that lie closer together than they are wide are looked at as one,
//! with all the ways that lead out of it.

use crate::plane::axis::Axis;
use glam::DVec2;

/// Directions at a fork are taken between these multiples of its half-width: nearer by, lines bend into the fork.
const REACH: [f64; 2] = [1.0, 3.0];

/// And at most to the next fork that lies beyond this multiple: what follows may be one of its limbs.
const NEXT: f64 = 1.5;

/// How much a pair of very unequal width loses against a straight one, where a right angle loses 0.5.
const UNEQUAL: f64 = 0.15;

/// Forks closer together than this multiple of the larger half-width are one.
const TOGETHER: f64 = 1.0;

/// A fork among those taken as one.
#[derive(Clone, Copy)]
struct Fork {
    node: u32,
    /// How it was reached; `None` for the first.
    back: Option<Back>,
}

/// The link to the fork before.
#[derive(Clone, Copy)]
struct Back {
    /// The row of the fork before.
    fork: usize,
    /// Its neighbour towards here.
    there: u32,
    /// The neighbour here towards it.
    here: u32,
}

/// Of every node, the two neighbours between which a line goes on; `None` at tips.
pub(super) fn through(axis: &Axis) -> Vec<Option<(u32, u32)>> {
    let n = axis.at.len();
    let mut through: Vec<_> = (0..n as u32).map(|node| pair(axis, node)).collect();
    let mut seen = vec![false; n];
    for node in 0..n as u32 {
        if axis.degree(node) < 3 || seen[node as usize] {
            continue;
        }
        let (forks, exits) = together(axis, node);
        forks.iter().for_each(|fork| seen[fork.node as usize] = true);
        if forks.len() > 1
            && let Some((from, to)) = best(axis, &exits)
        {
            lead(axis, from, to, &mut through);
        }
    }
    through
}

/// The other one of a pair.
pub(super) fn other(pair: Option<(u32, u32)>, one: u32) -> Option<u32> {
    let (a, b) = pair?;
    if a == one { Some(b) } else { (b == one).then_some(a) }
}

/// The neighbour of a fork that goes on straightest from the neighbour `before`.
pub(super) fn straightest(axis: &Axis, fork: u32, before: u32) -> Option<u32> {
    let from = way(axis, fork, before);
    let bent = |next: u32| bend(from, way(axis, fork, next));
    let others = axis.joined[fork as usize].iter().copied().filter(|&next| next != before);
    others.min_by(|&a, &b| bent(a).total_cmp(&bent(b)))
}

/// The straightest pair of neighbours of one node.
fn pair(axis: &Axis, node: u32) -> Option<(u32, u32)> {
    let all = &axis.joined[node as usize];
    if let &[a, b] = all.as_slice() {
        return Some((a, b));
    }
    let exits: Vec<(u32, u32)> = all.iter().map(|&next| (node, next)).collect();
    best(axis, &exits).map(|(from, to)| (from.1, to.1))
}

/// The straightest pair of ways, each a fork and its neighbour.
fn best(axis: &Axis, exits: &[(u32, u32)]) -> Option<((u32, u32), (u32, u32))> {
    let ways: Vec<(DVec2, f64)> = exits.iter().map(|&(fork, next)| way(axis, fork, next)).collect();
    let mut best = None;
    for (i, &a) in ways.iter().enumerate() {
        for (j, &b) in ways.iter().enumerate().skip(i + 1) {
            let bend = bend(a, b);
            if best.is_none_or(|(least, _)| bend < least) {
                best = Some((bend, (exits[i], exits[j])));
            }
        }
    }
    best.map(|(_, pair)| pair)
}

/// The forks that are one with the first, and the ways out.
fn together(axis: &Axis, first: u32) -> (Vec<Fork>, Vec<(u32, u32)>) {
    let mut forks = vec![Fork { node: first, back: None }];
    let mut exits = Vec::new();
    let mut row = 0;
    while let Some(&Fork { node, back }) = forks.get(row) {
        for &next in &axis.joined[node as usize] {
            if back.is_some_and(|back| back.here == next) {
                continue;
            }
            let chain = axis.chain(node, next);
            let (end, here) = (chain[chain.len() - 1], chain[chain.len() - 2]);
            let length: f64 = chain.windows(2).map(|pair| axis.length(pair[0], pair[1])).sum();
            let wide = axis.radii[node as usize].max(axis.radii[end as usize]);
            if axis.degree(end) > 2 && length < TOGETHER * wide {
                forks.push(Fork { node: end, back: Some(Back { fork: row, there: next, here }) });
            } else {
                exits.push((node, next));
            }
        }
        row += 1;
    }
    (forks, exits)
}

/// Lets the line go on from one way out of forks that are one to another, through all forks between.
fn lead(axis: &Axis, from: (u32, u32), to: (u32, u32), through: &mut [Option<(u32, u32)>]) {
    let (forks, _) = together(axis, from.0);
    let mut at = forks.iter().position(|fork| fork.node == to.0).unwrap_or(0);
    let mut onward = to.1;
    while let Some(back) = forks[at].back {
        through[forks[at].node as usize] = Some((back.here, onward));
        (at, onward) = (back.fork, back.there);
    }
    through[from.0 as usize] = Some((from.1, onward));
}

/// How little two ways are one line: 0 for straight and equally wide, 1 and more for back again.
fn bend((to_a, wide_a): (DVec2, f64), (to_b, wide_b): (DVec2, f64)) -> f64 {
    let equal = wide_a.min(wide_b) / wide_a.max(wide_b).max(f64::MIN_POSITIVE);
    0.5 * (1.0 + to_a.dot(to_b)) + UNEQUAL * (1.0 - equal)
}

/// Direction and half-width of the way out of a node by way of `next`, on through other forks where most hangs on.
fn way(axis: &Axis, node: u32, next: u32) -> (DVec2, f64) {
    let (from, radius) = (axis.at[node as usize], axis.radii[node as usize]);
    let (mut begin, mut before, mut at) = (None, node, next);
    loop {
        let away = axis.at[at as usize].distance(from);
        if begin.is_none() && away >= REACH[0] * radius {
            begin = Some(at);
        }
        let others = axis.joined[at as usize].iter().copied().filter(|&other| other != before);
        let on = others.max_by(|&a, &b| axis.beyond(at, a).total_cmp(&axis.beyond(at, b)));
        let is_next = axis.degree(at) > 2 && away >= NEXT * radius;
        match on {
            Some(on) if away < REACH[1] * radius && !is_next => (before, at) = (at, on),
            _ => break,
        }
    }
    let begin = begin.filter(|&begin| begin != at).unwrap_or(node);
    let direction = (axis.at[at as usize] - axis.at[begin as usize]).normalize_or_zero();
    // Beside the fork the chord is still as wide as what it leaves.
    (direction, axis.radii[begin as usize].min(axis.radii[next as usize]))
}
