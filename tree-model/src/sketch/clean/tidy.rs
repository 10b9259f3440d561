//! First step: points that are none and strokes that are none go.

use super::report::{CleanReport, RepairKind};
use crate::error::{ModelError, Result};
use crate::sketch::{Drawing, Role};
use glam::Vec2;

/// Points farther out than this many units are no points of a drawing.
const LARGEST: f32 = 1e7;

/// Points nearer to the one before than this share of the height are left out: half of what sampling may deviate,
/// and far less than a hand can mean.
pub(super) const THIN: f32 = 0.001;

/// A stroke all within this share of the height is a dot.
const DOT: f32 = 0.01;

/// A width of so many heights makes the drawing's size as large as its height.
const WIDEST: f32 = 10.0;

/// Ends closer than this share of the stroke's length close it, if its length is long enough.
const CLOSED: f32 = 0.03;

/// A stroke at work.
#[derive(Clone, Debug)]
pub(super) struct Ink {
    /// Its index in the drawing.
    pub(super) stroke: u32,
    pub(super) role: Option<Role>,
    /// Whether its role was given, not found out.
    pub(super) marked: bool,
    pub(super) closed: bool,
    pub(super) filled: bool,
    /// Whether it is the middle line of an outline.
    pub(super) middle: bool,
    /// In units of the drawing, y downwards; at least two, no two in a row the same.
    pub(super) points: Vec<Vec2>,
}

/// A box around points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    pub(super) low: Vec2,
    pub(super) high: Vec2,
}

impl Extent {
    /// A box around nothing.
    pub(super) const NONE: Self = Self { low: Vec2::INFINITY, high: Vec2::NEG_INFINITY };

    pub(super) fn of<'a>(points: impl IntoIterator<Item = &'a Vec2>) -> Self {
        let grow = |b: Self, &p: &Vec2| Self { low: b.low.min(p), high: b.high.max(p) };
        points.into_iter().fold(Self::NONE, grow)
    }

    pub(super) fn all<'a>(inks: impl IntoIterator<Item = &'a Ink>) -> Self {
        Self::of(inks.into_iter().flat_map(|ink| &ink.points))
    }

    pub(super) fn size(&self) -> Vec2 {
        (self.high - self.low).max(Vec2::ZERO)
    }

    pub(super) fn center(&self) -> Vec2 {
        0.5 * (self.low + self.high)
    }

    /// What shares are of.
    pub(super) fn unit(&self) -> f32 {
        let size = self.size();
        size.y.max(size.x / WIDEST)
    }

    /// Distance of a point to the box.
    pub(super) fn distance(&self, point: Vec2) -> f32 {
        (self.low - point).max(point - self.high).max(Vec2::ZERO).length()
    }
}

/// The strokes of a drawing that have points to speak of, thinned.
///
/// # Errors
/// [`ModelError::Sketch`] where none is left.
pub(super) fn tidy(drawing: &Drawing, report: &mut CleanReport) -> Result<Vec<Ink>> {
    if drawing.strokes.is_empty() {
        return Err(ModelError::Sketch {
            problem: "there are no strokes: draw at least one".into(),
        });
    }
    let good = |p: &&Vec2| p.x.abs() <= LARGEST && p.y.abs() <= LARGEST; // A NaN is in no range.
    let strokes = || drawing.strokes.iter();
    let unit = Extent::of(strokes().flat_map(|s| s.points.iter().filter(good))).unit();
    let mut inks = Vec::with_capacity(drawing.strokes.len());
    for (index, stroke) in strokes().enumerate() {
        let mut points: Vec<Vec2> = stroke.points.iter().filter(good).copied().collect();
        let n_bad = stroke.points.len() - points.len();
        if n_bad > 0 {
            report.add(index as u32, RepairKind::BadPoints(n_bad as u32));
        }
        thin(&mut points, THIN * unit);
        if points.len() < 2 || Extent::of(&points).size().max_element() < DOT * unit {
            report.add(index as u32, RepairKind::Empty);
            continue;
        }
        let closed = close(&mut points, stroke.closed);
        let (role, marked, filled) = (stroke.role, stroke.role.is_some(), stroke.filled);
        inks.push(Ink {
            stroke: index as u32,
            role,
            marked,
            closed,
            filled,
            middle: false,
            points,
        });
    }
    if inks.is_empty() {
        let n = drawing.strokes.len();
        return Err(ModelError::Sketch {
            problem: format!("none of the {n} strokes has a length: a stroke needs two points"),
        });
    }
    Ok(inks)
}

/// Leaves out points that lie nearer than `least` to the one before; the last stays.
fn thin(points: &mut Vec<Vec2>, least: f32) {
    let last = points.last().copied();
    let mut before: Option<Vec2> = None;
    points.retain(|&p| {
        let keep = before.is_none_or(|b| b.distance(p) > least);
        before = if keep { Some(p) } else { before };
        keep
    });
    if let (Some(last), Some(before)) = (last, before) {
        if last != before && points.len() > 1 {
            points.pop();
            points.push(last);
        } else if last != before {
            points.push(last);
        }
    }
    points.dedup();
}

/// Brings the first point again at the end of a closed stroke; whether it is one.
fn close(points: &mut Vec<Vec2>, closed: bool) -> bool {
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return false };
    if points.len() < 3 {
        return false;
    }
    let closed = closed || first.distance(last) < CLOSED * length(points);
    if closed && first != last {
        points.push(first);
    }
    closed
}

/// Length of a polyline.
pub(super) fn length(points: &[Vec2]) -> f32 {
    points.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}
