//! Where along an axis foliage begins, and axes that a crown's outline alone gives.

use crate::silhouette::bump::Bump;
use crate::silhouette::{Line, Outline};
use glam::Vec2;

/// Places along an axis at which the outline is asked.
const SAMPLES: usize = 96;
/// Branches leave no lower than this share of the part inside the outline.
const LOWEST: f32 = 0.02;
/// And no higher: the tip is the axis' own.
const HIGHEST: f32 = 0.97;
/// An axis that runs through less than this share of the crown is lengthened.
const SHORT: f32 = 0.3;
/// How far a lengthened axis reaches towards the far side of the crown.
const REACH: f32 = 0.86;

/// The part of the axis inside the outline, as shares of its length, a little inside; all where none of it is.
pub(super) fn foliage_part(axis: &Line, outline: &Outline) -> [f32; 2] {
    let inside: Vec<f32> = (0..=SAMPLES)
        .map(|i| i as f32 / SAMPLES as f32)
        .filter(|&t| outline.contains(axis.at(t)))
        .collect();
    let (Some(&low), Some(&high)) = (inside.first(), inside.last()) else {
        return [0.0, 1.0];
    };
    let size = high - low;
    [low + LOWEST * size, low + HIGHEST * size]
}

/// Whether a bump is where the axis enters its outline from below, not a branch's.
pub(super) fn is_foot(axis: &Line, within: [f32; 2], bump: &Bump) -> bool {
    let (t, distance) = axis.nearest(bump.tip);
    let downwards = bump.tangent.dot(axis.tangent(t)) < -0.5;
    let below = t <= within[0] + 0.05 * (within[1] - within[0]);
    below && downwards && distance <= 2.0 * bump.radius.max(0.02 * axis.length())
}

/// The axis of a crown: as drawn, where it runs through enough of the crown, leaves at its top, or ends where fronds
/// radiate from; lengthened into the crown where it ends early; and where nothing was drawn, from the crown's foot.
pub(crate) fn axis_of(trunk: Option<&Line>, outline: &Outline, bumps: &[Bump]) -> Option<Line> {
    let Some(trunk) = trunk else {
        return lengthened(&[foot_of(outline)], None, outline);
    };
    let (low, high) = outline.bounds();
    let [from, to] = foliage_part(trunk, outline);
    let within = outline.contains(trunk.end());
    let long_enough = within && (to - from) * trunk.length() >= SHORT * (high - low).y;
    let touches = (0..=SAMPLES).any(|i| outline.contains(trunk.at(i as f32 / SAMPLES as f32)));
    let is_through = touches && !within && trunk.end().y > 0.5 * (low.y + high.y);
    if long_enough || is_through || (within && radiate(trunk.end(), bumps)) {
        return Some(trunk.clone());
    }
    // The direction of its upper part: pens hook at the end.
    let upper = (trunk.at(0.95) - trunk.at(0.4)).try_normalize();
    let kept = trunk.part(0.0, 0.95)?;
    lengthened(kept.points(), upper, outline)
}

/// Whether most bumps are narrow and point away from one place: fronds of a palm or a fern.
fn radiate(heart: Vec2, bumps: &[Bump]) -> bool {
    /// Radius of a frond over its distance, at most.
    const NARROW: f32 = 0.2;
    /// Cosine of the angle between a frond's end and the way to it, at least: fronds arch.
    const AWAY: f32 = 0.3;
    /// Share of bumps that are fronds, and fewest.
    const MOST: f32 = 0.6;
    const FEWEST: usize = 4;
    let is_frond = |bump: &&Bump| {
        let way = bump.center - heart;
        bump.radius < NARROW * way.length() && bump.tangent.dot(way.normalize_or_zero()) > AWAY
    };
    let n = bumps.iter().filter(is_frond).count();
    n >= FEWEST && n as f32 >= MOST * bumps.len() as f32
}

/// The middle of a crown's lowest part.
fn foot_of(outline: &Outline) -> Vec2 {
    /// What counts as lowest, as a share of the height.
    const LOW: f32 = 0.04;
    let (low, high) = outline.bounds();
    let limit = low.y + LOW * (high.y - low.y);
    let lowest = outline.points().iter().filter(|point| point.y <= limit);
    let (least, most) = lowest.fold((f32::INFINITY, f32::NEG_INFINITY), |(least, most), point| {
        (least.min(point.x), most.max(point.x))
    });
    Vec2::new(0.5 * (least + most), low.y)
}

/// A line lengthened by a curve through the crown's middle, nearly to its far side.
fn lengthened(points: &[Vec2], direction: Option<Vec2>, outline: &Outline) -> Option<Line> {
    /// Points of the curve.
    const POINTS: usize = 12;
    let from = *points.last()?;
    let way = (centroid(outline) - from).try_normalize().unwrap_or(Vec2::Y);
    let to = from + REACH * farthest(outline, from, way)? * way;
    let reach = from.distance(to);
    // A trunk that leads elsewhere is not followed far.
    let direction = direction.filter(|direction| direction.dot(way) > 0.5).unwrap_or(way);
    let leave = 0.6 * reach * direction;
    let mut line = points.to_vec();
    line.extend((1..=POINTS).map(|i| {
        let s = i as f32 / POINTS as f32;
        // A cubic Hermite curve that arrives along the way through the middle.
        let (s2, s3) = (s * s, s * s * s);
        (2.0 * s3 - 3.0 * s2 + 1.0) * from
            + (s3 - 2.0 * s2 + s) * leave
            + (3.0 * s2 - 2.0 * s3) * to
            + (s3 - s2) * 0.6 * reach * way
    }));
    Line::new(line)
}

/// The middle of an outline's area.
fn centroid(outline: &Outline) -> Vec2 {
    let first = outline.points().first().copied().unwrap_or_default();
    let (mut sum, mut weight) = (Vec2::ZERO, 0.0);
    for (a, b) in outline.sides() {
        let area = (a - first).perp_dot(b - first);
        sum += area * ((a - first) + (b - first)) / 3.0;
        weight += area;
    }
    first + sum / weight.max(f32::MIN_POSITIVE)
}

/// The farthest crossing of an outline along a ray.
fn farthest(outline: &Outline, from: Vec2, way: Vec2) -> Option<f32> {
    let crossing = |(a, b): (Vec2, Vec2)| {
        let cross = way.perp_dot(b - a);
        let (far, part) = ((a - from).perp_dot(b - a) / cross, (a - from).perp_dot(way) / cross);
        (far > 0.0 && (0.0..=1.0).contains(&part)).then_some(far)
    };
    outline.sides().filter_map(crossing).max_by(f32::total_cmp)
}
