//! Alphas of the unknown pixels: conjugate gradients on the matting Laplacian.
//!
//! The known pixels are moved to the right side, so that only the unknown ones are solved for. The
//! preconditioner is the diagonal. Values are f32, sums f64 in a fixed order: the same bits on any number
//! of threads.

use super::laplacian::{Laplacian, MARGIN};
use crate::error::Result;
use rayon::prelude::*;
use tree_core::Control;

/// Rows that one task takes at least, so that handing out tasks costs little.
const MIN_ROWS: usize = 16;

/// How a solution was found.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Solved {
    pub(super) iterations: u32,
    /// What is left of the right side, as a share.
    pub(super) residual: f32,
}

/// When to stop.
#[derive(Clone, Copy)]
pub(super) struct Stop {
    pub(super) tolerance: f32,
    pub(super) max_iterations: u32,
}

/// Solves for the pixels where `unknown` is 1. `alpha` holds the known values and a guess for the others;
/// both are on the grid with margin.
pub(super) fn solve(
    laplacian: &Laplacian,
    unknown: &[f32],
    alpha: &mut [f32],
    stop: Stop,
    control: &Control,
) -> Result<Solved> {
    let inverse = inverse_diagonal(laplacian, unknown);
    let mut q = vec![0.0; alpha.len()];
    // The right side's size: the residual if all unknown were 0.
    let known: Vec<f32> = alpha.iter().zip(unknown).map(|(a, u)| a * (1.0 - u)).collect();
    apply(laplacian, &known, &mut q);
    let size = dot_by(laplacian, &q, &inverse);
    let mut solved = Solved::default();
    if size <= 0.0 {
        // No known pixel reaches an unknown one.
        return Ok(solved);
    }
    apply(laplacian, alpha, &mut q);
    let mut r: Vec<f32> = q.iter().zip(unknown).map(|(q, u)| -q * u).collect();
    let mut p: Vec<f32> = r.iter().zip(&inverse).map(|(r, i)| r * i).collect();
    let mut rz = dot_by(laplacian, &r, &inverse);
    let goal = f64::from(stop.tolerance) * f64::from(stop.tolerance) * size;
    while rz > goal && solved.iterations < stop.max_iterations {
        control.check()?;
        solved.iterations += 1;
        let pq = apply(laplacian, &p, &mut q);
        if pq <= 0.0 {
            // The rest of the system is singular: pixels that no known one reaches.
            break;
        }
        let step = (rz / pq) as f32;
        let next = advance(laplacian, step, &inverse, alpha, &mut r, &p, &q);
        turn(laplacian, (next / rz) as f32, &inverse, &r, &mut p);
        rz = next;
    }
    solved.residual = (rz / size).max(0.0).sqrt() as f32;
    Ok(solved)
}

/// One over the diagonal where a pixel is unknown and lies in a window, 0 elsewhere.
fn inverse_diagonal(laplacian: &Laplacian, unknown: &[f32]) -> Vec<f32> {
    let layout = laplacian.layout;
    let mut inverse = vec![0.0; layout.len()];
    for y in 0..layout.height {
        for x in 0..layout.width {
            let (i, diagonal) = (layout.index(x, y), laplacian.diagonal(x, y));
            if unknown[i] > 0.0 && diagonal > 0.0 {
                inverse[i] = 1.0 / diagonal;
            }
        }
    }
    inverse
}

/// `q = L p`; gives back `p · q`.
fn apply(laplacian: &Laplacian, p: &[f32], q: &mut [f32]) -> f64 {
    let (stride, height) = (laplacian.layout.stride(), laplacian.layout.height);
    let width = laplacian.layout.width;
    let sums: Vec<f64> = q[MARGIN * stride..]
        .par_chunks_exact_mut(stride)
        .take(height)
        .with_min_len(MIN_ROWS)
        .enumerate()
        .map(|(y, row)| {
            let row = &mut row[MARGIN..][..width];
            laplacian.product(p, y, row);
            dot(row, &p[(y + MARGIN) * stride + MARGIN..][..width])
        })
        .collect();
    sums.iter().sum()
}

/// `x += step p`, `r -= step q`; gives back `r · M⁻¹ r`.
fn advance(
    laplacian: &Laplacian,
    step: f32,
    inverse: &[f32],
    x: &mut [f32],
    r: &mut [f32],
    p: &[f32],
    q: &[f32],
) -> f64 {
    let stride = laplacian.layout.stride();
    let sums: Vec<f64> = x
        .par_chunks_exact_mut(stride)
        .zip(r.par_chunks_exact_mut(stride))
        .zip(p.par_chunks_exact(stride).zip(q.par_chunks_exact(stride)))
        .zip(inverse.par_chunks_exact(stride))
        .with_min_len(MIN_ROWS)
        .map(|(((x, r), (p, q)), inverse)| {
            for ((x, r), (p, q)) in x.iter_mut().zip(r.iter_mut()).zip(p.iter().zip(q)) {
                *x += step * p;
                *r -= step * q;
            }
            weighted(r, inverse)
        })
        .collect();
    sums.iter().sum()
}

/// `p = M⁻¹ r + turn p`.
fn turn(laplacian: &Laplacian, turn: f32, inverse: &[f32], r: &[f32], p: &mut [f32]) {
    let stride = laplacian.layout.stride();
    p.par_chunks_exact_mut(stride)
        .zip(r.par_chunks_exact(stride).zip(inverse.par_chunks_exact(stride)))
        .with_min_len(MIN_ROWS)
        .for_each(|(p, (r, inverse))| {
            for (p, (r, i)) in p.iter_mut().zip(r.iter().zip(inverse)) {
                *p = r * i + turn * *p;
            }
        });
}

/// `v · M⁻¹ v`.
fn dot_by(laplacian: &Laplacian, v: &[f32], inverse: &[f32]) -> f64 {
    let stride = laplacian.layout.stride();
    v.chunks_exact(stride).zip(inverse.chunks_exact(stride)).map(|(v, i)| weighted(v, i)).sum()
}

/// Sums kept apart, so that the processor may add several at once.
const LANES: usize = 8;

/// Sum of products.
fn dot(a: &[f32], b: &[f32]) -> f64 {
    let mut sums = [0.0_f32; LANES];
    for (a, b) in a.chunks(LANES).zip(b.chunks(LANES)) {
        for ((s, a), b) in sums.iter_mut().zip(a).zip(b) {
            *s += a * b;
        }
    }
    sums.iter().map(|&s| f64::from(s)).sum()
}

/// Sum of weighted squares.
fn weighted(v: &[f32], weights: &[f32]) -> f64 {
    let mut sums = [0.0_f32; LANES];
    for (v, w) in v.chunks(LANES).zip(weights.chunks(LANES)) {
        for ((s, v), w) in sums.iter_mut().zip(v).zip(w) {
            *s += v * v * w;
        }
    }
    sums.iter().map(|&s| f64::from(s)).sum()
}
