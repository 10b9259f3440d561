//! The exponent Δ of the pipe model, r₀^Δ = Σ rᵢ^Δ, read off a tree (Leonardo 2; Murray 1927, measured, 2.49;
//! Murray 1926, vessels, 3; Bentley et al. 2013, measured on whole trees, about 2).
//!
//! Radii are those of unbranched runs ([`Run::radius`]): the wood is thicker at a fork than below and above it, and
//! cylinder models are not exact enough there for a node to stand for a branch. A run that tapers is thinner in its
//! middle than at its base, so trees with taper come out a little below the exponent their forks were made by. Of a
//! single segment that ends in a tip nothing is known but the radius of the tip, so forks that bear one are left out.

use super::runs::{Run, Runs};
use crate::skeleton::{NO_PARENT, Skeleton};

/// Ratios to a power above this one say no more than that the thickest branch is as thick as the run below.
const MOST: f64 = 1000.0;

/// Δ of every fork that has one, in the order of runs below.
///
/// Infinite where a branch is as thick as the run below it or thicker: no exponent gives that. Forks at which a
/// radius is 0, or a branch is a tip of one segment, are left out.
///
/// # Complexity
/// O(nodes), and about 60 powers a branch.
#[must_use]
pub fn pipe_exponents(skeleton: &Skeleton) -> Vec<f64> {
    let runs = Runs::of(skeleton);
    let runs = runs.as_slice();
    let radius = |run: &Run| if run.is_tip && run.n_segments == 1 { 0.0 } else { run.radius };
    let mut above: Vec<(u32, f64)> =
        runs.iter().filter(|r| r.parent != NO_PARENT).map(|r| (r.parent, radius(r))).collect();
    above.sort_by_key(|&(parent, _)| parent);
    let exponent = |fork: &[(u32, f64)]| {
        let below: &Run = runs.get(fork.first()?.0 as usize)?;
        let known = below.radius > 0.0 && fork.iter().all(|&(_, radius)| radius > 0.0);
        let ratios: Vec<f64> = fork.iter().map(|&(_, radius)| radius / below.radius).collect();
        known.then(|| solve(&ratios))
    };
    above.chunk_by(|a, b| a.0 == b.0).filter_map(exponent).collect()
}

/// The median of [`pipe_exponents`], of two in the middle the higher; `None` of a tree without forks.
#[must_use]
pub fn pipe_exponent(skeleton: &Skeleton) -> Option<f64> {
    let mut exponents = pipe_exponents(skeleton);
    exponents.sort_by(f64::total_cmp);
    exponents.get(exponents.len() / 2).copied()
}

/// Δ in Σ ratio^Δ = 1, by bisection: with all ratios below 1 the sum falls as Δ rises, from the number of ratios.
fn solve(ratios: &[f64]) -> f64 {
    let sum = |exponent: f64| ratios.iter().map(|&ratio| libm::pow(ratio, exponent)).sum::<f64>();
    if ratios.iter().any(|&ratio| ratio >= 1.0) || sum(MOST) > 1.0 {
        return f64::INFINITY;
    }
    let (mut low, mut high) = (0.0, MOST);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if sum(middle) > 1.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
