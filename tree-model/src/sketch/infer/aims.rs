//! What each segment aims at within Ω.
//!
//! The likeliest depths give every branch the mean angle wherever the drawing allows it: an average tree, which no tree
//! is. So each segment gets a draw of its own, in standard deviations from the mean, and the posterior is largest where all
//! are met (perturb and maximise, Papandreou & Yuille 2011). Another seed gives another tree of the same habit.

use super::segments::Segments;
use crate::sketch::omega::{Habit, Normal, Omega};
use tree_core::Seed;

/// The quantities that Ω speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    Scale,
    LateralScale,
    Alpha,
    Beta,
    Gamma,
}

impl Quantity {
    pub(super) const ALL: [Self; 5] =
        [Self::Scale, Self::LateralScale, Self::Alpha, Self::Beta, Self::Gamma];

    pub(super) fn of(self, habit: &Habit) -> Normal {
        match self {
            Self::Scale => habit.scale,
            Self::LateralScale => habit.lateral_scale,
            Self::Alpha => habit.alpha,
            Self::Beta => habit.beta,
            Self::Gamma => habit.gamma,
        }
    }

    pub(super) fn of_mut(self, habit: &mut Habit) -> &mut Normal {
        match self {
            Self::Scale => &mut habit.scale,
            Self::LateralScale => &mut habit.lateral_scale,
            Self::Alpha => &mut habit.alpha,
            Self::Beta => &mut habit.beta,
            Self::Gamma => &mut habit.gamma,
        }
    }
}

/// No aim is farther from the mean than this many standard deviations.
const FARTHEST: f64 = 2.5;
/// Divergences aimed at are above 0: at least this share of the mean is left.
const LEAST_ANGLE: f64 = 0.1;

/// Draws in standard deviations, five for each segment.
pub(super) struct Aims {
    rows: Vec<[f64; 5]>,
    /// Least draw of α and β for each order.
    least: Vec<[f64; 2]>,
}

impl Aims {
    pub(super) fn draw(segments: &Segments, template: &Omega, spread: f64, seed: Seed) -> Self {
        let seed = seed.stream("aims");
        let row = |key: &[u64; 2]| {
            let mut rng = seed.child(key[0]).child(key[1]).rng();
            [0; 5].map(|_| {
                spread * f64::from(tree_core::seed::normal(&mut rng)).clamp(-FARTHEST, FARTHEST)
            })
        };
        let least =
            |normal: Normal| (LEAST_ANGLE - 1.0) * f64::from(normal.mean / normal.deviation);
        Self {
            rows: segments.keys.iter().map(row).collect(),
            least: template
                .orders
                .iter()
                .map(|habit| [least(habit.alpha), least(habit.beta)])
                .collect(),
        }
    }

    /// What segment `i` aims at if its parent's axis has this order.
    pub(super) fn of(&self, i: usize, quantity: Quantity, order: u32) -> f64 {
        let aim = self.rows[i][quantity as usize];
        let least = self.least.get(order as usize).or(self.least.last());
        match (quantity, least) {
            (Quantity::Alpha, Some(least)) => aim.max(least[0]),
            (Quantity::Beta, Some(least)) => aim.max(least[1]),
            _ => aim,
        }
    }

    /// A number from 0 to 1 that belongs to the whole sketch.
    pub(super) fn phase(seed: Seed) -> f64 {
        f64::from(seed.stream("stems").unit(0))
    }
}
