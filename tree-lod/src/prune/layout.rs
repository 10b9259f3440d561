//! Where the triangles of a part lie in its index buffer.
//!
//! A *block* holds the triangles of a part's elements in one tier, in the order of importance, as many
//! elements as the tier begins with. Blocks follow each other from the coarsest to the finest, so that
//! what a [`Cut`] draws is one piece: the end of a block and the beginning of the next, or the beginning
//! of one. Tiers in which no element of the part differs share a block.

use super::schedule::Cut;
use crate::outline::Tier;
use std::ops::Range;

/// The blocks of one part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    /// Ranks of the part's elements in the order of the whole model, rising.
    pub(super) ranks: Vec<u32>,
    /// The tier each block is made of: the finest of those that share it.
    pub(super) tiers: Vec<usize>,
    /// Block of each tier.
    block_of: Vec<usize>,
    /// Of each block: where the triangles of each of its elements begin in the index buffer, and where
    /// the block ends.
    pub(super) starts: Vec<Vec<u32>>,
}

impl Layout {
    /// `elements` are those of the part, in the order of `ranks`; `kept` as the schedule has it. All
    /// triangles of the tiers must be fewer than 2³².
    pub(super) fn new(ranks: Vec<u32>, elements: &[u32], tiers: &[Tier], kept: &[u32]) -> Self {
        // Finest first, until the end.
        let mut used: Vec<usize> = Vec::new();
        let mut block_of = Vec::with_capacity(tiers.len());
        for (number, tier) in tiers.iter().enumerate() {
            let as_before = used.last().is_some_and(|&last| {
                let same =
                    |&element: &u32| tiers[last].of(element as usize) == tier.of(element as usize);
                elements.iter().all(same)
            });
            if !as_before {
                used.push(number);
            }
            block_of.push(used.len() - 1);
        }
        let last = used.len().saturating_sub(1);
        block_of.iter_mut().for_each(|block| *block = last - *block);
        used.reverse();
        let mut end = 0;
        let starts = used.iter().map(|&tier| {
            let n = ranks.partition_point(|&rank| rank < kept[tier]);
            let mut starts = vec![end];
            for &element in &elements[..n] {
                end += tiers[tier].cost(element as usize);
                starts.push(end);
            }
            starts
        });
        let starts = starts.collect();
        Self { ranks, tiers: used, block_of, starts }
    }

    /// Number of triangles of all blocks.
    pub(super) fn n_triangles(&self) -> u32 {
        self.starts.last().and_then(|starts| starts.last()).copied().unwrap_or(0)
    }

    /// Triangles that are drawn.
    ///
    /// # Complexity
    /// O(log elements).
    pub(super) fn window(&self, cut: &Cut) -> Range<u32> {
        let before = |rank: u32| self.ranks.partition_point(|&r| r < rank);
        let tier = cut.tier as usize;
        let block = self.block_of[tier];
        let own = &self.starts[block];
        match self.block_of.get(tier + 1) {
            Some(&next) if next != block => {
                let (fine, next) = (before(cut.fine), &self.starts[next]);
                // Where none is drawn coarser, the next block ends where this one begins.
                next[fine.min(next.len() - 1)]..own[fine]
            }
            _ => own[0]..own[before(cut.end)],
        }
    }
}
