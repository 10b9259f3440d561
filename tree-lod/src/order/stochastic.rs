//! No order at all.

use crate::Elements;
use rayon::prelude::*;
use tree_core::Seed;

/// An order that has nothing to do with place, size, direction or colour: a shuffle.
///
/// Source: Cook, Halstead, Planck, Ryu, "Stochastic Simplification of Aggregate Detail", 2007.
///
/// # Complexity
/// O(n log n).
#[must_use]
pub fn stochastic(elements: &Elements, seed: Seed) -> Vec<u32> {
    let mut rows: Vec<u32> = (0..elements.len() as u32).collect();
    shuffle(&mut rows, seed.stream("stochastic order"));
    rows
}

/// Sorts rows by random keys of theirs.
pub(super) fn shuffle(rows: &mut [u32], seed: Seed) {
    rows.par_sort_unstable_by_key(|&row| (seed.child(row.into()).0, row));
}
