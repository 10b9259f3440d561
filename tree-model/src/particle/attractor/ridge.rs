//! Elongated thin structures: second derivatives of Gaussians, drawn out along eight directions.
//!
//! Frangi et al. (1998, *Multiscale vessel enhancement filtering*) read ridges off the Hessian of a blurred
//! picture. Leaves make ridges too, short ones. Branches are long, so the derivative across a direction is
//! averaged *along* the direction first (an oriented filter, as in Freeman & Adelson 1991), and
//! what remains belongs to a direction. A search step then asks for the evidence along its own direction,
//! so that crossing a branch gains nothing.
//!
//! 1. Blur with each sigma; the three second derivatives, times sigma² (scale normalisation).
//! 2. For each direction the derivative across it.
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

/// How strongly `plane` shows a ridge along each of the [`STEPS`]: 0 for none. `reach` is the length of
/// averaging to either side in pixels.
///
/// O(pixels · (sigmas + directions · sigmas count)).
pub(super) fn ridges(plane: &Plane, sigmas: &[f32], reach: f32, sign: Sign) -> Vec<Plane> {
    let seconds: Vec<[Plane; 3]> = sigmas
        .par_iter()
        .map(|&sigma| second_derivatives(&plane.blur(sigma), sigma * sigma))
        .collect();
    STEPS
        .par_iter()
        .map(|&step| {
            let mut best = Plane::new(plane.width, plane.height);
            for [xx, xy, yy] in &seconds {
                let across = drawn_out(across(xx, xy, yy, step), step, reach);
                for (best, value) in best.values.iter_mut().zip(across.values) {
                    // A bright ridge curves down across.
                    let value = if sign == Sign::Bright { -value } else { value.abs() };
                    *best = best.max(value);
                }
            }
            best
        })
        .collect()
}

/// Second derivatives xx, xy, yy by differences between neighbours, times `factor`.
fn second_derivatives(plane: &Plane, factor: f32) -> [Plane; 3] {
    let (w, h) = (plane.width, plane.height);
    let mut out = [Plane::new(w, h), Plane::new(w, h), Plane::new(w, h)];
    let [xx, xy, yy] = &mut out;
    for y in 0..h {
        let row = |y: usize| &plane.values[y * w..][..w];
        let (above, here, below) = (row(y.saturating_sub(1)), row(y), row((y + 1).min(h - 1)));
        for x in 0..w {
            let (left, right) = (x.saturating_sub(1), (x + 1).min(w - 1));
            let i = y * w + x;
            xx.values[i] = factor * (here[left] - 2.0 * here[x] + here[right]);
            yy.values[i] = factor * (above[x] - 2.0 * here[x] + below[x]);
            xy.values[i] =
                factor * 0.25 * (above[left] + below[right] - above[right] - below[left]);
        }
    }
    out
}

/// The second derivative across a direction.
fn across(xx: &Plane, xy: &Plane, yy: &Plane, step: (i32, i32)) -> Plane {
    let (dx, dy) = (step.0 as f32, step.1 as f32);
    let length2 = dx * dx + dy * dy;
    // The normal is (-dy, dx) / length.
    let (a, b, c) = (dy * dy / length2, -2.0 * dx * dy / length2, dx * dx / length2);
    let mut out = xx.clone();
    for ((value, &xy), &yy) in out.values.iter_mut().zip(&xy.values).zip(&yy.values) {
        *value = a * *value + b * xy + c * yy;
    }
    out
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
    fn small_planes_have_no_ridges() {
        for (w, h) in [(1, 1), (2, 1), (1, 3), (2, 2)] {
            let plane = Plane::new(w, h).map(|_| 1.0);
            let found = ridges(&plane, &[1.0], 6.0, Sign::Either);
            assert!(found.iter().all(|plane| plane.values.iter().all(|v| v.abs() < 1e-4)));
        }
    }
}
