//! Where the triangles of a part lie in its index buffer.
//!
//! A *block* holds the triangles of a part's elements in one tier, in the order of importance. Blocks
//! follow each other from the finest to the coarsest, so that what a [`Cut`] draws is one piece: the
//! rest of a block and the beginning of the next, or the beginning of the last. Tiers in which
//! no element of the part differs share a block.

use super::schedule::Cut;
use crate::outline::Tier;
use std::ops::Range;

/// The blocks of one part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    /// Ranks of the part's elements in the order of the whole model, rising.
    pub(super) ranks: Vec<u32>,
    /// The tier each block is made of.
    pub(super) tiers: Vec<usize>,
    /// Block of each tier.
    block_of: Vec<usize>,
    /// Of each block: where the triangles of each element begin in the index buffer, and where the
    /// block ends.
    pub(super) starts: Vec<Vec<u32>>,
}

impl Layout {
    /// `elements` are those of the part, in the order of `ranks`. All triangles of the tiers must be fewer
    /// than 2³².
    pub(super) fn new(ranks: Vec<u32>, elements: &[u32], tiers: &[Tier]) -> Self {
        let mut layout =
            Self { ranks, tiers: Vec::new(), block_of: Vec::new(), starts: Vec::new() };
        let mut end = 0;
        for (number, tier) in tiers.iter().enumerate() {
            let as_before = layout.tiers.last().is_some_and(|&last| {
                let same =
                    |&element: &u32| tiers[last].of(element as usize) == tier.of(element as usize);
                elements.iter().all(same)
            });
            if !as_before {
                let mut starts = vec![end];
                for &element in elements {
                    end += tier.cost(element as usize);
                    starts.push(end);
                }
                layout.tiers.push(number);
                layout.starts.push(starts);
            }
            layout.block_of.push(layout.tiers.len() - 1);
        }
        layout
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
        let start = |block: usize, place: usize| self.starts[block][place];
        let (tier, n) = (cut.tier as usize, self.ranks.len());
        let fine = self.block_of[tier];
        match self.block_of.get(tier + 1) {
            Some(&next) if next != fine => {
                let coarse = before(cut.coarse);
                start(fine, coarse)..start(next, coarse)
            }
            Some(_) => start(fine, 0)..start(fine, n),
            None => start(fine, 0)..start(fine, before(cut.end)),
        }
    }
}
