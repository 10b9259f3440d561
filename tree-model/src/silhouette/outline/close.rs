//! Any drawn stroke becomes an outline.
//!
//! 1. Points that are not finite, and repeated ones, go.
//! 2. The ends are joined by a straight line.
//! 3. Very many points are thinned (Douglas & Peucker 1973), after steps too small to see.
//! 4. Spikes without width go.
//! 5. Where it crosses itself, what it winds round is kept: the largest part without its holes. Steps 3 to 5 are
//!    repeated until nothing crosses, as thinning and rounding may make new crossings.
//! 6. It is turned against the clock. What encloses next to nothing is refused.
//!
//! A stroke that needs none of this stays point for point.

use super::{Outline, OutlineRepair, area, bounds};
use crate::error::{ModelError, Result, check};
use crate::plane::arrange;
use crate::plane::fill::{self, Fill, FillRule, Frame};
use glam::{DVec2, Vec2};
use std::collections::BTreeMap;

/// Coordinates beyond this many metres are no points of a drawing.
const LARGEST: f32 = 1e6;

/// Outlines smaller than this many metres are no outlines of anything that grows.
const SMALLEST: f32 = 1e-6;

/// An outline with less than this share of the square round it encloses nothing: a hair's breadth.
const LEAST_AREA: f64 = 1e-4;

/// Ends closer than this share of the stroke's length are one point.
const SAME_PLACE: f32 = 1e-5;

/// Strokes that cross themselves more often than this are taken thinned: a scribble.
const MOST_CROSSINGS: usize = 2000;

/// How far points may move at first when there are too many, as a share of half the size; doubled until there are few
/// enough.
const TOLERANCE: f64 = 2e-4;

/// How often crossings are undone and looked for again.
const ROUNDS: usize = 6;

/// How a drawn stroke becomes an outline.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct OutlineParams {
    /// Ends closer than this share of the stroke's length count as closed by hand; wider gaps are noted as such, 0 to 1.
    /// Default 0.15.
    pub gap: f32,
    /// Most corners of an outline, 8 to 4,096; those that change its shape least are left out. Default 2,000.
    pub corners: u32,
}

impl Default for OutlineParams {
    fn default() -> Self {
        Self { gap: 0.15, corners: 2000 }
    }
}

impl OutlineParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("outline.gap", self.gap, 0.0_f32, 1.0_f32)?;
        check("outline.corners", self.corners, 8_u32, fill::MOST_CORNERS as u32)
    }
}

impl Outline {
    /// Makes an outline of a drawn stroke, in metres, y up, and lists what was repaired. `what` names the stroke in
    /// errors, for example `crown` or `branch 3`.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] where fewer than three different points are left, where it is smaller than a
    /// thousandth of a millimetre or where it encloses next to nothing; [`ModelError::Parameter`].
    ///
    /// # Complexity
    /// O(n log n + crossings) for n points.
    pub fn close(
        stroke: &[Vec2],
        what: &str,
        params: &OutlineParams,
    ) -> Result<(Self, Vec<OutlineRepair>)> {
        params.validate()?;
        let refuse = |problem: String| ModelError::Silhouette { what: what.into(), problem };
        let mut repairs = Vec::new();
        let mut points = clean(stroke, &mut repairs);
        join_ends(&mut points, params.gap, &mut repairs);
        if points.len() < 3 {
            return Err(refuse(format!(
                "it has {} different points; an outline needs at least three",
                points.len()
            )));
        }
        check_size(&points).map_err(refuse)?;
        let mut points = make_simple(points, params, &mut repairs).map_err(refuse)?;
        check_area(&points).map_err(refuse)?;
        if area(&points) < 0.0 {
            // The first stays the first.
            points[1..].reverse();
            repairs.push(OutlineRepair::Turned);
        }
        Ok((Self::of_simple(points), repairs))
    }

    /// An outline of points that already are one: closed (the first is not repeated at the end), against the clock,
    /// without crossings, in metres. Nothing is repaired; for that see [`Outline::close`].
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] saying what is wrong and at which point.
    ///
    /// # Complexity
    /// O(n log n).
    pub fn from_points(points: Vec<Vec2>) -> Result<Self> {
        let refuse = |problem: String| ModelError::Silhouette { what: "outline".into(), problem };
        if points.len() < 3 {
            return Err(refuse(format!("it has {} points; it needs at least three", points.len())));
        }
        if points.len() > fill::MOST_CORNERS {
            let (n, most) = (points.len(), fill::MOST_CORNERS);
            return Err(refuse(format!("it has {n} points, allowed are {most}")));
        }
        if let Some(at) = points.iter().position(|p| !is_good(p)) {
            let problem = format!("points[{at}] is not finite or beyond {LARGEST} m");
            return Err(refuse(problem));
        }
        if let Some(at) = (0..points.len()).find(|&i| points[i] == points[(i + 1) % points.len()]) {
            return Err(refuse(format!("points[{at}] is repeated")));
        }
        check_size(&points).map_err(refuse)?;
        if crosses(&points) {
            return Err(refuse("it crosses or touches itself".into()));
        }
        check_area(&points).map_err(refuse)?;
        if area(&points) < 0.0 {
            return Err(refuse("it runs with the clock; turn it".into()));
        }
        Ok(Self::of_simple(points))
    }
}

/// Whether a point can be one of an outline.
fn is_good(point: &Vec2) -> bool {
    // A NaN is in no range.
    point.x.abs() <= LARGEST && point.y.abs() <= LARGEST
}

/// Leaves out bad and repeated points.
fn clean(stroke: &[Vec2], repairs: &mut Vec<OutlineRepair>) -> Vec<Vec2> {
    let mut points: Vec<Vec2> = stroke.iter().copied().filter(is_good).collect();
    let count = stroke.len() - points.len();
    if count > 0 {
        repairs.push(OutlineRepair::PointsDropped { count });
    }
    let before = points.len();
    points.dedup();
    if points.len() < before {
        repairs.push(OutlineRepair::DuplicatesDropped { count: before - points.len() });
    }
    points
}

/// Drops the last point where it is the first again, or notes the gap. A gap no longer than the longest step of the
/// stroke is a side like others: whoever gives the corners of a polygon need not repeat the first.
fn join_ends(points: &mut Vec<Vec2>, share: f32, repairs: &mut Vec<OutlineRepair>) {
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return };
    let length: f32 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    let gap = first.distance(last);
    if gap > SAME_PLACE * length {
        if points.windows(2).any(|pair| pair[0].distance(pair[1]) >= gap) {
            return;
        }
        repairs.push(if gap <= share * length {
            OutlineRepair::Closed { gap }
        } else {
            OutlineRepair::WideGapClosed { gap, share: gap / length }
        });
        return;
    }
    while points.len() > 1
        && points.last().is_some_and(|p| p.distance(first) <= SAME_PLACE * length)
    {
        points.pop();
    }
}

fn check_size(points: &[Vec2]) -> Result<(), String> {
    let (low, high) = bounds(points);
    let size = (high - low).max_element();
    if size >= SMALLEST {
        return Ok(());
    }
    Err(format!("it is {size} m large; it must be at least {SMALLEST} m"))
}

fn check_area(points: &[Vec2]) -> Result<(), String> {
    let (low, high) = bounds(points);
    let size = f64::from((high - low).max_element());
    let area = area(points).abs();
    if area > LEAST_AREA * size * size {
        return Ok(());
    }
    Err(format!(
        "it encloses next to nothing, {area:.3e} m² at a size of {size:.3} m; draw it round an area"
    ))
}

/// Whether a closed line has more in common with itself than its corners.
fn crosses(points: &[Vec2]) -> bool {
    Frame::of(&[points.to_vec()])
        .is_none_or(|(frame, _)| arrange::crossings(&[framed(points, &frame)], 1) > 0)
}

/// A closed line in a frame. As many points as before, less those that fall together.
fn framed(points: &[Vec2], frame: &Frame) -> Vec<DVec2> {
    let mut out = points.iter().map(|&p| frame.to_frame(p)).collect();
    fill::tidy(&mut out);
    out
}

/// A line out of its frame. What was a point before is just that.
fn unframed(contour: &[DVec2], before: &[Vec2], frame: &Frame) -> Vec<Vec2> {
    let key = |p: DVec2| (p.x as i64, p.y as i64);
    let drawn: BTreeMap<(i64, i64), Vec2> =
        before.iter().map(|&p| (key(frame.to_frame(p)), p)).collect();
    let back = |&p: &DVec2| drawn.get(&key(p)).copied().unwrap_or_else(|| frame.to_drawing(p));
    contour.iter().map(back).collect()
}

/// A closed line without crossings, of at most so many corners.
fn make_simple(
    mut points: Vec<Vec2>,
    params: &OutlineParams,
    repairs: &mut Vec<OutlineRepair>,
) -> Result<Vec<Vec2>, String> {
    let nothing = || String::from("it encloses nothing; draw it round an area");
    let before = points.len();
    let mut parts = Parts::default();
    for round in 0..ROUNDS {
        let (frame, thinned) = Frame::of(&[points.clone()]).ok_or_else(nothing)?;
        let mut contour = framed(&points, &frame);
        if points.len() > fill::MOST_CORNERS
            || arrange::crossings(&[contour.clone()], MOST_CROSSINGS) >= MOST_CROSSINGS
        {
            contour = thinned.concat();
        }
        simplify(&mut contour, params.corners as usize);
        let corners = contour.len();
        drop_spikes(&mut contour);
        if round == 0 {
            if corners < before {
                repairs.push(OutlineRepair::Thinned { before, after: corners });
            }
            if contour.len() < corners {
                repairs.push(OutlineRepair::SpikesDropped { count: corners - contour.len() });
            }
        }
        if contour.len() < 3 {
            return Err(nothing());
        }
        let simple = arrange::crossings(&[contour.clone()], 1) == 0;
        if simple && contour.len() == points.len() {
            // Nothing to do: as drawn.
            parts.note(repairs);
            return Ok(points);
        }
        if !simple {
            contour = parts.largest(&contour).ok_or_else(nothing)?;
        }
        points = unframed(&contour, &points, &frame);
        points.dedup();
        while points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
    }
    Err("it crosses itself too often to make an outline of it; draw it simpler".into())
}

/// Fewer corners where there are too many.
fn simplify(contour: &mut Vec<DVec2>, most: usize) {
    let mut tolerance = TOLERANCE * fill::HALF;
    while contour.len() > most && tolerance < fill::HALF {
        *contour = fill::simplify(contour, tolerance);
        tolerance *= 2.0;
    }
}

/// Leaves out corners at which the line turns back on itself, within a unit of the frame.
fn drop_spikes(contour: &mut Vec<DVec2>) {
    let is_spike = |a: DVec2, b: DVec2, c: DVec2| {
        let (u, v) = (b - a, c - b);
        a == b || b == c || (u.dot(v) < 0.0 && u.perp_dot(v).abs() <= u.length().max(v.length()))
    };
    let mut kept: Vec<DVec2> = Vec::with_capacity(contour.len());
    for &next in contour.iter() {
        while let [.., a, b] = kept[..]
            && is_spike(a, b, next)
        {
            kept.pop();
        }
        kept.push(next);
    }
    // Across the first corner.
    loop {
        match kept[..] {
            [first, second, .., a, b] if is_spike(a, b, first) || is_spike(b, first, second) => {
                if is_spike(a, b, first) {
                    kept.pop();
                } else {
                    kept.remove(0);
                }
            }
            _ => break,
        }
    }
    fill::tidy(&mut kept);
    *contour = kept;
}

/// What undoing crossings left out.
#[derive(Default)]
struct Parts {
    crossed: bool,
    count: usize,
    dropped: f64,
    kept: f64,
}

impl Parts {
    /// The outer border of the largest part of what a contour winds round.
    fn largest(&mut self, contour: &[DVec2]) -> Option<Vec<DVec2>> {
        let border = Fill::of(&[contour.to_vec()], FillRule::NonZero)?.border();
        let outer: Vec<(f64, Vec<DVec2>)> = border
            .into_iter()
            .map(|ring| (fill::area(&ring), ring))
            .filter(|r| r.0 > 0.0)
            .collect();
        let all: f64 = outer.iter().map(|ring| ring.0).sum();
        let count = outer.len();
        let (area, ring) = outer.into_iter().reduce(|a, b| if b.0 > a.0 { b } else { a })?;
        self.crossed = true;
        if self.kept == 0.0 {
            (self.count, self.dropped, self.kept) = (count - 1, all - area, area);
        }
        Some(ring)
    }

    fn note(&self, repairs: &mut Vec<OutlineRepair>) {
        if self.crossed {
            repairs.push(OutlineRepair::CrossingUndone);
        }
        if self.count > 0 {
            let share = (self.dropped / (self.dropped + self.kept)) as f32;
            repairs.push(OutlineRepair::PartsDropped { count: self.count, share });
        }
    }
}
