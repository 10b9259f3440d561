//! The outline of a leafy tree as a person would draw it round: gaps between leaves closed, corners rounded.
//!
//! The points are marked on a grid, grown by a radius and shrunk again (a morphological closing by exact distances,
//! Meijster, Roerdink & Hesselink 2000), and the line between in and out is traced (marching squares with the
//! distances interpolated, so it is smooth) and simplified. Holes are left out.
//!
//! O(points + cells): 1 ms for 10,000 points.

use super::fill;
use super::unite;
use crate::error::{Result, check};
use glam::{DVec2, Vec2};

/// Cells along the longer side of the points' bounding box.
const CELLS: usize = 128;

/// Parts smaller than this share of the largest are single leaves.
const LEAST: f64 = 0.01;

/// How outlines are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct OutlineParams {
    /// Bays narrower than twice this share of the size are drawn across, 0.01 to 0.5. Default 0.06.
    pub closing: f32,
    /// Most corners of all outlines together, 12 to 10,000. Default 120.
    pub corners: u32,
}

impl Default for OutlineParams {
    fn default() -> Self {
        Self { closing: 0.06, corners: 120 }
    }
}

impl OutlineParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("outline.closing", self.closing, 0.01_f32, 0.5_f32)?;
        check("outline.corners", self.corners, 12, 10_000)
    }
}

/// Outlines of a cloud of points, against the clock, the largest first: one where it hangs together. Empty for fewer than
/// three points, or where all are the same. Points that are not finite do not count.
#[must_use]
pub fn outline_of(points: &[Vec2], params: &OutlineParams) -> Vec<Vec<Vec2>> {
    let Some(grid) = Grid::of(points, params.closing) else { return Vec::new() };
    let mut out = trace(&grid);
    out.retain(|contour| fill::area(contour) > 0.0);
    out.sort_by(|a, b| fill::area(b).total_cmp(&fill::area(a)));
    let least = out.first().map_or(0.0, |largest| LEAST * fill::area(largest));
    out.retain(|contour| fill::area(contour) >= least);
    let mut tolerance = 0.3;
    loop {
        let simple: Vec<Vec<DVec2>> =
            out.iter().map(|contour| fill::simplify(contour, tolerance)).collect();
        let corners: usize = simple.iter().map(Vec::len).sum();
        if corners <= params.corners as usize || tolerance > CELLS as f64 {
            let metres = |contour: &Vec<DVec2>| contour.iter().map(|&p| grid.point(p)).collect();
            let mut drawn: Vec<Vec<Vec2>> = simple.iter().map(metres).collect();
            drawn.retain(|contour| contour.len() > 2 && unite::area(contour) > 0.0);
            return drawn;
        }
        tolerance *= 1.3;
    }
}

/// Values on grid points: above 0 inside the outline, in cells.
struct Grid {
    width: usize,
    height: usize,
    values: Vec<f32>,
    origin: DVec2,
    cell: f64,
}

impl Grid {
    fn of(points: &[Vec2], closing: f32) -> Option<Self> {
        let good = || points.iter().copied().filter(super::is_good);
        let low = good().fold(Vec2::INFINITY, Vec2::min).as_dvec2();
        let high = good().fold(Vec2::NEG_INFINITY, Vec2::max).as_dvec2();
        let size = (high - low).max_element();
        if !(size > 0.0 && size.is_finite()) || good().count() < 3 {
            return None;
        }
        let cell = size / CELLS as f64;
        let radius = f64::from(closing.clamp(0.01, 0.5)) * CELLS as f64;
        let margin = radius.ceil() + 2.0;
        let [width, height] =
            [high.x - low.x, high.y - low.y].map(|side| (side / cell + 2.0 * margin) as usize + 2);
        let origin = low - margin * cell;
        let mut marked = vec![false; width * height];
        for point in good() {
            let at = ((point.as_dvec2() - origin) / cell).round();
            let (column, row) = (at.x as usize, at.y as usize);
            if let Some(mark) = marked.get_mut(row.min(height - 1) * width + column.min(width - 1))
            {
                *mark = true;
            }
        }
        let grown: Vec<bool> = distances(&marked, width, height)
            .iter()
            .map(|&squared| f64::from(squared) > radius * radius)
            .collect();
        // Now marked is what lies outside of the grown points. Half a cell stays round single points.
        let inside = distances(&grown, width, height);
        let values = inside.iter().map(|&squared| squared.sqrt() - radius as f32 + 0.5).collect();
        Some(Self { width, height, values, origin, cell })
    }

    fn point(&self, at: DVec2) -> Vec2 {
        (self.origin + at * self.cell).as_vec2()
    }
}

/// Squared distance from every grid point to the nearest marked one.
fn distances(marked: &[bool], width: usize, height: usize) -> Vec<f32> {
    let far = (width + height) as f32;
    let mut columns = vec![far; marked.len()];
    for at in 0..marked.len() {
        if marked[at] {
            columns[at] = 0.0;
        } else if at >= width {
            columns[at] = (columns[at - width] + 1.0).min(far);
        }
    }
    for at in (0..marked.len() - width).rev() {
        columns[at] = columns[at].min(columns[at + width] + 1.0);
    }
    let mut out = vec![0.0; marked.len()];
    for row in 0..height {
        let line = row * width..(row + 1) * width;
        envelope(&columns[line.clone()], &mut out[line]);
    }
    out
}

/// The lower envelope of the parabolas (x − i)² + f(i)² (Felzenszwalb & Huttenlocher 2012).
fn envelope(f: &[f32], out: &mut [f32]) {
    let mut tops: Vec<(usize, f32)> = Vec::new();
    let meets = |i: usize, j: usize| {
        let (a, b) = (i as f32, j as f32);
        ((f[j] * f[j] + b * b) - (f[i] * f[i] + a * a)) / (2.0 * (b - a))
    };
    for j in 0..f.len() {
        while let Some(&(i, from)) = tops.last()
            && meets(i, j) <= from
        {
            tops.pop();
        }
        let from = tops.last().map_or(f32::NEG_INFINITY, |&(i, _)| meets(i, j));
        tops.push((j, from));
    }
    let mut at = 0;
    for (x, value) in out.iter_mut().enumerate() {
        while at + 1 < tops.len() && tops[at + 1].1 <= x as f32 {
            at += 1;
        }
        let Some(&(i, _)) = tops.get(at) else { return };
        let away = x as f32 - i as f32;
        *value = away * away + f[i] * f[i];
    }
}

/// Closed lines between in and out, inside to the left, in cells.
fn trace(grid: &Grid) -> Vec<Vec<DVec2>> {
    const NONE: usize = usize::MAX;
    let width = grid.width;
    // Crossing 2i lies between grid point i and the one to its right, 2i + 1 between i and the one above.
    let mut next = vec![NONE; 2 * grid.values.len()];
    for row in 0..grid.height - 1 {
        for column in 0..width - 1 {
            let at = row * width + column;
            let crossings = [2 * at, 2 * (at + 1) + 1, 2 * (at + width), 2 * at + 1];
            let corners = [at, at + 1, at + width + 1, at + width];
            let inside = corners.map(|corner| grid.values[corner] > 0.0);
            // Sides of the cell against the clock: the line enters where a side goes from in to out, and leaves
            // where it next goes from out to in, before it: so that inside is left.
            for side in 0..4 {
                if inside[side] && !inside[(side + 1) % 4] {
                    let back = (1..4).map(|k| (side + 4 - k) % 4);
                    let leaves = back.into_iter().find(|&s| !inside[s] && inside[(s + 1) % 4]);
                    if let Some(leaves) = leaves {
                        next[crossings[side]] = crossings[leaves];
                    }
                }
            }
        }
    }
    let mut out = Vec::new();
    for start in 0..next.len() {
        let mut contour = Vec::new();
        let mut at = start;
        while next[at] != NONE {
            contour.push(crossing(grid, at));
            at = std::mem::replace(&mut next[at], NONE);
        }
        if contour.len() > 2 {
            out.push(contour);
        }
    }
    out
}

/// Where the value passes 0 between two grid points.
fn crossing(grid: &Grid, which: usize) -> DVec2 {
    let (at, up) = (which / 2, which % 2 == 1);
    let other = if up { at + grid.width } else { at + 1 };
    let (a, b) = (f64::from(grid.values[at]), f64::from(grid.values[other]));
    let share = if a == b { 0.5 } else { (a / (a - b)).clamp(0.0, 1.0) };
    let foot = DVec2::new((at % grid.width) as f64, (at / grid.width) as f64);
    foot + if up { DVec2::new(0.0, share) } else { DVec2::new(share, 0.0) }
}
