//! An outline drawn as a leaf, ready to be put on a tree.

use super::{Outline, bounds};
use crate::error::{ModelError, Result};
use crate::plane::fill::{self, Fill, FillRule, Frame};
use glam::{DVec2, Vec2};

/// Most corners of a leaf's border: a tree has very many leaves.
const MOST_CORNERS: usize = 24;

/// How far corners may move at first when there are too many, as a share of half the size; raised by half until there
/// are few enough.
const TOLERANCE: f64 = 5e-4;

/// A stalk is thinner than this share of the leaf's length,
const STALK_WIDTH: f32 = 0.08;
/// and longer than this share.
const STALK_LENGTH: f32 = 0.1;
/// Rows in which widths along the leaf are taken.
const ROWS: usize = 50;
/// How much higher a point counts, in heights of the leaf, at half its width from the middle, when its lowest
/// is sought: lobes may hang below where the stalk was.
const ASIDE: f32 = 0.25;

/// A leaf's outline in its own plane, in triangles: the base at the origin, the tip at (0, 1).
///
/// Multiply by the leaf's length in metres. Like the paper's leaves (section 5.3) it is flat; what bends it is up to the
/// caller.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LeafOutline {
    /// The corners: the border against the clock, at most 24 of them.
    pub points: Vec<Vec2>,
    /// Indices of corners, against the clock.
    pub triangles: Vec<[u32; 3]>,
}

impl LeafOutline {
    /// The leaf of an outline that is attached at `base` and points to `tip`.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] where base and tip are not two different finite points.
    ///
    /// # Complexity
    /// O(n log n) for n points: some tens of microseconds.
    pub fn of(outline: &Outline, base: Vec2, tip: Vec2) -> Result<Self> {
        let refuse =
            |problem: &str| ModelError::Silhouette { what: "leaf".into(), problem: problem.into() };
        let axis = tip - base;
        let square = axis.length_squared();
        if !(square > 0.0 && square.is_finite()) {
            return Err(refuse("its base and tip must be two different finite points"));
        }
        let normal = |p: Vec2| Vec2::new(axis.perp_dot(base - p), axis.dot(p - base)) / square;
        let (frame, contours) = Frame::of(&[outline.points().iter().map(|&p| normal(p)).collect()])
            .ok_or_else(|| refuse("it has no size; draw it larger"))?;
        let border = few(contours.concat());
        let fill = Fill::of(&[border], FillRule::NonZero)
            .ok_or_else(|| refuse("it encloses nothing; draw it round an area"))?;
        let points = fill.points.iter().map(|&p| frame.to_drawing(p)).collect();
        Ok(Self { points, triangles: fill.triangles })
    }

    /// The leaf of an outline, with base and tip as they look: see [`base_of`](Self::base_of); the tip is the point
    /// farthest from the base.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub fn guess(outline: &Outline) -> Result<Self> {
        let base = Self::base_of(outline);
        Self::of(outline, base, Self::tip_of(outline, base))
    }

    /// Where a drawn leaf is attached: the end of its stalk where it has one at either end of its longest extent;
    /// else the lowest point near the middle of an upright one, and the left end of a lying one. O(points).
    #[must_use]
    pub fn base_of(outline: &Outline) -> Vec2 {
        let (low, high) = outline.bounds();
        let one = Self::tip_of(outline, 0.5 * (low + high));
        let other = Self::tip_of(outline, one);
        let stalks = [stalk(outline, one, other), stalk(outline, other, one)];
        let (long, short) = (stalks[0].max(stalks[1]), stalks[0].min(stalks[1]));
        if long > STALK_LENGTH && long > 1.5 * short {
            return if stalks[0] > stalks[1] { one } else { other };
        }
        let axis = other - one;
        if axis.x.abs() > axis.y.abs() {
            return if axis.x > 0.0 { one } else { other };
        }
        let height = |p: &Vec2| {
            let aside =
                2.0 * (p.x - 0.5 * (low.x + high.x)) / (high.x - low.x).max(f32::MIN_POSITIVE);
            p.y + ASIDE * (high.y - low.y) * aside * aside
        };
        let lowest = outline.points().iter().min_by(|a, b| height(a).total_cmp(&height(b)));
        lowest.copied().unwrap_or(low)
    }

    /// The corner farthest from a point. O(points).
    #[must_use]
    pub fn tip_of(outline: &Outline, base: Vec2) -> Vec2 {
        let far = |p: &Vec2| p.distance_squared(base);
        let tip = outline.points().iter().max_by(|a, b| far(a).total_cmp(&far(b)));
        tip.copied().unwrap_or(base)
    }

    /// The lowest and highest coordinates. O(points).
    #[must_use]
    pub fn bounds(&self) -> (Vec2, Vec2) {
        bounds(&self.points)
    }

    /// Area for a leaf of length 1. O(triangles).
    #[must_use]
    pub fn area(&self) -> f32 {
        let corner = |c: u32| self.points.get(c as usize).copied().unwrap_or_default();
        let part = |t: &[u32; 3]| {
            let [a, b, c] = t.map(corner);
            0.5 * (b - a).perp_dot(c - a)
        };
        self.triangles.iter().map(part).sum()
    }
}

/// A border of few corners.
fn few(mut border: Vec<DVec2>) -> Vec<DVec2> {
    let drawn = border.clone();
    let mut tolerance = TOLERANCE * fill::HALF;
    while border.len() > MOST_CORNERS && tolerance < fill::HALF {
        border = fill::simplify(&drawn, tolerance);
        tolerance *= 1.5;
    }
    border
}

/// Over which share of the way from one end to the other the outline is as thin as a stalk.
fn stalk(outline: &Outline, from: Vec2, to: Vec2) -> f32 {
    let way = to - from;
    let length = way.length();
    if length <= 0.0 {
        return 0.0;
    }
    let thin = |row: usize| {
        let at = from + way * ((row as f32 + 0.5) / ROWS as f32);
        // Widths across: between the first and the last crossing.
        let mut reach = (f32::INFINITY, f32::NEG_INFINITY);
        for (a, b) in outline.sides() {
            let (u, v) = ((a - at).dot(way), (b - at).dot(way));
            if (u > 0.0) != (v > 0.0) {
                let across = way.perp_dot(a.lerp(b, u / (u - v)) - at) / length;
                reach = (reach.0.min(across), reach.1.max(across));
            }
        }
        reach.1 - reach.0 < STALK_WIDTH * length
    };
    (0..ROWS).take_while(|&row| thin(row)).count() as f32 / ROWS as f32
}
