//! In which order elements are dropped: rows of [`Elements`], most important first. The first
//! λ · n of them are drawn.
//!
//! - [`stochastic`]: none (Cook et al. 2007).
//! - [`golden`]: evenly over the ground (Neubert 2012, §6.3.2, "drop and resize").
//! - [`density`]: crowded elements go first (§7.3.2).
//! - [`orientation`]: those that do not lie along the hull go first (§7.3.3).
//! - [`combined`]: the last two together (§7.3.4, eq. 7.8).
//! - [`coverage`]: what covers most of the right pixels comes first (ours).
//!
//! Every order is a permutation of all elements ([`check`]), with the same bits for any number of
//! threads. Elements without area show nothing: they come last, in rising order, except in
//! `stochastic` and `golden`, which do not look at areas.

mod combined;
mod coverage;
mod density;
mod golden;
mod orientation;
mod stochastic;

#[cfg(test)]
mod tests;

pub use combined::combined;
pub use coverage::{CoverageParams, Ranking, coverage};
pub use density::density;
pub use golden::golden;
pub use orientation::orientation;
pub use stochastic::stochastic;

use crate::Elements;
use crate::error::{LodError, Result, check_range};
use crate::implicit::{HullParams, Metaballs};
use rayon::prelude::*;

/// What orders by density and orientation need to know.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrderParams {
    /// Height of the plant in metres, 0 to 10⁹. Default 0: measured
    /// ([`plant_height`](crate::implicit::plant_height)).
    pub height: f32,
    /// Radius of influence of an element, as a share of the height, 0.001 to 1. Default 0.05 (§7.3.1).
    pub radius: f32,
    /// The hull, for [`combined`].
    pub hull: HullParams,
    /// When densities count as uniform and thinning by density ends: at this standard deviation of
    /// the densities of what is left, divided by their mean, 0 (never) to 10 (at once). Default 0.15: trees begin at
    /// 0.35 to 1.2 and get no more even than about 0.1.
    pub uniform: f32,
    /// Thinning by density ends at this share of the elements at the latest, 0 to 1. Default 0.25:
    /// below it neighbours are so few that their number says little.
    pub least: f32,
    /// How much chance is added to priorities, which lie within 0 to 1; 0 (none) to 1. Default 0.05.
    pub randomness: f32,
}

impl Default for OrderParams {
    fn default() -> Self {
        Self {
            height: 0.0,
            radius: 0.05,
            hull: HullParams::default(),
            uniform: 0.15,
            least: 0.25,
            randomness: 0.05,
        }
    }
}

impl OrderParams {
    /// Checks all numbers.
    ///
    /// # Errors
    /// [`LodError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("order.height", self.height.into(), 0.0, 1e9)?;
        check_range("order.radius", self.radius.into(), 0.001, 1.0)?;
        check_range("order.uniform", self.uniform.into(), 0.0, 10.0)?;
        check_range("order.least", self.least.into(), 0.0, 1.0)?;
        check_range("order.randomness", self.randomness.into(), 0.0, 1.0)?;
        self.hull.validate()
    }

    /// The field of all elements that have area.
    ///
    /// # Errors
    /// As [`validate`](Self::validate) and [`Metaballs::of_elements`].
    pub fn field(&self, elements: &Elements) -> Result<Metaballs> {
        self.validate()?;
        Metaballs::of_elements(elements, self.radius, self.height)
    }
}

/// Checks that an order has each of `n` elements once.
///
/// # Errors
/// [`LodError::Order`], with the first row at fault.
pub fn check(order: &[u32], n: usize) -> Result<()> {
    let mut there = vec![false; n];
    for (row, &element) in order.iter().enumerate() {
        match there.get_mut(element as usize) {
            None => return Err(LodError::Order { row, problem: "there is no such element" }),
            Some(true) => {
                return Err(LodError::Order {
                    row,
                    problem: "the element is in an earlier row too",
                });
            }
            Some(free) => *free = true,
        }
    }
    if order.len() < n {
        let problem = "the order ends here, but each element must have a row";
        return Err(LodError::Order { row: order.len(), problem });
    }
    Ok(())
}

/// Elements with area by falling priority, ties by row; then the others.
fn by_priority(elements: &Elements, priority: impl Fn(u32) -> f32 + Sync) -> Vec<u32> {
    let (areal, flat) = by_area(elements);
    let mut keyed: Vec<(f32, u32)> = areal.into_par_iter().map(|i| (priority(i), i)).collect();
    keyed.par_sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    keyed.into_iter().map(|(_, i)| i).chain(flat).collect()
}

/// Elements with area, and those without.
fn by_area(elements: &Elements) -> (Vec<u32>, Vec<u32>) {
    (0..elements.len() as u32).partition(|&i| elements.areas[i as usize] > 0.0)
}
