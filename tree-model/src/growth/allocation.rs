//! How vigour is shared out (Palubicki et al. 2009, section 4.2): what decides whether a tree has one trunk
//! or many limbs.
//!
//! Light is summed from the tips to the base; the base gets vigour in proportion; it flows back up and
//! is split at every fork by one of two models.

use super::stem::{BUD, NOTHING, Stem};
use crate::error::{Result, check};

/// A model of how branches of one tree compete.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Allocation {
    /// The extended Borchert-Honda model: at each fork the main axis and the laterals get shares
    /// λ Qₘ : (1 - λ) Qₗ of what arrives, for the light Q behind each; see `fork`.
    BorchertHonda {
        /// λ of a seedling, 0 to 1: above 0.5 the main axis is favoured, below the laterals. 0.46 to 0.54
        /// span shrubs to poplars.
        lambda: f32,
        /// λ of an old tree, 0 to 1: lower than `lambda` for a crown that opens with age.
        late: f32,
        /// Iterations in which λ goes from one to the other, 0 to 10,000.
        turning: u32,
    },
    /// The priority model: the buds and branches of each axis are ranked by the mean light of their buds, the
    /// terminal bud first, and get shares by light times weight; see `priorities`.
    Priority {
        /// Weight of the first rank (`w_max`), 0 to 1000.
        first: f32,
        /// Weight of the last ranks (`w_min`), 0 to 1000.
        last: f32,
        /// Share of the ranks (κ) over which the weight falls from one to the other, 0 to 1.
        fall: f32,
    },
}

impl Default for Allocation {
    fn default() -> Self {
        Self::BorchertHonda { lambda: 0.5, late: 0.5, turning: 0 }
    }
}

impl Allocation {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        match *self {
            Self::BorchertHonda { lambda, late, turning } => {
                check("habit.allocation.lambda", lambda, 0, 1)?;
                check("habit.allocation.late", late, 0, 1)?;
                check("habit.allocation.turning", turning, 0, 10_000)
            }
            Self::Priority { first, last, fall } => {
                check("habit.allocation.first", first, 0, 1000)?;
                check("habit.allocation.last", last, 0, 1000)?;
                check("habit.allocation.fall", fall, 0, 1)
            }
        }
    }
}

/// The extended Borchert-Honda model at one fork: what of `vigour` goes on in the main axis and what goes to the
/// lateral, for the light behind each. Where there is no light nothing arrives.
#[must_use]
pub(crate) fn fork(vigour: f32, lambda: f32, main: f32, lateral: f32) -> [f32; 2] {
    let (main, lateral) = (lambda * main, (1.0 - lambda) * lateral);
    let sum = main + lateral;
    // Light so faint that its share is not a number any more is none.
    if sum < f32::MIN_POSITIVE { [0.0; 2] } else { [main, lateral].map(|q| vigour * (q / sum)) }
}

/// A bud or a branch of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rival {
    /// Light of all its buds.
    pub(crate) light: f32,
    /// Number of its buds.
    pub(crate) n_buds: u32,
    /// Whatever the caller knows it by.
    pub(crate) index: u32,
}

/// The priority model along one axis: ranks the rivals and hands each its part of `vigour`.
///
/// The first `n_fixed` keep their rank before all others, which are ranked by mean light; of equals the
/// earlier comes first. Weights fall in a line from `first` to `last` over the share `fall` of the ranks.
///
/// # Complexity
/// O(n log n) for n rivals.
pub(crate) fn priorities(
    vigour: f32,
    [first, last, fall]: [f32; 3],
    n_fixed: usize,
    rivals: &mut [Rival],
    mut take: impl FnMut(u32, f32),
) {
    let mean = |rival: &Rival| rival.light / rival.n_buds.max(1) as f32;
    if let Some(ranked) = rivals.get_mut(n_fixed..) {
        ranked.sort_by(|a, b| mean(b).total_cmp(&mean(a)));
    }
    let falling = (fall * rivals.len() as f32).max(1.0);
    let weight = |rank: usize| first + (last - first) * (rank as f32 / falling).min(1.0);
    let share = |(rank, rival): (usize, &Rival)| weight(rank) * rival.light;
    let sum: f32 = rivals.iter().enumerate().map(share).sum();
    for ranked in rivals.iter().enumerate() {
        let part = if sum < f32::MIN_POSITIVE { 0.0 } else { vigour * (share(ranked) / sum) };
        take(ranked.1.index, part);
    }
}

/// What a node and all above it have.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Total {
    pub(super) light: f32,
    pub(super) n_buds: u32,
    pub(super) n_metamers: u32,
}

/// Sums light, buds and metamers from the tips to the base. `quality` has a row for each end.
pub(super) fn gather(stem: &Stem, quality: &[f32], totals: &mut Vec<Total>) {
    totals.clear();
    totals.resize(stem.len(), Total::default());
    for node in (0..stem.len()).rev() {
        let mut total = Total { n_metamers: 1, ..Total::default() };
        for (slot, &end) in stem.ends_of(node).iter().enumerate() {
            let part = end_total(end, quality[node * stem.width() + slot], totals);
            total.light += part.light;
            total.n_buds += part.n_buds;
            total.n_metamers += part.n_metamers;
        }
        totals[node] = total;
    }
}

fn end_total(end: u32, quality: f32, totals: &[Total]) -> Total {
    match end {
        NOTHING => Total::default(),
        BUD => Total { light: quality, n_buds: 1, n_metamers: 0 },
        child => totals.get(child as usize).copied().unwrap_or_default(),
    }
}

/// Shares the base's vigour out: `vigour` gets a row for each end.
pub(super) fn share_out(
    stem: &Stem,
    allocation: &Allocation,
    iteration: u32,
    base: f32,
    (quality, totals): (&[f32], &[Total]),
    vigour: &mut Vec<f32>,
) {
    vigour.clear();
    vigour.resize(stem.len() * stem.width(), 0.0);
    match *allocation {
        Allocation::BorchertHonda { lambda, late, turning } => {
            let turned = if turning == 0 { 1.0 } else { iteration as f32 / turning as f32 };
            let lambda = lambda + (late - lambda) * turned.min(1.0);
            share_at_forks(stem, lambda, base, (quality, totals), vigour);
        }
        Allocation::Priority { first, last, fall } => {
            let weights = [first, last, fall];
            share_along_axes(stem, weights, base, (quality, totals), vigour);
        }
    }
}

fn share_at_forks(
    stem: &Stem,
    lambda: f32,
    base: f32,
    (quality, totals): (&[f32], &[Total]),
    vigour: &mut [f32],
) {
    let width = stem.width();
    let mut arriving = vec![0.0; stem.len()];
    arriving[0] = base;
    for node in 0..stem.len() {
        let ends = stem.ends_of(node);
        let from = node * width;
        let light = |slot: usize| end_total(ends[slot], quality[from + slot], totals).light;
        let laterals: f32 = (1..width).map(light).sum();
        let [main, lateral] = fork(arriving[node], lambda, light(0), laterals);
        for (slot, &end) in ends.iter().enumerate() {
            let part = match slot {
                0 => main,
                _ if laterals > 0.0 => lateral * (light(slot) / laterals),
                _ => 0.0,
            };
            vigour[from + slot] = part;
            if let Some(arriving) = arriving.get_mut(end as usize) {
                *arriving = part;
            }
        }
    }
}

fn share_along_axes(
    stem: &Stem,
    weights: [f32; 3],
    base: f32,
    (quality, totals): (&[f32], &[Total]),
    vigour: &mut [f32],
) {
    let width = stem.width();
    let (mut rivals, mut laterals) = (Vec::new(), Vec::new());
    // Axes by their first nodes, which rise from parent axis to lateral.
    for first in 0..stem.len() {
        let Some(arriving) = axis_vigour(stem, first, base, vigour) else { continue };
        rivals.clear();
        laterals.clear();
        let mut node = first;
        loop {
            let ends = stem.ends_of(node);
            for (slot, &end) in ends.iter().enumerate() {
                let row = node * width + slot;
                let total = end_total(end, quality[row], totals);
                let rival = Rival { light: total.light, n_buds: total.n_buds, index: row as u32 };
                match (slot, end) {
                    (_, NOTHING) => {}
                    (0, BUD) => rivals.push(rival),
                    (0, _) => {}
                    _ => laterals.push(rival),
                }
            }
            match ends[0] {
                BUD | NOTHING => break,
                next => node = next as usize,
            }
        }
        let n_fixed = rivals.len();
        rivals.append(&mut laterals);
        priorities(arriving, weights, n_fixed, &mut rivals, |row, part| {
            vigour[row as usize] = part;
        });
    }
}

/// The vigour that arrives at the first node of an axis; `None` for a node that goes on with one.
fn axis_vigour(stem: &Stem, node: usize, base: f32, vigour: &[f32]) -> Option<f32> {
    if node == 0 {
        return Some(base);
    }
    let parent = stem.parents[node] as usize;
    let slot = stem.ends_of(parent).iter().position(|&end| end as usize == node)?;
    (slot > 0).then(|| vigour[parent * stem.width() + slot])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn lambda_decides_between_the_main_axis_and_laterals() {
        assert_eq!(fork(4.0, 0.5, 3.0, 1.0), [3.0, 1.0]);
        assert_eq!(fork(4.0, 0.75, 1.0, 1.0), [3.0, 1.0]);
        assert_eq!(fork(4.0, 0.2, 0.0, 0.0), [0.0, 0.0]);
        assert_eq!(fork(4.0, 1.0, 0.0, 1.0), [0.0, 0.0]);
    }

    #[test]
    fn the_brighter_rank_higher_and_fixed_ones_highest() {
        let rival = |index, light| Rival { light, n_buds: 1, index };
        let mut rivals = [rival(0, 0.5), rival(1, 0.6), rival(2, 1.0)];
        let mut parts = [0.0; 3];
        priorities(1.0, [1.0, 0.0, 1.0], 1, &mut rivals, |i, part| parts[i as usize] = part);
        // Weights 1, 1/3 for rank 2, 2/3 for rank 1.
        let sum = 0.5 + 2.0 / 3.0 + 0.2;
        for (part, share) in parts.iter().zip([0.5, 0.2, 2.0 / 3.0]) {
            assert!((part - share / sum).abs() < 1e-6, "{parts:?}");
        }
    }

    proptest! {
        #[test]
        fn no_vigour_is_made_or_lost(
            lights in prop::collection::vec(0.01_f32..1.0, 1..9),
            n_fixed in 0_usize..3,
            fall in 0.0_f32..1.0,
        ) {
            let rival = |(i, &light): (usize, &f32)| Rival { light, n_buds: 1, index: i as u32 };
            let mut rivals: Vec<Rival> = lights.iter().enumerate().map(rival).collect();
            let mut sum = 0.0;
            priorities(5.0, [1.0, 0.1, fall], n_fixed, &mut rivals, |_, part| sum += part);
            prop_assert!((sum - 5.0).abs() < 1e-4);
            let [main, lateral] = fork(5.0, fall, lights[0], 0.3);
            prop_assert!((main + lateral - 5.0).abs() < 1e-4);
        }
    }
}
