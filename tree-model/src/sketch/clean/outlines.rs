//! Outlines of wood become middle lines: trunks drawn by their two sides or round about, filled branches, and
//! the thin loops by which fronds and leaves are drawn.
//!
//! Marks on the bark, between the sides of a trunk, are left out. O(strokes² + points).

use super::report::{CleanReport, RepairKind};
use super::roles::FOOT;
use super::sample::resample;
use super::shape::{Shape, contains, ends, slice};
use super::tidy::{Extent, Ink};
use crate::sketch::{Drawing, MidlineParams, Role, midlines_of};
use glam::Vec2;

/// Points of a trunk's middle line.
const N_MIDDLE: usize = 24;

/// Sides of a trunk that are longest are looked at first, and at most so many.
const MOST_SIDES: usize = 40;

/// A side rises by at least this share of the height.
const RISE: f32 = 0.15;

/// A side's rise is at least this share of the distance of its ends.
const STEEP: f32 = 0.7;

/// Where two sides are closest they are within this share of the lower one's rise, and in the mean within twice it.
const CLOSE: f32 = 0.3;

/// The same below a crown: two lines there are hardly two trees ...
const CLOSE_BELOW_CROWN: f32 = 0.4;

/// ... and then this share of the height will do.
const WIDTH_BELOW_CROWN: f32 = 0.2;

/// Sides are at least this share of the height apart: below, one is drawn over the other.
const APART: f32 = 0.015;

/// Sides do not part upwards by more than this factor: stems do.
const PART: f32 = 1.3;

/// Of a mark on the bark at least this share of the points is between the sides.
const WITHIN: f32 = 0.7;

/// Takes middle lines of trunks that nobody marked as anything else.
pub(super) fn trunks(inks: &mut Vec<Ink>, report: &mut CleanReport) {
    let extent = Extent::all(inks.iter());
    let (unit, foot) = (extent.unit(), extent.high.y);
    for index in 0..inks.len() {
        let Some(middle) = trunk_outline(&inks[index], foot, unit) else { continue };
        let ink = &mut inks[index];
        report.add(ink.stroke, RepairKind::MiddleOfOutline);
        let outline = std::mem::replace(&mut ink.points, middle);
        (ink.closed, ink.filled, ink.role) = (false, false, Some(Role::Trunk));
        leave_out_marks(inks, &outline, report);
        break;
    }
    while let Some((a, b)) = two_sides(inks, foot, unit) {
        let mut outline = upwards(&inks[a].points);
        let left = sampled(&outline);
        let right = sampled(&upwards(&inks[b].points));
        outline.extend(upwards(&inks[b].points).iter().rev());
        let middle: Vec<Vec2> = left.iter().zip(&right).map(|(a, b)| 0.5 * (*a + *b)).collect();
        report.add(inks[b].stroke, RepairKind::MiddleOfSides(inks[a].stroke));
        inks[a].points = middle;
        inks[a].role = Some(Role::Trunk);
        // Found, not given, so that it is no side of another trunk.
        inks[a].marked = false;
        inks.remove(b);
        leave_out_marks(inks, &outline, report);
    }
}

/// Takes middle lines of what is filled or a loop, and no crown. Filled strokes of one name that follow one another are
/// the parts and holes of one area.
pub(super) fn branches(drawing: &Drawing, inks: &mut Vec<Ink>, report: &mut CleanReport) {
    let name = |ink: &Ink| drawing.strokes.get(ink.stroke as usize).map_or("", |s| s.name.as_str());
    let is_outline = |ink: &Ink| ink.role != Some(Role::Crown) && (ink.filled || ink.closed);
    let mut out = Vec::with_capacity(inks.len());
    let together = |a: &Ink, b: &Ink| {
        is_outline(a)
            && is_outline(b)
            && a.filled
            && b.filled
            && !name(a).is_empty()
            && name(a) == name(b)
    };
    for group in inks.chunk_by(together) {
        let Some(ink) = group.first() else { continue };
        if !is_outline(ink) {
            out.push(ink.clone());
            continue;
        }
        report.add(ink.stroke, RepairKind::MiddleOfOutline);
        for (i, points) in middle_lines(group).into_iter().enumerate() {
            // Only the strongest line of a filled trunk is the trunk.
            let role = if i > 0 && ink.role.is_some() { Some(Role::Branch) } else { ink.role };
            out.push(Ink {
                points,
                role,
                closed: false,
                filled: false,
                middle: true,
                ..ink.clone()
            });
        }
    }
    *inks = out;
}

/// The middle lines of the area within outlines.
fn middle_lines(group: &[Ink]) -> Vec<Vec<Vec2>> {
    let outlines: Vec<Vec<Vec2>> = group.iter().map(|ink| ink.points.clone()).collect();
    // A loop that was not filled and crosses itself is a scribble: what is inside it nobody can say.
    let scribble = group.iter().any(|ink| !ink.filled && crosses_itself(&ink.points));
    let lines =
        if scribble { Vec::new() } else { midlines_of(&outlines, &MidlineParams::default()) };
    if lines.is_empty() {
        // Too thin for an area: a line drawn there and back.
        return outlines
            .iter()
            .map(|outline| middle_of_loop(outline))
            .filter(|l| l.len() > 1)
            .collect();
    }
    lines.into_iter().map(|line| line.points).collect()
}

/// Whether two segments of a polyline that are no neighbours cross; so it is said of a very long one, too.
fn crosses_itself(points: &[Vec2]) -> bool {
    const LONGEST: usize = 2000;
    let n = points.len().saturating_sub(1);
    let side = |a: Vec2, b: Vec2, p: Vec2| (b - a).perp_dot(p - a);
    let cross = |i: usize, k: usize| {
        let (a, b, c, d) = (points[i], points[i + 1], points[k], points[k + 1]);
        let apart = a.min(b).cmpgt(c.max(d)).any() || c.min(d).cmpgt(a.max(b)).any();
        !apart && side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
    };
    n > LONGEST || (0..n).any(|i| (i + 2..n).any(|k| cross(i, k)))
}

/// The middle line of a simple loop: between its two halves from one of its farthest points to the other.
fn middle_of_loop(outline: &[Vec2]) -> Vec<Vec2> {
    let n = outline.len();
    let farthest = |from: Vec2| {
        let far = |i: &usize| outline[*i].distance_squared(from);
        (0..n).max_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0)
    };
    let a = farthest(ends(outline).0);
    let b = farthest(outline.get(a).copied().unwrap_or_default());
    let (low, high) = (a.min(b), a.max(b));
    let one = outline[low..=high.min(n - 1)].to_vec();
    let other: Vec<Vec2> = outline[high..].iter().chain(&outline[..=low]).rev().copied().collect();
    let mut middle: Vec<Vec2> =
        sampled(&one).iter().zip(sampled(&other)).map(|(a, b)| 0.5 * (*a + b)).collect();
    middle.dedup();
    middle
}

/// The middle line of a trunk that is drawn round about, from below; `None` where the stroke is none.
fn trunk_outline(ink: &Ink, foot: f32, unit: f32) -> Option<Vec<Vec2>> {
    if ink.filled || ink.marked || ink.role.is_some() {
        return None;
    }
    let shape = Shape::of(ink, unit);
    let rise = shape.extent.size().y;
    let stands = shape.extent.high.y > foot - FOOT * unit && rise > RISE * unit;
    let looped = ink.closed || shape.gap < CLOSE * shape.length;
    if !(stands && looped && shape.width() > APART * unit) {
        return None;
    }
    let at = |share: f32| slice(&ink.points, shape.extent.high.y - share * rise);
    let width = |share: f32| at(share).map(|(low, high)| high - low);
    // Two stems drawn in one go are narrow below and wide above.
    if width(0.15)? < 0.5 * width(0.8)? {
        return None;
    }
    let shares = (0..N_MIDDLE).map(|i| (i as f32 + 0.5) / N_MIDDLE as f32);
    let slices: Vec<(f32, f32, f32)> = shares
        .filter_map(|share| at(share).map(|(low, high)| (share, 0.5 * (low + high), high - low)))
        .collect();
    let mut widths: Vec<f32> = slices.iter().map(|slice| slice.2).collect();
    widths.sort_by(f32::total_cmp);
    // Where it is narrow a corner is cut, not the trunk.
    let least = 0.5 * widths.get(widths.len() / 2)?;
    let sound = || slices.iter().filter(|slice| slice.2 >= least);
    let ends = [(1.0, sound().next_back()?.1), (0.0, sound().next()?.1)];
    let inner = sound().map(|slice| (slice.0, slice.1));
    let middle = [ends[1]].into_iter().chain(inner).chain([ends[0]]);
    Some(middle.map(|(share, x)| Vec2::new(x, shape.extent.high.y - share * rise)).collect())
}

/// Two strokes that are the sides of one trunk: of all such pairs the longest.
fn two_sides(inks: &[Ink], foot: f32, unit: f32) -> Option<(usize, usize)> {
    let rise = |i: usize| Extent::of(&inks[i].points).size().y;
    let crowned = inks.iter().any(|ink| ink.role == Some(Role::Crown));
    let is_side = |i: &usize| {
        let ink = &inks[*i];
        let trunk = ink.role == Some(Role::Trunk) && ink.marked;
        let line = upwards(&ink.points);
        let (low, high) = ends(&line);
        (ink.role.is_none() || trunk)
            && !ink.closed
            && !ink.filled
            && low.y > foot - 2.0 * FOOT * unit
            && low.y - high.y > (RISE * unit).max(STEEP * low.distance(high))
    };
    let mut sides: Vec<usize> = (0..inks.len()).filter(is_side).collect();
    sides.sort_by(|&a, &b| rise(b).total_cmp(&rise(a)));
    sides.truncate(MOST_SIDES);
    let mut best: Option<(f32, usize, usize)> = None;
    for (k, &a) in sides.iter().enumerate() {
        for &b in &sides[k + 1..] {
            let score = rise(a).min(rise(b));
            if best.is_none_or(|best| score > best.0)
                && are_sides(&inks[a], &inks[b], unit, crowned)
            {
                best = Some((score, a, b));
            }
        }
    }
    best.map(|(_, a, b)| (a.min(b), a.max(b)))
}

fn are_sides(a: &Ink, b: &Ink, unit: f32, crowned: bool) -> bool {
    let boxes = [a, b].map(|ink| Extent::of(&ink.points));
    let least = boxes[0].size().y.min(boxes[1].size().y);
    let shared = boxes[0].high.y.min(boxes[1].high.y) - boxes[0].low.y.max(boxes[1].low.y);
    if shared < 0.6 * least {
        return false;
    }
    let (a, b) = (sampled(&upwards(&a.points)), sampled(&upwards(&b.points)));
    let gaps: Vec<Vec2> = a.iter().zip(&b).map(|(a, b)| *b - *a).collect();
    let side = gaps.iter().map(|gap| gap.x).sum::<f32>().signum();
    let crossed = gaps.iter().any(|gap| gap.x * side < 0.0);
    let wide = |range: &[Vec2]| {
        range.iter().map(|gap| gap.x.abs()).sum::<f32>() / range.len().max(1) as f32
    };
    let third = gaps.len() / 3;
    let (low, high) = (wide(&gaps[..third]), wide(&gaps[gaps.len() - third..]));
    let closest = gaps.iter().map(|gap| gap.x.abs()).fold(f32::INFINITY, f32::min);
    let close = if crowned {
        (CLOSE_BELOW_CROWN * least).max(WIDTH_BELOW_CROWN * unit)
    } else {
        CLOSE * least
    };
    !crossed
        && closest < close
        && closest > APART * unit
        && wide(&gaps) < 2.0 * close
        && high < PART * low + APART * unit
}

/// Leaves out strokes that nobody marked and that lie within the outline of a trunk.
fn leave_out_marks(inks: &mut Vec<Ink>, outline: &[Vec2], report: &mut CleanReport) {
    inks.retain(|ink| {
        if ink.role.is_some() {
            return true;
        }
        let inside = ink.points.iter().filter(|p| contains(outline, **p)).count();
        // Marks that go from side to side may stick out a little: their middles count too.
        let middles = ink.points.windows(2).filter(|w| contains(outline, 0.5 * (w[0] + w[1])));
        let n = 2 * ink.points.len() - 1;
        let mark = (inside + middles.count()) as f32 >= WITHIN * n as f32 || {
            let even =
                resample(&ink.points, super::tidy::length(&ink.points) / 20.0, f32::INFINITY);
            let inside = even.iter().filter(|p| contains(outline, **p)).count();
            inside as f32 >= WITHIN * even.len() as f32
        };
        if mark {
            report.add(ink.stroke, RepairKind::BarkMark);
        }
        !mark
    });
}

/// A line with its lower end first.
fn upwards(points: &[Vec2]) -> Vec<Vec2> {
    let (first, last) = ends(points);
    let mut line = points.to_vec();
    if first.y < last.y {
        line.reverse();
    }
    line
}

/// A line at a fixed number of even places.
fn sampled(points: &[Vec2]) -> Vec<Vec2> {
    let total = super::tidy::length(points);
    let mut out = resample(points, total / (N_MIDDLE - 1) as f32, f32::INFINITY);
    let (_, last) = ends(points);
    out.resize(N_MIDDLE, last);
    out
}
