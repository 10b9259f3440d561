//! How many leaves each part of the crown is to bear, so that the images are covered as they ask.
//!
//! A first guess follows from the density. Then leaves are grown, counted in the images, and the demand is
//! multiplied by what the images ask for over what they got (multiplicative algebraic reconstruction, Gordon,
//! Bender and Herman 1970).

use super::sight::Sight;
use crate::error::Result;
use crate::particle::grid::Grid;
use glam::{IVec3, Vec3};
use tree_core::{Foliage, Limits};

/// Share of a leaf's area that is seen on average, before leaves have been counted.
const FACING: f32 = 0.5;
/// Optical depth below which differences do not matter: it keeps ratios tame.
const FLOOR: f32 = 0.15;
/// One correction changes the demand by at most this factor either way.
const LARGEST_CHANGE: f32 = 3.0;
/// Leaves a voxel is never asked for more of than this many times its first guess.
const LARGEST_DEMAND: f32 = 8.0;

/// Leaves asked for in each voxel.
pub(super) struct Demand {
    /// Leaves in a voxel.
    wanted: Grid,
    most: Vec<f32>,
    /// Asked for over there, averaged over the voxels around.
    ratio: Grid,
}

impl Demand {
    /// The first guess: as many leaves of the area `area` in square metres as give the density.
    pub(super) fn new(density: &Grid, area: f32, fullness: f32, limits: &Limits) -> Result<Self> {
        let mut wanted = density.clone();
        let volume = density.voxel() * density.voxel() * density.voxel();
        for value in wanted.values_mut() {
            *value *= fullness * volume / (area * FACING);
        }
        let most = wanted.values().iter().map(|value| LARGEST_DEMAND * value).collect();
        let ratio = Grid::new(density.corner(), density.voxel(), density.size(), limits)?;
        Ok(Self { wanted, most, ratio })
    }

    /// Leaves asked for altogether.
    pub(super) fn total(&self) -> f64 {
        self.wanted.values().iter().map(|&n| f64::from(n)).sum()
    }

    /// Takes note of how many leaves could stand where. Afterwards [`at`](Self::at) answers.
    pub(super) fn spread_over(&mut self, places: impl Iterator<Item = Vec3>) {
        let mut there = vec![0.0_f32; self.wanted.values().len()];
        for place in places {
            if let Some(i) = self.wanted.index(self.wanted.voxel_at(place)) {
                there[i] += 1.0;
            }
        }
        let wanted = blurred(&self.wanted, self.wanted.values());
        let there = blurred(&self.wanted, &there);
        for ((ratio, wanted), there) in self.ratio.values_mut().iter_mut().zip(wanted).zip(there) {
            *ratio = wanted / there.max(1e-3);
        }
    }

    /// How many leaves are to stand at each place for one, about `point`.
    pub(super) fn at(&self, point: Vec3) -> f32 {
        self.ratio.nearest(point)
    }

    /// Puts the demand right after `leaves` have been counted in all images.
    pub(super) fn correct(
        &mut self,
        sights: &[Sight<'_>],
        leaves: &Foliage,
        blade: f32,
        fullness: f32,
    ) {
        let changes: Vec<Vec<f32>> = sights
            .iter()
            .map(|sight| {
                let covered = sight.covered(leaves.iter(), blade);
                let asked = sight.asked();
                let change = asked.iter().zip(covered).map(|(&asked, covered)| {
                    let ratio = (fullness * asked + FLOOR) / (covered + FLOOR);
                    ratio.clamp(1.0 / LARGEST_CHANGE, LARGEST_CHANGE)
                });
                change.collect()
            })
            .collect();
        for i in 0..self.wanted.values().len() {
            if self.wanted.values()[i] <= 0.0 {
                continue;
            }
            let center = self.wanted.center(self.wanted.voxel_of(i));
            let (mut product, mut n) = (1.0_f32, 0_u8);
            for (sight, change) in sights.iter().zip(&changes) {
                if let Some(ratio) = sight.look_up(change, center) {
                    product *= ratio;
                    n += 1;
                }
            }
            let change = match n {
                0 => 1.0,
                1 => product,
                n => libm::powf(product, 1.0 / f32::from(n)),
            };
            let wanted = &mut self.wanted.values_mut()[i];
            *wanted = (*wanted * change).min(self.most[i]);
        }
    }
}

/// Sums over each voxel and the 26 around it.
fn blurred(grid: &Grid, values: &[f32]) -> Vec<f32> {
    let mut values = values.to_vec();
    for step in [IVec3::X, IVec3::Y, IVec3::Z] {
        let old = values.clone();
        let at = |voxel: IVec3| grid.index(voxel).map_or(0.0, |i| old[i]);
        for (i, value) in values.iter_mut().enumerate() {
            let voxel = grid.voxel_of(i);
            *value += at(voxel - step) + at(voxel + step);
        }
    }
    values
}
