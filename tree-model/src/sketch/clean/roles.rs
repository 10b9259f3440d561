//! What strokes show that nobody marked: the ground, the crown, or branches.
//!
//! * **Ground**: flat and long at the foot of the drawing, and what is low and closed on such ground.
//! * **Crown**: a loop, or an arch whose ends are low, that encloses a good part of the drawing; a dense scribble; a
//!   line that turns and turns, as a row of bumps does; an arc with free ends that bulges outwards; what goes on
//!   from the end of such a one. One that stands on the ground below a larger one is a trunk.
//! * A line that goes straight up from the ground and then turns sharply into a crown is cut at the corner.
//!
//! All else is wood. O(strokes² + points).

use super::report::{CleanReport, RepairKind};
use super::sample::{closest, resample};
use super::shape::{Shape, ends};
use super::tidy::{Extent, Ink, length};
use crate::sketch::Role;
use glam::Vec2;

/// The ground's height is at most this share of its width, and its width at least [`GROUND_WIDTH`] of the drawing's.
const GROUND_FLAT: f32 = 0.15;
/// See [`GROUND_FLAT`].
const GROUND_WIDTH: f32 = 0.3;
/// A line so much flatter ...
const HORIZON_FLAT: f32 = 0.03;
/// ... and wider is the ground also where roots are drawn below it, ...
const HORIZON_WIDTH: f32 = 0.6;
/// ... up to this share of the height.
const HORIZON_HEIGHT: f32 = 0.6;
/// What is lower than this share of the height and closed, and stands on ground, belongs to it.
const GRASS: f32 = 0.2;
/// What ends within this share of the height above the drawing's lowest point stands on the ground.
pub(super) const FOOT: f32 = 0.12;
/// A crown encloses at least this share of the box around the drawing ...
const CROWN_AREA: f32 = 0.12;
/// ... and is at least this share of the height wide in the mean: outlines of branches are thin.
const CROWN_WIDTH: f32 = 0.08;
/// A scribble is longer than so many times the outline of its box.
const SCRIBBLE: f32 = 2.0;
/// The line of a crown turns by more than this in all, in radians: a branch bends, but not as often.
const CROWN_TURNING: f32 = 7.0;
/// Ends farther than this share of the height from any wood are free.
const FREE: f32 = 0.06;
/// An arc bulges by at least this share of its chord, and its chord is at least [`CHORD`] of the height.
const BULGE: f32 = 0.05;
/// See [`BULGE`].
const CHORD: f32 = 0.1;
/// The ends of an arc are at least this share of its length apart: a leaf that is drawn round about is folded.
const UNFOLDED: f32 = 0.5;
/// A line that stands on the ground and rises by this share of the height, and by [`STEEP`] of the distance of its
/// ends, is wood.
const RISE: f32 = 0.15;
/// See [`RISE`].
const STEEP: f32 = 0.6;
/// Smaller strokes than this share of the height that touch nothing, in a drawing with a crown, are specks ...
const SPECK: f32 = 0.06;
/// ... and these, where no wood is larger.
const MARK: f32 = 0.15;
/// Ends closer than this share of the height go on from one another.
const GOES_ON: f32 = 0.08;
/// What stands on the ground below another crown is a bush if it is larger and wider than this share of the drawing.
const BUSH_WIDTH: f32 = 0.6;
/// The crown reaches beyond the trunk's side by at least this share of its width on either side: a bush does not.
const INSET: f32 = 0.08;
/// The least turn of a corner between trunk and crown, in radians.
const CORNER: f32 = 1.0;

/// Finds the roles of strokes that have none. What is ground is left out; what stays without a role is wood.
/// Gives the height of the ground (y), where it was drawn.
pub(super) fn decide(inks: &mut Vec<Ink>, report: &mut CleanReport) -> Option<f32> {
    let ground = leave_out_ground(inks, report);
    let extent = Extent::all(inks.iter());
    let unit = extent.unit();
    let foot = extent.high.y;
    for index in 0..inks.len() {
        cut_at_corners(inks, index, foot, unit, report);
    }
    let shapes: Vec<Shape> = inks.iter().map(|ink| Shape::of(ink, unit)).collect();
    let size = extent.size();
    let looks: Vec<bool> = inks
        .iter()
        .zip(&shapes)
        .map(|(ink, shape)| !ink.marked && looks_like_crown(ink, shape, size, unit))
        .collect();
    let aloft = |shape: &Shape| shape.extent.high.y < foot - FOOT * unit;
    let is_crown = |i: usize| looks[i] || inks[i].role == Some(Role::Crown);
    let above = (0..inks.len()).filter(|&i| is_crown(i) && aloft(&shapes[i]));
    let largest_aloft = above.map(|i| shapes[i].area).fold(0.0, f32::max);
    let any_given = inks.iter().any(|ink| ink.role == Some(Role::Crown));
    let is_bush = |shape: &Shape| {
        let alone = largest_aloft <= 0.0 && !any_given;
        let wide = shape.extent.size().x > BUSH_WIDTH * size.x;
        alone || (wide && shape.area > largest_aloft && !any_given)
    };
    for (i, ink) in inks.iter_mut().enumerate() {
        if looks[i] && (aloft(&shapes[i]) || is_bush(&shapes[i])) {
            ink.role = Some(Role::Crown);
        }
    }
    let stands = |i: usize| {
        let (first, last) = ends(&inks[i].points);
        let rise = first.y.max(last.y) - first.y.min(last.y);
        first.y.max(last.y) > foot - 2.0 * FOOT * unit
            && rise > RISE * unit
            && rise > STEEP * first.distance(last)
    };
    let mut open: Vec<usize> = (0..inks.len()).filter(|&i| !stands(i)).collect();
    // Arcs are pieces of a crown that has no outline in one piece.
    let arcs = !inks.iter().zip(&shapes).any(|(ink, shape)| {
        ink.role == Some(Role::Crown) && shape.area > CROWN_AREA * size.x * size.y
    });
    while let Some(at) = open.iter().position(|&i| is_arc_or_goes_on(inks, &shapes, i, unit, arcs))
    {
        inks[open.remove(at)].role = Some(Role::Crown);
    }
    for ink in inks.iter().filter(|ink| !ink.marked && ink.role.is_some()) {
        report.add(ink.stroke, RepairKind::TakenAs(Role::Crown));
    }
    leave_out_specks(inks, &shapes, unit, report);
    ground
}

/// Leaves out the ground, and gives its height.
fn leave_out_ground(inks: &mut Vec<Ink>, report: &mut CleanReport) -> Option<f32> {
    let extent = Extent::all(inks.iter());
    let (size, unit, foot) = (extent.size(), extent.unit(), extent.high.y);
    let is_ground = |ink: &Ink| {
        let here = Extent::of(&ink.points);
        let flat = |flat: f32, wide: f32| {
            here.size().x > wide * size.x && here.size().y < flat * here.size().x
        };
        let above = (foot - here.low.y) / unit;
        // A crown by its colour may be grass; wood that was marked is what it was marked.
        (!ink.marked || ink.role == Some(Role::Crown))
            && ((above < 2.0 * FOOT && flat(GROUND_FLAT, GROUND_WIDTH))
                || (above < HORIZON_HEIGHT && flat(HORIZON_FLAT, HORIZON_WIDTH)))
    };
    let grounds: Vec<bool> = inks.iter().map(is_ground).collect();
    let tops = inks.iter().zip(&grounds).filter(|(_, ground)| **ground);
    let level = tops.map(|(ink, _)| Extent::of(&ink.points).low.y).reduce(f32::min)?;
    let is_grass = |ink: &Ink| {
        let here = Extent::of(&ink.points);
        let low = here.size().y < GRASS * unit && here.high.y > level - 0.05 * unit;
        ink.closed && !ink.marked && low
    };
    let rows: Vec<bool> =
        inks.iter().zip(&grounds).map(|(ink, &ground)| ground || is_grass(ink)).collect();
    // A drawing of nothing else is no ground.
    if rows.iter().all(|&leave| leave) {
        return None;
    }
    leave_out(inks, &rows, RepairKind::Ground, report);
    Some(level)
}

fn looks_like_crown(ink: &Ink, shape: &Shape, drawing: Vec2, unit: f32) -> bool {
    let whole = drawing.x * drawing.y;
    let size = shape.extent.size();
    let open = !ink.closed && shape.gap > 0.25 * shape.length;
    let loops = !open || shape.arched;
    let encloses = shape.area > CROWN_AREA * whole && shape.width() > CROWN_WIDTH * unit;
    let scribble =
        shape.length > SCRIBBLE * 2.0 * (size.x + size.y) && size.x * size.y > CROWN_AREA * whole;
    let big = size.min_element() > 0.1 * unit && size.max_element() > 0.25 * unit;
    let bumpy = shape.turning > CROWN_TURNING && big && !ink.filled;
    (loops && encloses) || scribble || bumpy
}

/// Whether a stroke without a role is an arc of the crown, or goes on from the end of a crown's line.
fn is_arc_or_goes_on(inks: &[Ink], shapes: &[Shape], index: usize, unit: f32, arcs: bool) -> bool {
    let ink = &inks[index];
    if ink.role.is_some() || ink.closed || ink.filled {
        return false;
    }
    let (first, last) = ends(&ink.points);
    let wood = || {
        let others = inks.iter().zip(shapes).enumerate().filter(|(i, _)| *i != index);
        others.map(|(_, both)| both).filter(|(other, _)| other.role != Some(Role::Crown))
    };
    let free = |end: Vec2| !wood().any(|(other, shape)| touches(other, shape, end, FREE * unit));
    let goes_on = |end: Vec2| {
        let crowns = inks.iter().filter(|other| other.role == Some(Role::Crown) && !other.closed);
        crowns
            .map(|other| ends(&other.points))
            .any(|(a, b)| a.distance(end).min(b.distance(end)) < GOES_ON * unit)
    };
    if (goes_on(first) && free(last)) || (goes_on(last) && free(first)) {
        return true;
    }
    if !arcs {
        return false;
    }
    let chord = 0.5 * (first + last);
    let bulge = |p: &Vec2| closest(*p, first, last).1;
    let Some(far) = ink.points.iter().max_by(|a, b| bulge(a).total_cmp(&bulge(b))) else {
        return false;
    };
    let center = Extent::of(wood().flat_map(|(other, _)| &other.points)).center();
    // Of nothing the centre is no number, and nothing is farther.
    bulge(far) > BULGE * first.distance(last)
        && first.distance(last) > CHORD * unit
        && shapes[index].gap > UNFOLDED * shapes[index].length
        && far.distance(center) > chord.distance(center)
        && free(first)
        && free(last)
}

/// Whether a stroke comes within a distance of a point.
fn touches(ink: &Ink, shape: &Shape, point: Vec2, within: f32) -> bool {
    shape.extent.distance(point) < within
        && ink.points.windows(2).any(|pair| closest(point, pair[0], pair[1]).1 < within)
}

/// Leaves out specks that nobody marked.
fn leave_out_specks(inks: &mut Vec<Ink>, shapes: &[Shape], unit: f32, report: &mut CleanReport) {
    if !inks.iter().any(|ink| ink.role == Some(Role::Crown)) {
        return;
    }
    let size = |i: usize| shapes[i].extent.size().max_element();
    let wood = (0..inks.len()).filter(|&i| inks[i].role != Some(Role::Crown));
    let largest = wood.map(size).fold(0.0, f32::max);
    let limit = unit * if largest > MARK * unit { SPECK } else { MARK };
    let foot = Extent::all(inks.iter()).high.y;
    // A short stem below a cloud is all the wood there is.
    let stands = |i: usize| largest <= MARK * unit && shapes[i].extent.high.y >= foot;
    let is_speck = |i: usize| {
        let (first, last) = ends(&inks[i].points);
        let near = |k: usize| {
            let at = |end: Vec2| touches(&inks[k], &shapes[k], end, 0.5 * FREE * unit);
            k != i && inks[k].role != Some(Role::Crown) && (at(first) || at(last))
        };
        inks[i].role.is_none() && size(i) < limit && !stands(i) && !(0..inks.len()).any(near)
    };
    let specks: Vec<bool> = (0..inks.len()).map(is_speck).collect();
    leave_out(inks, &specks, RepairKind::Speck, report);
}

/// Leaves out the strokes of some rows.
fn leave_out(inks: &mut Vec<Ink>, rows: &[bool], kind: RepairKind, report: &mut CleanReport) {
    let mut rows = rows.iter();
    inks.retain(|ink| {
        let leave = rows.next().copied().unwrap_or(false);
        if leave {
            report.add(ink.stroke, kind);
        }
        !leave
    });
}

/// Cuts a stroke that comes straight up from the ground and turns sharply into something that looks like a crown.
fn cut_at_corners(
    inks: &mut Vec<Ink>,
    index: usize,
    foot: f32,
    unit: f32,
    report: &mut CleanReport,
) {
    for _ in 0..2 {
        let ink = &mut inks[index];
        if ink.role.is_some() || ink.closed || ink.filled {
            return;
        }
        ink.points.reverse();
        let even = resample(&ink.points, 0.02 * unit, unit);
        let Some(at) = corner(&even, foot, unit) else { continue };
        let (corner, rest) = (even[at], even[at..].to_vec());
        let rest = Ink { points: rest, ..ink.clone() };
        let shape = Shape::of(&rest, unit);
        let middle = even[at / 2..=at].iter().map(|p| p.x).sum::<f32>() / (at - at / 2 + 1) as f32;
        let inset = INSET * shape.extent.size().x;
        let inside = middle > shape.extent.low.x + inset && middle < shape.extent.high.x - inset;
        if shape.turning < CORNER * 4.0 || shape.length < 0.5 * unit || !inside {
            continue;
        }
        // Of the drawn points those up to the corner are the trunk's side.
        let mut walked = 0.0;
        let until = length(&even[..=at]);
        let split = ink.points.windows(2).position(|pair| {
            walked += pair[0].distance(pair[1]);
            walked >= until
        });
        let mut above = ink.points.split_off(split.map_or(ink.points.len() - 1, |i| i + 1));
        above.insert(0, corner);
        ink.points.push(corner);
        above.dedup();
        ink.points.dedup();
        report.add(ink.stroke, RepairKind::CutAtCorner);
        let side = Ink { points: std::mem::replace(&mut ink.points, above), ..ink.clone() };
        inks.push(side);
    }
}

/// Where a line that begins at the foot and rises turns sharply for the first time.
fn corner(even: &[Vec2], foot: f32, unit: f32) -> Option<usize> {
    const ARM: usize = 3;
    let start = *even.first()?;
    if start.y < foot - FOOT * unit {
        return None;
    }
    let turn = |i: usize| {
        let (a, b) = (even[i] - even[i - ARM], even[i + ARM] - even[i]);
        a.angle_to(b).abs()
    };
    let last = even.len().checked_sub(ARM + 1)?;
    let high = |i: usize| start.y - even[i].y > 0.15 * unit;
    let first = (ARM..last).find(|&i| high(i) && turn(i) > CORNER)?;
    let at = (first..last.min(first + 2 * ARM)).max_by(|&a, &b| turn(a).total_cmp(&turn(b)))?;
    let (chord, rise) = (start.distance(even[at]), start.y - even[at].y);
    (rise > 0.75 * chord && chord > 0.75 * length(&even[..=at])).then_some(at)
}
