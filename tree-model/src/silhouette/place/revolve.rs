//! The pseudo-surface of revolution between outlines (section 5.6): how far a branch reaches at any azimuth.
//!
//! A drawn outline has two halves, right and left of the axis. Turned round it, one becomes the other:
//!
//! 1. each outline is split where the axis, extended straight at both ends, comes into it first and leaves it last;
//! 2. each half becomes points at even shares of its length, from top to bottom;
//! 3. between two neighbouring halves the surface is the same point of both, weighted by a smooth step over azimuth.
//!
//! The paper has one outline, and so two halves. Further outlines, drawn in other planes through the axis, add two each
//! (its section 6 names that as a limitation); the step is then between the two nearest, all the way round.
//!
//! The surface is in the frame of its axis: y along the straight span from its start, r across. An axis that curves
//! splits the outline where it really runs, so a half may have points with r below 0; where the axis misses the outline,
//! it is split at its lowest and highest point, and one half lies wholly on the other side. All of it morphs alike.
//!
//! Building takes O(axis + outline) for each outline. A query blends only those of the 24 blocks of a profile that the line
//! it follows meets: about 0.2 µs.

mod half;

use super::super::{Line, Outline};
use super::domain::in_turn;
use crate::plane::arrange::crossings;
use crate::plane::fill::{Fill, FillRule, Frame, area};
use glam::{Vec2, Vec3};
use half::{BLOCK, BLOCKS, Half, POINTS};
use std::f32::consts::{PI, TAU};

/// Outlines whose planes are closer than this, in radians, are one: the last of them counts.
const SAME_PLANE: f32 = 0.01;

/// Where less than this share of the axis' span is seen, its image no longer tells where it points.
const LEAST_SEEN: f32 = 0.5;

/// An outline and the plane it is drawn in.
#[derive(Clone, Copy, Debug)]
pub struct Section<'a> {
    /// Azimuth of the plane's right side in radians: 0 for the drawing seen along −Z, π/2 for one seen from its left side.
    pub azimuth: f32,
    /// The outline as seen there, metres, x to the plane's right, y up, the tree's base at the origin: another view of
    /// the same tree, turned about the vertical.
    pub outline: &'a Outline,
}

/// A closed surface round an axis, through outlines in planes through it.
#[derive(Clone, Debug, PartialEq)]
pub struct Revolved {
    view: View,
    /// Ascending by azimuth; none where there was no outline.
    halves: Vec<Half>,
}

/// The frame of the axis as a view shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct View {
    origin: Vec2,
    /// Unit vector along the straight span of the axis.
    up: Vec2,
    /// How much shorter than it is the span is seen.
    stretch: f32,
}

impl View {
    /// Of the axis from `start` over `span`, turned about the vertical by the angle that `cos` is the cosine of. An axis that
    /// is seen nearly end on is taken as it is in the first drawing: the view is then one of the plane through it.
    fn of(start: Vec2, span: Vec2, cos: f32) -> Self {
        let turned = Vec2::new(cos, 1.0);
        let shown = (span * turned).length() / span.length();
        if shown < LEAST_SEEN || !shown.is_finite() {
            return Self {
                origin: start,
                up: span.try_normalize().unwrap_or(Vec2::Y),
                stretch: 1.0,
            };
        }
        let up = (span * turned).try_normalize().unwrap_or(Vec2::Y);
        Self { origin: start * turned, up, stretch: 1.0 / shown }
    }

    fn to_frame(self, point: Vec2) -> Vec2 {
        let way = point - self.origin;
        Vec2::new(-self.up.perp_dot(way), self.up.dot(way) * self.stretch)
    }
}

/// Brings points of a drawing in another plane into the frame of the axis' span, whose length is 1 there.
pub(crate) fn section_to_frame(axis: &Line, azimuth: f32) -> impl Fn(Vec2) -> Vec2 {
    let view = View::of(axis.start(), axis.span(), libm::cosf(azimuth));
    let length = axis.span().length();
    move |point| view.to_frame(point) / length
}

/// Two halves and the share of the second.
struct Blend<'a> {
    from: &'a Half,
    to: &'a Half,
    share: f32,
}

impl Blend<'_> {
    #[inline(always)]
    fn mix(&self, from: f32, to: f32) -> f32 {
        from + self.share * (to - from)
    }

    fn point(&self, i: usize) -> Vec2 {
        let ([ax, ay], [bx, by]) = (&self.from.points, &self.to.points);
        Vec2::new(self.mix(ax[i], bx[i]), self.mix(ay[i], by[i]))
    }

    fn points(&self) -> impl DoubleEndedIterator<Item = Vec2> + '_ {
        (0..POINTS).map(|i| self.point(i))
    }
}

impl Revolved {
    /// The surface through `sections`, round `axis`, which is drawn in the plane of azimuth 0 (in a plane turned from it,
    /// only so much of its bends shows).
    ///
    /// Without a section, or where an azimuth is not finite, the section counts for nothing; a surface of none is empty.
    /// O(axis + outlines).
    #[must_use]
    pub fn of(axis: &Line, sections: &[Section<'_>]) -> Self {
        let (start, span) = (axis.start(), axis.span());
        let view = View::of(start, span, 1.0);
        let mut surface = Self { view, halves: Vec::new() };
        let local: Vec<Vec2> = axis.points().iter().map(|&p| view.to_frame(p)).collect();
        for section in sections.iter().filter(|section| section.azimuth.is_finite()) {
            let cos = libm::cosf(section.azimuth);
            let view = View::of(start, span, cos);
            let outline: Vec<Vec2> =
                section.outline.points().iter().map(|&p| view.to_frame(p)).collect();
            let seen: Vec<Vec2> = local.iter().map(|&p| p * Vec2::new(cos, 1.0)).collect();
            for (half, turned) in half::split(&outline, &seen).into_iter().zip([0.0, PI]) {
                surface.add(Half { azimuth: in_turn(section.azimuth + turned), ..half });
            }
        }
        surface
    }

    /// Puts a half in its place by azimuth, instead of one in the same plane.
    fn add(&mut self, half: Half) {
        let apart = |a: f32, b: f32| in_turn(a - b).min(in_turn(b - a));
        self.halves.retain(|other| apart(other.azimuth, half.azimuth) > SAME_PLANE);
        let at = self.halves.partition_point(|other| other.azimuth < half.azimuth);
        self.halves.insert(at, half);
    }

    /// Whether there is no surface, for want of an outline.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.halves.is_empty()
    }

    /// Where the frame begins: the start of the axis, in the drawing.
    #[must_use]
    pub fn origin(&self) -> Vec2 {
        self.view.origin
    }

    /// The unit vector along the span of the axis, in the drawing.
    #[must_use]
    pub fn up(&self) -> Vec2 {
        self.view.up
    }

    /// A point of the drawing in the frame of the axis: x across to the right, y along.
    #[must_use]
    pub fn to_frame(&self, point: Vec2) -> Vec2 {
        self.view.to_frame(point)
    }

    /// The half at an azimuth: points (r, y) in metres, from top to bottom. Empty where the surface is. O(points).
    #[must_use]
    pub fn half(&self, azimuth: f32) -> Vec<Vec2> {
        self.blend(azimuth).map_or_else(Vec::new, |blend| blend.points().collect())
    }

    /// The outline of both halves at an azimuth and across from it, in (r, y), against the clock. Where blending made it
    /// cross itself, what it winds round, and of several parts the largest. `None` where nothing is left. O(points log
    /// points).
    #[must_use]
    pub fn profile(&self, azimuth: f32) -> Option<Outline> {
        let (right, left) = (self.blend(azimuth)?, self.blend(azimuth + PI)?);
        let mirrored = left.points().map(|point| point * Vec2::new(-1.0, 1.0));
        simple(right.points().rev().chain(mirrored).collect())
    }

    /// How far it is from a point (r, y) in the half-plane of an azimuth along a direction in that plane, of unit length, to
    /// the surface: the first crossing. `None` from outside. The way may lead across the axis.
    ///
    /// O(blocks): about 0.2 µs.
    #[must_use]
    pub fn exit(&self, from: Vec2, direction: Vec2, azimuth: f32) -> Option<f32> {
        let (right, left) = (self.blend(azimuth)?, self.blend(azimuth + PI)?);
        let mut ray = Ray { from, direction, crossings: 0, nearest: f32::INFINITY };
        let ends = |blend: &Blend<'_>| (blend.point(0), blend.point(POINTS - 1));
        let ((top, bottom), (left_top, left_bottom)) = (ends(&right), ends(&left));
        let mirror = Vec2::new(-1.0, 1.0);
        ray.chain(&right, 1.0);
        ray.chain(&left, -1.0);
        ray.side(top, left_top * mirror);
        ray.side(bottom, left_bottom * mirror);
        (ray.crossings % 2 == 1 && ray.nearest.is_finite()).then_some(ray.nearest)
    }

    /// Whether a point lies inside: in the frame of the axis, X to the right of the drawing, Y along the span, Z towards
    /// azimuth π/2. O(blocks).
    #[must_use]
    pub fn contains(&self, point: Vec3) -> bool {
        let r = (point.x * point.x + point.z * point.z).sqrt();
        let azimuth = libm::atan2f(point.z, point.x);
        self.exit(Vec2::new(r, point.y), Vec2::X, azimuth).is_some()
    }

    /// The halves on both sides of an azimuth. O(halves).
    fn blend(&self, azimuth: f32) -> Option<Blend<'_>> {
        // The remainder is slow, and most azimuths need none.
        let azimuth = if (0.0..TAU).contains(&azimuth) { azimuth } else { in_turn(azimuth) };
        let after = self.halves.iter().take_while(|half| half.azimuth <= azimuth).count();
        let from = if after > 0 { self.halves.get(after - 1) } else { self.halves.last() }?;
        let to = self.halves.get(after).or(self.halves.first())?;
        let ahead = |from: f32, to: f32| if to < from { to - from + TAU } else { to - from };
        // A single half may be all there is.
        let gap = ahead(from.azimuth, to.azimuth);
        let t = if gap > 0.0 { ahead(from.azimuth, azimuth) / gap } else { 0.0 };
        // A smooth step, within a hundredth of (1 − cos πt) / 2.
        Some(Blend { from, to, share: t * t * (3.0 - 2.0 * t) })
    }
}

/// A line from a point, and what it crossed.
struct Ray {
    from: Vec2,
    direction: Vec2,
    crossings: u32,
    nearest: f32,
}

impl Ray {
    /// Crosses one half; `side` −1 mirrors it to the left. Only blocks whose box the line meets are blended: the box of
    /// blended points lies in the blended box.
    fn chain(&mut self, blend: &Blend<'_>, side: f32) {
        for (block, meets) in self.boxes(blend, side).into_iter().enumerate() {
            if meets >= 0.0 {
                self.block(blend, side, block);
            }
        }
    }

    /// For each block how far the line reaches into its box; below 0 where it misses it.
    fn boxes(&self, blend: &Blend<'_>, side: f32) -> [f32; BLOCKS] {
        let (way, size) = (self.direction, self.direction.abs());
        let ([ax, ay, awide, ahigh], [bx, by, bwide, bhigh]) = (&blend.from.boxes, &blend.to.boxes);
        std::array::from_fn(|i| {
            let x = side * blend.mix(ax[i], bx[i]) - self.from.x;
            let y = blend.mix(ay[i], by[i]) - self.from.y;
            let (wide, high) = (blend.mix(awide[i], bwide[i]), blend.mix(ahigh[i], bhigh[i]));
            let across = size.y * wide + size.x * high - (way.x * y - way.y * x).abs();
            let ahead = size.x * wide + size.y * high + (way.x * x + way.y * y);
            if across < ahead { across } else { ahead }
        })
    }

    /// Crosses the sides of one block.
    fn block(&mut self, blend: &Blend<'_>, side: f32, block: usize) {
        let part = block * BLOCK..=(block + 1) * BLOCK;
        let column = |half: &Half, axis: usize| -> [f32; BLOCK + 1] {
            let mut column = [0.0; BLOCK + 1];
            column.copy_from_slice(&half.points[axis][part.clone()]);
            column
        };
        let (ax, ay) = (column(blend.from, 0), column(blend.from, 1));
        let (bx, by) = (column(blend.to, 0), column(blend.to, 1));
        let x: [f32; BLOCK + 1] =
            std::array::from_fn(|k| side * blend.mix(ax[k], bx[k]) - self.from.x);
        let y: [f32; BLOCK + 1] = std::array::from_fn(|k| blend.mix(ay[k], by[k]) - self.from.y);
        let off: [f32; BLOCK + 1] =
            std::array::from_fn(|k| self.direction.x * y[k] - self.direction.y * x[k]);
        for k in 0..BLOCK {
            if (off[k] >= 0.0) != (off[k + 1] >= 0.0) {
                self.cross(
                    Vec2::new(x[k], y[k]),
                    Vec2::new(x[k + 1], y[k + 1]),
                    off[k],
                    off[k + 1],
                );
            }
        }
    }

    /// Crosses one side. A corner belongs to the side that comes to it from below the line alone, so that the number of
    /// crossings tells inside from outside.
    fn side(&mut self, a: Vec2, b: Vec2) {
        let (a, b) = (a - self.from, b - self.from);
        let (off_a, off_b) = (self.direction.perp_dot(a), self.direction.perp_dot(b));
        if (off_a >= 0.0) != (off_b >= 0.0) {
            self.cross(a, b, off_a, off_b);
        }
    }

    /// Counts a crossing between two points seen from the start, which lie that far off the line on its two sides.
    fn cross(&mut self, a: Vec2, b: Vec2, off_a: f32, off_b: f32) {
        let (way_a, way_b) = (self.direction.dot(a), self.direction.dot(b));
        let way = way_a + off_a / (off_a - off_b) * (way_b - way_a);
        if way > 0.0 {
            self.crossings += 1;
            self.nearest = self.nearest.min(way);
        }
    }
}

/// The outline of a closed line that may cross itself: its largest part.
fn simple(points: Vec<Vec2>) -> Option<Outline> {
    let (frame, contours) = Frame::of(&[points])?;
    let rings = if crossings(&contours, 1) == 0 {
        contours
    } else {
        Fill::of(&contours, FillRule::NonZero)?.border()
    };
    let mut ring = rings.into_iter().max_by(|a, b| area(a).abs().total_cmp(&area(b).abs()))?;
    if area(&ring) < 0.0 {
        ring.reverse();
    }
    let mut points: Vec<Vec2> = ring.into_iter().map(|point| frame.to_drawing(point)).collect();
    points.dedup();
    while points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    (points.len() > 2).then(|| Outline::of_simple(points))
}

#[cfg(test)]
mod tests;
