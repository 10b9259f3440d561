//! The outline by points at even distances, without jitter.

use super::Outline;
use crate::plane::fill::Frame;
use glam::{DVec2, Vec2};

/// Points on the border. Enough for some forty bumps.
pub(super) const POINTS: usize = 320;

/// Each point is the mean of a stretch this many times as long as the way from one to the next.
const STRETCH: f64 = 2.0;

/// Passes of smoothing after that.
const PASSES: usize = 1;

/// An outline drawn anew.
pub(super) struct Border {
    /// Its points against the clock, in the frame.
    pub(super) at: Vec<DVec2>,
    /// Length of the outline in metres.
    pub(super) length: f64,
    /// Where the first point belongs along the outline, in metres.
    first: f64,
    /// From metres to the frame.
    pub(super) frame: Frame,
}

impl Border {
    /// The border of an outline; `None` where it is too small to have an area. O(n + [`POINTS`] log n).
    pub(super) fn of(outline: &Outline) -> Option<Self> {
        let sums = Sums::of(outline);
        let length = sums.length;
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let step = length / POINTS as f64;
        let window = STRETCH * step;
        let mut points: Vec<DVec2> = (0..POINTS)
            .map(|i| i as f64 * step)
            .map(|from| (sums.to(from + window) - sums.to(from)) / window)
            .collect();
        for _ in 0..PASSES {
            let before = points.clone();
            for (i, point) in points.iter_mut().enumerate() {
                let around = before[(i + POINTS - 1) % POINTS] + before[(i + 1) % POINTS];
                *point = 0.5 * *point + 0.25 * around;
            }
        }
        let drawn: Vec<Vec2> = points.iter().map(|&p| (p + sums.origin).as_vec2()).collect();
        let (frame, _) = Frame::of(std::slice::from_ref(&drawn))?;
        let at = drawn.iter().map(|&p| frame.to_frame(p)).collect();
        Some(Self { at, length, first: 0.5 * window, frame })
    }

    /// Where a point belongs along the outline, in metres; up to a little more than its length.
    pub(super) fn along(&self, point: u32) -> f64 {
        self.first + f64::from(point) / POINTS as f64 * self.length
    }

    /// How far a distance between neighbours on the border reaches along the outline, in metres.
    pub(super) fn step(&self) -> f64 {
        self.length / POINTS as f64
    }
}

/// Integrals of the position along an outline.
struct Sums {
    origin: DVec2,
    corners: Vec<DVec2>,
    /// Length to each corner, and the integral.
    before: Vec<(f64, DVec2)>,
    length: f64,
    total: DVec2,
}

impl Sums {
    fn of(outline: &Outline) -> Self {
        let origin = outline.points().first().map_or(DVec2::ZERO, |p| p.as_dvec2());
        let corners: Vec<DVec2> = outline.points().iter().map(|p| p.as_dvec2() - origin).collect();
        let mut before = Vec::with_capacity(corners.len());
        let (mut length, mut total) = (0.0, DVec2::ZERO);
        for (i, &corner) in corners.iter().enumerate() {
            before.push((length, total));
            let next = corners[(i + 1) % corners.len()];
            let side = corner.distance(next);
            length += side;
            total += 0.5 * side * (corner + next);
        }
        Self { origin, corners, before, length, total }
    }

    /// The integral from the first corner over a length, which may be up to two rounds.
    fn to(&self, length: f64) -> DVec2 {
        if length > self.length {
            return self.total + self.to((length - self.length).min(self.length));
        }
        let i = self.before.partition_point(|&(at, _)| at <= length).max(1) - 1;
        let (at, sum) = self.before[i];
        let (from, next) = (self.corners[i], self.corners[(i + 1) % self.corners.len()]);
        let part = length - at;
        let direction = (next - from).normalize_or_zero();
        sum + part * (from + 0.5 * part * direction)
    }
}
