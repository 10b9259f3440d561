//! Outlines: closed polygons without crossings.

use glam::Vec2;

/// A closed outline: a simple polygon against the clock, of at least three points, finite, none repeated (the first not
/// at the end either). Metres, y up.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    points: Vec<Vec2>,
}

impl Outline {
    /// Of points that are known to be such a polygon.
    #[allow(dead_code)]
    pub(crate) fn of_simple(points: Vec<Vec2>) -> Self {
        Self { points }
    }

    /// Its corners, against the clock.
    #[must_use]
    pub fn points(&self) -> &[Vec2] {
        &self.points
    }

    /// Its sides, each from a corner to the next, the last back to the first.
    pub fn sides(&self) -> impl Iterator<Item = (Vec2, Vec2)> + '_ {
        let next = self.points.iter().skip(1).chain(self.points.first());
        self.points.iter().zip(next).map(|(&a, &b)| (a, b))
    }

    /// Area in square metres. O(points).
    #[must_use]
    pub fn area(&self) -> f32 {
        (0.5 * self.sides().map(|(a, b)| f64::from(a.perp_dot(b))).sum::<f64>()) as f32
    }

    /// Its length round in metres. O(points).
    #[must_use]
    pub fn perimeter(&self) -> f32 {
        self.sides().map(|(a, b)| a.distance(b)).sum()
    }

    /// The lowest and highest coordinates. O(points).
    #[must_use]
    pub fn bounds(&self) -> (Vec2, Vec2) {
        let all = || self.points.iter().copied();
        (all().fold(Vec2::INFINITY, Vec2::min), all().fold(Vec2::NEG_INFINITY, Vec2::max))
    }

    /// Whether a point lies inside. O(points).
    #[must_use]
    pub fn contains(&self, point: Vec2) -> bool {
        let crosses = |&(a, b): &(Vec2, Vec2)| {
            (a.y > point.y) != (b.y > point.y)
                && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
        };
        self.sides().filter(crosses).count() % 2 == 1
    }

    /// How far it is from a point along a unit direction to the outline, the first crossing in front; `None` where there is
    /// none. From outside that is the near side. O(points).
    #[must_use]
    pub fn exit(&self, from: Vec2, direction: Vec2) -> Option<f32> {
        let mut best: Option<f32> = None;
        for (a, b) in self.sides() {
            let side = b - a;
            let cross = direction.perp_dot(side);
            if cross == 0.0 {
                continue;
            }
            let (way, part) =
                ((a - from).perp_dot(side) / cross, (a - from).perp_dot(direction) / cross);
            if way > 0.0 && (0.0..=1.0).contains(&part) && best.is_none_or(|best| way < best) {
                best = Some(way);
            }
        }
        best
    }
}
