//! The line an axis is drawn along: its nodes, cleaned, joined by cubics.
//!
//! 1. Nodes so near to the last that a ring there would only make slivers are left out; the tip
//!    stays. So are steps back inside the wood.
//! 2. The line is a clamped cubic B-spline (Neubert 2012, §5.2.1), kept as one cubic for each pair of
//!    nodes ([`CurveFit`]):
//!    * *through* the nodes: the interpolating spline with continuous curvature, knots at the lengths
//!      along the nodes, ends without curvature. One tridiagonal system.
//!    * *near* the nodes: nodes are control points of the uniform spline (Eq. 5.14). The end points are
//!      mirrored outwards instead of their knots being repeated: the line starts and ends on its
//!      nodes all the same, and keeps one piece for each pair of nodes.
//! 3. At each node stands a frame without twist, so that a frame anywhere is one step away.
//!
//! Radii are linear between nodes: a spline could swing below zero.

use super::frame::Frame;
use crate::params::{CurveFit, MeshParams};
use glam::Vec3;

/// Nodes nearer to the last one than this share of the larger radius are left out. More loses bends,
/// less leaves rings that cut into each other.
const MERGE_SHARE: f32 = 0.1;
/// Shortest segment as a share of the largest coordinate (or of a metre): some thirty steps of an f32.
const LENGTH_MIN: f32 = 4e-6;
/// A tip thinner than this share of the node before it ends in a point; a thicker one in a cap.
const POINT_SHARE: f32 = 0.35;

/// A place on the line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Station {
    pub(crate) position: Vec3,
    /// Radius without flare, at least [`MeshParams::min_radius`].
    pub(crate) radius: f32,
    /// Length along the axis from its base, over straight segments.
    pub(crate) along: f32,
}

/// A place on the line and the unit direction there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub(crate) station: Station,
    pub(crate) tangent: Vec3,
}

/// The line of one axis, borrowed from [`Curves`](super::curves::Curves).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Curve<'a> {
    pub(crate) nodes: &'a [Station],
    /// Derivatives at the nodes: by length, or by number of node for [`CurveFit::Near`].
    pub(crate) slopes: &'a [Vec3],
    /// Frames at the nodes.
    pub(crate) frames: &'a [Frame],
    pub(crate) fit: CurveFit,
    /// The axis ends in a point instead of a ring with a cap.
    pub(crate) pointed: bool,
}

impl Curve<'_> {
    /// Length from base to tip.
    pub(crate) fn length(&self) -> f32 {
        self.nodes.last().map_or(0.0, |tip| tip.along)
    }

    /// The segment that holds `along`.
    fn segment(&self, along: f32) -> usize {
        let last = self.nodes.len().saturating_sub(2);
        self.nodes.partition_point(|node| node.along <= along).saturating_sub(1).min(last)
    }

    /// The place `along` the line, from 0 to its length.
    pub(crate) fn at(&self, along: f32) -> Place {
        self.on(self.segment(along), along)
    }

    /// As [`at`](Self::at) on a segment that is known.
    pub(crate) fn on(&self, i: usize, along: f32) -> Place {
        let (a, b) = (self.nodes[i], self.nodes[i + 1]);
        let length = b.along - a.along;
        let t = ((along - a.along) / length).clamp(0.0, 1.0);
        let s = 1.0 - t;
        let chord = b.position - a.position;
        let (position, tangent) = if self.fit == CurveFit::Straight {
            let tangent = self.frames[i].tangent * s + self.frames[i + 1].tangent * t;
            (a.position + chord * t, tangent)
        } else {
            let scale = if self.fit == CurveFit::Near { 1.0 } else { length };
            let (m0, m1) = (self.slopes[i] * scale, self.slopes[i + 1] * scale);
            // Cubic Hermite basis and its derivative.
            let position = a.position * (s * s * (1.0 + 2.0 * t))
                + b.position * (t * t * (1.0 + 2.0 * s))
                + (m0 * s - m1 * t) * (s * t);
            let tangent =
                chord * (6.0 * s * t) + m0 * (s * (1.0 - 3.0 * t)) + m1 * (t * (3.0 * t - 2.0));
            (position, tangent)
        };
        Place {
            station: Station { position, radius: a.radius + t * (b.radius - a.radius), along },
            tangent: tangent.try_normalize().unwrap_or(self.frames[i].tangent),
        }
    }

    /// The twist-free frame `along` the line, turned to stand on `tangent`.
    pub(crate) fn frame(&self, station: &Station, tangent: Vec3) -> Frame {
        let i = self.segment(station.along);
        let step = station.position - self.nodes[i].position;
        // At a node the step is nothing but rounding, which has any direction.
        let length = self.nodes[i + 1].along - self.nodes[i].along;
        let noise = step.length_squared() < NOISE * NOISE * length * length;
        self.frames[i].advance(if noise { Vec3::ZERO } else { step }, tangent)
    }

    /// How many pieces segment `i` is looked at in, so that chords stay within `error` of the line.
    pub(crate) fn n_pieces(&self, i: usize, error: f32) -> u32 {
        if self.fit == CurveFit::Straight {
            return 1;
        }
        let (a, b) = (self.nodes[i], self.nodes[i + 1]);
        let scale = if self.fit == CurveFit::Near { 1.0 } else { b.along - a.along };
        let (m0, m1) = (self.slopes[i] * scale, self.slopes[i + 1] * scale);
        let chord = b.position - a.position;
        // The second derivative of a cubic is largest at an end; a chord over a step h leaves the
        // curve by at most h²/8 of it. On the outer side the turn of the rings adds to that.
        let bend = (6.0 * chord - 4.0 * m0 - 2.0 * m1)
            .length()
            .max((6.0 * chord - 2.0 * m0 - 4.0 * m1).length());
        let turn = (self.frames[i].tangent - self.frames[i + 1].tangent).length_squared();
        let pieces = ((bend + a.radius.max(b.radius) * turn) / (8.0 * error)).sqrt().ceil();
        (pieces as u32).clamp(1, PIECES_MAX)
    }
}

/// Steps below this share of a segment are rounding.
const NOISE: f32 = 1e-3;
/// Most pieces of one segment, so that one wild bend cannot eat the budget of the whole tree.
const PIECES_MAX: u32 = 16;

/// Cleans and joins the nodes of one axis; reused from axis to axis so that nothing is allocated.
#[derive(Debug, Default)]
pub(crate) struct Drawing {
    /// The nodes as they came.
    pub(crate) raw: Vec<Station>,
    pub(crate) nodes: Vec<Station>,
    pub(crate) slopes: Vec<Vec3>,
    /// Frames with tangents, not yet with normals: those need a hint.
    pub(crate) frames: Vec<Frame>,
    /// For each of `raw` the node that stands for it.
    pub(crate) kept: Vec<u32>,
    /// Nodes left out.
    pub(crate) n_dropped: u32,
    pub(crate) pointed: bool,
    /// Right-hand factors of the tridiagonal system.
    factors: Vec<f32>,
}

impl Drawing {
    /// Draws an axis through the nodes in `raw`, whose `along` is not read. Returns false when it has
    /// no length: then there is nothing to draw.
    ///
    /// # Complexity
    /// O(nodes of the axis).
    pub(crate) fn draw(&mut self, params: &MeshParams) -> bool {
        self.nodes.clear();
        self.kept.clear();
        let last = self.raw.len().saturating_sub(1);
        let mut end = 0.0;
        for i in 0..self.raw.len() {
            let mut station = self.raw[i];
            end = station.radius;
            let coarsest = ROUND_MIN * station.position.abs().max_element();
            station.radius = station.radius.max(params.min_radius).max(coarsest);
            if i == last {
                self.push_tip(station);
            } else {
                self.push(station, MERGE_SHARE);
            }
            self.kept.push(self.nodes.len().saturating_sub(1) as u32);
        }
        self.n_dropped = (self.raw.len() - self.nodes.len()) as u32;
        if self.nodes.len() < 2 {
            return false;
        }
        self.measure();
        let before = self.nodes[self.nodes.len() - 2].radius;
        self.pointed = end <= params.min_radius || end < POINT_SHARE * before;
        self.find_slopes(params.fit);
        self.find_tangents(params.fit);
        true
    }

    /// Adds a node unless it is nearer to the last than `share` of the larger radius.
    fn push(&mut self, station: Station, share: f32) {
        if let Some(last) = self.nodes.last() {
            let near = share * last.radius.max(station.radius);
            if last.position.distance(station.position) <= near.max(length_min(station.position)) {
                return;
            }
            // A step back inside the wood would turn the tube inside out.
            if let [.., before, last] = self.nodes[..] {
                let (ahead, step) =
                    (last.position - before.position, station.position - last.position);
                let inside = step.length() < last.radius.max(station.radius);
                if inside && step.dot(ahead) < 0.0 {
                    return;
                }
            }
        }
        self.nodes.push(station);
    }

    /// Adds the tip, which rather replaces the node before it than being left out.
    fn push_tip(&mut self, tip: Station) {
        if let [.., before, last] = self.nodes[..] {
            let near = MERGE_SHARE * last.radius.max(tip.radius);
            let far_enough = before.position.distance(tip.position) > length_min(tip.position);
            if last.position.distance(tip.position) <= near && far_enough {
                self.nodes.pop();
            }
        }
        self.push(tip, 0.0);
    }

    fn measure(&mut self) {
        let mut along = 0.0;
        let mut last = self.nodes[0].position;
        for node in &mut self.nodes {
            // Far from the base a short step could vanish in the sum.
            let step = node.position.distance(last);
            along = if step > 0.0 { (along + step).max(along * (1.0 + 2e-7)) } else { along };
            last = node.position;
            node.along = along;
        }
    }

    fn find_slopes(&mut self, fit: CurveFit) {
        self.slopes.clear();
        match fit {
            CurveFit::Straight => self.slopes.resize(self.nodes.len(), Vec3::ZERO),
            CurveFit::Through => self.interpolate(),
            CurveFit::Near => self.approximate(),
        }
    }

    /// Slopes of the spline through all nodes: h₁m₀ + 2(h₀+h₁)m₁ + h₀m₂ = 3(h₁d₀ + h₀d₁) at inner
    /// nodes, 2m₀ + m₁ = 3d₀ at the ends, with lengths h and directions d of segments.
    fn interpolate(&mut self) {
        let n = self.nodes.len();
        let segment = |i: usize| {
            let (a, b) = (self.nodes[i], self.nodes[i + 1]);
            let length = b.along - a.along;
            (length, (b.position - a.position) / length)
        };
        self.factors.clear();
        let (mut h0, mut d0) = segment(0);
        self.factors.push(0.5);
        self.slopes.push(1.5 * d0);
        for i in 1..n {
            let (factor, slope) = (self.factors[i - 1], self.slopes[i - 1]);
            if i + 1 == n {
                self.slopes.push((3.0 * d0 - slope) / (2.0 - factor));
                break;
            }
            let (h1, d1) = segment(i);
            let pivot = 2.0 * (h0 + h1) - h1 * factor;
            self.factors.push(h0 / pivot);
            self.slopes.push((3.0 * (h1 * d0 + h0 * d1) - h1 * slope) / pivot);
            (h0, d0) = (h1, d1);
        }
        for i in (0..n - 1).rev() {
            let above = self.slopes[i + 1];
            self.slopes[i] -= self.factors[i] * above;
        }
    }

    /// Moves nodes onto the uniform spline that has them as control points.
    fn approximate(&mut self) {
        let n = self.nodes.len();
        let mut before = 2.0 * self.nodes[0].position - self.nodes[1].position;
        for i in 0..n {
            let here = self.nodes[i].position;
            let after = match self.nodes.get(i + 1) {
                Some(node) => node.position,
                None => 2.0 * here - before,
            };
            self.slopes.push(0.5 * (after - before));
            if i > 0 && i + 1 < n {
                self.nodes[i].position = (before + 4.0 * here + after) / 6.0;
            }
            before = here;
        }
    }

    fn find_tangents(&mut self, fit: CurveFit) {
        self.frames.clear();
        let chord = |i: usize| {
            let (a, b) = (self.nodes[i].position, self.nodes[i + 1].position);
            (b - a).normalize_or(Vec3::Y)
        };
        let n = self.nodes.len();
        for i in 0..n {
            let (below, above) = (chord(i.saturating_sub(1)), chord(i.min(n - 2)));
            let straight = (below + above).try_normalize().unwrap_or(above);
            let tangent = match fit {
                CurveFit::Straight => straight,
                _ => self.slopes[i].try_normalize().unwrap_or(straight),
            };
            self.frames.push(Frame { tangent, normal: Vec3::ZERO });
        }
    }
}

/// Turns frames along `nodes` so that the first normal lies as near to `hint` as it can.
pub(crate) fn carry(nodes: &[Station], frames: &mut [Frame], hint: Vec3) {
    let mut last: Option<(Frame, Vec3)> = None;
    for (frame, node) in frames.iter_mut().zip(nodes) {
        *frame = match last {
            None => Frame::new(frame.tangent, hint),
            Some((below, position)) => below.advance(node.position - position, frame.tangent),
        };
        last = Some((*frame, node.position));
    }
}

/// Thinnest wood as a share of the largest coordinate: corners of a ring stay apart in f32.
const ROUND_MIN: f32 = 1e-5;

/// Shortest segment at this place.
pub(crate) fn length_min(position: Vec3) -> f32 {
    LENGTH_MIN * (1.0 + position.abs().max_element())
}

#[cfg(test)]
#[path = "curve_tests.rs"]
mod tests;
