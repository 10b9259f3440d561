//! Overdrawn strokes: what runs along a longer stroke is part of it.
//!
//! The longest stroke stays as it is, then the next, and so on; a trunk goes before all others. Of each next one the
//! points that lie within the merging distance of what stays, in the same direction or the opposite one, make runs. A
//! run is dropped where it is nearly parallel to what stays, and covers the stroke, or begins or ends it, or is long. So what
//! merely crosses another stroke, or leaves it at an acute angle, stays whole. What goes on beyond a run begins at the
//! run's end. O(points · neighbours) by a uniform grid.

use super::report::{CleanReport, RepairKind};
use super::sample::closest;
use super::tidy::{Extent, Ink, length};
use crate::error::Result;
use crate::sketch::Role;
use glam::{IVec2, Vec2};
use tree_core::Control;

/// Strokes run along each other where the cosine of the angle between them is above this (26 degrees).
const ALONG: f32 = 0.9;

/// A run is longer than so many merging distances: two strokes that merely cross or fork are close for a shorter way.
const RUN: f32 = 4.0;

/// A run in the middle of a stroke is longer than this share of the height.
const LONG: f32 = 0.06;

/// Along a run the distance to the other stroke, left of it or right, changes by at most this share of the run: what does more
/// crosses the other stroke or leaves it.
const DRIFT: f32 = 0.12;

/// What is left between runs or beyond them stays if it is longer than so many merging distances.
const REST: f32 = 2.5;

/// What is left of the ink of a crown's line stays if it is so much longer, where it reaches the foot: it is the trunk.
const FOOT_REST: f32 = 1.0;

/// What is low enough: this share of the height above the lowest point.
const FOOT: f32 = 0.03;

/// Segments by the cell that their middle is in.
struct Grid {
    cell: f32,
    buckets: Vec<Vec<Segment>>,
}

struct Segment {
    a: Vec2,
    b: Vec2,
    stroke: u32,
}

impl Grid {
    fn new(cell: f32, n: usize) -> Self {
        let mut buckets = Vec::new();
        buckets.resize_with(n.next_power_of_two(), Vec::new);
        Self { cell, buckets }
    }

    fn bucket(&self, cell: IVec2) -> usize {
        let (x, y) = (cell.x as u32, cell.y as u32);
        let hash = x.wrapping_mul(0x9E37_79B1) ^ y.wrapping_mul(0x85EB_CA77).rotate_left(15);
        (hash ^ (hash >> 15)) as usize & (self.buckets.len() - 1)
    }

    fn add(&mut self, ink: &Ink) {
        for pair in ink.points.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let bucket = self.bucket((0.5 * (a + b) / self.cell).floor().as_ivec2());
            self.buckets[bucket].push(Segment { a, b, stroke: ink.stroke });
        }
    }

    /// Whether a point is within the cell's size of any segment.
    fn is_near(&self, point: Vec2) -> bool {
        let center = (point / self.cell).floor().as_ivec2();
        (0..9).any(|i| {
            let bucket = self.bucket(center + IVec2::new(i % 3 - 1, i / 3 - 1));
            let mut segments = self.buckets[bucket].iter();
            segments.any(|segment| closest(point, segment.a, segment.b).1 < self.cell)
        })
    }

    /// The stroke nearest to a point among those that run this way there, and how far to its right the point is.
    fn along(&self, point: Vec2, way: Vec2, within: f32) -> Option<(u32, f32)> {
        let center = (point / self.cell).floor().as_ivec2();
        let mut best = (within, None);
        for i in 0..9 {
            let bucket = self.bucket(center + IVec2::new(i % 3 - 1, i / 3 - 1));
            for segment in &self.buckets[bucket] {
                let distance = closest(point, segment.a, segment.b).1;
                let side = (segment.b - segment.a).normalize_or_zero();
                if distance < best.0 && side.dot(way).abs() > ALONG {
                    let right = side.perp_dot(point - segment.a);
                    best = (distance, Some((segment.stroke, distance.copysign(right))));
                }
            }
        }
        best.1
    }
}

/// Merges evenly sampled strokes. `within`, `spacing` and `unit`, the height, in units of the drawing.
pub(super) fn merge(
    inks: Vec<Ink>,
    [within, spacing, unit]: [f32; 3],
    report: &mut CleanReport,
    control: &Control,
) -> Result<Vec<Ink>> {
    if within <= 0.0 {
        return Ok(inks);
    }
    let mut order: Vec<(bool, f32, usize)> = inks
        .iter()
        .enumerate()
        .map(|(i, ink)| (ink.role != Some(Role::Trunk), length(&ink.points), i))
        .collect();
    order.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)).then(a.2.cmp(&b.2)));
    // A segment's middle lies within half a segment of its nearest point.
    let n: usize = inks.iter().map(|ink| ink.points.len()).sum();
    let mut grid = Grid::new(within + spacing, n);
    let mut kept: Vec<(usize, Ink)> = Vec::with_capacity(inks.len());
    let rule =
        Rule { within, drift: DRIFT, inside: LONG * unit, foot: f32::INFINITY, hooks: false };
    for (_, _, index) in order {
        control.check()?;
        let ink = &inks[index];
        for piece in remaining(ink, &grid, &rule, RepairKind::Merged, report) {
            grid.add(&piece);
            kept.push((index, piece));
        }
    }
    kept.sort_by_key(|(index, _)| *index);
    Ok(kept.into_iter().map(|(_, ink)| ink).collect())
}

/// Leaves out of middle lines what runs along a crown's line: who draws with a pen or fills an outline has the line's
/// ink as an area of its own, often one with that of the branches.
pub(super) fn leave_out_ink(
    inks: Vec<Ink>,
    crowns: &[Ink],
    [within, spacing, unit]: [f32; 3],
    report: &mut CleanReport,
) -> Vec<Ink> {
    let foot = Extent::all(&inks).high.y - FOOT * unit;
    // Ink goes all round: it may wander from side to side of the line and be cut anywhere.
    let rule = Rule { within, drift: f32::INFINITY, inside: 0.0, foot, hooks: true };
    let n = crowns.iter().map(|ink| ink.points.len()).sum();
    let mut grid = Grid::new(within + spacing, n);
    crowns.iter().for_each(|ink| grid.add(ink));
    let keep = |ink: Ink| {
        if ink.middle && !ink.marked {
            remaining(&ink, &grid, &rule, RepairKind::CrownInk, report)
        } else {
            vec![ink]
        }
    };
    inks.into_iter().flat_map(keep).collect()
}

/// Which runs are dropped, and what is left.
struct Rule {
    within: f32,
    /// See [`DRIFT`].
    drift: f32,
    /// Least length of a run between the ends of a stroke.
    inside: f32,
    /// What is left and reaches down to here stays even if it is short.
    foot: f32,
    /// Whether what is left goes if most of it is near: hooks of ink.
    hooks: bool,
}

impl Rule {
    /// A piece without what is near at its ends, where hooks go.
    fn without_hooks(
        &self,
        points: &[Vec2],
        grid: &Grid,
        from: usize,
        to: usize,
    ) -> (usize, usize) {
        let (mut from, mut to) = (from, to);
        while self.hooks && to > from && grid.is_near(points[to]) {
            to -= 1;
        }
        while self.hooks && to > from && grid.is_near(points[from]) {
            from += 1;
        }
        (from, to)
    }
}

/// What is left of a stroke beside those in the grid.
fn remaining(
    ink: &Ink,
    grid: &Grid,
    rule: &Rule,
    whole: fn(u32) -> RepairKind,
    report: &mut CleanReport,
) -> Vec<Ink> {
    let points = &ink.points;
    let last = points.len() - 1;
    let within = rule.within;
    let along: Vec<Option<(u32, f32)>> = (0..points.len())
        .map(|i| {
            let way = points[(i + 1).min(last)] - points[i.saturating_sub(1)];
            grid.along(points[i], way.normalize_or_zero(), within)
        })
        .collect();
    let mut runs: Vec<(bool, usize, usize)> = Vec::new();
    for (i, over) in along.iter().enumerate() {
        match runs.last_mut() {
            Some((before, _, to)) if *before == over.is_some() => *to = i,
            _ => runs.push((over.is_some(), i, i)),
        }
    }
    let is_run = |&&(over, from, to): &&(bool, usize, usize)| {
        let run = length(&points[from..=to]);
        let [one, other] = [from, to].map(|i| along[i].map_or(0.0, |(_, right)| right));
        let parallel = (other - one).abs() <= rule.drift * run;
        let at_end = from == 0 || to == last;
        let whole = from == 0 && to == last;
        over && (whole || (run >= RUN * within && parallel && (at_end || run > rule.inside)))
    };
    let stays = |from: usize, to: usize| {
        let piece = &points[from..=to];
        if piece.iter().any(|p| p.y > rule.foot) {
            return length(piece) >= FOOT_REST * within;
        }
        let near = || piece.iter().filter(|&&p| grid.is_near(p)).count();
        length(piece) >= REST * within && !(rule.hooks && 2 * near() > piece.len())
    };
    let covered: Vec<(usize, usize)> = runs.iter().filter(is_run).map(|r| (r.1, r.2)).collect();
    if covered.is_empty() {
        return vec![ink.clone()];
    }
    // Between runs, from the last point of one to the first of the next: so that it joins there.
    let mut pieces = Vec::new();
    let mut next = 0;
    for (start, end) in covered.iter().copied().chain([(last, last)]) {
        let (from, to) = rule.without_hooks(points, grid, next, start);
        if to > from && stays(from, to) {
            pieces.push((from, to));
        }
        next = end;
    }
    let into = covered
        .iter()
        .find_map(|&(start, _)| along[start])
        .map_or(ink.stroke, |(stroke, _)| stroke);
    report.add(
        ink.stroke,
        match (whole(into), pieces.is_empty()) {
            (RepairKind::Merged(_), false) => RepairKind::MergedPartly(into),
            (kind, _) => kind,
        },
    );
    let piece =
        |(from, to): (usize, usize)| Ink { points: points[from..=to].to_vec(), ..ink.clone() };
    pieces.into_iter().map(piece).collect()
}
