//! The middle lines of branches that are drawn as a filled area.
//!
//! Many drawings show the trunk and its branches as one outline. The strokes meant are the area's middle lines: here
//! the chordal axis (Prasad 1997; Igarashi, Matsuoka & Tanaka 1999 use it for freehand outlines).
//!
//! 1. `fill`: the outline is made simple: sides are cut where they cross (`arrange`), and
//!    of a constrained Delaunay triangulation the triangles are in or out by winding; their border is the outline that
//!    counts.
//! 2. `axis`: the border is drawn anew with even spacing and triangulated. An edge between two inner
//!    triangles is a chord across the area; the chords' middles are joined through every triangle. A triangle with one
//!    chord is a tip, with two a sleeve, with three a fork.
//! 3. `prune`: at holes the line is cut where it is narrowest; spurs shorter than a share of the local
//!    width go. Where both corners of a blunt end go, the line is lengthened to the outline.
//! 4. `lines`: at each fork the straightest pair goes on (`forks`), the others begin
//!    there. Points are smoothed.
//!
//! We depart from both papers in the pruning (Igarashi grows half discs; a share of the width is as good for branches
//! and simpler) and in the cut of cycles (a tree has none).
//!
//! O(n log n) for n points on the border, about 4,000 at most, and O(spurs · n) for the pruning: 1 ms for a
//! trunk with twenty branches.

mod forks;
mod lines;
mod prune;

use crate::error::{Result, check};
use crate::plane::axis;
use crate::plane::fill::{self, Fill, Frame};
use glam::{DVec2, Vec2};

pub use crate::plane::fill::FillRule;

/// Distance of points on the border, as a share of the mean width of the area.
const SPACING: f64 = 0.4;

/// Details of the border below this share of the mean width are left out: they would only make spurs.
const DETAIL: f64 = 0.04;

/// Most points on the border. Holes smaller than the square of the mean width are filled: knots and bark.
const MOST_POINTS: f64 = 4000.0;

/// Areas below this share of their bounding square have no middle line.
const LEAST_AREA: f64 = 1e-6;

/// How middle lines are found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct MidlineParams {
    /// Side lines shorter than this share of the area's width where they leave are no branches, 0 to 10. Default 1.
    pub spur: f32,
    /// What lies inside where contours cross or nest. Default [`FillRule::NonZero`], as in SVG.
    pub rule: FillRule,
}

impl Default for MidlineParams {
    fn default() -> Self {
        Self { spur: 1.0, rule: FillRule::NonZero }
    }
}

impl MidlineParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("midline.spur", self.spur, 0.0_f32, 10.0_f32)
    }
}

/// A middle line from where it begins (the thicker end, or a fork) to its tip.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Midline {
    /// Its points in the outline's units, at least two. A side line begins at a point of the line that bears it.
    pub points: Vec<Vec2>,
    /// Half the area's width across the line at every point; about 0 at a pointed tip.
    pub half_widths: Vec<f32>,
}

/// The middle lines of a filled, closed outline that may cross itself: the main line first, then those that leave
/// it, then those that leave these, the strongest first. Where there are separate areas, each has its own main line.
///
/// Points that are not finite are left out. An outline without area gives an empty list.
///
/// # Complexity
/// See the module.
#[must_use]
pub fn midlines(outline: &[Vec2], params: &MidlineParams) -> Vec<Midline> {
    midlines_of(&[outline.to_vec()], params)
}

/// The same for an area of several contours: parts, and holes by `params.rule`.
///
/// # Complexity
/// See the module.
#[must_use]
pub fn midlines_of(outlines: &[Vec<Vec2>], params: &MidlineParams) -> Vec<Midline> {
    let Some((frame, contours)) = Frame::of(outlines) else { return Vec::new() };
    let Some(area) = Fill::of(&contours, params.rule) else { return Vec::new() };
    let border = area.border();
    let size: f64 = border.iter().map(|contour| fill::area(contour)).sum();
    if size < LEAST_AREA * (4.0 * fill::HALF * fill::HALF) {
        return Vec::new();
    }
    let Some(even) = even(&border, size) else { return Vec::new() };
    let Some(mesh) = Fill::of(&even, FillRule::NonZero) else { return Vec::new() };
    let mut axis = axis::Axis::of(&mesh);
    prune::cut_cycles(&mut axis);
    prune::prune(&mut axis, f64::from(params.spur));
    prune::lengthen(&mut axis, &mesh.border());
    lines::lines(axis, &frame)
}

/// Contours with corners where the border turns and points at even distances between.
fn even(border: &[Vec<DVec2>], area: f64) -> Option<Vec<Vec<DVec2>>> {
    let length: f64 = border.iter().map(|contour| perimeter(contour)).sum();
    let width = 2.0 * area / length;
    let spacing = (SPACING * width).max(length / MOST_POINTS);
    let contours: Vec<Vec<DVec2>> = border
        .iter()
        .filter(|contour| fill::area(contour) > 0.0 || fill::area(contour) < -width * width)
        .map(|contour| spaced(&fill::simplify(contour, DETAIL * width), spacing))
        .filter(|contour| contour.len() > 2)
        .collect();
    (!contours.is_empty()).then_some(contours)
}

fn perimeter(contour: &[DVec2]) -> f64 {
    fill::sides(contour).map(|(a, b)| a.distance(b)).sum()
}

/// The contour with points added so that none are farther apart than `spacing`.
fn spaced(contour: &[DVec2], spacing: f64) -> Vec<DVec2> {
    let mut out = Vec::new();
    for (a, b) in fill::sides(contour) {
        let parts = (a.distance(b) / spacing).ceil().clamp(1.0, MOST_POINTS) as usize;
        // Whole numbers again: what is nearly straight would give triangles too thin to tell in from out.
        out.extend((0..parts).map(|part| a.lerp(b, part as f64 / parts as f64).round()));
    }
    out
}

#[cfg(test)]
mod tests;
