//! What can be said of a stroke's shape alone.

use super::sample::resample;
use super::tidy::{Extent, Ink, length};
use glam::Vec2;

/// Turning is measured between points at this share of the height.
const TURN_STEP: f32 = 0.03;

/// Figures of a stroke.
pub(super) struct Shape {
    pub(super) extent: Extent,
    pub(super) length: f32,
    /// Distance between its ends.
    pub(super) gap: f32,
    /// Area enclosed with the line between its ends.
    pub(super) area: f32,
    /// Sum of all turns, left or right, in radians.
    pub(super) turning: f32,
    /// Whether both ends lie lower than its middle: as those of an arch.
    pub(super) arched: bool,
}

impl Shape {
    pub(super) fn of(ink: &Ink, unit: f32) -> Self {
        let points = &ink.points;
        let (first, last) = ends(points);
        let even = resample(points, TURN_STEP * unit, unit);
        let middle = even.iter().sum::<Vec2>() / even.len().max(1) as f32;
        Self {
            extent: Extent::of(points),
            length: length(points),
            gap: first.distance(last),
            area: area(points),
            turning: even.windows(3).map(|w| (w[1] - w[0]).angle_to(w[2] - w[1]).abs()).sum(),
            arched: first.y > middle.y && last.y > middle.y,
        }
    }

    /// Mean width of what the stroke encloses: of a long band its width, of a circle its radius.
    pub(super) fn width(&self) -> f32 {
        2.0 * self.area / (self.length + self.gap)
    }
}

/// First and last point.
pub(super) fn ends(points: &[Vec2]) -> (Vec2, Vec2) {
    let first = points.first().copied().unwrap_or_default();
    (first, points.last().copied().unwrap_or(first))
}

fn area(points: &[Vec2]) -> f32 {
    let (first, last) = ends(points);
    let twice = |a: Vec2, b: Vec2| f64::from((a - first).perp_dot(b - first));
    let sum: f64 = points.windows(2).map(|pair| twice(pair[0], pair[1])).sum();
    (0.5 * (sum + twice(last, first))).abs() as f32
}

/// Whether a point lies within a closed polygon (even-odd rule).
pub(super) fn contains(polygon: &[Vec2], p: Vec2) -> bool {
    let mut inside = false;
    let (_, mut a) = ends(polygon);
    for &b in polygon {
        if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) {
            inside = !inside;
        }
        a = b;
    }
    inside
}

/// Leftmost and rightmost place of a closed polygon at a height.
pub(super) fn slice(polygon: &[Vec2], y: f32) -> Option<(f32, f32)> {
    let (_, mut a) = ends(polygon);
    let mut range: Option<(f32, f32)> = None;
    for &b in polygon {
        if (a.y > y) != (b.y > y) {
            let x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
            range = Some(range.map_or((x, x), |(low, high)| (low.min(x), high.max(x))));
        }
        a = b;
    }
    range
}
