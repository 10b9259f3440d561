//! Where on an axis rings stand, and how they are turned.
//!
//! Rings stand at the base, on both sides of every storey, and between them where the line or its
//! radius leaves the straight by more than the error: from each ring the next is set as far ahead as
//! the error allows. Rings follow twist-free frames; where the line turns sharper than a ring's radius
//! allows, their planes turn later than the line, so that they do not cut into each other.

use super::curve::{Curve, Station};
use super::frame::Frame;
use super::storey::{Storey, Storeys, Wall};
use glam::Vec3;

/// Samples that one strip may pass over: bounds the cost of the search at this many steps a ring.
const WINDOW: usize = 24;
/// Cosine of the largest turn between neighbouring rings.
const TURN_COSINE: f32 = 0.8;
/// Share of its radius that a ring may be turned by for each step of that length.
const TURN_RATE: f32 = 0.8;
/// No ring stands nearer to a storey than this share of its radius.
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
}

/// Finds rings; reused from axis to axis.
#[derive(Debug, Default)]
pub(crate) struct RingFinder {
    stops: Vec<Stop>,
    samples: Vec<Station>,
    tangents: Vec<Vec3>,
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
        self.tangents.clear();
        self.find_stops(&wall.curve, start, &storeys.storeys);
        let end = wall.curve.length();
        for i in 0..self.stops.len() {
            let stop = self.stops[i];
            self.push(wall, stop);
            let next = self.stops.get(i + 1).map_or(end, |next| next.along);
            let open = i + 1 == self.stops.len();
            if stop.mask == 0 {
                self.fill(wall, stop.along, next, open, fineness);
            }
        }
        if !wall.curve.pointed {
            self.push(wall, Stop { along: end, n: None, mask: 0 });
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

    fn push(&mut self, wall: &Wall<'_>, stop: Stop) {
        if stop.mask != 0 {
            self.ring_of_storey.push(self.rings.len() as u32);
        }
        let place = wall.curve.at(stop.along);
        let station = place.station;
        let n = || wall.circles.n_sides(station.radius, station.along, &wall.flare);
        let frame = Frame { tangent: place.tangent, normal: Vec3::ZERO };
        let n = stop.n.unwrap_or_else(n);
        self.rings.push(Ring { station, frame, n, first: 0, mask: stop.mask });
    }

    /// Rings between two that stand; `open` when the upper one is the tip.
    fn fill(&mut self, wall: &Wall<'_>, from: f32, to: f32, open: bool, fineness: Fineness) {
        let curve = &wall.curve;
        let near = |along: f32| CLEARANCE * curve.at(along).station.radius;
        let (low, high) = (from + near(from), to - if open { 0.0 } else { near(to) });
        self.sample(wall, low, high, fineness.error);
        let end = Station { radius: curve.at(to).station.radius, ..curve.at(to).station };
        self.samples.push(if open && curve.pointed { Station { radius: 0.0, ..end } } else { end });
        let mut last = curve.at(from).station;
        last.radius *= wall.flare.widest(from);
        let mut kept = 0;
        while kept < self.samples.len() {
            let mut ahead = kept;
            while ahead + 1 < self.samples.len()
                && ahead - kept < WINDOW
                && self.samples[ahead + 1].along - last.along < fineness.longest
                && fits(last, self.samples[ahead + 1], &self.samples[kept..=ahead], fineness.error)
                && self.turns_little(curve, last, self.samples[ahead + 1])
            {
                ahead += 1;
            }
            // The last sample is the upper stop itself.
            if ahead + 1 >= self.samples.len() {
                break;
            }
            last = self.samples[ahead];
            self.push(wall, Stop { along: last.along, n: None, mask: 0 });
            kept = ahead + 1;
        }
    }

    fn turns_little(&self, curve: &Curve<'_>, a: Station, b: Station) -> bool {
        b.along >= curve.length()
            || curve.at(a.along).tangent.dot(curve.at(b.along).tangent) > TURN_COSINE
    }

    /// Places between `low` and `high` where the line could need a ring.
    fn sample(&mut self, wall: &Wall<'_>, low: f32, high: f32, error: f32) {
        self.samples.clear();
        let curve = &wall.curve;
        let nodes = curve.nodes;
        let first = nodes.partition_point(|node| node.along <= low).saturating_sub(1);
        for i in first..nodes.len() - 1 {
            let (a, b) = (nodes[i].along, nodes[i + 1].along);
            if a >= high {
                break;
            }
            let n = curve.n_pieces(i, error);
            for k in 0..n {
                let along = a + (b - a) * k as f32 / n as f32;
                if along > low && along < high {
                    self.samples.push(curve.at(along).station);
                }
            }
        }
        for along in wall.flare.stops() {
            if along > low && along < high {
                self.samples.push(curve.at(along).station);
            }
        }
        if wall.flare.acts(low) {
            self.samples.sort_by(|a, b| a.along.total_cmp(&b.along));
            self.samples.dedup_by(|a, b| a.along - b.along < 0.1 * b.radius);
            // The flare is not in the radii: widen them for the search.
            for sample in &mut self.samples {
                sample.radius *= wall.flare.widest(sample.along);
            }
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
                tangent = towards(below.frame.tangent, tangent, TURN_RATE * step / radius);
            }
            let place = curve.at(ring.station.along);
            self.rings[i].frame = curve.frame(&place, tangent);
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

/// Whether all of `between` lie within `error` of the straight strip from `a` to `b`.
fn fits(a: Station, b: Station, between: &[Station], error: f32) -> bool {
    let chord = b.position - a.position;
    let squared = chord.length_squared().max(f32::MIN_POSITIVE);
    between.iter().all(|station| {
        let arm = station.position - a.position;
        let t = (arm.dot(chord) / squared).clamp(0.0, 1.0);
        let off = (arm - chord * t).length();
        let radius = a.radius + t * (b.radius - a.radius);
        off + (station.radius - radius).abs() <= error
    })
}
