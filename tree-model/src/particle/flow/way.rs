//! The way to the base through the tree: where particles go when no image tells.
//!
//! The thesis pulls particles straight to the base; where a crown stands on a bare trunk, or bends, that
//! leads them out of the tree. Here they take the cheapest way, which keeps to dense voxels and prefers the
//! stem. It ends at the base from everywhere, so it also brings back particles that got lost.

use super::super::grid::Grid;
use super::march::{march, neighbours};
use super::params::FlowParams;
use crate::error::Result;
use glam::{IVec3, Vec3};
use tree_core::Control;

/// A metre through empty voxels costs as much as this many through dense ones.
const EMPTY_COST: f32 = 20.0;
/// Half the width of the stem in voxels: wide enough that it hangs together along diagonals.
const STEM_WIDTH: f32 = 0.9;
/// Rows over which the middle of the crown is averaged to find the stem, as a share of all rows.
const STEM_SMOOTHING: f32 = 0.2;
/// The stem goes up to this share of the height.
const STEM_TOP: f32 = 0.92;
/// So many voxels beyond the outermost centres a point is outside.
const OUTSIDE: f32 = 1.0;
/// Within so many voxels of the base the way is straight.
const LAST_VOXELS: f32 = 1.5;

/// Directions to the base on the density's grid.
#[derive(Clone, Debug)]
pub struct Way {
    grid: Grid,
    directions: Vec<Vec3>,
}

impl Way {
    /// Finds the way to the origin from everywhere in `density`.
    ///
    /// # Errors
    /// [`ModelError::Cancelled`](crate::ModelError::Cancelled).
    ///
    /// # Complexity
    /// O(n log n) for n voxels.
    pub fn new(density: &Grid, params: &FlowParams, control: &Control) -> Result<Self> {
        let mut grid = density.clone();
        make_costs(&mut grid, density, params.stem);
        let size = grid.size().as_ivec3();
        let base = grid.voxel_at(Vec3::ZERO).clamp(IVec3::ZERO, size - 1);
        let start = grid.index(base).unwrap_or(0);
        let costs = march(&grid, start, control)?;
        let directions = (0..costs.len()).map(|at| direction(&grid, &costs, at)).collect();
        grid.values_mut().copy_from_slice(&costs);
        Ok(Self { grid, directions })
    }

    /// Cost of the way to the base from the centre of each voxel: metres, more where it is not dense.
    #[must_use]
    pub fn costs(&self) -> &Grid {
        &self.grid
    }

    /// Whether `point` is so close to the base that the way is straight.
    #[must_use]
    #[inline]
    pub fn is_last(&self, point: Vec3) -> bool {
        point.length() < LAST_VOXELS * self.grid.voxel()
    }

    /// The way on from `point`: a vector of length 0 to 1. From outside the grid it leads back into it.
    #[must_use]
    #[inline]
    pub fn sample(&self, point: Vec3) -> Vec3 {
        let last = (self.grid.size() - 1).as_vec3();
        let wanted = (point - self.grid.corner()) / self.grid.voxel() - 0.5;
        let at = wanted.max(Vec3::ZERO).min(last);
        if (at - wanted).length_squared() > OUTSIDE * OUTSIDE {
            return (at - wanted).normalize();
        }
        if self.is_last(point) {
            return (-point).normalize_or(Vec3::NEG_Y);
        }
        let low = at.as_uvec3();
        let share = at - low.as_vec3();
        let size = self.grid.size();
        let step = (low + 1).min(size - 1) - low;
        let (dx, dy, dz) =
            (step.x as usize, (step.y * size.x) as usize, (step.z * size.x * size.y) as usize);
        let i = ((low.z * size.y + low.y) * size.x + low.x) as usize;
        let d = &self.directions;
        let along = |i: usize| d[i] + (d[i + dx] - d[i]) * share.x;
        let across = |i: usize| {
            let low = along(i);
            low + (along(i + dy) - low) * share.y
        };
        let low = across(i);
        low + (across(i + dz) - low) * share.z
    }
}

/// Cost of a metre in every voxel.
fn make_costs(costs: &mut Grid, density: &Grid, stem: f32) {
    let mut dense: Vec<f32> = density.values().iter().copied().filter(|&d| d > 0.0).collect();
    dense.sort_unstable_by(f32::total_cmp);
    let usual = dense.get(dense.len() / 2).copied().unwrap_or(1.0);
    for (cost, &density) in costs.values_mut().iter_mut().zip(density.values()) {
        let share = (density / usual).clamp(0.0, 1.0);
        *cost = 1.0 / (1.0 / EMPTY_COST + (1.0 - 1.0 / EMPTY_COST) * share);
    }
    if stem < 1.0 {
        let line = stem_line(density);
        let top = STEM_TOP * (line.len() as f32);
        for i in 0..costs.values().len() {
            let voxel = costs.voxel_of(i);
            let row = voxel.y as usize;
            let off = costs.center(voxel) - line[row];
            let near = Vec3::new(off.x, 0.0, off.z).length() < STEM_WIDTH * costs.voxel();
            if near && (row as f32) < top {
                costs.values_mut()[i] = stem;
            }
        }
    }
}

/// The middle of the density at each height, from the base up, smoothed.
fn stem_line(density: &Grid) -> Vec<Vec3> {
    let rows = density.size().y as usize;
    let mut sums = vec![(Vec3::ZERO, 0.0_f32); rows];
    for (i, &value) in density.values().iter().enumerate() {
        if value > 0.0 {
            let voxel = density.voxel_of(i);
            let sum = &mut sums[voxel.y as usize];
            sum.0 += value * density.center(voxel);
            sum.1 += value;
        }
    }
    let reach = ((STEM_SMOOTHING * rows as f32) as usize).max(1);
    (0..rows)
        .map(|row| {
            let near = &sums[row.saturating_sub(reach)..(row + reach + 1).min(rows)];
            let (sum, weight) = near.iter().fold((Vec3::ZERO, 0.0), |(s, w), r| (s + r.0, w + r.1));
            let middle = if weight > 0.0 { sum / weight } else { Vec3::ZERO };
            // The stem starts at the base, whatever the crown above it does.
            let rise = (row as f32 / reach as f32).min(1.0);
            Vec3::new(middle.x * rise, 0.0, middle.z * rise)
        })
        .collect()
}

/// Down the slope of the costs, by upwind differences.
fn direction(grid: &Grid, costs: &[f32], at: usize) -> Vec3 {
    let center = grid.center(grid.voxel_of(at));
    if center.length() < LAST_VOXELS * grid.voxel() {
        return (-center).normalize_or(Vec3::NEG_Y);
    }
    let near = neighbours(grid, at).map(|n| n.map_or(f32::INFINITY, |n| costs[n]));
    let slope = |low: f32, high: f32| {
        let fall = (costs[at] - low.min(high)).max(0.0);
        if low < high { -fall } else { fall }
    };
    let down = Vec3::new(slope(near[0], near[1]), slope(near[2], near[3]), slope(near[4], near[5]));
    down.normalize_or(-center.normalize_or(Vec3::Y))
}
