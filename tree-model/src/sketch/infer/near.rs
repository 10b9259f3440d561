//! Branches that share space: competition for it (Eq. 4.22), and crossings in the drawing.
//!
//! Departure: the thesis sums over 25³ voxels, each with the density of branches in it. Here the sum runs over the branches
//! themselves, by their middles and ends, and over the nearest only. Nothing is rounded to voxels, no grid has to follow each step, and the
//! sum of all pairs is one function of all depths, so that a step that raises it for one branch raises it for all.

use super::segments::Segments;
use glam::DVec2;

/// Lengths are in edges of the voxels that the thesis divides the crown into.
const VOXELS: f64 = 25.0;
/// Branches compete up to this many voxels away.
const REACH: f64 = 8.0;
/// Each branch end competes with at most so many points of others, the nearest in the drawing.
const MOST: usize = 16;
/// A middle or an end stands for half a segment.
const HALF: f64 = 0.5;
/// Exponent of the pipe model by which the thickness of branches is estimated (Murray).
const PIPE: f64 = 2.49;
/// Branches nearer along the tree than this many clearances join there, and may touch.
const JOINING: f64 = 3.0;
/// How steeply an overlap is punished: 72 nats at none of the clearance left, 3 at four fifths.
const STEEPNESS: f64 = 12.0;

/// The end of one segment and the middle or end of another.
#[derive(Clone, Copy)]
pub(super) struct Pair {
    pub(super) end: u32,
    pub(super) other: u32,
    middle: bool,
    /// Squared distance in the plane, in voxels.
    apart: f64,
}

/// Two segments that cross in the plane or nearly so.
#[derive(Clone, Copy, Debug)]
pub(in crate::sketch) struct Crossing {
    /// The segments, and where on them as a share of their length.
    pub(in crate::sketch) a: (u32, f64),
    pub(in crate::sketch) b: (u32, f64),
    /// How far apart in depth they must be, in metres.
    pub(in crate::sketch) clearance: f64,
}

/// Everything near something else.
pub(super) struct Near {
    pub(super) pairs: Vec<Pair>,
    pub(super) crossings: Vec<Crossing>,
    voxel: f64,
    strength: f64,
}

impl Near {
    pub(super) fn new(segments: &Segments, crossings: Vec<Crossing>, competition: f64) -> Self {
        let voxel = segments.extent / VOXELS;
        let pairs = if competition > 0.0 { pairs(segments, voxel) } else { Vec::new() };
        Self { pairs, crossings, voxel, strength: competition }
    }

    /// ln of a pair's part in Eq. 4.22.
    pub(super) fn pair(&self, segments: &Segments, depths: &[f64], pair: &Pair) -> f64 {
        let (end, other) = (pair.end as usize, pair.other as usize);
        let mut depth = depths[other];
        if pair.middle {
            depth = 0.5 * (depth + segments.parent(other).map_or(0.0, |parent| depths[parent]));
        }
        let step = (depths[end] - depth) / self.voxel;
        let square = pair.apart + step * step;
        let least = 1.0 / (1.0 + REACH * REACH);
        -self.strength * HALF * (1.0 / (1.0 + square) - least).max(0.0)
    }

    /// ln of the factor that keeps crossing branches apart; 0 where they are.
    pub(super) fn crossing(&self, segments: &Segments, depths: &[f64], crossing: &Crossing) -> f64 {
        let overlap = crossing.overlap(segments, depths) * STEEPNESS;
        -0.5 * overlap * overlap
    }
}

impl Crossing {
    /// What is missing in depth, as a share of the clearance, 0 to 1.
    pub(in crate::sketch) fn overlap(&self, segments: &Segments, depths: &[f64]) -> f64 {
        let depth = |(segment, share): (u32, f64)| {
            let i = segment as usize;
            let below = segments.parent(i).map_or(0.0, |parent| depths[parent]);
            below + share * (depths[i] - below)
        };
        (1.0 - (depth(self.a) - depth(self.b)).abs() / self.clearance).max(0.0)
    }
}

/// The pairs that compete. O(segments · (log segments + neighbours in a strip)).
fn pairs(segments: &Segments, voxel: f64) -> Vec<Pair> {
    struct Point {
        at: DVec2,
        segment: u32,
        middle: bool,
    }
    let first = usize::from(segments.imagined_root);
    let mut points: Vec<Point> = (first..segments.len())
        .flat_map(|i| {
            let (start, end) = (segments.start(i) / voxel, segments.ends[i] / voxel);
            let segment = i as u32;
            [
                Point { at: 0.5 * (start + end), segment, middle: true },
                Point { at: end, segment, middle: false },
            ]
        })
        .collect();
    points.sort_by(|p, q| p.at.x.total_cmp(&q.at.x));
    let mut out = Vec::new();
    for i in first..segments.len() {
        let end = segments.ends[i] / voxel;
        let from = points.partition_point(|point| point.at.x < end.x - REACH);
        let strip = points[from..].iter().take_while(|point| point.at.x <= end.x + REACH);
        let mut near: Vec<Pair> = strip
            .filter(|point| !adjacent(segments, i, point.segment as usize))
            .map(|point| Pair {
                end: i as u32,
                other: point.segment,
                middle: point.middle,
                apart: point.at.distance_squared(end),
            })
            .filter(|pair| pair.apart < REACH * REACH)
            .collect();
        near.sort_by(|p, q| p.apart.total_cmp(&q.apart).then(p.other.cmp(&q.other)));
        out.extend(near.into_iter().take(MOST));
    }
    out
}

/// Whether two segments are one, or share the fork at the end of the first.
fn adjacent(segments: &Segments, end: usize, other: usize) -> bool {
    end == other || segments.parent(other) == Some(end) || segments.parent(end) == Some(other)
}

/// Thickness of each segment: the pipe model on the drawing, with the trunk as thick as `slenderness` says.
pub(in crate::sketch) fn radii(segments: &Segments, slenderness: f64) -> Vec<f64> {
    let mut powers = vec![0.0_f64; segments.len()];
    for i in (0..segments.len()).rev() {
        if segments.children(i).is_empty() {
            powers[i] = 1.0;
        }
        if let Some(parent) = segments.parent(i) {
            powers[parent] += powers[i];
        }
    }
    let trunk = slenderness * segments.height;
    let whole = powers.first().copied().unwrap_or(1.0).max(1.0);
    powers.iter().map(|power| trunk * libm::pow(power / whole, 1.0 / PIPE)).collect()
}

/// A short straight piece of a segment, for finding crossings.
struct Piece {
    from: DVec2,
    to: DVec2,
    segment: u32,
    /// Share of the segment's length at `from` and `to`.
    shares: (f64, f64),
    /// Length from the base along the tree to `from`.
    height: f64,
}

/// Where segments cross or nearly cross in the plane, farther along the tree than where they join. `points` are the plan's.
pub(in crate::sketch) fn crossings(
    segments: &Segments,
    points: &[glam::Vec2],
    radii: &[f64],
    clearance: f64,
) -> Vec<Crossing> {
    let (pieces, heights) = pieces(segments, points);
    let longest = pieces.iter().map(|piece| piece.from.distance(piece.to)).fold(0.0, f64::max);
    let thickest =
        radii.iter().skip(usize::from(segments.imagined_root)).copied().fold(0.0, f64::max);
    let reach = longest + 2.0 * clearance * thickest;
    let mut order: Vec<u32> = (0..pieces.len() as u32).collect();
    order.sort_by(|&a, &b| pieces[a as usize].from.x.total_cmp(&pieces[b as usize].from.x));
    let mut found: Vec<(Crossing, f64)> = Vec::new();
    for (place, &i) in order.iter().enumerate() {
        let piece = &pieces[i as usize];
        for &j in &order[place + 1..] {
            let other = &pieces[j as usize];
            if other.from.x - piece.from.x > reach {
                break;
            }
            if (other.from.y - piece.from.y).abs() > reach {
                continue;
            }
            found.extend(meeting(segments, piece, other, radii, clearance, &heights));
        }
    }
    thinned(found)
}

/// Two pieces that come nearer than the clearance of their segments, with their distance in the plane.
fn meeting(
    segments: &Segments,
    piece: &Piece,
    other: &Piece,
    radii: &[f64],
    clearance: f64,
    heights: &[f64],
) -> Option<(Crossing, f64)> {
    let needed = clearance * (radii[piece.segment as usize] + radii[other.segment as usize]);
    let (s, t, distance) = nearest(piece, other);
    if distance >= needed || needed <= 0.0 {
        return None;
    }
    let height = |piece: &Piece, share: f64| piece.height + share * piece.from.distance(piece.to);
    let apart = if piece.segment == other.segment {
        (height(piece, s) - height(other, t)).abs()
    } else {
        let (p, q) = (piece.segment as usize, other.segment as usize);
        match common(segments, p, q) {
            // One bears the other.
            Some(fork) if fork == p || fork == q => (height(piece, s) - height(other, t)).abs(),
            fork => {
                height(piece, s) + height(other, t) - 2.0 * fork.map_or(0.0, |fork| heights[fork])
            }
        }
    };
    if apart < JOINING * needed {
        return None;
    }
    let share = |piece: &Piece, t: f64| piece.shares.0 + t * (piece.shares.1 - piece.shares.0);
    let (mut a, mut b) = ((piece.segment, share(piece, s)), (other.segment, share(other, t)));
    if a.0 > b.0 || (a.0 == b.0 && a.1 > b.1) {
        (a, b) = (b, a);
    }
    let clearance = (needed * needed - distance * distance).sqrt();
    Some((Crossing { a, b, clearance }, distance))
}

/// Of meetings of the same segments close to each other only the closest stays.
fn thinned(mut found: Vec<(Crossing, f64)>) -> Vec<Crossing> {
    /// Meetings nearer to each other than this share of the segment are one.
    const ONE: f64 = 0.15;
    found.sort_by(|(p, _), (q, _)| {
        (p.a.0, p.b.0).cmp(&(q.a.0, q.b.0)).then(p.a.1.total_cmp(&q.a.1))
    });
    let mut out: Vec<(Crossing, f64)> = Vec::new();
    for (crossing, distance) in found {
        match out.last_mut() {
            Some((last, least))
                if (last.a.0, last.b.0) == (crossing.a.0, crossing.b.0)
                    && crossing.a.1 - last.a.1 < ONE
                    && (crossing.b.1 - last.b.1).abs() < ONE =>
            {
                if distance < *least {
                    (*last, *least) = (crossing, distance);
                }
            }
            _ => out.push((crossing, distance)),
        }
    }
    out.into_iter().map(|(crossing, _)| crossing).collect()
}

/// All pieces, and each segment's length from the base to its end along the tree.
fn pieces(segments: &Segments, points: &[glam::Vec2]) -> (Vec<Piece>, Vec<f64>) {
    let at = |node: u32| points[node as usize].as_dvec2();
    let mut heights = vec![0.0; segments.len()];
    let mut pieces = Vec::new();
    for i in 0..segments.len() {
        let nodes = segments.nodes(i);
        let length: f64 = nodes.windows(2).map(|pair| at(pair[0]).distance(at(pair[1]))).sum();
        let below = segments.parent(i).map_or(0.0, |parent| heights[parent]);
        let mut walked = 0.0;
        for pair in nodes.windows(2) {
            let (from, to) = (at(pair[0]), at(pair[1]));
            let next = walked + from.distance(to);
            let shares = (walked / length.max(1e-12), next / length.max(1e-12));
            pieces.push(Piece { from, to, segment: i as u32, shares, height: below + walked });
            walked = next;
        }
        heights[i] = below + length;
    }
    (pieces, heights)
}

/// The highest segment that bears or is both; `None` where there is none.
fn common(segments: &Segments, mut a: usize, mut b: usize) -> Option<usize> {
    while a != b {
        // Parents have lower numbers.
        if a > b { a = segments.parent(a)? } else { b = segments.parent(b)? }
    }
    Some(a)
}

/// Where two pieces are nearest, as shares of them, and how near.
fn nearest(p: &Piece, q: &Piece) -> (f64, f64, f64) {
    let (u, v, w) = (p.to - p.from, q.to - q.from, p.from - q.from);
    let cross = u.perp_dot(v);
    if cross.abs() > 1e-12 * u.length() * v.length() {
        let (s, t) = (v.perp_dot(w) / cross, u.perp_dot(w) / cross);
        if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
            return (s, t, 0.0);
        }
    }
    let onto = |point: DVec2, from: DVec2, along: DVec2| {
        let share =
            ((point - from).dot(along) / along.length_squared().max(1e-300)).clamp(0.0, 1.0);
        (share, point.distance(from + share * along))
    };
    let (s0, d0) = onto(q.from, p.from, u);
    let (s1, d1) = onto(q.to, p.from, u);
    let (t0, e0) = onto(p.from, q.from, v);
    let (t1, e1) = onto(p.to, q.from, v);
    let all = [(s0, 0.0, d0), (s1, 1.0, d1), (0.0, t0, e0), (1.0, t1, e1)];
    all.into_iter()
        .fold((0.0, 0.0, f64::INFINITY), |best, next| if next.2 < best.2 { next } else { best })
}
