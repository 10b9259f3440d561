//! Steps 3d and 4: from level lines to a clean piece of skeleton with radii.
//!
//! 1. The radius of a line is the mean distance of its corners from the axis, each weighed by how
//!    much the line turns there. So a slanting cut does no harm, a regular prism has the radius of
//!    the circle round its corners whatever its number of sides, and extra points on straight sides
//!    count for nothing.
//! 2. Nodes are split into chains; at a fork the child that bears most surface goes on.
//! 3. Chains that hardly stand out of their parent are bumps, and are dropped.
//! 4. Just below a fork a line runs round both branches, its middle lies between them: nodes whose
//!    radius is far above the median around them are put back on the line between good ones.
//! 5. A lateral leaves its parent's axis where its own axis, drawn on backwards, passes closest by;
//!    its nodes within the parent's wood are dropped.
//! 6. Nodes are spaced out where the wood is straight.

use super::params::SkeletonizeParams;
use super::slices::{NONE, Slices};
use glam::Vec3;
use std::f32::consts::TAU;

/// A tree of nodes, parents first, in units of the mesh's size; node 0 has parent [`NONE`].
#[derive(Clone, Debug, Default)]
pub(super) struct Traced {
    pub(super) positions: Vec<Vec3>,
    pub(super) radii: Vec<f32>,
    pub(super) parents: Vec<u32>,
    /// Side chains dropped as bumps.
    pub(super) n_bumps: usize,
    /// Ends where a loop was cut open.
    pub(super) n_cut: usize,
}

/// Above this factor times the median around, a radius belongs to a fork zone.
const BULGE: f32 = 1.2;
/// The median is taken over so many radii either way …
const MEDIAN_REACH: f32 = 4.0;
/// … from so many samples on each side.
const MEDIAN_SAMPLES: usize = 6;
/// Positions are averaged over this many radii either way …
const SMOOTH_REACH: f32 = 0.4;
/// … and at most so many nodes.
const SMOOTH_NODES: usize = 6;
/// Last nodes nearer to the end than this share of their radius lie on its cap.
const CAP_SHARE: f32 = 0.3;
/// So many radii from its start, a piece has its full thickness.
const BASE_SHARE: f32 = 1.5;
/// Lines thinner than this share of it below are cut off slantingly.
const BLUNT: f32 = 0.75;
/// Steps that the direction of the axis is taken over, at most.
const WALK_MAX: usize = 40;
/// Longest distance between nodes in straight wood, in radii.
const STRAIGHT: f32 = 10.0;
/// A lateral's direction is taken over this many of its radii.
const AIM: f32 = 3.0;
/// Bark is rough by this share of its radius, or by what the triangles make of it.
const ROUGH: f32 = 0.12;
/// Over a flat place where waves of the distance field meet, lines shrink to a point over about
/// their radius: a side chain shorter than this many radii is no branch.
const FLAT: f32 = 1.7;
/// The same for chains thinner than `SMALL` radii of their parent, where slivers are commoner than
/// stubs of twigs.
const FLAT_SMALL: f32 = 4.0;
const SMALL: f32 = 0.2;
/// Ends more than so many of the parent's radii outside of it are branches all the same.
const FLAT_REACH: f32 = 4.0;
/// Nodes of a lateral nearer to its parent's axis than this share of the parent's radius are inside.
const INSIDE: f32 = 1.05;

/// A run of nodes from a fork to an end.
struct Chain {
    nodes: Vec<u32>,
    /// Parent chain and place there, of the fork.
    fork: Option<(usize, usize)>,
    /// Positions and radii, smoothed.
    line: Vec<(Vec3, f32)>,
    /// First node outside the parent.
    first: usize,
    kept: bool,
    /// Girth over 2π of its longest line, and how many times that it is long.
    wide: f32,
    slender: f32,
}

/// One piece per start.
pub(super) fn trace(slices: &Slices, params: &SkeletonizeParams) -> Vec<Traced> {
    let heirs = slices.heirs();
    let radii = radii(slices, &heirs);
    let mut chains = chains(slices, &heirs);
    let mut totals = (0, 0);
    for i in 0..chains.len() {
        let Some((parent, place)) = chains[i].fork else {
            let (line, first) = clean(slices, &radii, &chains[i].nodes, None);
            (chains[i].line, chains[i].first) = (line, first);
            continue;
        };
        // Past the end of a parent that was cut short.
        let place = place.min(chains[parent].line.len().saturating_sub(1));
        let cut = chains[i].nodes.last().is_some_and(|&end| slices.cut[end as usize]);
        totals.1 += usize::from(cut);
        if !chains[parent].kept {
            chains[i].kept = false;
            continue;
        }
        let fork = chains[parent].line[place];
        chains[i].line = clean(slices, &radii, &chains[i].nodes, Some(fork)).0;
        let (kept, first) = stands_out(&chains[i], &chains[parent], place, cut, params);
        (chains[i].kept, chains[i].first) = (kept, first);
        totals.0 += usize::from(!kept);
        if kept {
            chains[i].fork = Some((parent, leave(&chains[i], &chains[parent], place, slices.step)));
        }
    }
    let mut pieces = join(&chains, params);
    if let Some(piece) = pieces.first_mut() {
        (piece.n_bumps, piece.n_cut) = totals;
    }
    pieces
}

/// Radius of every line (see the module, 1).
fn radii(slices: &Slices, heirs: &[u32]) -> Vec<f32> {
    let walk = |node: usize, next: &dyn Fn(usize) -> u32| {
        let reach = (slices.lengths[node] / TAU).max(slices.step);
        let mut at = node;
        for _ in 0..WALK_MAX {
            let then = next(at);
            if then == NONE {
                break;
            }
            at = then as usize;
            if slices.middles[at].distance(slices.middles[node]) > reach {
                break;
            }
        }
        slices.middles[at]
    };
    (0..slices.parents.len())
        .map(|node| {
            let up = walk(node, &|at| heirs[at]) - walk(node, &|at| slices.parents[at]);
            let along = up.normalize_or_zero();
            let (mut sum, mut weight) = (0.0, 0.0);
            for (point, turn) in slices.points_of(node as u32) {
                let away = point - slices.middles[node];
                sum += turn * (away - along * away.dot(along)).length();
                weight += turn;
            }
            if weight > 0.0 { sum / weight } else { slices.lengths[node] / TAU }
        })
        .collect()
}

fn chains(slices: &Slices, heirs: &[u32]) -> Vec<Chain> {
    let mut chains: Vec<Chain> = Vec::new();
    let mut place_of = vec![(0_usize, 0_usize); heirs.len()];
    for node in 0..heirs.len() as u32 {
        let parent = slices.parents[node as usize];
        let goes_on = parent != NONE && heirs[parent as usize] == node;
        let chain = if goes_on {
            place_of[parent as usize].0
        } else {
            let fork = (parent != NONE).then(|| place_of[parent as usize]);
            let (nodes, line) = (Vec::new(), Vec::new());
            chains.push(Chain { nodes, fork, line, first: 0, kept: true, wide: 0.0, slender: 0.0 });
            chains.len() - 1
        };
        place_of[node as usize] = (chain, chains[chain].nodes.len());
        chains[chain].nodes.push(node);
    }
    for chain in &mut chains {
        let girth = |&node: &u32| slices.lengths[node as usize];
        chain.wide = chain.nodes.iter().map(girth).fold(0.0, f32::max) / TAU;
        chain.slender = chain.nodes.len() as f32 * slices.step / chain.wide;
    }
    chains
}

/// The chain's line without bulges, smoothed, and its first place that counts; `fork` is where it
/// comes from.
fn clean(
    slices: &Slices,
    radii: &[f32],
    nodes: &[u32],
    fork: Option<(Vec3, f32)>,
) -> (Vec<(Vec3, f32)>, usize) {
    let raw: Vec<(Vec3, f32)> =
        nodes.iter().map(|&n| (slices.middles[n as usize], radii[n as usize])).collect();
    let reach = |radius: f32, factor: f32, most: usize| {
        ((factor * radius / slices.step) as usize).min(most)
    };
    let mut samples = Vec::new();
    let medians: Vec<f32> = (0..raw.len())
        .map(|i| {
            let reach = reach(raw[i].1, MEDIAN_REACH, raw.len());
            let stride = reach.div_ceil(MEDIAN_SAMPLES).max(1);
            let low = i - (i.min(reach) / stride) * stride;
            samples.clear();
            samples.extend(
                raw[low..].iter().step_by(stride).take(2 * MEDIAN_SAMPLES + 1).map(|&(_, r)| r),
            );
            samples.sort_by(f32::total_cmp);
            samples[samples.len() / 2]
        })
        .collect();
    let good = |i: usize| raw[i].1 <= BULGE * medians[i];
    let mut line = raw.clone();
    let mut last_good = None;
    for i in 0..raw.len() {
        if !good(i) {
            continue;
        }
        let from = last_good.map_or(0, |last: usize| last + 1);
        for bad in from..i {
            line[bad] = match last_good {
                Some(last) => {
                    let share = (bad - last) as f32 / (i - last) as f32;
                    let (a, b) = (raw[last], raw[i]);
                    (a.0.lerp(b.0, share), a.1 + share * (b.1 - a.1))
                }
                // Before the first good one only the radius is wrong, unless there is a fork.
                None => (raw[bad].0, raw[bad].1.min(raw[i].1 * BULGE)),
            };
        }
        last_good = Some(i);
    }
    for (slot, &median) in line.iter_mut().zip(&medians).skip(last_good.map_or(0, |last| last + 1))
    {
        slot.1 = slot.1.min(median);
    }
    let mut line = smooth(&line, &reach, fork.is_some());
    let first = square_off(&mut line, fork.is_none());
    (line, first)
}

/// Ends that are cut off. Level lines run on over a cap, towards its middle, without getting any
/// farther; the chain ends where they start to. The last node of a slanting end is one corner of it;
/// it is put back on the axis, with the radius that the lines before it lead to.
fn square_off(line: &mut Vec<(Vec3, f32)>, base_too: bool) -> usize {
    let Some(&(end, _)) = line.last() else {
        return 0;
    };
    let on_cap = |&(place, radius): &(Vec3, f32)| place.distance(end) < CAP_SHARE * radius;
    let cap = line.iter().rev().take_while(|node| on_cap(node)).count();
    if cap > 1 && cap + 2 < line.len() {
        line.truncate(line.len() - cap + 1);
    }
    straighten_end(line);
    if !base_too {
        return 0;
    }
    let first = blunt(line);
    line[first..].reverse();
    straighten_end(&mut line[first..]);
    line[first..].reverse();
    first
}

/// A base is never pointed: moves the start up to the last of the lines round one corner of a
/// slanting base, and returns its new place.
fn blunt(line: &mut [(Vec3, f32)]) -> usize {
    let Some(&(start, _)) = line.first() else {
        return 0;
    };
    let beyond = |&&(place, radius): &&(Vec3, f32)| {
        radius > 0.0 && place.distance(start) >= BASE_SHARE * radius
    };
    let Some(&(_, full)) = line.iter().find(beyond) else {
        return 0;
    };
    let slim = line.iter().take_while(|(_, radius)| *radius < BLUNT * full).count();
    if slim == 0 || slim + 3 >= line.len() {
        return 0;
    }
    line[slim - 1] = (start, line[slim].1);
    slim - 1
}

/// Moves the last node onto the axis through those before it.
fn straighten_end(line: &mut [(Vec3, f32)]) {
    let n = line.len();
    if n < 4 {
        return;
    }
    let (near, r_near) = line[n - 2];
    let before = line[..n - 2].iter().rev().find(|(p, _)| p.distance(near) >= 0.5 * r_near);
    let Some(&(far, r_far)) = before else {
        return;
    };
    let length = far.distance(near);
    let along = (near - far) / length;
    let ahead = (line[n - 1].0 - near).dot(along).max(0.0);
    let radius = r_near + (r_near - r_far) * (ahead / length).min(1.0);
    let most = r_near.max(line[n - 1].1);
    line[n - 1] = (near + along * ahead, radius.clamp(0.0, most));
}

/// Moving averages; both ends stay, a lateral's first node does not.
fn smooth(
    line: &[(Vec3, f32)],
    reach: &dyn Fn(f32, f32, usize) -> usize,
    lateral: bool,
) -> Vec<(Vec3, f32)> {
    (0..line.len())
        .map(|i| {
            let most = SMOOTH_NODES.min(line.len() - 1 - i);
            let most = if lateral { most } else { most.min(i) };
            let (back, on) =
                (reach(line[i].1, SMOOTH_REACH, most).min(i), reach(line[i].1, SMOOTH_REACH, most));
            // As many on either side, or the mean would move along.
            let wide = back.min(on);
            let around = &line[i - wide..=i + wide];
            let n = around.len() as f32;
            let place = around.iter().map(|&(p, _)| p).sum::<Vec3>() / n;
            (place, around.iter().map(|&(_, r)| r).sum::<f32>() / n)
        })
        .collect()
}

/// Distance to the parent's nodes near the fork, and the radius there. `span` is how many nodes up
/// and down the parent to look.
fn to_parent(point: Vec3, parent: &Chain, place: usize, span: usize) -> (f32, f32) {
    let low = place.saturating_sub(span);
    let high = (place + span + 1).min(parent.line.len());
    let mut best = (f32::INFINITY, 0.0);
    for &(position, radius) in &parent.line[low..high] {
        let distance = position.distance(point);
        if distance < best.0 {
            best = (distance, radius);
        }
    }
    best
}

/// Whether a side chain is more than a bump, and its first node outside the parent.
fn stands_out(
    chain: &Chain,
    parent: &Chain,
    place: usize,
    cut: bool,
    params: &SkeletonizeParams,
) -> (bool, usize) {
    let (n, span) = (chain.line.len(), chain.line.len() + 2);
    let mut first = n - 1;
    for (i, &(position, _)) in chain.line.iter().enumerate() {
        let (distance, radius) = to_parent(position, parent, place, span.min(i + 64));
        if distance > INSIDE * radius {
            first = i;
            break;
        }
    }
    let own = chain.line[first..].iter().map(|&(_, r)| r).fold(0.0, f32::max);
    let (distance, radius) = to_parent(chain.line[n - 1].0, parent, place, span);
    // A loop cut open goes nowhere: only long ones are branches that touch.
    let share = if cut { 1.0_f32.max(params.prune) } else { params.prune };
    let own = if cut { f32::INFINITY } else { own.max(ROUGH * radius) };
    let bump = distance - radius < (share * radius).min(own);
    let flat = if chain.wide < SMALL * radius { FLAT_SMALL } else { FLAT };
    let bump = bump || (chain.slender < flat && distance < (1.0 + FLAT_REACH) * radius);
    (!bump || params.prune <= 0.0, first)
}

/// Place in the parent where the lateral's axis, drawn on backwards, passes closest by.
fn leave(chain: &Chain, parent: &Chain, place: usize, step: f32) -> usize {
    let (start, own) = chain.line[chain.first];
    let on =
        ((AIM * own / step) as usize).saturating_add(1).min(chain.line.len() - 1 - chain.first);
    let ahead = chain.line[chain.first + on].0;
    let (_, radius) = parent.line[place];
    let back = (start - ahead).normalize_or(parent.line[place].0 - start);
    let span = ((4.0 * radius.max(own) / step) as usize).saturating_add(2);
    let low = place.saturating_sub(span);
    let high = (place + span / 2 + 1).min(parent.line.len());
    let miss = |at: usize| {
        let to = parent.line[at].0 - start;
        let along = to.dot(back).max(0.0);
        // Among nearly parallel axes the nearest place will do.
        to.distance(back * along) + 0.1 * to.length()
    };
    (low..high).min_by(|&a, &b| miss(a).total_cmp(&miss(b))).unwrap_or(place)
}

/// Spaces nodes out and joins the chains.
fn join(chains: &[Chain], params: &SkeletonizeParams) -> Vec<Traced> {
    let mut forks: Vec<Vec<usize>> = vec![Vec::new(); chains.len()];
    for (parent, place) in chains.iter().filter(|c| c.kept).filter_map(|chain| chain.fork) {
        forks[parent].push(place);
    }
    let mut pieces: Vec<Traced> = Vec::new();
    // Piece of each chain, and (place in the chain, node of the piece) of what is kept of it.
    let mut kept: Vec<(usize, Vec<(usize, u32)>)> = Vec::with_capacity(chains.len());
    for (chain, forks) in chains.iter().zip(&mut forks) {
        if !chain.kept {
            kept.push((0, Vec::new()));
            continue;
        }
        let (piece, mut last) = match chain.fork {
            None => {
                pieces.push(Traced::default());
                (pieces.len() - 1, NONE)
            }
            Some((parent, place)) => {
                let (piece, nodes) = &kept[parent];
                let at = nodes.partition_point(|&(at, _)| at < place).min(nodes.len() - 1);
                (*piece, nodes[at].1)
            }
        };
        forks.sort_unstable();
        let piece_nodes = &mut pieces[piece];
        let mut nodes = Vec::new();
        for place in space_out(chain, forks, params) {
            let (position, radius) = chain.line[place];
            piece_nodes.positions.push(position);
            piece_nodes.radii.push(radius);
            piece_nodes.parents.push(last);
            last = piece_nodes.parents.len() as u32 - 1;
            nodes.push((place, last));
        }
        kept.push((piece, nodes));
    }
    pieces
}

/// Which nodes of a chain stay: both ends, forks, and what keeps to the line.
fn space_out(chain: &Chain, forks: &[usize], params: &SkeletonizeParams) -> Vec<usize> {
    let line = &chain.line;
    let mut chosen = vec![chain.first];
    let mut from = chain.first;
    let mut forks = forks.iter().copied().filter(|&fork| fork > chain.first).peekable();
    while from + 1 < line.len() {
        while forks.next_if(|&fork| fork <= from).is_some() {}
        let limit = forks.peek().copied().unwrap_or(line.len() - 1).min(line.len() - 1);
        let mut to = from + 1;
        while to < limit && may_skip(line, from, to + 1, params) {
            to += 1;
        }
        chosen.push(to);
        from = to;
    }
    // A last bit shorter than the spacing is no segment of its own.
    if let [.., before, last] = chosen[..]
        && chosen.len() > 2
        && line[before].0.distance(line[last].0) < 0.3 * params.spacing * line[before].1
        && may_skip(line, chosen[chosen.len() - 3], last, params)
    {
        chosen.remove(chosen.len() - 2);
    }
    chosen
}

/// Whether the straight segment between two nodes stands for all between them.
fn may_skip(line: &[(Vec3, f32)], from: usize, to: usize, params: &SkeletonizeParams) -> bool {
    let ((a, ra), (b, rb)) = (line[from], line[to]);
    let length = a.distance(b);
    if length > STRAIGHT * ra.max(rb) {
        return false;
    }
    if length < 0.5 * params.spacing * ra.max(rb) {
        return true;
    }
    let along = (b - a) / length.max(f32::MIN_POSITIVE);
    let stride = ((to - from) / 12).max(1);
    line[from..to].iter().step_by(stride).skip(1).all(|&(point, r)| {
        let share = ((point - a).dot(along) / length.max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
        let off = point.distance(a.lerp(b, share));
        let wide = (ra + share * (rb - ra) - r).abs();
        off <= params.tolerance * r && wide <= 0.1 * r
    })
}
