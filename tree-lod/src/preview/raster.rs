//! Triangles to samples.
//!
//! 1. Corners are fixed-point numbers, so the edge functions (Pineda 1988, "A parallel algorithm
//!    for polygon rasterization") are exact integers. With the top-left rule, two triangles that
//!    share an edge cover each sample along it exactly once.
//! 2. Per row, each edge bounds the covered samples from one side; the bound is found by one exact
//!    division per edge and row, and the inner loop is free of edge tests. Small triangles, which
//!    is nearly all of them, do this in 32 bits with a reciprocal and a correction.
//! 3. The sample is tested against the depth buffer first and against the alpha of the texture
//!    only then. At equal depth the triangle drawn first stays.
//! 4. The mip level is chosen once per triangle.
//!
//! Depth and texture coordinates are affine on screen (divided by distance in perspective) and are
//! evaluated from the triangle's first corner, not stepped, so the bits do not depend on which part
//! of a triangle falls into which band.

use super::project::{Corner, SUBSAMPLES};
use super::texture::Level;

/// Rows of a picture: depth per sample and, if wanted, the triangle seen there.
#[derive(Debug)]
pub(crate) struct Band<'a> {
    /// First row.
    pub(crate) top: i32,
    pub(crate) width: i32,
    /// Row by row; larger is nearer.
    pub(crate) depth: &'a mut [f32],
    /// As `depth`, or empty.
    pub(crate) ids: &'a mut [u32],
}

/// What decides about a sample besides depth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mask<'a> {
    pub(crate) level: &'a Level,
    pub(crate) filter: Filter,
}

/// How alpha is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Filter {
    /// The nearest texel; no corner lies outside 0 to 1.
    Within,
    /// The nearest texel; coordinates repeat.
    Repeat,
    /// Interpolated: the texture is magnified.
    Smooth,
}

impl Mask<'_> {
    #[inline]
    fn covers(&self, u: f32, v: f32) -> bool {
        match self.filter {
            Filter::Within => self.level.covers_within(u, v),
            Filter::Repeat => self.level.covers(u, v),
            Filter::Smooth => self.level.covers_smoothly(u, v),
        }
    }
}

/// Fixed-point coordinate of the middle of sample 0.
const HALF: i32 = SUBSAMPLES / 2;
/// Extents (in fixed-point steps, 64 samples) up to which edge functions fit into 32 bits: each
/// product below 2¹⁴ · 2¹⁴, two of them, and room for the corrections.
const SMALL_EXTENT: i64 = 1 << 14;

/// Extents (6 samples) up to which testing every sample of the box is faster than finding spans.
const TINY_EXTENT: i64 = 6 << 8;

/// The first and last sample whose middle lies between fixed-point `low` and `high`.
#[inline]
pub(super) fn sample_range(low: i32, high: i32) -> (i32, i32) {
    ((low - HALF + SUBSAMPLES - 1) >> 8, (high - HALF) >> 8)
}

/// An affine function on screen.
#[derive(Clone, Copy)]
struct Slope {
    at_a: f32,
    per_x: f32,
    per_y: f32,
}

/// Draws a triangle into the rows of a band, `id` into its ids.
#[inline]
pub(super) fn draw<const IDS: bool, const PERSPECTIVE: bool>(
    band: &mut Band<'_>,
    corners: [Corner; 3],
    id: u32,
    mask: Option<Mask<'_>>,
) {
    let [a, mut b, mut c] = corners;
    let area = cross(&a, &b, &c);
    if area == 0 {
        return;
    }
    if area < 0 {
        std::mem::swap(&mut b, &mut c);
    }
    let xs = [a.spot.x, b.spot.x, c.spot.x];
    let ys = [a.spot.y, b.spot.y, c.spot.y];
    let (x_low, x_high) = (xs[0].min(xs[1]).min(xs[2]), xs[0].max(xs[1]).max(xs[2]));
    let (y_low, y_high) = (ys[0].min(ys[1]).min(ys[2]), ys[0].max(ys[1]).max(ys[2]));
    let (left, right) = sample_range(x_low, x_high);
    let (left, right) = (left.max(0), right.min(band.width - 1));
    let (top, bottom) = sample_range(y_low, y_high);
    let n_rows = (band.depth.len() / band.width.max(1) as usize) as i32;
    let (top, bottom) = (top.max(band.top), bottom.min(band.top + n_rows - 1));
    if left > right || top > bottom {
        return;
    }
    let size = (i64::from(x_high) - i64::from(x_low)).max(i64::from(y_high) - i64::from(y_low));
    if size <= TINY_EXTENT {
        return tiny::<IDS, PERSPECTIVE>(
            band,
            [a, b, c],
            id,
            mask,
            area,
            [left, right, top, bottom],
        );
    }
    let edges = [(&a, &b), (&b, &c), (&c, &a)].map(|(a, b)| Edge::new(a, b, left, top));
    if size <= SMALL_EXTENT {
        let edges = edges.map(SmallEdge::from);
        let bounds = |row: i32, first: &mut i32, last: &mut i32| {
            edges.iter().for_each(|edge| edge.bound(row, first, last));
        };
        fill::<IDS, PERSPECTIVE>(
            band,
            [a, b, c],
            id,
            mask,
            area,
            [left, right, top, bottom],
            bounds,
        );
    } else {
        let bounds = |row: i32, first: &mut i32, last: &mut i32| {
            edges.iter().for_each(|edge| edge.bound(row, first, last));
        };
        fill::<IDS, PERSPECTIVE>(
            band,
            [a, b, c],
            id,
            mask,
            area,
            [left, right, top, bottom],
            bounds,
        );
    }
}

/// Draws a triangle of a few samples: edge functions stepped over its box, everything else from
/// barycentric coordinates, which are two of the edge functions.
#[inline]
fn tiny<const IDS: bool, const PERSPECTIVE: bool>(
    band: &mut Band<'_>,
    [a, b, c]: [Corner; 3],
    id: u32,
    mask: Option<Mask<'_>>,
    area: i64,
    [left, right, top, bottom]: [i32; 4],
) {
    let area = area.unsigned_abs() as i32;
    let (x1, y1) = (b.spot.x - a.spot.x, b.spot.y - a.spot.y);
    let (x2, y2) = (c.spot.x - a.spot.x, c.spot.y - a.spot.y);
    let (px, py) = (left * SUBSAMPLES + HALF - a.spot.x, top * SUBSAMPLES + HALF - a.spot.y);
    // Opposite to c and to b; the third is what is missing to the area.
    let (mut row_c, mut row_b) = (x1 * py - y1 * px, y2 * px - x2 * py);
    let open = |dx: i32, dy: i32| i32::from(!(dy < 0 || dy == 0 && dx > 0));
    let (open_c, open_b, open_a) = (open(x1, y1), open(-x2, -y2), open(x2 - x1, y2 - y1));
    let per_area = 1.0 / area as f32;
    let qs = if PERSPECTIVE { [a, b, c].map(|corner| corner.spot.depth) } else { [1.0; 3] };
    let width = band.width as usize;
    for y in top..=bottom {
        let (mut at_c, mut at_b) = (row_c, row_b);
        let row = (y - band.top) as usize * width;
        for x in left..=right {
            let inside = (at_c - open_c) | (at_b - open_b) | (area - at_c - at_b - open_a);
            if inside >= 0 {
                let (wb, wc) = (at_b as f32 * per_area, at_c as f32 * per_area);
                let mix = |a: f32, b: f32, c: f32| a + (b - a) * wb + (c - a) * wc;
                let found = mix(a.spot.depth, b.spot.depth, c.spot.depth);
                let sample = row + x as usize;
                if found > band.depth[sample] {
                    let covered = mask.is_none_or(|mask| {
                        let u = mix(a.uv.x * qs[0], b.uv.x * qs[1], c.uv.x * qs[2]);
                        let v = mix(a.uv.y * qs[0], b.uv.y * qs[1], c.uv.y * qs[2]);
                        let far = if PERSPECTIVE { 1.0 / found } else { 1.0 };
                        mask.covers(u * far, v * far)
                    });
                    if covered {
                        band.depth[sample] = found;
                        if IDS {
                            band.ids[sample] = id;
                        }
                    }
                }
            }
            at_c -= y1 * SUBSAMPLES;
            at_b += y2 * SUBSAMPLES;
        }
        row_c += x1 * SUBSAMPLES;
        row_b -= x2 * SUBSAMPLES;
    }
}

/// Draws the samples of a box that `bounds` leaves in each row. It is given the row from the top of
/// the box and narrows the first and last sample, counted from the left of the box.
#[inline]
fn fill<const IDS: bool, const PERSPECTIVE: bool>(
    band: &mut Band<'_>,
    [a, b, c]: [Corner; 3],
    id: u32,
    mask: Option<Mask<'_>>,
    area: i64,
    [left, right, top, bottom]: [i32; 4],
    bounds: impl Fn(i32, &mut i32, &mut i32),
) {
    let (x1, y1) = ((b.spot.x - a.spot.x) as f32, (b.spot.y - a.spot.y) as f32);
    let (x2, y2) = ((c.spot.x - a.spot.x) as f32, (c.spot.y - a.spot.y) as f32);
    let per_area = 1.0 / area.unsigned_abs() as f32;
    let slope = |at_a: f32, at_b: f32, at_c: f32| {
        let (d1, d2) = (at_b - at_a, at_c - at_a);
        Slope { at_a, per_x: (d1 * y2 - d2 * y1) * per_area, per_y: (x1 * d2 - x2 * d1) * per_area }
    };
    let depths = [a.spot.depth, b.spot.depth, c.spot.depth];
    let depth = slope(depths[0], depths[1], depths[2]);
    // A sliver's slopes are steep; rounding must not throw it in front of its own corners.
    let farthest = depths[0].min(depths[1]).min(depths[2]);
    let nearest = depths[0].max(depths[1]).max(depths[2]);
    let uv = mask.map(|mask| {
        let [qa, qb, qc] = if PERSPECTIVE { depths } else { [1.0; 3] };
        let u = slope(a.uv.x * qa, b.uv.x * qb, c.uv.x * qc);
        (mask, u, slope(a.uv.y * qa, b.uv.y * qb, c.uv.y * qc))
    });

    for y in top..=bottom {
        let (mut first, mut last) = (0, right - left);
        bounds(y - top, &mut first, &mut last);
        if first > last {
            continue;
        }
        let (first, last) = (left + first, left + last);
        let row = (y - band.top) as usize * band.width as usize;
        let span = row + first as usize..=row + last as usize;
        let dy = (y * SUBSAMPLES + HALF - a.spot.y) as f32;
        let x_start = first * SUBSAMPLES + HALF - a.spot.x;
        let depth_row = depth.at_a + dy * depth.per_y;
        let Some(depths) = band.depth.get_mut(span.clone()) else {
            continue;
        };
        let depth_at = |i: usize| {
            let dx = (x_start + (i as i32) * SUBSAMPLES) as f32;
            (dx, between(depth_row + dx * depth.per_x, farthest, nearest))
        };
        match &uv {
            None => {
                if IDS {
                    let Some(ids) = band.ids.get_mut(span) else {
                        continue;
                    };
                    for (i, (held, held_id)) in depths.iter_mut().zip(ids).enumerate() {
                        let (_, found) = depth_at(i);
                        if found > *held {
                            *held = found;
                            *held_id = id;
                        }
                    }
                } else {
                    for (i, held) in depths.iter_mut().enumerate() {
                        let found = depth_at(i).1;
                        *held = if found > *held { found } else { *held };
                    }
                }
            }
            Some((mask, u, v)) => {
                let (u_row, v_row) = (u.at_a + dy * u.per_y, v.at_a + dy * v.per_y);
                for (i, held) in depths.iter_mut().enumerate() {
                    let (dx, found) = depth_at(i);
                    if found <= *held {
                        continue;
                    }
                    let far = if PERSPECTIVE { 1.0 / found } else { 1.0 };
                    let (u, v) = ((u_row + dx * u.per_x) * far, (v_row + dx * v.per_x) * far);
                    if mask.covers(u, v) {
                        *held = found;
                        if IDS {
                            band.ids[row + first as usize + i] = id;
                        }
                    }
                }
            }
        }
    }
}

/// `f32::clamp` without its case for NaN, which costs more than the rest.
#[inline]
fn between(v: f32, low: f32, high: f32) -> f32 {
    let v = if v > low { v } else { low };
    if v < high { v } else { high }
}

/// Twice the signed area, exactly.
#[inline]
pub(super) fn cross(a: &Corner, b: &Corner, c: &Corner) -> i64 {
    let (x1, y1) =
        (i64::from(b.spot.x) - i64::from(a.spot.x), i64::from(b.spot.y) - i64::from(a.spot.y));
    let (x2, y2) =
        (i64::from(c.spot.x) - i64::from(a.spot.x), i64::from(c.spot.y) - i64::from(a.spot.y));
    x1 * y2 - x2 * y1
}

/// A sample x of row r (both counted from the corner of the triangle's box) is inside where
/// `start + r·per_row + x·per_x` is not negative.
#[derive(Clone, Copy)]
struct Edge {
    start: i64,
    per_row: i64,
    per_x: i64,
}

impl Edge {
    /// From `a` to `b`, the inside being where the cross product is positive.
    #[inline]
    fn new(a: &Corner, b: &Corner, left: i32, top: i32) -> Self {
        let middle = |sample: i32| i64::from(sample) * i64::from(SUBSAMPLES) + i64::from(HALF);
        let dx = i64::from(b.spot.x) - i64::from(a.spot.x);
        let dy = i64::from(b.spot.y) - i64::from(a.spot.y);
        let start =
            dx * (middle(top) - i64::from(a.spot.y)) - dy * (middle(left) - i64::from(a.spot.x));
        // Samples on the edge itself belong to the triangle only if the edge is a top or left one.
        let owns = dy < 0 || dy == 0 && dx > 0;
        Self {
            start: if owns { start } else { start - 1 },
            per_row: dx * i64::from(SUBSAMPLES),
            per_x: -dy * i64::from(SUBSAMPLES),
        }
    }

    /// Narrows the samples `first..=last` to the inside of this edge in a row.
    #[inline]
    fn bound(&self, row: i32, first: &mut i32, last: &mut i32) {
        let at_left = self.start + i64::from(row) * self.per_row;
        let clamp = |quotient: i64| quotient.clamp(-1, 1 << 30) as i32;
        if self.per_x > 0 {
            *first = (*first).max(clamp(-at_left.div_euclid(self.per_x)));
        } else if self.per_x < 0 {
            *last = (*last).min(clamp(at_left.div_euclid(-self.per_x)));
        } else if at_left < 0 {
            *last = -1;
        }
    }
}

/// An [`Edge`] of a small triangle.
#[derive(Clone, Copy)]
struct SmallEdge {
    start: i32,
    per_row: i32,
    /// The absolute value of `per_x`, and its reciprocal (0 for a horizontal edge).
    slope: i32,
    per_slope: f32,
    rising: bool,
}

impl From<Edge> for SmallEdge {
    #[inline]
    fn from(edge: Edge) -> Self {
        let slope = edge.per_x.unsigned_abs() as i32;
        Self {
            start: edge.start as i32,
            per_row: edge.per_row as i32,
            slope,
            per_slope: if slope > 0 { 1.0 / slope as f32 } else { 0.0 },
            rising: edge.per_x > 0,
        }
    }
}

impl SmallEdge {
    #[inline]
    fn bound(&self, row: i32, first: &mut i32, last: &mut i32) {
        let at_left = self.start + row * self.per_row;
        if self.rising {
            if at_left < 0 {
                *first = (*first).max(self.quotient(self.slope - 1 - at_left));
            }
        } else if at_left < 0 {
            *last = -1;
        } else if self.slope > 0 {
            *last = (*last).min(self.quotient(at_left));
        }
    }

    /// `n / slope` rounded down, for `n` from 0 to 2³⁰ and a slope of at least [`SUBSAMPLES`]: the
    /// product is off by less than one half, which the remainder corrects.
    #[inline]
    fn quotient(&self, n: i32) -> i32 {
        let near = (n as f32 * self.per_slope) as i32;
        let rest = n - near * self.slope;
        near - i32::from(rest < 0) + i32::from(rest >= self.slope)
    }
}

#[cfg(test)]
#[path = "raster_tests.rs"]
mod tests;
