//! The line a tube is drawn along: the nodes of one axis, cleaned, rounded, cut into stations.
//!
//! 1. Nodes so near to the last that a ring there would only make slivers are left out; the tip
//!    stays.
//! 2. The trunk gets extra points where its root flare bends most.
//! 3. Between nodes runs a cubic through both with the tangents of the parabola through three
//!    neighbours, parametrised by length (Bessel's choice; Farin, *Curves and Surfaces for CAGD*,
//!    5th ed. 2002). It is local, passes through the nodes, so forks stay where they are, and
//!    does not overshoot like uniform Catmull-Rom where long and short segments meet.
//! 4. A segment is cut evenly so that chords stay within [`MeshParams::curve_error`] of the cubic and
//!    of the tube's outer side.
//!
//! Radii are linear between nodes: a spline could swing below zero.

use crate::params::MeshParams;
use glam::Vec3;
use tree_core::{Axis, Skeleton};

/// Nodes nearer to the last one than this share of the larger radius are left out. More loses bends,
/// less leaves rings that cut into each other.
const MERGE_SHARE: f32 = 0.1;
/// Shortest segment as a share of the largest coordinate (or of a metre): eight steps of an f32.
const LENGTH_MIN: f32 = 1e-6;
/// Most stations in one segment, so that one wild bend cannot eat the budget of the whole tree.
const SAMPLES_MAX: u32 = 16;
/// A tip thinner than this share of the node before it ends in a point; a thicker one in a cap.
const POINT_SHARE: f32 = 0.35;
/// Where the flare gets points of its own, as shares of its height.
const FLARE_POINTS: [f32; 6] = [0.07, 0.18, 0.32, 0.5, 0.72, 1.0];
/// No flare point is put nearer to a node than this share of the flare's height.
const FLARE_GAP: f32 = 0.04;

/// A place on the line where a ring stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Station {
    pub(crate) position: Vec3,
    /// Radius without flare, at least [`MeshParams::radius_min`].
    pub(crate) radius: f32,
    /// Length along the axis from its base.
    pub(crate) along: f32,
}

/// One axis made ready; reused from axis to axis so that nothing is allocated for each.
#[derive(Debug, Default)]
pub(crate) struct Spine {
    nodes: Vec<Station>,
    /// Derivatives by length at the nodes; no longer than 1.
    tangents: Vec<Vec3>,
    smooth: bool,
    curve_error: f32,
    /// The axis ends in a point instead of a ring with a cap.
    pub(crate) pointed: bool,
    /// Whether this is the trunk, which has a bottom that can be seen.
    pub(crate) trunk: bool,
    /// Whether its foot widens: a lone trunk's does, stems and roots that share the ground do not.
    pub(crate) flared: bool,
    /// Nodes left out.
    pub(crate) n_dropped: u32,
}

impl Spine {
    /// Loads an axis. Returns false when it has no length: then there is nothing to draw.
    ///
    /// # Complexity
    /// O(nodes of the axis).
    pub(crate) fn load(
        &mut self,
        skeleton: &Skeleton,
        axis: Axis<'_>,
        params: &MeshParams,
    ) -> bool {
        self.nodes.clear();
        self.tangents.clear();
        self.smooth = params.smooth;
        self.curve_error = params.curve_error;
        self.trunk = axis.index == 0;
        let alone = || skeleton.parents().iter().filter(|&&parent| parent == 0).nth(1).is_none();
        self.flared = self.trunk && params.flare > 0.0 && alone();
        self.n_dropped = 0;
        let (positions, radii) = (skeleton.positions(), skeleton.radii());
        let station = |at: u32, radius_of: u32| Station {
            position: positions[at as usize],
            radius: radii[radius_of as usize].max(params.radius_min),
            along: 0.0,
        };
        // A lateral starts on the line of its parent axis, as thin as it is itself.
        if let Some(&first) = axis.nodes.first()
            && let Some(fork) = skeleton.parent(first)
        {
            self.nodes.push(station(fork, first));
        }
        let (Some(&tip), inner) = (axis.nodes.last(), axis.nodes.len().saturating_sub(1)) else {
            return false;
        };
        for &node in axis.nodes.iter().take(inner) {
            self.push(station(node, node), MERGE_SHARE);
        }
        self.push_tip(station(tip, tip));
        if self.nodes.len() < 2 {
            return false;
        }
        self.measure();
        if self.flared {
            self.add_flare_points(params);
        }
        let before = self.nodes[self.nodes.len() - 2].radius;
        let end = radii[tip as usize];
        self.pointed = end <= params.radius_min || end < POINT_SHARE * before;
        self.find_tangents();
        true
    }

    /// Adds a node unless it is nearer to the last than `share` of the larger radius.
    fn push(&mut self, station: Station, share: f32) -> bool {
        if let Some(last) = self.nodes.last() {
            let near = share * last.radius.max(station.radius);
            if last.position.distance(station.position) <= near.max(length_min(station.position)) {
                self.n_dropped += 1;
                return false;
            }
        }
        self.nodes.push(station);
        true
    }

    /// Adds the tip, which rather replaces the node before it than being left out.
    fn push_tip(&mut self, tip: Station) {
        if let [.., before, last] = self.nodes[..] {
            let near = MERGE_SHARE * last.radius.max(tip.radius);
            let far_enough = before.position.distance(tip.position) > length_min(tip.position);
            if last.position.distance(tip.position) <= near && far_enough {
                self.nodes.pop();
                self.n_dropped += 1;
            }
        }
        self.push(tip, 0.0);
    }

    /// Lengths from the base along straight segments.
    fn measure(&mut self) {
        let mut along = 0.0;
        let mut last = self.nodes[0].position;
        for node in &mut self.nodes {
            along += node.position.distance(last);
            last = node.position;
            node.along = along;
        }
    }

    fn add_flare_points(&mut self, params: &MeshParams) {
        let height = params.flare_height * self.nodes[0].radius;
        let gap = (FLARE_GAP * height).max(length_min(self.nodes[0].position));
        for along in FLARE_POINTS.map(|share| share * height) {
            let above = self.nodes.partition_point(|node| node.along < along);
            if above == 0 || above == self.nodes.len() {
                continue;
            }
            let (a, b) = (self.nodes[above - 1], self.nodes[above]);
            if along - a.along > gap && b.along - along > gap {
                let share = (along - a.along) / (b.along - a.along);
                let point = Station {
                    position: a.position.lerp(b.position, share),
                    radius: a.radius + share * (b.radius - a.radius),
                    along,
                };
                self.nodes.insert(above, point);
            }
        }
    }

    fn find_tangents(&mut self) {
        let direction = |a: Station, b: Station| (b.position - a.position) / (b.along - a.along);
        let last = self.nodes.len() - 1;
        for (i, &node) in self.nodes.iter().enumerate() {
            let tangent = if i == 0 {
                direction(node, self.nodes[1])
            } else if i == last {
                direction(self.nodes[i - 1], node)
            } else {
                let (a, b) = (self.nodes[i - 1], self.nodes[i + 1]);
                let (below, above) = (node.along - a.along, b.along - node.along);
                (direction(a, node) * above + direction(node, b) * below) / (below + above)
            };
            self.tangents.push(if tangent.is_finite() { tangent } else { Vec3::ZERO });
        }
    }

    /// How many stations segment `i` is cut into: at least 1.
    fn n_samples(&self, i: usize) -> u32 {
        if !self.smooth {
            return 1;
        }
        let (a, b) = (self.nodes[i], self.nodes[i + 1]);
        let (m0, m1) = (self.tangents[i], self.tangents[i + 1]);
        let length = b.along - a.along;
        let chord = b.position - a.position;
        // The second derivative of a cubic is largest at an end; a chord over a step h leaves the
        // curve by at most h²/8 of it. On the outer side the turn of the rings adds to that.
        let bend = (6.0 * chord - length * (4.0 * m0 + 2.0 * m1))
            .length()
            .max((6.0 * chord - length * (2.0 * m0 + 4.0 * m1)).length());
        let turn = (m0.normalize_or_zero() - m1.normalize_or_zero()).length_squared();
        let error = bend + a.radius.max(b.radius) * turn;
        let n = (error / (8.0 * self.curve_error)).sqrt().ceil();
        (n as u32).clamp(1, SAMPLES_MAX)
    }

    /// The station at share `t` of segment `i`.
    fn at(&self, i: usize, t: f32) -> Station {
        let (a, b) = (self.nodes[i], self.nodes[i + 1]);
        if t <= 0.0 {
            return a;
        }
        let length = b.along - a.along;
        let s = 1.0 - t;
        let position = if self.smooth {
            // Cubic Hermite basis.
            a.position * (s * s * (1.0 + 2.0 * t))
                + b.position * (t * t * (1.0 + 2.0 * s))
                + (self.tangents[i] * s - self.tangents[i + 1] * t) * (length * s * t)
        } else {
            a.position.lerp(b.position, t)
        };
        Station {
            position,
            radius: a.radius + t * (b.radius - a.radius),
            along: a.along + t * length,
        }
    }

    /// Every place where a ring stands, from base to tip; at least one. The tip itself is among them
    /// unless the axis is pointed.
    pub(crate) fn rings(&self) -> impl Iterator<Item = Station> + '_ {
        let n_segments = self.nodes.len() - 1;
        let inner = (0..n_segments).flat_map(move |i| {
            let n = self.n_samples(i);
            (0..n).map(move |k| self.at(i, k as f32 / n as f32))
        });
        inner.chain((!self.pointed).then(|| self.tip()))
    }

    /// The first node.
    pub(crate) fn base(&self) -> Station {
        self.nodes[0]
    }

    /// The last node.
    pub(crate) fn tip(&self) -> Station {
        self.nodes[self.nodes.len() - 1]
    }
}

fn length_min(position: Vec3) -> f32 {
    LENGTH_MIN * (1.0 + position.abs().max_element())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain() -> MeshParams {
        MeshParams { flare: 0.0, ..Default::default() }
    }

    fn rings(points: &[(Vec3, f32)], params: &MeshParams) -> (Vec<Station>, u32) {
        let mut builder = Skeleton::builder(points[0].0, points[0].1).unwrap();
        for (i, &(position, radius)) in points.iter().enumerate().skip(1) {
            builder.add(i as u32 - 1, position, radius).unwrap();
        }
        let skeleton = builder.finish();
        let axes = skeleton.axes(params.continuation);
        let mut spine = Spine::default();
        if !spine.load(&skeleton, axes.get(0).unwrap(), params) {
            return (Vec::new(), spine.n_dropped);
        }
        (spine.rings().collect(), spine.n_dropped)
    }

    #[test]
    fn straight_axes_get_no_extra_rings_and_bent_ones_do() {
        let up = |h: f32| (Vec3::Y * h, 0.05);
        assert_eq!(rings(&[up(0.0), up(1.0), up(3.0)], &plain()).0.len(), 3);
        let bent = [up(0.0), up(1.0), (Vec3::new(1.0, 1.0, 0.0), 0.05)];
        let smooth = rings(&bent, &plain()).0;
        assert!(smooth.len() > 6, "{}", smooth.len());
        let nodes = bent.map(|(position, _)| position);
        let hit = nodes.iter().all(|&n| smooth.iter().any(|s| s.position == n));
        assert!(hit, "the curve passes through the nodes");
        let raw = MeshParams { smooth: false, ..plain() };
        assert_eq!(rings(&bent, &raw).0.len(), 3);
    }

    #[test]
    fn chords_keep_the_promised_distance_from_the_curve() {
        let zigzag: Vec<_> =
            (0..6).map(|i| (Vec3::new((i % 2) as f32 * 0.1, i as f32 * 0.2, 0.0), 0.001)).collect();
        let dense = MeshParams { curve_error: 1e-5, ..plain() };
        let (coarse, fine) = (rings(&zigzag, &plain()).0, rings(&zigzag, &dense).0);
        for point in fine {
            let nearest = coarse
                .windows(2)
                .map(|pair| {
                    let (a, d) = (pair[0].position, pair[1].position - pair[0].position);
                    let t = ((point.position - a).dot(d) / d.length_squared()).clamp(0.0, 1.0);
                    point.position.distance(a + d * t)
                })
                .fold(f32::INFINITY, f32::min);
            assert!(nearest < 1.05 * plain().curve_error, "{nearest}");
        }
    }

    #[test]
    fn nodes_without_length_are_dropped_and_counted() {
        let p = |h: f32| (Vec3::Y * h, 0.1);
        let (found, dropped) = rings(&[p(0.0), p(0.0), p(1.0), p(1.0), p(1.004)], &plain());
        assert_eq!((found.len(), dropped), (2, 3));
        assert_eq!(found[1].position.y, 1.004, "the tip stays");
        assert_eq!(rings(&[p(2.0), p(2.0)], &plain()), (vec![], 1));
        assert_eq!(rings(&[p(2.0)], &plain()), (vec![], 0));
    }

    #[test]
    fn the_flare_brings_its_own_rings() {
        let points = [(Vec3::ZERO, 0.2), (Vec3::Y * 5.0, 0.1)];
        let flared = MeshParams { flare: 0.5, ..plain() };
        assert_eq!(rings(&points, &flared).0.len(), 2 + FLARE_POINTS.len());
    }
}
