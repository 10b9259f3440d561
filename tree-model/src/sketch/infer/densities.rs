//! Ω as its densities are evaluated: with what each needs worked out once.

use super::aims::Quantity;
use crate::sketch::omega::{Normal, Omega};

/// ½ ln 2π.
pub(super) const HALF_LN_TAU: f64 = 0.918_938_533_204_672_7;

/// A normal density.
#[derive(Clone, Copy, Debug)]
pub(super) struct Density {
    pub(super) mean: f64,
    pub(super) deviation: f64,
    /// 1 / σ.
    pub(super) narrowness: f64,
    /// ln of the density at its mean.
    pub(super) top: f64,
}

impl Density {
    pub(super) fn of(normal: Normal) -> Self {
        let deviation = f64::from(normal.deviation);
        Self {
            mean: normal.mean.into(),
            deviation,
            narrowness: 1.0 / deviation,
            top: -libm::log(deviation) - HALF_LN_TAU,
        }
    }
}

impl Density {
    /// ln of the density.
    pub(super) fn ln(&self, value: f64) -> f64 {
        let residual = (value - self.mean) * self.narrowness;
        self.top - 0.5 * residual * residual
    }
}

/// Ω with the densities of all its parameters.
#[derive(Clone, Debug)]
pub(super) struct Densities {
    pub(super) omega: Omega,
    rows: Vec<[Density; 5]>,
}

impl Densities {
    pub(super) fn of(omega: Omega) -> Self {
        let row = |habit| Quantity::ALL.map(|quantity| Density::of(quantity.of(habit)));
        Self { rows: omega.orders.iter().map(row).collect(), omega }
    }

    /// The density of a quantity for axes of `order`. Ω has at least one order: it is checked on the way in.
    pub(super) fn get(&self, order: u32, quantity: Quantity) -> Density {
        let row = (order as usize).min(self.rows.len() - 1);
        self.rows[row][quantity as usize]
    }
}
