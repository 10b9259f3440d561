//! Coverage: branches for what no bump's foliage covers (section 4.1).
//!
//! 1. From the base of the axis to its tip, on either side, the nearest sibling is copied: it leaves at the branching
//!    angle and is scaled to end before the outline. Its own outline is made by the cone rule, so that it shares the parent's edge
//!    (the paper scales the copied crown to fit in, which leaves the edge bare). It is rejected when more than a fifth of it overlaps
//!    its siblings.
//! 2. What of the parent's edge no branch shares then gets a branch to its middle, the longest stretch first. The paper stops
//!    after the first step; smooth and concave outlines are left with holes by it.
//!
//! O(places × raster), about 0.5 ms.

use super::raster::Raster;
use super::{Lateral, Origin, System, SystemParams};
use crate::error::{Result, check};
use crate::silhouette::Line;
use crate::silhouette::branch::{Span, infer};
use glam::Vec2;

/// A branch ends where this share of its way to the outline is done; its foliage goes on.
pub(in crate::silhouette) const END: f32 = 0.78;
/// Radius that stands for a bump's, as a share of the branch's length.
pub(in crate::silhouette) const ROUND: f32 = 0.3;
/// What is nearer to the axis than this share of its length needs no branch: the axis itself is there.
const NEAR: f32 = 0.05;
/// Branches added for bare stretches of the edge, at most.
const MOST_EDGE: usize = 200;

/// How gaps between branches are filled.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct CoverParams {
    /// Places on each side of the axis that are tried, 0 to 10,000. Default 24.
    pub places: u32,
    /// Share of a new branch's outline that may overlap its siblings, 0 to 1. Default 0.2, as in the paper.
    pub overlap: f32,
    /// Longest stretch of the outline that may stay bare, as a share of its length round, 0.005 to 1. Default 0.04.
    pub bare: f32,
}

impl Default for CoverParams {
    fn default() -> Self {
        Self { places: 24, overlap: 0.2, bare: 0.04 }
    }
}

impl CoverParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("cover.places", self.places, 0, 10_000)?;
        check("cover.overlap", self.overlap, 0.0_f32, 1.0_f32)?;
        check("cover.bare", self.bare, 0.005_f32, 1.0_f32)
    }
}

/// How well the outlines of branches cover that of their parent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Coverage {
    /// Share of the parent's area in the outlines of branches from bumps, 0 to 1.
    pub by_bumps: f32,
    /// Share of it in the outlines of all branches, 0 to 1.
    pub by_all: f32,
}

/// Fills the gaps.
pub(super) fn cover(
    system: &mut System,
    within: [f32; 2],
    params: &SystemParams,
    raster: &mut Raster,
    name: &mut impl FnMut() -> u32,
) -> Coverage {
    // Those drawn from elsewhere cover nothing in the plane.
    for lateral in system.laterals.iter().filter(|lateral| lateral.azimuth.is_none()) {
        raster.add(&lateral.outline);
    }
    let by_bumps = raster.covered();
    along_axis(system, within, params, raster, name);
    along_edge(system, within, params, raster, name);
    Coverage { by_bumps, by_all: raster.covered() }
}

/// The first step: copies of siblings from the base up.
fn along_axis(
    system: &mut System,
    within: [f32; 2],
    params: &SystemParams,
    raster: &mut Raster,
    name: &mut impl FnMut() -> u32,
) {
    let places = params.cover.places;
    for i in 0..places {
        let t = within[0] + (within[1] - within[0]) * (i as f32 + 0.5) / places as f32;
        for left in [false, true] {
            let Some(line) = copy_of_nearest(system, t, left) else { continue };
            if line.span().length() < NEAR * system.axis.length() || raster.is_off(&line) {
                continue;
            }
            let radius = ROUND * line.span().length();
            let lateral = system.lateral(0, Origin::Coverage, t, line, (radius, None), params);
            let (own, overlap) = raster.overlap(&lateral.outline);
            if own > 0 && overlap as f32 <= params.cover.overlap * own as f32 {
                raster.add(&lateral.outline);
                system.laterals.push(Lateral { id: name(), left, ..lateral });
            }
        }
    }
}

/// The nearest sibling's line at another place: at the branching angle, as long as there is room. Without siblings a
/// straight line.
fn copy_of_nearest(system: &System, t: f32, left: bool) -> Option<Line> {
    let base = system.axis.at(t);
    let distance =
        |lateral: &&Lateral| (lateral.t - t).abs() + f32::from(u8::from(lateral.left != left));
    let nearest = system.laterals.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let shape = nearest.and_then(Lateral::shape);
    let leaving = shape.as_ref().map_or(0.0, |shape| shape.leaving());
    let angle = system.angles.at(t) - leaving;
    let (sin, cos) = libm::sincosf(if left { angle } else { -angle });
    let way = Vec2::new(cos, sin).rotate(system.axis.tangent(t));
    let length = END * system.outline.exit(base, way)?;
    let span = Span::new(base, base + length * way, left)?;
    match shape {
        Some(shape) => shape.line_on(&span),
        None => Line::new(vec![base, base + 0.5 * length * way, base + length * way]),
    }
}

/// The second step: branches to bare stretches of the edge.
fn along_edge(
    system: &mut System,
    within: [f32; 2],
    params: &SystemParams,
    raster: &mut Raster,
    name: &mut impl FnMut() -> u32,
) {
    let mut edge = Edge::of(system, within, raster);
    for _ in 0..MOST_EDGE {
        let Some((middle, length)) = edge.longest_bare() else { return };
        if length < params.cover.bare {
            return;
        }
        let grown = branch_towards(system, edge.points[middle], within, raster, params);
        let Some((t, line)) = grown.filter(|(_, line)| !raster.is_off(line)) else {
            edge.covered[middle] = true;
            continue;
        };
        let radius = ROUND * line.span().length();
        let lateral = system.lateral(name(), Origin::Coverage, t, line, (radius, None), params);
        raster.add(&lateral.outline);
        edge.update(raster);
        // Whatever came of it, the place is done.
        edge.covered[middle] = true;
        system.laterals.push(lateral);
    }
}

/// A branch that ends before a point of the edge.
fn branch_towards(
    system: &System,
    edge: Vec2,
    within: [f32; 2],
    raster: &Raster,
    params: &SystemParams,
) -> Option<(f32, Line)> {
    let (t, _) = system.axis.nearest(edge);
    let base = system.axis.at(t.clamp(within[0], within[1]));
    let way = edge - base;
    let end = base + END * way;
    let is_inside = |point: Vec2| raster.is_inside(point);
    let found = infer(&system.axis, &system.angles, (end, way), within, &is_inside, &params.infer)?;
    Some((found.t, found.line))
}

/// Even points of the outline, and which of them lie by a covered cell.
struct Edge {
    points: Vec<Vec2>,
    /// The same, a little inside.
    inside: Vec<Vec2>,
    covered: Vec<bool>,
}

impl Edge {
    /// Points of the edge; those at the foot, below where branches begin and near the axis, need no cover.
    fn of(system: &System, within: [f32; 2], raster: &Raster) -> Self {
        /// Points round.
        const POINTS: usize = 256;
        /// How far inside cover is looked for, in cells.
        const DEPTH: f32 = 2.0;
        let outline = &system.outline;
        let round = outline.perimeter();
        let at = |i: usize| i as f32 / POINTS as f32 * round;
        let points: Vec<Vec2> = (0..POINTS).map(|i| outline.along(at(i))).collect();
        let inwards = |i: usize| points[i] + DEPTH * raster.cell * outline.tangent(at(i)).perp();
        let inside = (0..POINTS).map(inwards).collect();
        let foot = system.axis.at(within[0]);
        let up = system.axis.tangent(within[0]);
        let reach = 0.08 * round / std::f32::consts::PI;
        let near = NEAR * system.axis.length();
        let is_foot = |point: &Vec2| {
            let at_foot = (*point - foot).dot(up) < 0.0 && point.distance(foot) < reach;
            at_foot || system.axis.nearest(*point).1 < near
        };
        let covered = points.iter().map(is_foot).collect();
        let mut edge = Self { points, inside, covered };
        edge.update(raster);
        edge
    }

    fn update(&mut self, raster: &Raster) {
        for (covered, &inside) in self.covered.iter_mut().zip(&self.inside) {
            *covered |= raster.is_covered(inside);
        }
    }

    /// The middle of the longest bare stretch, and its share of all points.
    fn longest_bare(&self) -> Option<(usize, f32)> {
        let n = self.covered.len();
        let Some(first) = self.covered.iter().position(|&covered| covered) else {
            return Some((0, 1.0));
        };
        let (mut best, mut run) = ((0, 0_usize), 0_usize);
        for i in (first..first + n).map(|i| i % n).chain([first]) {
            if self.covered[i] {
                if run > best.1 {
                    best = (i, run);
                }
                run = 0;
            } else {
                run += 1;
            }
        }
        let (end, length) = best;
        (length > 0).then_some(((end + n - length.div_ceil(2)) % n, length as f32 / n as f32))
    }
}
