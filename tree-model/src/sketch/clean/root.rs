//! Where the tree begins.

use super::line::Line;
use super::shape::ends;
use super::tidy::{Extent, Ink};
use crate::sketch::Role;
use glam::Vec2;

/// A stroke whose lowest end lies a share of the height above the foot leads up by so many times less.
const FOOT_WEIGHT: f32 = 2.0;

/// A stroke drawn from limb to limb through the base rises by this share of the height on either side.
const BOTH_RISE: f32 = 0.15;

/// A second stem begins within this share of the height above or below the base ...
const LEVEL: f32 = 0.08;

/// ... and rises by at least this share.
const STEM_RISE: f32 = 0.2;

/// The stroke that the tree begins with, and its point that is the base.
pub(super) struct Root {
    pub(super) stroke: usize,
    pub(super) point: usize,
}

/// Finds the root: where the caller says, or the lower end of the trunk, or else of the stroke that leads up most
/// from the foot of the drawing. `lines` must not be empty.
pub(super) fn find(inks: &[Ink], lines: &[Line], given: Option<Vec2>, unit: f32) -> Root {
    if let Some(root) = given.and_then(|root| nearest(lines, root, unit)) {
        return root;
    }
    let foot = Extent::all(inks).high.y;
    let any_trunk = inks.iter().any(|ink| ink.role == Some(Role::Trunk));
    let score = |ink: &Ink| {
        let extent = Extent::of(&ink.points);
        let (first, last) = ends(&ink.points);
        // A stroke from limb to limb is as low as its middle.
        let low = if lowest_inside(&ink.points, unit).is_some() {
            extent.high.y
        } else {
            first.y.max(last.y)
        };
        (low - extent.low.y) - FOOT_WEIGHT * (foot - low)
    };
    let candidates = inks.iter().enumerate();
    let candidates = candidates.filter(|(_, ink)| !any_trunk || ink.role == Some(Role::Trunk));
    let best =
        candidates.map(|(i, ink)| (i, score(ink))).reduce(|a, b| if b.1 > a.1 { b } else { a });
    let stroke = best.map_or(0, |(i, _)| i);
    let points = inks.get(stroke).map_or(&[][..], |ink| &ink.points);
    let (first, last) = ends(points);
    let end = if last.y > first.y { points.len().saturating_sub(1) } else { 0 };
    Root { stroke, point: lowest_inside(points, unit).unwrap_or(end) }
}

/// The lowest point of a stroke that rises well on both sides of it.
fn lowest_inside(points: &[Vec2], unit: f32) -> Option<usize> {
    let lowest = (0..points.len()).max_by(|&a, &b| points[a].y.total_cmp(&points[b].y))?;
    let y = points[lowest].y;
    let (first, last) = ends(points);
    (y - first.y.max(last.y) > BOTH_RISE * unit).then_some(lowest)
}

fn nearest(lines: &[Line], root: Vec2, unit: f32) -> Option<Root> {
    let mut best = None;
    let mut least = f32::INFINITY;
    for (stroke, line) in lines.iter().enumerate() {
        if let Some(place) = line.nearest(root, least) {
            least = place.distance;
            best = Some((stroke, place));
        }
    }
    let (stroke, place) = best?;
    let line = lines.get(stroke)?;
    // An end about as near is meant.
    let near = |last: bool| line.end(last).distance(root) < least + 0.03 * unit;
    let point = match (near(false), near(true)) {
        (true, _) => 0,
        (false, true) => line.points.len() - 1,
        _ => place.segment as usize + usize::from(place.share > 0.5),
    };
    Some(Root { stroke, point })
}

/// The lower end (whether it is the last point) of a stroke that begins on the ground beside the base and leads up.
pub(super) fn second_root(points: &[Vec2], base: Vec2, unit: f32) -> Option<bool> {
    let (first, last) = ends(points);
    let (low, high, is_last) =
        if last.y > first.y { (last, first, true) } else { (first, last, false) };
    let rise = low.y - high.y;
    let stem = (low.y - base.y).abs() < LEVEL * unit
        && rise > STEM_RISE * unit
        && rise > 0.5 * low.distance(high);
    stem.then_some(is_last)
}
