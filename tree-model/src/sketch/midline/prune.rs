//! Cuts cycles and spurs off an axis.

use crate::plane::axis::Axis;
use crate::plane::fill::sides;
use glam::DVec2;

/// A shortened end is lengthened by at most this multiple of what was pruned off it.
const LENGTHEN: f64 = 1.5;

/// A side line that sticks out by this multiple of its own mean width is a branch however short it is against the width
/// of what bears it: limbs on a very thick trunk. A right-angled corner sticks out by its mean width.
const LONG: f64 = 1.6;

/// But not where it sticks out by less than this share of the half-width it leaves: thorns and rough bark.
const STICKS_OUT: f64 = 0.25;

/// Makes the graph a forest: of each cycle (round a hole) the narrowest link goes. O(n log n).
pub(super) fn cut_cycles(axis: &mut Axis) {
    let n = axis.at.len();
    let width = |&(a, b): &(u32, u32)| axis.radii[a as usize].min(axis.radii[b as usize]);
    let mut links: Vec<(u32, u32)> = (0..n as u32)
        .flat_map(|a| axis.joined[a as usize].iter().map(move |&b| (a, b)))
        .filter(|(a, b)| a < b)
        .collect();
    links.sort_by(|s, t| width(t).total_cmp(&width(s)).then(s.cmp(t)));
    let mut groups: Vec<u32> = (0..n as u32).collect();
    for (a, b) in links {
        let (one, other) = (group(&mut groups, a), group(&mut groups, b));
        if one == other {
            axis.joined[a as usize].retain(|&node| node != b);
            axis.joined[b as usize].retain(|&node| node != a);
        }
        groups[one as usize] = other;
    }
}

/// The group a node belongs to; halves the way there.
fn group(groups: &mut [u32], mut node: u32) -> u32 {
    while groups[node as usize] != node {
        groups[node as usize] = groups[groups[node as usize] as usize];
        node = groups[node as usize];
    }
    node
}

/// A line from a tip to the fork it leaves.
struct Spur {
    /// From tip to fork.
    nodes: Vec<u32>,
    fork: u32,
    length: f64,
    /// Below 1 it is no branch.
    ratio: f64,
}

/// Takes off the spurs shorter than `least` widths of what bears them, unless they are long for their own width, the
/// least first. Of a fork whose ends are all spurs but one
/// (the corners of a blunt end) all go. O(spurs · n).
pub(super) fn prune(axis: &mut Axis, least: f64) {
    loop {
        let spurs = spurs(axis, least);
        let short = spurs.iter().filter(|spur| spur.ratio < 1.0);
        let Some(worst) = short.min_by(|a, b| a.ratio.total_cmp(&b.ratio)) else { return };
        let fork = worst.fork;
        let here: Vec<&Spur> =
            spurs.iter().filter(|spur| spur.fork == fork && spur.ratio < 1.0).collect();
        if here.len() + 1 == axis.degree(fork) {
            here.iter().for_each(|spur| remove(axis, spur));
        } else {
            remove(axis, worst);
        }
    }
}

/// All lines from a tip to a fork.
fn spurs(axis: &Axis, least: f64) -> Vec<Spur> {
    let tips = (0..axis.at.len() as u32).filter(|&node| axis.degree(node) == 1);
    tips.filter_map(|tip| {
        let nodes = axis.chain(tip, axis.joined[tip as usize][0]);
        let &fork = nodes.last()?;
        if axis.degree(fork) < 3 {
            return None;
        }
        let length: f64 = nodes.windows(2).map(|pair| axis.length(pair[0], pair[1])).sum();
        let length = length + axis.lost[tip as usize];
        let ratio = ratio(axis, &nodes, fork, length, least);
        Some(Spur { nodes, fork, length, ratio })
    })
    .collect()
}

/// How sure a line from a tip to a fork is a branch: 1 and more is one.
fn ratio(axis: &Axis, nodes: &[u32], fork: u32, length: f64, least: f64) -> f64 {
    let radius = axis.radii[fork as usize];
    let short = length / (2.0 * radius * least).max(f64::MIN_POSITIVE);
    // The branch's first chord is a side of the fork's triangle: up to there it is inside what bears it.
    let outer = &nodes[..nodes.len() - 1];
    let Some(&base) = outer.last() else { return short };
    let across = axis.chords[base as usize].normalize_or_zero();
    let (mut out, mut area) = (0.0_f64, 0.0);
    for pair in outer.windows(2) {
        let [from, to] = [pair[0], pair[1]].map(|node| node as usize);
        let step = axis.at[to] - axis.at[from];
        out = out.max((axis.at[from] - axis.at[base as usize]).perp_dot(across).abs());
        area +=
            0.5 * (step.perp_dot(axis.chords[from]).abs() + step.perp_dot(axis.chords[to]).abs());
    }
    if out < STICKS_OUT * radius {
        return short;
    }
    short.max(out * out / (LONG * area).max(f64::MIN_POSITIVE))
}

fn remove(axis: &mut Axis, spur: &Spur) {
    for &node in &spur.nodes {
        if node != spur.fork {
            axis.joined[node as usize].clear();
        }
    }
    let link = spur.nodes[spur.nodes.len() - 2];
    axis.joined[spur.fork as usize].retain(|&node| node != link);
    let lost = &mut axis.lost[spur.fork as usize];
    *lost = lost.max(spur.length);
}

/// Moves ends from which spurs were pruned on to the outline, in the direction the line has there.
/// O(ends · corners).
pub(super) fn lengthen(axis: &mut Axis, border: &[Vec<DVec2>]) {
    for tip in 0..axis.at.len() as u32 {
        let lost = axis.lost[tip as usize];
        if axis.degree(tip) != 1 || lost == 0.0 {
            continue;
        }
        let chain = axis.chain(tip, axis.joined[tip as usize][0]);
        let from = axis.at[tip as usize];
        let reach = axis.radii[tip as usize];
        let is_away = |&&node: &&u32| axis.at[node as usize].distance(from) >= reach;
        let Some(&behind) = chain.iter().find(is_away).or(chain.last()) else { continue };
        let direction = (from - axis.at[behind as usize]).normalize_or_zero();
        let hits = border.iter().flat_map(|contour| sides(contour));
        let hit = hits.filter_map(|(a, b)| hit(from, direction, a, b)).min_by(f64::total_cmp);
        if let Some(distance) = hit {
            axis.at[tip as usize] = from + distance.min(LENGTHEN * lost) * direction;
            axis.radii[tip as usize] = 0.0;
        }
    }
}

/// How far along a ray a segment is hit.
fn hit(from: DVec2, direction: DVec2, a: DVec2, b: DVec2) -> Option<f64> {
    let side = b - a;
    let slant = direction.perp_dot(side);
    let along = (a - from).perp_dot(side) / slant;
    let share = (a - from).perp_dot(direction) / slant;
    (slant != 0.0 && along > 0.0 && (0.0..=1.0).contains(&share)).then_some(along)
}
