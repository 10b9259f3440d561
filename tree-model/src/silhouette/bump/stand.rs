//! Which terminals stand out.

use super::BumpParams;
use super::mesh::{Mesh, Terminal};
use crate::plane::fill::{HALF, NONE};
use glam::DVec2;

/// What sticks out counts by this factor where there are no valleys beside it: a square's corners, which stick out by
/// 0.29 of their width, are no bumps then, those of 75 degrees are.
const BARE: f64 = 0.55;

/// And by this much more between two clear valleys.
const BETWEEN_VALLEYS: f64 = 1.45;

/// Share of that which the less clear valley of the two decides.
const LESS_CLEAR: f64 = 0.6;

/// A valley is clear from this turn on, in radians, measured with straight lines from its deepest point to either rim.
const CLEAR: f64 = 0.35;

/// A line without forks has a waist where it is narrower than on both sides by this share of the least height of bumps.
const WAIST: f64 = 0.4;

/// A terminal and what it stands on.
#[derive(Clone, Debug)]
pub(super) struct End {
    /// Triangles from the end inwards, up to what it stands on.
    pub(super) path: Vec<u32>,
    /// Its part of the border, against the clock from one point to another.
    pub(super) stretch: [u32; 2],
    /// The disc it stands on.
    pub(super) body: (DVec2, f64),
    /// The point of its border farthest from there.
    pub(super) tip: u32,
    /// How wide it is where it begins.
    pub(super) neck: f64,
    fork: u32,
    /// How far it sticks out of the disc.
    height: f64,
}

impl End {
    fn new(mesh: &Mesh, terminal: Terminal, body: (DVec2, f64), neck: f64) -> Self {
        let Terminal { path, fork, stretch } = terminal;
        let away = |point: u32| mesh.at()[point as usize].distance_squared(body.0);
        let points = between(stretch, mesh.at().len());
        let tip = points.max_by(|&i, &j| away(i).total_cmp(&away(j))).unwrap_or(stretch[0]);
        let height = away(tip).sqrt() - body.1;
        Self { path, stretch, body, tip, neck, fork, height }
    }

    /// A terminal at a fork.
    fn at_fork(mesh: &Mesh, terminal: Terminal) -> Self {
        let [a, b] = terminal.stretch.map(|point| mesh.at()[point as usize]);
        let body = mesh.circle(terminal.fork);
        Self::new(mesh, terminal, body, a.distance(b))
    }

    /// How much it stands out with valleys of these turns beside it.
    fn prominence(&self, valleys: [f64; 2]) -> f64 {
        let [one, other] = valleys.map(|turn| (turn / CLEAR).min(1.0));
        let clear = LESS_CLEAR * one.min(other) + (1.0 - LESS_CLEAR) * one.max(other);
        self.height / self.neck.max(1.0) * (BARE + BETWEEN_VALLEYS * clear)
    }
}

/// The points of a stretch of the border, both ends included.
fn between([from, to]: [u32; 2], n: usize) -> impl Iterator<Item = u32> {
    let n = n as u32;
    let steps = if to >= from { to - from } else { to + n - from };
    (0..=steps).map(move |step| (from + step) % n)
}

/// Takes terminals off until all that are left stand out, the least first. None are left where the outline is all one.
/// O(terminals · (terminals + m)).
pub(super) fn ends(mesh: &mut Mesh, params: &BumpParams) -> Vec<End> {
    let least = 2.0 * HALF * f64::from(params.detail);
    let prominence = f64::from(params.prominence);
    let mut ends: Vec<End> = mesh
        .terminals()
        .into_iter()
        .filter(|terminal| terminal.fork != NONE)
        .map(|terminal| End::at_fork(mesh, terminal))
        .collect();
    while ends.len() > 2 {
        let low = (0..ends.len()).min_by(|&i, &j| ends[i].height.total_cmp(&ends[j].height));
        let Some(mut worst) = low else { break };
        if ends[worst].height >= least {
            let standing = standing(mesh, &mut ends, least);
            let by = |&i: &usize, &j: &usize| standing[i].total_cmp(&standing[j]);
            worst = (0..ends.len()).min_by(by).unwrap_or(0);
            if standing[worst] >= prominence {
                return ends;
            }
        }
        take_off(mesh, &mut ends, worst);
    }
    let mut ends = line(mesh, least);
    let standing = standing(mesh, &mut ends, least);
    let mut standing = standing.into_iter();
    ends.retain(|end| {
        standing.next().is_some_and(|standing| standing >= prominence) && end.height >= least
    });
    ends
}

/// Removes one end; what it left at its fork goes on to the next fork.
fn take_off(mesh: &mut Mesh, ends: &mut Vec<End>, which: usize) {
    let gone = ends.swap_remove(which);
    mesh.remove(&gone.path, gone.fork);
    for end in ends.iter_mut().filter(|end| end.fork == gone.fork) {
        let Some(&first) = end.path.first() else { continue };
        let terminal = mesh.terminal(first);
        if terminal.fork != NONE {
            *end = End::at_fork(mesh, terminal);
        }
    }
}

/// How much each end stands out. Brings them into their order along the border.
fn standing(mesh: &Mesh, ends: &mut [End], least: f64) -> Vec<f64> {
    ends.sort_by_key(|end| end.tip);
    let n = ends.len();
    let valleys: Vec<f64> = (0..n)
        .map(|i| [ends[i].tip, ends[(i + 1) % n].tip])
        .map(|tips| valley(mesh.at(), tips, least))
        .collect();
    (0..n).map(|i| ends[i].prominence([valleys[(i + n - 1) % n], valleys[i]])).collect()
}

/// The turn of the deepest valley between two tips, in radians, 0 where there is none; less where it is not even
/// `least` deep. O(points between).
fn valley(at: &[DVec2], tips: [u32; 2], least: f64) -> f64 {
    let points: Vec<DVec2> = between(tips, at.len()).map(|i| at[i as usize]).collect();
    // A string pulled tight round the outside.
    let mut tight: Vec<usize> = Vec::new();
    for (i, &point) in points.iter().enumerate() {
        while let [.., a, b] = tight[..]
            && (points[b] - points[a]).perp_dot(point - points[b]) <= 0.0
        {
            tight.pop();
        }
        tight.push(i);
    }
    let mut deepest = (0.0, 0.0);
    for rim in tight.windows(2) {
        let (from, to) = (points[rim[0]], points[rim[1]]);
        let across = (to - from).normalize_or_zero();
        for &point in &points[rim[0] + 1..rim[1]] {
            let depth = across.perp_dot(point - from);
            if depth > deepest.0 {
                deepest = (depth, (point - from).angle_to(to - point).abs());
            }
        }
    }
    deepest.1 * (deepest.0 / least).min(1.0)
}

/// The two ends of an axis without forks. They stand on its waist, or on its widest place where it has none.
fn line(mesh: &Mesh, least: f64) -> Vec<End> {
    let Some(terminal) = mesh.terminals().into_iter().next() else { return Vec::new() };
    let path = terminal.path;
    let n = path.len();
    if n < 3 {
        return Vec::new();
    }
    let discs: Vec<(DVec2, f64)> = (1..n - 1).map(|i| disc(mesh, &path[i..i + 2])).collect();
    let radii: Vec<f64> = discs.iter().map(|disc| disc.1).collect();
    let mut narrow = narrow(&radii).into_iter().enumerate();
    let waist = narrow.by_ref().max_by(|a, b| a.1.total_cmp(&b.1));
    let widest = radii.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).map_or(0, |(i, _)| i);
    let place = waist.filter(|waist| waist.1 > WAIST * least).map_or(widest, |(i, _)| i);
    let (body, at) = (discs[place], place + 1);
    let end = |outer: usize, path: Vec<u32>, whole: &[u32]| {
        let stretch = mesh.stretch(whole[outer], whole[at])?;
        Some(End::new(mesh, Terminal { path, fork: NONE, stretch }, body, 2.0 * body.1))
    };
    let back: Vec<u32> = path[at + 1..].iter().rev().copied().collect();
    let both = [end(at - 1, path[..at].to_vec(), &path), end(at + 1, back, &path)];
    both.into_iter().flatten().collect()
}

/// By how much each place is narrower than the widest on either side.
fn narrow(radii: &[f64]) -> Vec<f64> {
    let widest = |most: &mut f64, radius: &f64| {
        *most = most.max(*radius);
        Some(*most)
    };
    let before: Vec<f64> = radii.iter().scan(0.0, widest).collect();
    let mut after: Vec<f64> = radii.iter().rev().scan(0.0, widest).collect();
    after.reverse();
    (0..radii.len()).map(|i| before[i].min(after[i]) - radii[i]).collect()
}

/// The disc in a triangle of a line: about the middle of the circle through its corners, or where that lies outside
/// about the middle of its chord. O(m).
pub(super) fn disc(mesh: &Mesh, pair: &[u32]) -> (DVec2, f64) {
    let round = mesh.circle(pair[0]).0;
    let middle = mesh.chord(pair[0], pair[1]).unwrap_or(round);
    let place = if mesh.contains(round) { round } else { middle };
    (place, mesh.clearance(place))
}
