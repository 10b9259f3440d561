//! Where on an axis rings stand, and how they are turned.
//!
//! Rings stand at the base, on both sides of every storey, and between them where the line or its
//! radius leaves the straight by more than the error: from each ring the next is set as far ahead as
//! the error allows. Rings follow twist-free frames; where the line turns sharper than a ring's radius
//! allows, their planes turn later than the line, so that they do not cut into each other.

use super::curve::{Curve, Place, Station};
use super::frame::Frame;
use super::storey::{Storey, Storeys, Wall};
use glam::Vec3;

/// Samples that one strip may pass over: bounds the cost of the search at this many steps a ring.
const WINDOW: usize = 24;
/// Cosine of the largest turn between neighbouring rings.
const TURN_COSINE: f32 = 0.8;
/// Share of its radius that a ring may be turned by for each step of that length.
const TURN_RATE: f32 = 0.8;
/// How far a ring may be turned from its line, as a chord of the unit sphere: past a right angle (1.41)
/// the tube would be inside out.
const LATE_MAX: f32 = 1.1;
/// Smallest cosine between a ring's line and the strip above it.
const FORWARD: f32 = 0.3;
/// No ring stands nearer to a storey than this share of its radius, or of the stretch between two.
const CLEARANCE: f32 = 0.25;

/// A ring of vertices.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ring {
    pub(crate) station: Station,
    pub(crate) frame: Frame,
    /// Number of sides.
    pub(crate) n: u32,
    /// Number of its first vertex, counted from the first of its axis.
    pub(crate) first: u32,
    /// Columns of the strip above it that are given to laterals.
    pub(crate) mask: u128,
}

/// Place where a ring must stand.
#[derive(Clone, Copy, Debug)]
struct Stop {
    along: f32,
    n: Option<u32>,
    mask: u128,
}

/// What limits strips.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fineness {
    pub(crate) error: f32,
    /// Longest strip.
    pub(crate) longest: f32,
    /// Rings of one axis after which no more are set: there are too many triangles then.
    pub(crate) max_rings: usize,
}

/// Finds rings; reused from axis to axis.
#[derive(Debug, Default)]
pub(crate) struct RingFinder {
    stops: Vec<Stop>,
    samples: Vec<Place>,
    rings: Vec<Ring>,
    /// For each storey the ring below it.
    pub(crate) ring_of_storey: Vec<u32>,
}

impl RingFinder {
    /// The rings of an axis whose wall starts at `start`, from base to tip; a pointed tip gets none.
    pub(crate) fn find(
        &mut self,
        wall: &Wall<'_>,
        start: f32,
        storeys: &Storeys,
        fineness: Fineness,
    ) -> &[Ring] {
        self.rings.clear();
        self.find_stops(&wall.curve, start, &storeys.storeys);
        let end = wall.curve.length();
        let mut place = wall.curve.at(self.stops.first().map_or(start, |stop| stop.along));
        for i in 0..self.stops.len() {
            let stop = self.stops[i];
            self.push(wall, &place, stop.n, stop.mask);
            let open = i + 1 == self.stops.len();
            let next = wall.curve.at(self.stops.get(i + 1).map_or(end, |next| next.along));
            if stop.mask == 0 {
                self.fill(wall, &place, &next, open, fineness);
            }
            place = next;
        }
        if !wall.curve.pointed {
            self.push(wall, &place, None, 0);
        }
        self.turn(&wall.curve);
        let mut next = 0_u32;
        for ring in &mut self.rings {
            ring.first = next;
            // More vertices than fit are refused when they are counted.
            next = next.wrapping_add(ring.n + 1);
        }
        &self.rings
    }

    /// The base and both sides of every storey.
    fn find_stops(&mut self, curve: &Curve<'_>, start: f32, storeys: &[Storey]) {
        self.stops.clear();
        self.ring_of_storey.clear();
        self.stops.push(Stop { along: start, n: None, mask: 0 });
        let radius = |along| curve.at(along).station.radius;
        if let Some(first) = storeys.first()
            && first.low <= start + 0.02 * radius(start)
        {
            self.stops.clear();
        }
        for storey in storeys {
            let n = Some(storey.n_sides);
            match self.stops.last_mut() {
                Some(last) if last.along >= storey.low && last.n == n => last.mask = storey.mask,
                _ => self.stops.push(Stop { along: storey.low, n, mask: storey.mask }),
            }
            self.stops.push(Stop { along: storey.high, n, mask: 0 });
        }
    }

    fn push(&mut self, wall: &Wall<'_>, place: &Place, n: Option<u32>, mask: u128) {
        if mask != 0 {
            self.ring_of_storey.push(self.rings.len() as u32);
        }
        let station = place.station;
        let n_sides = || wall.circles.n_sides(station.radius, station.along, &wall.flare);
        let frame = Frame { tangent: place.tangent, normal: Vec3::ZERO };
        let n = n.unwrap_or_else(n_sides);
        self.rings.push(Ring { station, frame, n, first: 0, mask });
    }

    /// Rings between two that stand; `open` when the upper one is the tip.
    fn fill(&mut self, wall: &Wall<'_>, from: &Place, to: &Place, open: bool, fineness: Fineness) {
        let room = CLEARANCE * (to.station.along - from.station.along);
        let near = |place: &Place| (CLEARANCE * place.station.radius).min(room);
        let low = from.station.along + near(from);
        let high = to.station.along - if open { 0.0 } else { near(to) };
        self.sample(wall, low, high, fineness);
        let mut end = *to;
        if open && wall.curve.pointed {
            end.station.radius = 0.0;
        }
        self.samples.push(end);
        let widened = |mut place: Place| {
            place.station.radius *= wall.flare.widest(place.station.along);
            place
        };
        let mut last = widened(*from);
        let mut kept = 0;
        while kept < self.samples.len() && self.rings.len() < fineness.max_rings {
            let mut ahead = kept;
            while let Some(next) = self.samples.get(ahead + 1)
                && ahead - kept < WINDOW
                && next.station.along - last.station.along < fineness.longest
                && (open && ahead + 2 == self.samples.len()
                    || last.tangent.dot(next.tangent) > TURN_COSINE)
                && goes_on(&last, next)
                && fits(&last.station, next, &self.samples[kept..=ahead], fineness.error)
            {
                ahead += 1;
            }
            // The last sample is the upper stop itself.
            if ahead + 1 >= self.samples.len() {
                break;
            }
            last = self.samples[ahead];
            let mut narrow = last;
            narrow.station.radius /= wall.flare.widest(last.station.along);
            self.push(wall, &narrow, None, 0);
            kept = ahead + 1;
        }
    }

    /// Places between `low` and `high` where the line could need a ring.
    fn sample(&mut self, wall: &Wall<'_>, low: f32, high: f32, fineness: Fineness) {
        self.samples.clear();
        let curve = &wall.curve;
        let nodes = curve.nodes;
        let first = nodes.partition_point(|node| node.along <= low).saturating_sub(1);
        for i in first..nodes.len() - 1 {
            let (a, b) = (nodes[i].along, nodes[i + 1].along);
            if a >= high {
                break;
            }
            let strips = ((b - a) / fineness.longest).ceil() as u32;
            let n = curve.n_pieces(i, fineness.error).max(strips);
            for k in 0..n {
                let along = a + (b - a) * k as f32 / n as f32;
                if along > low && along < high {
                    self.samples.push(curve.on(i, along));
                }
                if self.samples.len() > WINDOW.saturating_mul(fineness.max_rings) {
                    return;
                }
            }
        }
        if !wall.flare.acts(low) {
            return;
        }
        for along in wall.flare.stops() {
            if along > low && along < high {
                self.samples.push(curve.at(along));
            }
        }
        self.samples.sort_by(|a, b| a.station.along.total_cmp(&b.station.along));
        self.samples.dedup_by(|a, b| a.station.along - b.station.along < 0.1 * b.station.radius);
        // The flare is not in the radii: widen them for the search.
        for sample in &mut self.samples {
            sample.station.radius *= wall.flare.widest(sample.station.along);
        }
    }

    /// Turns ring planes no faster than their radius allows, and their frames with them.
    fn turn(&mut self, curve: &Curve<'_>) {
        for i in 0..self.rings.len() {
            let ring = self.rings[i];
            let mut tangent = ring.frame.tangent;
            if let Some(below) = i.checked_sub(1).map(|i| self.rings[i]) {
                let step = ring.station.position.distance(below.station.position);
                let radius = ring.station.radius.max(below.station.radius);
                let late = towards(below.frame.tangent, tangent, TURN_RATE * step / radius);
                tangent = towards(tangent, late, LATE_MAX);
            }
            self.rings[i].frame = curve.frame(&ring.station, tangent);
        }
    }
}

/// `to`, or the direction on the way to it that is `most` (a chord of the unit sphere) from `from`.
fn towards(from: Vec3, to: Vec3, most: f32) -> Vec3 {
    let chord = from.distance(to);
    if chord <= most {
        return to;
    }
    from.lerp(to, most / chord).try_normalize().unwrap_or(from)
}

/// Whether a strip from `a` to `b` goes the way that the line goes at `a`: small zigzags would stay
/// within the error, but turn a strip inside out.
fn goes_on(a: &Place, b: &Place) -> bool {
    let chord = b.station.position - a.station.position;
    chord.dot(a.tangent) > FORWARD * chord.length()
}

/// Whether all of `between` lie within `error` of the straight strip from `a` to `b`.
fn fits(a: &Station, b: &Place, between: &[Place], error: f32) -> bool {
    let chord = b.station.position - a.position;
    let inverse = 1.0 / chord.length_squared().max(f32::MIN_POSITIVE);
    between.iter().all(|place| {
        let arm = place.station.position - a.position;
        let t = (arm.dot(chord) * inverse).clamp(0.0, 1.0);
        let off = (arm - chord * t).length_squared();
        let radius = a.radius + t * (b.station.radius - a.radius);
        let rest = error - (place.station.radius - radius).abs();
        rest >= 0.0 && off <= rest * rest
    })
}
