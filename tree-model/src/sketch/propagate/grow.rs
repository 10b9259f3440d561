//! Attaches blocks to open ends.

use super::block::{Child, Pools};
use super::bound::{Bounds, Cut};
use super::drawn::{chain, code, habit, usual_ratio};
use super::frame::{BETWEEN, Frame};
use super::params::PropagateParams;
use crate::sketch::{Label, Omega};
use glam::Vec3;
use std::f32::consts::TAU;
use tree_core::Seed;
use tree_core::seed::{Rng, normal, uniform};

/// Lengths vary by up to this share either way, so that no copy is exact.
const LENGTH_VARIATION: f32 = 0.15;
/// How far an apical segment first goes on as its parent did, so that an axis has no kink at its forks, 0 to 1.
const EASE: f32 = 0.5;
/// What grows on a sketched segment is made smaller or larger by at most these factors to reach the crown's surface,
const FIT: [f32; 2] = [0.5, 2.5];
/// and what grows in the next generations by these.
const LATER_FIT: [f32; 2] = [0.7, 1.3];
/// Generations that are so fitted.
const FITTED: u32 = 4;
/// Generations that this reckons with at most: later ones hardly reach farther.
const FIT_GENERATIONS: u32 = 7;
/// A segment of which the surface leaves less than this share does not grow.
const LEAST_LEFT: f32 = 0.25;
/// How a segment is turned aside from an obstacle, and then shortened: turn of the azimuth, change of the angle, share
/// of the length.
const ASIDE: [(f32, f32, f32); 12] = [
    (0.0, 0.0, 1.0),
    (0.7, 0.0, 1.0),
    (-0.7, 0.0, 1.0),
    (1.5, 0.2, 1.0),
    (-1.5, 0.2, 1.0),
    (2.4, 0.2, 1.0),
    (-2.4, 0.2, 1.0),
    (3.1, 0.5, 1.0),
    (0.0, 0.0, 0.6),
    (1.5, 0.2, 0.6),
    (-1.5, 0.2, 0.6),
    (0.0, 0.0, 0.3),
];
/// The first of these that shortens.
const SHORTENED: usize = 8;

/// Points of a new segment.
const POINTS: usize = BETWEEN + 2;

/// A place where a block may be attached.
#[derive(Clone, Copy, Debug)]
pub(super) struct Open {
    /// The segment it is on, and where: counted in the segment's points.
    pub(super) segment: u32,
    pub(super) fork: f32,
    pub(super) point: Vec3,
    pub(super) frame: Frame,
    /// Azimuth of the block's first lateral.
    pub(super) turn: f32,
    /// Length that the block's ratios refer to; of laterals only, their own.
    pub(super) length: f32,
    pub(super) order: u32,
    pub(super) key: Seed,
    /// Number of the first lateral; `None` at an end, where an apical segment grows too.
    pub(super) laterals: Option<u16>,
    pub(super) generation: u32,
}

/// What happened while segments grew.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    pub(super) touched: u64,
    pub(super) outside: u64,
    pub(super) too_short: u64,
    pub(super) aside: u64,
    pub(super) shortened: u64,
    pub(super) dropped: u64,
}

/// New segments in columns, each with [`POINTS`] points or fewer.
#[derive(Clone, Debug, Default)]
pub(super) struct Part {
    pub(super) parents: Vec<u32>,
    pub(super) labels: Vec<Label>,
    pub(super) forks: Vec<f32>,
    pub(super) points: Vec<[Vec3; POINTS]>,
    pub(super) n_points: Vec<u8>,
    /// The open end of each, where it has one: its segment is the row here.
    pub(super) opens: Vec<Open>,
    pub(super) tally: Tally,
}

/// All that growing heeds.
pub(super) struct Grower<'a> {
    pub(super) pools: &'a Pools,
    pub(super) omega: &'a Omega,
    pub(super) bounds: Bounds<'a>,
    pub(super) params: &'a PropagateParams,
    pub(super) generations: u32,
    /// Length of the shortest segment in metres.
    pub(super) shortest: f32,
}

impl Grower<'_> {
    /// Attaches a block to each open place.
    pub(super) fn grow(&self, opens: &[Open]) -> Part {
        let mut part = Part::default();
        for open in opens {
            self.attach(open, &mut part);
        }
        part
    }

    fn attach(&self, open: &Open, part: &mut Part) {
        if !self.pools.branches(open.order) {
            return;
        }
        let mut number = open.laterals.unwrap_or(0);
        for child in self.pools.draw(open.order, open.key) {
            let mut child = *child;
            if child.label == Label::Apical {
                if open.laterals.is_some() {
                    continue;
                }
            } else {
                if open.order >= self.params.orders {
                    continue;
                }
                child.label = Label::Lateral(number);
                number = number.saturating_add(1);
            }
            self.child(open, &child, part);
        }
    }

    fn child(&self, open: &Open, child: &Child, part: &mut Part) {
        let key = open.key.child(code(child.label));
        let rng = &mut key.rng();
        let apical = child.label == Label::Apical;
        let jitter = self.params.jitter;
        let ratio = if open.laterals.is_some() { 1.0 } else { child.ratio };
        let mut length =
            open.length * ratio * uniform(rng, 1.0 - LENGTH_VARIATION, 1.0 + LENGTH_VARIATION);
        let angle = child.angle + uniform(rng, -jitter, jitter);
        let azimuth = open.turn + child.azimuth + uniform(rng, -jitter, jitter);
        let order = open.order + u32::from(!apical);
        if open.generation < FITTED && self.bounds.crown.is_some() {
            let [along, ..] = open.frame.child(angle, azimuth);
            length *= self.fit(open, along, length, order);
        }
        if length < self.shortest {
            part.tally.too_short += 1;
            return;
        }
        let Some((points, n, touched)) = self.place(open, child, [angle, azimuth, length], part)
        else {
            return;
        };
        let row = part.parents.len() as u32;
        part.parents.push(open.segment);
        part.labels.push(child.label);
        part.forks.push(open.fork);
        part.points.push(points);
        part.n_points.push(n as u8);
        part.tally.touched += u64::from(touched);
        if touched || open.generation + 1 >= self.generations {
            return;
        }
        let (point, frame) = (points[n - 1], open.frame);
        part.opens.push(Open {
            segment: row,
            fork: (n - 1) as f32,
            point,
            frame: frame.carried((point - open.point).normalize_or(frame.along)),
            turn: if apical { self.turned(open.turn, order, rng) } else { uniform(rng, 0.0, TAU) },
            length: length.min(open.point.distance(point)),
            order,
            key,
            laterals: None,
            generation: open.generation + 1,
        });
    }

    /// The azimuth of the next fork's first lateral: γ on from the last.
    pub(super) fn turned(&self, turn: f32, order: u32, rng: &mut Rng) -> f32 {
        let gamma = habit(self.omega, order).gamma;
        (turn + gamma.mean + gamma.deviation * normal(rng)) % TAU
    }

    /// How much smaller or larger to make a child and what grows on it, so that it reaches the crown's surface.
    fn fit(&self, open: &Open, along: Vec3, length: f32, order: u32) -> f32 {
        let [least, most] = if open.generation == 0 { FIT } else { LATER_FIT };
        let ratio = usual_ratio(habit(self.omega, order));
        let left = self.generations - open.generation;
        let reach = length * chain(ratio, left.min(FIT_GENERATIONS));
        let room = self.bounds.room(open.point, along, most * reach);
        room.map_or(most, |room| (room / reach).clamp(least, most))
    }

    /// Finds a place for a child of this angle, azimuth and length: its points, how many, and whether it touches the
    /// crown's surface.
    fn place(
        &self,
        open: &Open,
        child: &Child,
        [angle, azimuth, length]: [f32; 3],
        part: &mut Part,
    ) -> Option<([Vec3; POINTS], usize, bool)> {
        for (attempt, (turn, tilt, share)) in ASIDE.into_iter().enumerate() {
            let length = share * length;
            let mut points = self.points(open, child, angle + tilt, azimuth + turn, length);
            let (mut n, mut touched) = (POINTS, false);
            if let Cut::At(kept, end) = self.bounds.cut(&points) {
                (n, touched) = (kept, true);
                points[n - 1] = end;
                if end.distance(open.point) < (LEAST_LEFT * length).max(0.5 * self.shortest) {
                    part.tally.outside += 1;
                    return None;
                }
            }
            if self.bounds.is_free(&points[..n]) {
                part.tally.aside += u64::from(attempt > 0 && attempt < SHORTENED);
                part.tally.shortened += u64::from(attempt >= SHORTENED);
                return Some((points, n, touched));
            }
        }
        part.tally.dropped += 1;
        None
    }

    /// The points of a segment: the straight way, the block's bend, and at the beginning some of the parent's
    /// direction.
    fn points(
        &self,
        open: &Open,
        child: &Child,
        angle: f32,
        azimuth: f32,
        length: f32,
    ) -> [Vec3; POINTS] {
        let [along, bow, side] = open.frame.child(angle, azimuth);
        let down = self.params.gravitropism * Vec3::NEG_Y;
        let along = (along + down).normalize_or(along);
        let ease = if child.label == Label::Apical { EASE } else { 0.0 };
        let entry = ease * (open.frame.along - along);
        std::array::from_fn(|i| {
            let share = i as f32 / (POINTS - 1) as f32;
            let off = match i {
                0 => return open.point,
                1..=BETWEEN => child.bend[i - 1].x * bow + child.bend[i - 1].y * side,
                _ => Vec3::ZERO,
            };
            let rest = 1.0 - share;
            open.point + length * (share * along + off + share * rest * rest * entry)
        })
    }
}
