//! A row becomes path-planning parameters: its trunk, arms and laterals are drawn as thin tubes, whose union is the
//! volume of level 1. Paths to the tubes' ends are the main branches; subgraphs along them are the twigs.
//!
//! Directions, lengths and places are drawn from normal distributions about the row's, so that trees of one row differ
//! as trees of one species do, and Ω has something to measure.

use super::row::{Arms, Laterals, Row, Toward, Twigs};
use crate::error::Result;
use crate::path::{Endpoints, Level, LevelAxis, Lifespan, LinkParams, PathParams, SubShape};
use glam::{Quat, Vec2, Vec3};
use tree_core::allometry::{PipeModel, RadiusRule};
use tree_core::seed::normal;
use tree_core::{Rng, Seed, Species, Volume};

/// Deviation of directions, in degrees.
const ANGLE_DEVIATION: f32 = 5.0;
/// Deviation of turns about an axis, in degrees.
const TURN_DEVIATION: f32 = 8.0;
/// Deviation of the logarithm of lengths.
const LENGTH_DEVIATION: f32 = 0.08;
/// Pieces a bent tube is made of.
const PIECES: u32 = 4;
/// Radius of a tube as a share of the height: so thin that paths run in it one after another.
const TUBE: f32 = 0.011;
/// Radius of a tube in separations of the search graph's nodes.
const TUBE_IN_SEPARATIONS: f32 = 0.75;
/// How much shorter the outermost lateral of an arm is than its innermost, as a share.
const LATERAL_TAPER: f32 = 0.5;
/// Where on an arm the outermost lateral stands.
const LAST_LATERAL: f32 = 0.88;
/// How much smaller twigs are from level to level.
const SHRINK: f32 = 0.6;

/// The middle line of a tube.
struct Guide {
    points: Vec<Vec3>,
    /// From which share of its length on it bears twigs.
    bare: f32,
}

/// The parameters of a row's tree.
pub(super) fn params(row: &Row, seed: Seed) -> Result<PathParams> {
    let guides = guides(row, &mut seed.stream("scaffold").rng());
    let radius = TUBE * row.height;
    let volume = tubes(&guides, radius)?;
    let separation = radius / TUBE_IN_SEPARATIONS;
    let length: f32 = guides.iter().map(|guide| length_of(&guide.points)).sum();
    let measure = std::f32::consts::PI * radius * radius * length;
    // The graph's fill factor: this many nodes lie about a separation apart.
    let nodes = crate::path::nodes::FILL * measure / (separation * separation * separation);
    let (levels, size) = row
        .twigs
        .map_or((Vec::new(), row.height), |twigs| (twigs.levels(), twigs.size * row.height));
    let (kind, leaves) = row.leaves.clone().unzip();
    Ok(PathParams {
        volume,
        root: Vec3::ZERO,
        graph_nodes: (nodes as u32).max(64),
        endpoints: Endpoints { random: 0, placed: ends(row, &guides), ..Endpoints::default() },
        size,
        shrink: SHRINK,
        levels,
        lifespan: Lifespan::Full,
        linking: LinkParams { low: row.low, ..LinkParams::default() },
        paint: Vec::new(),
        cost: None,
        obstacle: None,
        smoothing: row.smoothing,
        radii: RadiusRule::Pipe(PipeModel {
            exponent: row.pipe_exponent,
            trunk_radius: Some(row.trunk_radius),
            ..PipeModel::default()
        }),
        leaves,
        species: Species {
            name: row.species.into(),
            bark: row.bark.into(),
            leaf_kinds: kind.map(str::to_owned).into_iter().collect(),
        },
        roots: None,
    })
}

impl Twigs {
    fn levels(&self) -> Vec<Level> {
        let level = Level {
            branching: self.branching,
            shape: SubShape::Sector { angle: self.angle.to_radians() },
            graph_nodes: 60,
            axis: match self.toward {
                Toward::Outward => LevelAxis::Outward,
                Toward::Down => LevelAxis::Down,
                Toward::Up => LevelAxis::Fixed(Vec3::Y),
            },
            ..Level::default()
        };
        vec![level; self.levels as usize]
    }
}

/// Trunk, arms and laterals, in metres.
fn guides(row: &Row, rng: &mut Rng) -> Vec<Guide> {
    let trunk = trunk(row, rng);
    let on_trunk = row.twigs.is_some_and(|twigs| twigs.on_trunk);
    let mut guides = Vec::new();
    if row.leader > 0.0 {
        let lowest = row.arms.iter().map(|arms| arms.height[0]).fold(1.0, f32::min);
        let bare = if on_trunk { lowest / row.leader } else { 1.0 };
        guides.push(Guide { points: trunk.clone(), bare });
    }
    let mut azimuth = 360.0 * rand_unit(rng);
    for arms in row.arms {
        for number in 0..arms.count {
            let step = if number % arms.whorl == 0 { arms.turn } else { 360.0 / arms.whorl as f32 };
            azimuth += step;
            let arm = arms.arm(number, azimuth, row.height, &trunk, rng);
            if let Some(laterals) = &row.laterals {
                guides.extend(laterals.of(&arm, arms.bare, row.height, rng));
            }
            guides.push(Guide { points: arm, bare: arms.bare });
        }
    }
    guides
}

/// A line up from the origin that strays a little.
fn trunk(row: &Row, rng: &mut Rng) -> Vec<Vec3> {
    let top = row.leader * row.height;
    let sway = row.sway * row.height;
    let mut aside = Vec2::ZERO;
    let mut points = vec![Vec3::ZERO];
    for piece in 1..=2 * PIECES {
        aside += 0.5 * sway * Vec2::new(normal(rng), normal(rng));
        points.push(Vec3::new(aside.x, top * piece as f32 / (2 * PIECES) as f32, aside.y));
    }
    points
}

impl Arms {
    /// The arm of this number, which leaves the trunk towards `azimuth`.
    fn arm(
        &self,
        number: u32,
        azimuth: f32,
        height: f32,
        trunk: &[Vec3],
        rng: &mut Rng,
    ) -> Vec<Vec3> {
        let whorls = (self.count / self.whorl).max(2) - 1;
        let t = (number / self.whorl) as f32 / whorls as f32;
        let t = t.min(1.0);
        let at = mix(self.height[0], self.height[1], t) * height;
        let angle = mix(self.angle[0], self.angle[1], t) + ANGLE_DEVIATION * normal(rng);
        let azimuth = (azimuth + TURN_DEVIATION * normal(rng)).to_radians();
        let [low, middle, high] = self.length;
        let length =
            if t < 0.5 { mix(low, middle, 2.0 * t) } else { mix(middle, high, 2.0 * t - 1.0) };
        let length = length * height * libm::expf(LENGTH_DEVIATION * normal(rng));
        let (sin, cos) = libm::sincosf(angle.to_radians());
        let (x, z) = (libm::cosf(azimuth), libm::sinf(azimuth));
        let direction = Vec3::new(sin * x, cos, sin * z);
        bent(at_height(trunk, at), direction, length, self.bend)
    }
}

impl Laterals {
    /// The laterals of an arm.
    fn of(&self, arm: &[Vec3], bare: f32, height: f32, rng: &mut Rng) -> Vec<Guide> {
        let length = length_of(arm);
        if length < self.from_length * height {
            return Vec::new();
        }
        // The first stands at one side, level with the arm.
        let mut turn = 90.0 + 360.0 * f32::from(rand_unit(rng) < 0.5) * 0.5;
        let mut out = Vec::new();
        for number in 0..self.count {
            let t = (number as f32 + 0.5 + 0.15 * normal(rng)) / self.count as f32;
            let share = mix(bare, LAST_LATERAL, t).clamp(0.05, 0.95);
            let (start, along) = along(arm, share);
            let angle = (self.angle + ANGLE_DEVIATION * normal(rng)).to_radians();
            let about =
                Quat::from_axis_angle(along, (turn + TURN_DEVIATION * normal(rng)).to_radians());
            let (sin, cos) = libm::sincosf(angle);
            let direction = cos * along + sin * (about * upper_side(along));
            let own = self.length
                * length
                * (1.0 - LATERAL_TAPER * t)
                * libm::expf(LENGTH_DEVIATION * normal(rng));
            out.push(Guide { points: bent(start, direction, own, self.bend), bare: 0.25 });
            turn += self.turn;
        }
        out
    }
}

/// The unit vector across `along` that points most upwards.
fn upper_side(along: Vec3) -> Vec3 {
    (Vec3::Y - Vec3::Y.dot(along) * along).try_normalize().unwrap_or(Vec3::X)
}

/// A line that bends evenly by `bend` degrees, upwards where positive, at most until it is vertical.
fn bent(start: Vec3, direction: Vec3, length: f32, bend: f32) -> Vec<Vec3> {
    let mut points = vec![start];
    let mut direction = direction;
    let goal = if bend > 0.0 { Vec3::Y } else { Vec3::NEG_Y };
    let step = bend.abs().to_radians() / PIECES as f32;
    let mut at = start;
    for _ in 0..PIECES {
        at += direction * (length / PIECES as f32);
        points.push(at);
        if let Some(axis) = direction.cross(goal).try_normalize() {
            let left = libm::acosf(direction.dot(goal).clamp(-1.0, 1.0));
            direction = Quat::from_axis_angle(axis, step.min(0.95 * left)) * direction;
        }
    }
    points
}

/// Ends of level 1: those of all tubes, and where twigs stand.
fn ends(row: &Row, guides: &[Guide]) -> Vec<Vec3> {
    let mut ends = Vec::new();
    for (number, guide) in guides.iter().enumerate() {
        let is_fork = number == 0 && row.leader > 0.0 && row.leader < 0.75;
        if !is_fork {
            ends.extend(guide.points.last());
        }
        let Some(twigs) = row.twigs else { continue };
        let length = length_of(&guide.points);
        let free = (1.0 - guide.bare) * length;
        let n = (free / (twigs.spacing * row.height)) as u32;
        ends.extend((0..n).map(|i| {
            let share = guide.bare + (1.0 - guide.bare) * (i as f32 + 0.5) / n as f32;
            along(&guide.points, share).0
        }));
    }
    ends
}

/// The union of tubes round the guides.
fn tubes(guides: &[Guide], radius: f32) -> Result<Volume> {
    let pieces = guides.iter().flat_map(|guide| guide.points.windows(2));
    let parts =
        pieces.map(|p| Volume::capsule(p[0], p[1], radius)).collect::<Result<Vec<_>, _>>()?;
    Ok(Volume::union_all(parts)?)
}

fn length_of(points: &[Vec3]) -> f32 {
    points.windows(2).map(|p| p[0].distance(p[1])).sum()
}

/// The point at a share of a line's length, and the line's direction there.
fn along(points: &[Vec3], share: f32) -> (Vec3, Vec3) {
    let mut left = share * length_of(points);
    let mut last = (Vec3::ZERO, Vec3::Y);
    for p in points.windows(2) {
        let step = p[1] - p[0];
        let direction = step.try_normalize().unwrap_or(Vec3::Y);
        if left <= step.length() {
            return (p[0] + left * direction, direction);
        }
        left -= step.length();
        last = (p[1], direction);
    }
    last
}

/// Where a rising line has this height; its end where it has not.
fn at_height(points: &[Vec3], height: f32) -> Vec3 {
    for p in points.windows(2) {
        if height <= p[1].y {
            let t = (height - p[0].y) / (p[1].y - p[0].y).max(1e-6);
            return p[0].lerp(p[1], t.clamp(0.0, 1.0));
        }
    }
    points.last().copied().unwrap_or_default()
}

fn mix(a: f32, b: f32, t: f32) -> f32 {
    a + (b - a) * t
}

fn rand_unit(rng: &mut Rng) -> f32 {
    tree_core::seed::uniform(rng, 0.0, 1.0)
}
