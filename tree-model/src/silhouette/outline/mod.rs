//! Outlines: closed polygons without crossings, against the clock.
//!
//! * [`Outline::close`] makes one of any drawn stroke and lists what was repaired. [`Outline::from_points`] only
//!   checks.
//! * `measure`: lengths along an outline, its nearest point, masks, the area two outlines have in common.
//! * [`LeafOutline`]: an outline drawn as a leaf, in triangles (Wither et al. 2009, section 5.3: the leaf is the last
//!   level).
//!
//! The paper says nothing about bad strokes. Ours are closed, turned and made simple as crowns of sketches are
//! ([`Crown`](crate::sketch::crown::Crown)).
//!
//! Closing is O(n log n + crossings) for n points. Each measure tells its own cost.

mod close;
mod leaf;
mod measure;
mod report;

pub use close::OutlineParams;
pub use leaf::LeafOutline;
pub use report::OutlineRepair;

use crate::error::ModelError;
use glam::Vec2;

/// A closed outline: a simple polygon against the clock, of at least three points, finite, none repeated (the first not
/// at the end either). Metres, y up.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "Vec<Vec2>", into = "Vec<Vec2>")
)]
pub struct Outline {
    points: Vec<Vec2>,
    /// Length from the first corner to each.
    along: Vec<f32>,
    perimeter: f32,
}

impl Outline {
    /// Of points that are known to be such a polygon.
    pub(crate) fn of_simple(points: Vec<Vec2>) -> Self {
        let mut along = Vec::with_capacity(points.len());
        let mut length = 0.0;
        for (i, &point) in points.iter().enumerate() {
            along.push(length);
            length += point.distance(points[(i + 1) % points.len()]);
        }
        Self { points, along, perimeter: length }
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
        area(&self.points) as f32
    }

    /// Its length round in metres.
    #[must_use]
    pub fn perimeter(&self) -> f32 {
        self.perimeter
    }

    /// The lowest and highest coordinates. O(points).
    #[must_use]
    pub fn bounds(&self) -> (Vec2, Vec2) {
        bounds(&self.points)
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

impl TryFrom<Vec<Vec2>> for Outline {
    type Error = ModelError;

    fn try_from(points: Vec<Vec2>) -> Result<Self, Self::Error> {
        Self::from_points(points)
    }
}

impl From<Outline> for Vec<Vec2> {
    fn from(outline: Outline) -> Self {
        outline.points
    }
}

/// Area of a closed line, above 0 against the clock. From its first point, as drawings may lie far from the origin.
fn area(points: &[Vec2]) -> f64 {
    let Some(&origin) = points.first() else { return 0.0 };
    let from = |point: Vec2| point.as_dvec2() - origin.as_dvec2();
    0.5 * points.windows(2).map(|pair| from(pair[0]).perp_dot(from(pair[1]))).sum::<f64>()
}

/// The lowest and highest coordinates of points.
fn bounds(points: &[Vec2]) -> (Vec2, Vec2) {
    let all = || points.iter().copied();
    (all().fold(Vec2::INFINITY, Vec2::min), all().fold(Vec2::NEG_INFINITY, Vec2::max))
}

#[cfg(test)]
mod tests;
