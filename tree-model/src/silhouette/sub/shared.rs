//! The part of an outline inside a cone.

use super::Join;
use crate::silhouette::{Line, Outline};
use glam::Vec2;

/// The least part that is shared reaches this share of the branch's span to either side.
const LEAST: f32 = 0.02;

/// At most this share of the outline is shared.
const MOST: f32 = 0.9;

/// An outline measured along.
pub(super) struct Round<'a> {
    pub(super) outline: &'a Outline,
    /// Length to each corner.
    along: Vec<f32>,
    pub(super) length: f32,
}

/// A part of an outline, about a point of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section {
    /// Length along the outline of the point that the branch is directed at.
    pub(super) anchor: f32,
    /// How far it reaches with the clock and against it.
    pub(super) reach: [f32; 2],
}

impl<'a> Round<'a> {
    pub(super) fn of(outline: &'a Outline) -> Self {
        let mut along = Vec::with_capacity(outline.points().len());
        let mut length = 0.0;
        for (from, to) in outline.sides() {
            along.push(length);
            length += from.distance(to);
        }
        Self { outline, along, length }
    }

    /// The part inside the cone about a branch that hangs together with the point the branch is directed at, within a
    /// stretch. O(n).
    pub(super) fn section(&self, branch: &Line, half: f32, stretch: Option<[f32; 2]>) -> Section {
        let (base, end) = (branch.start(), branch.end());
        let span = base.distance(end);
        let direction = (end - base).try_normalize().unwrap_or_else(|| branch.tangent(1.0));
        let ahead = self.ahead(end, direction);
        let anchor = match stretch {
            None => ahead.unwrap_or_else(|| self.nearest(end)),
            Some(stretch) => ahead
                .filter(|&at| self.is_within(at, stretch))
                .unwrap_or_else(|| self.nearest_within(end, stretch)),
        };
        let least = LEAST * span.max(f32::MIN_POSITIVE);
        let room = |forth: bool| {
            let free = stretch.map_or(self.length, |stretch| {
                let to = if forth { stretch[1] - anchor } else { anchor - stretch[0] };
                // Round the first point.
                let to = if to < 0.0 { to + self.length } else { to };
                if to > self.length { to - self.length } else { to }
            });
            free.min(0.5 * MOST * self.length).max(least.min(0.25 * self.length))
        };
        let cone = Cone { base, direction, half };
        let reach = [false, true].map(|forth| {
            let far = self.in_cone(&cone, anchor, room(forth), forth);
            far.max(least.min(0.25 * self.length))
        });
        Section { anchor, reach }
    }

    fn is_within(&self, at: f32, [from, to]: [f32; 2]) -> bool {
        (from..=to).contains(&at) || (from..=to).contains(&(at + self.length))
    }

    /// Length along the outline to where a ray leaves it.
    fn ahead(&self, from: Vec2, direction: Vec2) -> Option<f32> {
        let mut best: Option<(f32, f32)> = None;
        // From outside, a ray that comes in again has nothing to do with the end it left by.
        if !self.outline.contains(from) {
            return None;
        }
        for (i, (a, b)) in self.outline.sides().enumerate() {
            let side = b - a;
            let cross = direction.perp_dot(side);
            let (way, part) =
                ((a - from).perp_dot(side) / cross, (a - from).perp_dot(direction) / cross);
            let hits = cross != 0.0 && way >= 0.0 && (0.0..=1.0).contains(&part);
            if hits && best.is_none_or(|best| way < best.0) {
                best = Some((way, self.along[i] + part * side.length()));
            }
        }
        best.map(|(_, at)| at)
    }

    fn nearest(&self, point: Vec2) -> f32 {
        self.nearest_within(point, [0.0, self.length])
    }

    /// Length along the outline to the point of a stretch nearest to another.
    fn nearest_within(&self, point: Vec2, stretch: [f32; 2]) -> f32 {
        let mut best = (f32::INFINITY, stretch[0]);
        for (i, (a, b)) in self.outline.sides().enumerate() {
            let side = b - a;
            let length = side.length();
            let part = ((point - a).dot(side) / (length * length)).clamp(0.0, 1.0);
            let at = self.along[i] + part * length;
            let away = point.distance_squared(a + part * side);
            if away < best.0 && self.is_within(at, stretch) {
                best = (away, at);
            }
        }
        if best.1 > self.length { best.1 - self.length } else { best.1 }
    }

    /// The side a length lies on.
    fn side(&self, at: f32) -> usize {
        self.along.partition_point(|&along| along <= at).max(1) - 1
    }

    /// The corners of a side, its begin and end.
    fn ends(&self, side: usize) -> (Vec2, Vec2) {
        let points = self.outline.points();
        (points[side], points[(side + 1) % points.len()])
    }

    /// Brings a length into one round.
    pub(super) fn reduced(&self, at: f32) -> f32 {
        let at = at % self.length;
        if at < 0.0 { (at + self.length).min(self.length) } else { at }
    }

    /// The place at a length, and the outline's direction there: at a corner that of the side after it, or with `before` of
    /// the side before it.
    pub(super) fn join(&self, at: f32, before: bool) -> Join {
        let at = self.reduced(at);
        let mut side = self.side(at);
        if before && at <= self.along[side] {
            side = side.checked_sub(1).unwrap_or(self.along.len() - 1);
            let (from, to) = self.ends(side);
            return Join { point: to, tangent: (to - from).normalize_or(Vec2::X) };
        }
        let (from, to) = self.ends(side);
        let way = to - from;
        let part = ((at - self.along[side]) / way.length()).clamp(0.0, 1.0);
        Join { point: from + part * way, tangent: way.normalize_or(Vec2::X) }
    }

    /// The corners strictly between two lengths, the second greater by a round at most.
    pub(super) fn corners(&self, from: f32, to: f32) -> Vec<Vec2> {
        let n = self.along.len();
        let first = self.side(from) + 1;
        let at = |i: usize| self.along[i % n] + if i >= n { self.length } else { 0.0 };
        let inside = (first..first + n).take_while(|&i| at(i) < to);
        inside.map(|i| self.outline.points()[i % n]).collect()
    }

    /// How far from a length on the outline stays in a cone, at most `room`.
    fn in_cone(&self, cone: &Cone, anchor: f32, room: f32, forth: bool) -> f32 {
        let n = self.along.len();
        let mut side = self.side(anchor);
        let (from, _) = self.ends(side);
        let into = anchor - self.along[side];
        let mut at = self.join(anchor, false).point;
        if !cone.holds(at) {
            return 0.0;
        }
        let mut far = 0.0;
        let mut target = if forth { self.ends(side).1 } else { from };
        let mut left = if forth { at.distance(target) } else { into };
        for _ in 0..=n {
            if !cone.holds(target) {
                far += left * cone.leaves(at, target);
                break;
            }
            far += left;
            if far >= room {
                break;
            }
            side = if forth { (side + 1) % n } else { (side + n - 1) % n };
            at = target;
            target = if forth { self.ends(side).1 } else { self.ends(side).0 };
            left = at.distance(target);
        }
        far.min(room)
    }
}

/// A cone in the plane, less than half of it.
struct Cone {
    base: Vec2,
    direction: Vec2,
    half: f32,
}

impl Cone {
    fn holds(&self, point: Vec2) -> bool {
        let way = point - self.base;
        let (along, off) = (self.direction.dot(way), self.direction.perp_dot(way).abs());
        libm::atan2f(off, along) <= self.half
    }

    /// At which share of the way from a point inside to one outside it is left.
    fn leaves(&self, from: Vec2, to: Vec2) -> f32 {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..12 {
            let middle = 0.5 * (low + high);
            if self.holds(from.lerp(to, middle)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }
}
