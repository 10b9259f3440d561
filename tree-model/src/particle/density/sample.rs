//! Points in proportion to the density: where particles start (Neubert 2012, 3.4).
//!
//! The voxels are strung along a space-filling curve, and the points are spread evenly along the density
//! gathered on it, one in each equal part (stratified sampling). So no region gets many more or fewer
//! than its share.

use super::super::grid::Grid;
use crate::error::{Result, check};
use glam::{IVec3, Vec3};
use rayon::prelude::*;
use tree_core::{Control, Resource, Seed};

/// `n` points in proportion to density times `weight`, spread evenly; where in a voxel is random.
/// Negative and NaN weights count as 0. `weight` is asked once for the centre of each filled voxel.
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter) naming `density` when the grid holds none;
/// [`ModelError::Limit`](crate::ModelError::Limit) for more points than nodes are allowed;
/// [`ModelError::Cancelled`](crate::ModelError::Cancelled).
///
/// # Complexity
/// O(voxels + filled voxels × log + n).
pub fn sample_points(
    grid: &Grid,
    n: u32,
    weight: impl Fn(Vec3) -> f32 + Sync,
    seed: Seed,
    control: &Control,
) -> Result<Vec<Vec3>> {
    control.limits.check(Resource::Nodes, u64::from(n))?;
    control.check()?;
    let mut filled: Vec<(u64, IVec3, f32)> = grid
        .values()
        .par_iter()
        .enumerate()
        .filter(|(_, value)| **value > 0.0 && value.is_finite())
        .map(|(i, &value)| {
            let voxel = grid.voxel_of(i);
            (curve(voxel), voxel, value * weight(grid.center(voxel)))
        })
        .filter(|(_, _, share)| *share > 0.0 && share.is_finite())
        .collect();
    filled.par_sort_unstable_by_key(|&(key, ..)| key);
    control.check()?;
    let total: f64 = filled.iter().map(|&(_, _, share)| f64::from(share)).sum();
    check("density.sum", total, f64::MIN_POSITIVE, f64::MAX)?;
    let (along, within) = (seed.stream("density.along"), seed.stream("density.within"));
    let part = total / f64::from(n.max(1));
    let mut points = Vec::with_capacity(n as usize);
    let (mut place, mut passed) = (0, 0.0);
    for i in 0..u64::from(n) {
        let wanted = (i as f64 + f64::from(along.unit(i))) * part;
        while place + 1 < filled.len() && passed + f64::from(filled[place].2) < wanted {
            passed += f64::from(filled[place].2);
            place += 1;
        }
        let Some(&(_, voxel, _)) = filled.get(place) else { break };
        let jitter = Vec3::from_array([0, 1, 2].map(|axis| within.unit(3 * i + axis)));
        points.push(grid.center(voxel) + grid.voxel() * (jitter - 0.5));
    }
    Ok(points)
}

/// The place of a voxel on the Z-order curve (Morton 1966): the bits of its coordinates in turn.
fn curve(voxel: IVec3) -> u64 {
    let spread = |value: i32| {
        // Sizes are at most 4096: 12 bits.
        (0..12).fold(0_u64, |key, bit| key | u64::from(value as u32 >> bit & 1) << (3 * bit))
    };
    spread(voxel.x) | spread(voxel.y) << 1 | spread(voxel.z) << 2
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::UVec3;
    use tree_core::Limits;

    fn grid() -> Grid {
        let mut grid = Grid::new(Vec3::ZERO, 0.5, UVec3::new(8, 4, 8), &Limits::default()).unwrap();
        for (i, value) in grid.values_mut().iter_mut().enumerate() {
            *value = if i % 8 < 4 { 1.0 } else { 3.0 };
        }
        grid
    }

    #[test]
    fn points_are_in_proportion_to_the_density() {
        let points = sample_points(&grid(), 1000, |_| 1.0, Seed(1), &Control::default()).unwrap();
        assert_eq!(points.len(), 1000);
        let low = points.iter().filter(|p| p.x < 2.0).count();
        assert!((245..=255).contains(&low), "{low}");
        assert!(points.iter().all(|p| grid().nearest(*p) > 0.0));
    }

    #[test]
    fn weights_leave_out_and_seeds_differ() {
        let control = Control::default();
        let right = |p: Vec3| if p.x < 2.0 { f32::NAN } else { 1.0 };
        let a = sample_points(&grid(), 100, right, Seed(1), &control).unwrap();
        assert!(a.iter().all(|p| p.x >= 2.0));
        assert_eq!(a, sample_points(&grid(), 100, right, Seed(1), &control).unwrap());
        assert_ne!(a, sample_points(&grid(), 100, right, Seed(2), &control).unwrap());
    }

    #[test]
    fn an_empty_grid_is_an_error() {
        let control = Control::default();
        let error = sample_points(&grid(), 10, |_| 0.0, Seed(1), &control).unwrap_err();
        assert!(error.to_string().contains("density"), "{error}");
        assert!(sample_points(&grid(), 0, |_| 1.0, Seed(1), &control).unwrap().is_empty());
    }
}
