//! Loops become simple polygons that lie apart.

use super::arrange;
use super::fill::{self, Fill, FillRule, Frame};
use super::{CrownRepair, CrownReport};
use glam::{DVec2, Vec2};

/// Polygons smaller than this share of the largest are crumbs that crossings leave.
const CRUMB: f64 = 0.003;

/// Loops with more corners than this together are simplified: far more than a hand draws on purpose.
const MOST_CORNERS: usize = 1024;

/// Loops that cross more often than this are taken thinned.
const MOST_CROSSINGS: usize = 2000;

/// How far they may then move at first, as a share of half the size; doubled until there are few enough.
const TOLERANCE: f64 = 2e-4;

/// Polygons with less than this share of the square round everything have no area.
const LEAST_AREA: f64 = 1e-6;

/// Simple polygons against the clock, the largest first.
pub(super) fn unite(loops: Vec<Vec<Vec2>>, report: &mut CrownReport) -> Vec<Vec<Vec2>> {
    let Some((frame, thinned)) = Frame::of(&loops) else { return Vec::new() };
    // Thinned only where there was too much: a scribble.
    let corners: usize = thinned.iter().map(Vec::len).sum();
    let loops = if corners > MOST_CORNERS
        || arrange::crossings(&thinned, MOST_CROSSINGS) >= MOST_CROSSINGS
        || loops.iter().map(Vec::len).sum::<usize>() > fill::MOST_CORNERS
    {
        let back = |contour: &Vec<DVec2>| contour.iter().map(|&p| frame.to_drawing(p)).collect();
        thinned.iter().map(back).collect()
    } else {
        loops
    };
    let loops = simplify(loops, &frame);
    let parts = undo_crossings(loops, &frame, report);
    let mut polygons = merge(&parts, &frame, report);
    polygons.sort_by(|a, b| area(b).total_cmp(&area(a)));
    let least = polygons.first().map_or(0.0, |largest| CRUMB * area(largest));
    let before = polygons.len();
    let size = f64::from(frame.length(2.0 * fill::HALF));
    polygons.retain(|polygon| area(polygon) >= least && area(polygon) > LEAST_AREA * size * size);
    if polygons.len() < before && !polygons.is_empty() {
        report.repairs.push(CrownRepair::CrumbsDropped { count: before - polygons.len() });
    }
    polygons
}

/// Fewer corners where there are very many.
fn simplify(mut loops: Vec<Vec<Vec2>>, frame: &Frame) -> Vec<Vec<Vec2>> {
    let mut tolerance = TOLERANCE * fill::HALF;
    while loops.iter().map(Vec::len).sum::<usize>() > MOST_CORNERS && tolerance < fill::HALF {
        for points in &mut loops {
            let framed: Vec<DVec2> = points.iter().map(|&p| frame.to_frame(p)).collect();
            *points =
                fill::simplify(&framed, tolerance).iter().map(|&p| frame.to_drawing(p)).collect();
        }
        tolerance *= 2.0;
    }
    loops
}

/// Loops without crossings, against the clock. Those that have none stay point for point.
fn undo_crossings(
    loops: Vec<Vec<Vec2>>,
    frame: &Frame,
    report: &mut CrownReport,
) -> Vec<Vec<Vec2>> {
    let mut out = Vec::new();
    for (part, mut points) in loops.into_iter().enumerate() {
        points.dedup();
        while points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        if points.len() < 3 {
            continue;
        }
        let framed: Vec<Vec<DVec2>> = vec![points.iter().map(|&p| frame.to_frame(p)).collect()];
        if arrange::crossings(&framed, 1) == 0 {
            if area(&points) < 0.0 {
                points.reverse();
            }
            out.push(points);
        } else {
            report.repairs.push(CrownRepair::CrossingUndone { part });
            out.extend(filled(&framed, frame));
        }
    }
    out
}

/// The outer border of what loops wind round.
fn filled(loops: &[Vec<DVec2>], frame: &Frame) -> Vec<Vec<Vec2>> {
    let Some(fill) = Fill::of(loops, FillRule::NonZero) else { return Vec::new() };
    let outer = fill.border().into_iter().filter(|contour| fill::area(contour) > 0.0);
    outer.map(|contour| contour.iter().map(|&p| frame.to_drawing(p)).collect()).collect()
}

/// Leaves out loops inside others and unites those that overlap.
fn merge(parts: &[Vec<Vec2>], frame: &Frame, report: &mut CrownReport) -> Vec<Vec<Vec2>> {
    let before = parts.len();
    let kept: Vec<Vec<Vec2>> = (0..before)
        .filter(|&i| !(0..before).any(|j| is_within(parts, i, j)))
        .map(|i| parts[i].clone())
        .collect();
    if kept.len() < before {
        report.repairs.push(CrownRepair::NestedDropped { count: before - kept.len() });
    }
    let framed: Vec<Vec<DVec2>> =
        kept.iter().map(|part| part.iter().map(|&p| frame.to_frame(p)).collect()).collect();
    if kept.len() < 2 || arrange::crossings(&framed, 1) == 0 {
        return kept;
    }
    let united = outer_only(filled(&framed, frame));
    if united.len() != kept.len() {
        report.repairs.push(CrownRepair::United { before: kept.len(), after: united.len() });
    }
    united
}

/// Whether all corners of part `i` lie in part `j`; of two equal ones only the later is within.
fn is_within(parts: &[Vec<Vec2>], i: usize, j: usize) -> bool {
    let (inner, outer) = (&parts[i], &parts[j]);
    if i == j {
        return false;
    }
    if inner == outer {
        return i > j;
    }
    area(inner) <= area(outer) && inner.iter().all(|&point| contains(outer, point))
}

/// Leaves out polygons in what were holes of others.
fn outer_only(polygons: Vec<Vec<Vec2>>) -> Vec<Vec<Vec2>> {
    let keep: Vec<bool> = (0..polygons.len())
        .map(|i| !(0..polygons.len()).any(|j| is_within(&polygons, i, j)))
        .collect();
    polygons.into_iter().zip(keep).filter(|(_, keep)| *keep).map(|(polygon, _)| polygon).collect()
}

/// Area of a polygon in its own units, above 0 against the clock.
pub(super) fn area(polygon: &[Vec2]) -> f64 {
    let Some(&origin) = polygon.first() else { return 0.0 };
    let origin = origin.as_dvec2();
    let part = |pair: &[Vec2]| (pair[0].as_dvec2() - origin).perp_dot(pair[1].as_dvec2() - origin);
    0.5 * polygon.windows(2).map(part).sum::<f64>()
}

/// Centroid of a polygon's area; `None` where it has none.
pub(super) fn centroid(polygon: &[Vec2]) -> Option<Vec2> {
    let origin = polygon.first()?.as_dvec2();
    let (mut sum, mut area) = (DVec2::ZERO, 0.0);
    for pair in polygon.windows(2) {
        let (a, b) = (pair[0].as_dvec2() - origin, pair[1].as_dvec2() - origin);
        sum += a.perp_dot(b) * (a + b) / 3.0;
        area += a.perp_dot(b);
    }
    (area.abs() > f64::MIN_POSITIVE).then(|| (origin + sum / area).as_vec2())
}

/// Whether a point lies in a closed line, by even and odd.
pub(super) fn contains(polygon: &[Vec2], point: Vec2) -> bool {
    let mut inside = false;
    let mut before = polygon.last().copied().unwrap_or_default();
    for &corner in polygon {
        if (corner.y > point.y) != (before.y > point.y) {
            let (a, b) = (corner.as_dvec2(), before.as_dvec2());
            let share = (f64::from(point.y) - a.y) / (b.y - a.y);
            inside ^= f64::from(point.x) < a.x + share * (b.x - a.x);
        }
        before = corner;
    }
    inside
}
