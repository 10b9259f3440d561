//! When outlines are made simpler, and when leaves are dropped.
//!
//! 1. Each tier alone is measured at a few shares of its elements, each with its best scale.
//! 2. A path leads from all elements of the first tier down: each step drops elements or goes on to the
//!    next tier. Its worth is the area under quality over log λ, so that every halving of the geometry
//!    counts the same. The best path is found by dynamic programming over the measured states.
//!
//! Cost: as a table for each tier, on few and small views.

use crate::cover::Around;
use crate::error::Result;
use crate::quality::{Subject, Table, TableParams};
use tree_core::Control;

/// Shares of the elements at which tiers may change, falling.
const SHARES: [f32; 9] = [1.0, 0.75, 0.55, 0.4, 0.28, 0.2, 0.13, 0.08, 0.04];
/// Below this λ nothing counts: a tree is a few pixels there.
const LEAST_LAMBDA: f64 = 0.01;
/// Quality beyond the smallest share, relative to that at it.
const BEYOND: f64 = 0.8;

/// Views that the plan is made on: differences between tiers are large, so few will do.
const AZIMUTHS: u32 = 2;
/// Size of these views in pixels.
const SIZE: u32 = 144;

/// The number of elements with which each tier should begin ([`Schedule::new`](super::Schedule::new)).
/// Tiers that are better left out begin with one element. What the subject has as `kept` is not looked at.
///
/// # Errors
/// As [`Table::measure`].
///
/// # Complexity
/// See the module; parallel over views.
pub fn plan(subject: &Subject<'_>, control: &Control) -> Result<Vec<u32>> {
    let n = subject.elements.len() as u32;
    if subject.tiers.len() < 2 || n < 2 {
        return Ok(vec![n; subject.tiers.len()]);
    }
    let mut states = Vec::with_capacity(subject.tiers.len());
    let params = TableParams {
        around: Around { azimuths: AZIMUTHS, turn: 0.5, size: SIZE, ..Around::default() },
        lambdas: SHARES.iter().rev().copied().collect(),
        ..TableParams::default()
    };
    let full = subject.tiers[0].triangles.len().max(1) as f64;
    for tier in subject.tiers {
        let alone = Subject { tiers: std::slice::from_ref(tier), kept: &[], ..*subject };
        let table = Table::measure(&alone, &params, control)?;
        let of = tier.triangles.len() as f64 / full;
        let state = |row: &crate::quality::Row| State {
            height: log2(f64::from(row.lambda) * of),
            quality: row.quality.into(),
        };
        states.push(table.rows().iter().rev().map(state).collect::<Vec<_>>());
    }
    // Ranks that have no triangles left in the last tier must be kept there, or nothing would be seen.
    let last = &subject.tiers[subject.tiers.len() - 1];
    let empty =
        subject.ranking.order.iter().take_while(|&&element| last.cost(element as usize) == 0);
    let least = (empty.count() as u32 + 1).min(n);
    Ok(kept(&best_changes(&states), n).into_iter().map(|kept| kept.max(least)).collect())
}

/// Some of the elements in one tier.
#[derive(Clone, Copy, Debug)]
struct State {
    /// log₂ λ above the least that counts, at least 0.
    height: f64,
    quality: f64,
}

/// For each tier but the first the place in [`SHARES`] at which it begins; none when it is not used.
fn best_changes(states: &[Vec<State>]) -> Vec<Option<usize>> {
    let last = SHARES.len() - 1;
    // What the rest of the best path is worth, and whether it goes on to the next tier.
    let mut worth = vec![[0.0_f64; SHARES.len()]; states.len()];
    let mut changes = vec![[false; SHARES.len()]; states.len()];
    for tier in (0..states.len()).rev() {
        for at in (0..=last).rev() {
            let here = states[tier][at];
            let area = |to: State| 0.5 * (here.quality + to.quality) * (here.height - to.height);
            worth[tier][at] = if at == last {
                BEYOND * here.quality * here.height
            } else {
                area(states[tier][at + 1]) + worth[tier][at + 1]
            };
            if let Some(next) = states.get(tier + 1).map(|states| states[at]) {
                let coarser = area(next) + worth[tier + 1][at];
                if coarser > worth[tier][at] {
                    worth[tier][at] = coarser;
                    changes[tier][at] = true;
                }
            }
        }
    }
    let mut at = 0;
    let begins = (0..states.len() - 1).scan(true, |used, tier| {
        let found = (at..=last).find(|&at| *used && changes[tier][at]);
        *used = found.is_some();
        at = found.unwrap_or(at);
        Some(found)
    });
    begins.collect()
}

fn kept(changes: &[Option<usize>], n: u32) -> Vec<u32> {
    let number = |share: f32| ((n as f32 * share) as u32).clamp(1, n);
    let later = changes.iter().map(|at| at.map_or(1, |at| number(SHARES[at])));
    std::iter::once(n).chain(later).collect()
}

fn log2(lambda: f64) -> f64 {
    libm::log2((lambda / LEAST_LAMBDA).max(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tier of this share of the triangles, whose quality is this at all of them and falls to a
    /// third of it.
    fn tier(share: f64, quality: f64) -> Vec<State> {
        let state = |&kept: &f32| State {
            height: log2(share * f64::from(kept)),
            quality: quality * (1.0 + 2.0 * f64::from(kept)) / 3.0,
        };
        SHARES.iter().map(state).collect()
    }

    #[test]
    fn a_tier_that_loses_nothing_is_taken_at_once_and_one_that_loses_all_never() {
        assert_eq!(best_changes(&[tier(1.0, 1.0), tier(0.5, 1.0)]), [Some(0)]);
        assert_eq!(best_changes(&[tier(1.0, 1.0), tier(0.5, 0.1)]), [None]);
        assert_eq!(kept(&[Some(0), Some(3), None], 100), [100, 100, 40, 1]);
    }

    #[test]
    fn redundant_elements_are_dropped_before_a_tier_that_loses_some() {
        let mut full = tier(1.0, 1.0);
        // Half of the elements are not seen.
        full[..=3].iter_mut().for_each(|state| state.quality = 1.0);
        let mut coarse = tier(0.25, 0.9);
        coarse[..=3].iter_mut().for_each(|state| state.quality = 0.9);
        let found = best_changes(&[full, coarse]);
        assert!(matches!(found[0], Some(at) if at >= 3), "{found:?}");
    }
}
