//! Elongated thin structures: how far a blurred picture falls off to both sides, drawn out along eight
//! directions.
//!
//! Frangi et al. (1998, *Multiscale vessel enhancement filtering*) read ridges off the Hessian of a blurred
//! picture. Two things mislead it here. The inner side of an edge curves like a ridge, so that paths would
//! hug the silhouette: we take the smaller of the falls to the two sides. And leaves make ridges too,
//! short ones; branches are long, so the fall is averaged *along* the direction (as oriented filters do,
//! Freeman & Adelson 1991). What remains belongs to a direction, and a search step asks for the evidence
//! along its own, so that crossing a branch gains nothing.
//!
//! 1. Blur with each sigma.
//! 2. For each direction the smaller fall to the two sides, two sigmas away.
//! 3. Averaged along it by two recursive filters, forwards and backwards: one multiplication a pixel
//!    for any length.
//! 4. The strongest over all sigmas.

use super::plane::Plane;
use rayon::prelude::*;

/// Steps between pixels, one for each of eight undirected directions over half a turn; with their
/// opposites the 16 neighbours of a search.
pub(super) const STEPS: [(i32, i32); 8] =
    [(1, 0), (2, 1), (1, 1), (1, 2), (0, 1), (-1, 2), (-1, 1), (-2, 1)];

/// Number of undirected directions.
pub(super) const DIRECTIONS: usize = STEPS.len();

/// Which side of a ridge lies lower.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    /// Ridges brighter than what is beside them.
    Bright,
    /// Either brighter or darker, but the same all along.
    Either,
}

/// How far to the sides a ridge must have fallen off, in sigmas.
const ASIDE: f32 = 2.0;

/// How strongly `plane` shows a ridge along each of the [`STEPS`]: 0 for none. `reach` is the length of
/// averaging to either side in pixels.
///
/// O(pixels · (sum of sigmas + directions · number of sigmas)).
pub(super) fn ridges(plane: &Plane, sigmas: &[f32], reach: f32, sign: Sign) -> Vec<Plane> {
    let blurred: Vec<Plane> = sigmas.par_iter().map(|&sigma| plane.blur(sigma)).collect();
    STEPS
        .par_iter()
        .map(|&step| {
            let mut best = Plane::new(plane.width, plane.height);
            for (plane, &sigma) in blurred.iter().zip(sigmas) {
                let along = drawn_out(falls(plane, step, ASIDE * sigma, sign), step, reach);
                for (best, value) in best.values.iter_mut().zip(along.values) {
                    *best = best.max(value.abs());
                }
            }
            best
        })
        .collect()
}

/// The smaller fall from each pixel to its two sides, `aside` pixels away across a direction; negative
/// for the smaller rise. Outside, the border goes on.
fn falls(plane: &Plane, step: (i32, i32), aside: f32, sign: Sign) -> Plane {
    let (w, h) = (plane.width, plane.height);
    let length = ((step.0 * step.0 + step.1 * step.1) as f32).sqrt();
    let dx = (-(step.1 as f32) / length * aside).round() as isize;
    let dy = (step.0 as f32 / length * aside).round() as isize;
    let mut out = Plane::new(w, h);
    let mut padded = [vec![0.0; w], vec![0.0; w]];
    for y in 0..h {
        for (side, row) in [1, -1].into_iter().zip(&mut padded) {
            let from = (y as isize + side * dy).clamp(0, h as isize - 1) as usize;
            shifted(&plane.values[from * w..][..w], side * dx, row);
        }
        let [a, b] = &padded;
        let here = &plane.values[y * w..][..w];
        let into = out.values[y * w..][..w].iter_mut();
        for (((into, &here), &a), &b) in into.zip(here).zip(a).zip(b) {
            let bright = (here - a.max(b)).max(0.0);
            let dark = if sign == Sign::Either { (a.min(b) - here).max(0.0) } else { 0.0 };
            *into = bright - dark;
        }
    }
    out
}

/// A row as seen from `shift` pixels to the left; beyond its ends they go on.
fn shifted(row: &[f32], shift: isize, into: &mut [f32]) {
    let last = row.len() as isize - 1;
    let skip = (-shift).clamp(0, last + 1) as usize;
    let first = shift.clamp(0, last) as usize;
    let n = row.len() - skip.max(first);
    into[..skip].fill(row[0]);
    into[skip..skip + n].copy_from_slice(&row[first..first + n]);
    into[skip + n..].fill(row[row.len() - 1]);
}

/// Averaged along a direction with weights that fall off exponentially, to 1/e at `reach` pixels.
fn drawn_out(plane: Plane, step: (i32, i32), reach: f32) -> Plane {
    let length = ((step.0 * step.0 + step.1 * step.1) as f32).sqrt();
    let keep = libm::expf(-length / reach.max(1e-3));
    let forwards = recursive(&plane, step, keep, false);
    let backwards = recursive(&plane, step, keep, true);
    // Both hold the pixel itself.
    let norm = (1.0 - keep) / (1.0 + keep);
    let mut out = plane;
    let sums = forwards.values.iter().zip(&backwards.values);
    for (value, (a, b)) in out.values.iter_mut().zip(sums) {
        *value = norm * (a + b - *value);
    }
    out
}

/// out(p) = in(p) + keep · out(p − step), from the first row down or from the last row up.
fn recursive(plane: &Plane, step: (i32, i32), keep: f32, reverse: bool) -> Plane {
    let (w, h) = (plane.width, plane.height);
    let mut out = plane.clone();
    let (dx, dy) = (step.0 as isize, step.1 as usize);
    let shift = if reverse { dx } else { -dx };
    for i in 0..h {
        let y = if reverse { h - 1 - i } else { i };
        if dy == 0 {
            let row = &mut out.values[y * w..][..w];
            for j in 1..w {
                let (x, from) = if reverse { (w - 1 - j, w - j) } else { (j, j - 1) };
                row[x] += keep * row[from];
            }
            continue;
        }
        let from = if reverse { y + dy } else { y.wrapping_sub(dy) };
        if from >= h {
            continue;
        }
        // The part of the row whose source lies in the picture.
        let first = (-shift).max(0) as usize;
        let last = (w as isize - shift.max(0)).max(0) as usize;
        if first >= last {
            continue;
        }
        let source = (first as isize + shift) as usize;
        let (into, from) = if y < from {
            let (low, high) = out.values.split_at_mut(from * w);
            (&mut low[y * w + first..y * w + last], &high[source..])
        } else {
            let (low, high) = out.values.split_at_mut(y * w);
            (&mut high[first..last], &low[from * w + source..])
        };
        for (into, from) in into.iter_mut().zip(from) {
            *into += keep * from;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(step: (i32, i32), value: f32) -> Plane {
        let mut plane = Plane::new(61, 61).map(|_| 0.5);
        let length = ((step.0 * step.0 + step.1 * step.1) as f32).sqrt();
        for i in 0..plane.values.len() {
            let (x, y) = ((i % 61) as f32 - 30.0, (i / 61) as f32 - 30.0);
            let aside = (x * step.1 as f32 - y * step.0 as f32).abs() / length;
            if aside < 1.5 {
                plane.values[i] = value;
            }
        }
        plane
    }

    #[test]
    fn a_line_is_a_ridge_along_its_own_direction() {
        for (direction, &step) in STEPS.iter().enumerate() {
            let found = ridges(&line(step, 1.0), &[1.0, 2.0], 6.0, Sign::Bright);
            let middle: Vec<f32> = found.iter().map(|plane| plane.values[30 * 61 + 30]).collect();
            let best = (0..8).max_by(|&a, &b| middle[a].total_cmp(&middle[b])).unwrap();
            assert_eq!(best, direction, "{middle:?}");
            assert!(middle[(direction + 4) % 8] < 0.3 * middle[direction], "across: {middle:?}");
        }
    }

    #[test]
    fn dark_lines_are_ridges_of_either_sign_only() {
        let dark = line((0, 1), 0.0);
        let at = |sign| ridges(&dark, &[1.0], 6.0, sign)[4].values[30 * 61 + 30];
        assert!(at(Sign::Either) > 0.1);
        assert!(at(Sign::Bright) <= 0.0);
    }

    #[test]
    fn an_edge_is_no_ridge() {
        let mut plane = Plane::new(61, 61);
        for (i, value) in plane.values.iter_mut().enumerate() {
            *value = if i % 61 < 30 { 1.0 } else { 0.0 };
        }
        let upright = &ridges(&plane, &[1.0, 2.0], 6.0, Sign::Bright)[4];
        assert!(upright.values.iter().all(|&value| value < 1e-3));
    }

    #[test]
    fn small_planes_have_no_ridges() {
        for (w, h) in [(1, 1), (2, 1), (1, 3), (2, 2)] {
            let plane = Plane::new(w, h).map(|_| 1.0);
            let found = ridges(&plane, &[1.0], 6.0, Sign::Either);
            assert!(found.iter().all(|plane| plane.values.iter().all(|v| v.abs() < 1e-4)));
        }
    }
}
