//! Crowded elements go first.
//!
//! Source: Neubert 2012, §7.3.2.
//!
//! 1. The density at an element is the field of metaballs at its centre: how many others stand near.
//! 2. The element of highest density is removed, what it contributed is taken from its neighbours,
//!    and so on: densities are never out of date.
//! 3. When densities have become uniform, the rest is in stochastic order.
//!
//! Densities only fall, so the queue is lazy: an entry that comes up with a density that has fallen is
//! put back where it belongs. One that has fallen by very little is taken as it is.

use super::stochastic::shuffle;
use super::{OrderParams, by_area};
use crate::Elements;
use crate::error::Result;
use crate::implicit::Metaballs;
use rayon::prelude::*;
use std::collections::BinaryHeap;
use tree_core::{Control, Seed};

/// How much lower than in the queue a density may be and still have its turn.
const SLACK: f32 = 0.02;
/// How often uniformity is measured while everything is removed.
const MEASURED: usize = 128;
/// Removals between two looks at whether to stop.
const CHECKED: usize = 256;

/// An order in which elements of dense places go first, until all places are about as dense; the rest
/// is stochastic.
///
/// # Errors
/// [`LodError::Parameter`](crate::LodError::Parameter); [`LodError::Foliage`](crate::LodError::Foliage)
/// when there are no elements, or none has area; [`LodError::Cancelled`](crate::LodError::Cancelled).
///
/// # Complexity
/// O(n · (neighbours within the radius + log n)).
pub fn density(
    elements: &Elements,
    params: &OrderParams,
    seed: Seed,
    control: &Control,
) -> Result<Vec<u32>> {
    let field = params.field(elements)?;
    let Thinned { mut kept, removed } = thin(&field, params, seed, control)?;
    shuffle(&mut kept, seed.stream("density order, kept"));
    let (_, flat) = by_area(elements);
    Ok(kept.into_iter().chain(removed.into_iter().rev()).chain(flat).collect())
}

/// What thinning by density leaves.
pub(super) struct Thinned {
    /// Elements left when densities have become uniform, in rising order.
    pub(super) kept: Vec<u32>,
    /// The others, as they were removed.
    pub(super) removed: Vec<u32>,
}

/// Removes the densest element of the field until densities are uniform.
pub(super) fn thin(
    field: &Metaballs,
    params: &OrderParams,
    seed: Seed,
    control: &Control,
) -> Result<Thinned> {
    let n = field.len();
    control.report("density", 0.0)?;
    let mut densities = (0..n)
        .into_par_iter()
        .with_min_len(CHECKED)
        .map(|row| control.check().map(|()| field.value(field.point(row))))
        .collect::<Result<Vec<f32>, _>>()?;
    let ties = seed.stream("density order");
    // Positive floats sort as their bits do.
    let entry = |density: f32, row: u32| {
        (density.max(0.0).to_bits(), (ties.child(row.into()).0 >> 32) as u32, row)
    };
    let mut queue: BinaryHeap<_> =
        densities.iter().zip(0..).map(|(&density, row)| entry(density, row)).collect();
    let mut there = vec![true; n];
    let mut removed = Vec::new();
    let least = (f64::from(params.least) * n as f64).ceil() as usize;
    let mut next_measure = 0;
    while n - removed.len() > least.max(1) {
        if removed.len() >= next_measure {
            if variation(&densities, &there) < f64::from(params.uniform) {
                break;
            }
            next_measure = removed.len() + n.div_ceil(MEASURED);
            control.report("density", removed.len() as f32 / n as f32)?;
        }
        if removed.len() % CHECKED == 0 {
            control.check()?;
        }
        let Some((bits, _, row)) = queue.pop() else { break };
        let density = densities[row as usize];
        if density < (1.0 - SLACK) * f32::from_bits(bits) {
            queue.push(entry(density, row));
            continue;
        }
        there[row as usize] = false;
        removed.push(row);
        field.near(field.point(row as usize), |other, share| densities[other] -= share * share);
    }
    let mut kept: Vec<u32> =
        field.ids.iter().zip(&there).filter(|&(_, &there)| there).map(|(&id, _)| id).collect();
    kept.sort_unstable();
    let removed = removed.into_iter().map(|row| field.ids[row as usize]).collect();
    Ok(Thinned { kept, removed })
}

/// Standard deviation by mean of the densities of what is there.
fn variation(densities: &[f32], there: &[bool]) -> f64 {
    let (mut n, mut sum, mut squares) = (0.0, 0.0, 0.0);
    for (&density, _) in densities.iter().zip(there).filter(|&(_, &there)| there) {
        let density = f64::from(density);
        n += 1.0;
        sum += density;
        squares += density * density;
    }
    let mean = sum / n;
    (squares / n - mean * mean).max(0.0).sqrt() / mean
}
