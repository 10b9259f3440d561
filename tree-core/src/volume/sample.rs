//! Random points in a volume, and its size by counting them.

use super::Volume;
use crate::control::{Cancelled, Control};
use crate::seed::{Rng, Seed};
use glam::{DVec3, Vec3};
use rand::RngExt;

/// Seed of [`Volume::estimate_measure`]; any other gives another, equally good estimate.
const ESTIMATE_SEED: Seed = Seed(0).stream("volume estimate");

/// So many steps take well under a millisecond.
const STEPS_BETWEEN_CHECKS: u64 = 4096;

impl Volume {
    /// A point uniform in the volume, by rejection from [`bounds`](Self::bounds).
    ///
    /// None when the bounds are infinite or empty, or when none of `attempts` points lay inside. A
    /// volume that fills a share `f` of its box fails with probability `(1 - f)^attempts`: 64
    /// attempts do for any of the plain solids but very narrow ones.
    ///
    /// # Complexity
    /// At most `attempts` calls of [`contains`](Self::contains).
    #[must_use]
    pub fn sample(&self, rng: &mut Rng, attempts: u32) -> Option<Vec3> {
        let bounds = self.bounds();
        if bounds.is_empty() || !bounds.is_finite() {
            return None;
        }
        let min = bounds.min.as_dvec3();
        let size = bounds.max.as_dvec3() - min;
        (0..attempts).map(|_| (min + size * unit_cube(rng)).as_vec3()).find(|&p| self.contains(p))
    }

    /// Cubic metres inside, by sampling one point in each cell of a grid over the box: the same
    /// bits in every run. The error falls a little faster than `1 / sqrt(samples)`.
    ///
    /// Infinite when the bounds are, zero when they are empty.
    ///
    /// # Errors
    /// [`Cancelled`].
    ///
    /// # Complexity
    /// At most `samples` calls of [`contains`](Self::contains): the largest cube number not above
    /// it, and at least 1.
    pub fn estimate_measure(&self, samples: u32, control: &Control) -> Result<f32, Cancelled> {
        let bounds = self.bounds();
        if bounds.is_empty() {
            return Ok(0.0);
        }
        if !bounds.is_finite() {
            return Ok(f32::INFINITY);
        }
        let n_side = cube_root(samples).max(1);
        let min = bounds.min.as_dvec3();
        let size = bounds.max.as_dvec3() - min;
        let mut rng = ESTIMATE_SEED.rng();
        let mut n_inside = 0_u32;
        let between_checks = (STEPS_BETWEEN_CHECKS / self.cost()).max(1);
        for x in 0..n_side {
            for y in 0..n_side {
                for z in 0..n_side {
                    if u64::from(z).is_multiple_of(between_checks) {
                        control.check()?;
                    }
                    let cell = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
                    let share = (cell + unit_cube(&mut rng)) / f64::from(n_side);
                    n_inside += u32::from(self.contains((min + size * share).as_vec3()));
                }
            }
        }
        let n_cells = f64::from(n_side * n_side * n_side);
        Ok(super::math::narrow(size.element_product() * f64::from(n_inside) / n_cells))
    }
}

fn unit_cube(rng: &mut Rng) -> DVec3 {
    DVec3::new(rng.random(), rng.random(), rng.random())
}

/// Rounded down. In whole numbers: the cube of the largest answer, 1625, still fits.
fn cube_root(n: u32) -> u32 {
    let root = libm::cbrt(f64::from(n)).round() as u32;
    if u64::from(root).pow(3) > u64::from(n) { root - 1 } else { root }
}
