//! The linear equations of the rays (Neubert 2012, 3.3.2), and walks of rays through a grid.

use super::super::camera::Projector;
use super::super::grid::Grid;
use super::super::view::View;
use super::carve::{Carved, NO_COLUMN, check_views};
use super::coverage::Coverage;
use super::params::DensityParams;
use crate::error::{ModelError, Result};
use glam::{IVec3, UVec3, Vec2, Vec3};
use rayon::prelude::*;
use tree_core::{Control, Resource};

/// Rays for a piece of parallel work.
const RAYS_AT_ONCE: usize = 256;

/// The equations A x = b: for each ray the densities x of the voxels on it, times its length in them in
/// metres, add up to −ln of the transparency seen.
///
/// Rows are rays, columns the voxels left by [`carve`](super::carve). Wanted is the x ≥ 0 with the least
/// ‖A x − b‖² + λ² ‖W⁻¹ x‖², where W holds the [`weights`](Self::weights).
#[derive(Clone, Debug, PartialEq)]
pub struct Equations {
    pub(super) rows: Sparse,
    /// The transpose of `rows`.
    pub(super) turned: Sparse,
    targets: Vec<f32>,
    weights: Vec<f32>,
    lambda: f32,
    /// First ray of each view, and the number of rays.
    pub(super) view_starts: Vec<usize>,
    /// For each view the sum of b² over rays that meet no voxel: nothing can explain them.
    pub(super) unexplained: Vec<f64>,
}

/// A sparse matrix in compressed rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Sparse {
    pub(super) starts: Vec<usize>,
    pub(super) columns: Vec<u32>,
    pub(super) values: Vec<f32>,
}

/// A ray and what is seen along it.
#[derive(Clone, Copy, Debug)]
struct Ray {
    on: Vec3,
    along: Vec3,
    /// Where it begins, in voxels beyond `on`.
    from: f32,
    target: f32,
    n_entries: usize,
}

impl Equations {
    /// Sets up the equations for the same `views` and `params` that were carved.
    ///
    /// # Errors
    /// As [`carve`](super::carve); [`ModelError::Limit`] when there are more entries than the limit on
    /// voxels allows, before memory is taken.
    ///
    /// # Complexity
    /// O(entries): about rays × voxels along one.
    pub fn new(
        carved: &Carved,
        views: &[View],
        params: &DensityParams,
        control: &Control,
    ) -> Result<Self> {
        params.validate()?;
        check_views(views)?;
        let mut rays: Vec<Ray> = Vec::new();
        let mut view_starts = vec![0];
        let mut unexplained = Vec::with_capacity(views.len());
        for view in views {
            control.check()?;
            let all = cast(carved, view, params, control)?;
            let lost = all.iter().filter(|ray| ray.n_entries == 0);
            unexplained.push(lost.map(|ray| f64::from(ray.target * ray.target)).sum());
            rays.extend(all.into_iter().filter(|ray| ray.n_entries > 0));
            view_starts.push(rays.len());
        }
        let n_entries = rays.iter().map(|ray| ray.n_entries).sum::<usize>();
        control.limits.check(Resource::Voxels, n_entries as u64)?;
        let rows = fill(carved, &rays, n_entries, control)?;
        let turned = rows.transposed(carved.voxels().len());
        let demand: f64 = rows.values.iter().map(|&length| f64::from(length * length)).sum();
        let mean = (demand / carved.voxels().len().max(1) as f64) as f32;
        Ok(Self {
            rows,
            turned,
            targets: rays.iter().map(|ray| ray.target).collect(),
            weights: carved.weights().to_vec(),
            lambda: params.evenness * mean.max(f32::MIN_POSITIVE).sqrt(),
            view_starts,
            unexplained,
        })
    }

    /// Rays: rows of A.
    #[must_use]
    pub fn n_rays(&self) -> usize {
        self.targets.len()
    }

    /// Unknown voxels: columns of A.
    #[must_use]
    pub fn n_voxels(&self) -> usize {
        self.weights.len()
    }

    /// Entries of A that are not zero.
    #[must_use]
    pub fn n_entries(&self) -> usize {
        self.rows.values.len()
    }

    /// A ray: the voxels it meets, as places in [`Carved::voxels`], and its length in each in metres.
    /// Empty beyond the last ray.
    #[must_use]
    pub fn row(&self, ray: usize) -> (&[u32], &[f32]) {
        if ray < self.n_rays() { self.rows.row(ray) } else { (&[], &[]) }
    }

    /// b: for each ray −ln of the transparency seen.
    #[must_use]
    pub fn targets(&self) -> &[f32] {
        &self.targets
    }

    /// The diagonal of W: how far each voxel lies inside the rounded crown, above 0 to 1.
    #[must_use]
    pub fn weights(&self) -> &[f32] {
        &self.weights
    }

    /// λ in metres.
    #[must_use]
    pub fn lambda(&self) -> f32 {
        self.lambda
    }
}

impl Sparse {
    #[inline]
    pub(super) fn row(&self, row: usize) -> (&[u32], &[f32]) {
        let range = self.starts[row]..self.starts[row + 1];
        (&self.columns[range.clone()], &self.values[range])
    }

    /// `to` = this × `from`.
    pub(super) fn times(&self, from: &[f32], to: &mut [f32]) {
        to.par_iter_mut().enumerate().with_min_len(RAYS_AT_ONCE).for_each(|(row, sum)| {
            let (columns, values) = self.row(row);
            *sum = columns.iter().zip(values).map(|(&c, v)| v * from[c as usize]).sum();
        });
    }

    fn transposed(&self, n_columns: usize) -> Self {
        let mut starts = vec![0; n_columns + 1];
        for &column in &self.columns {
            starts[column as usize + 1] += 1;
        }
        for column in 0..n_columns {
            starts[column + 1] += starts[column];
        }
        let mut free = starts.clone();
        let mut columns = vec![0; self.columns.len()];
        let mut values = vec![0.0; self.values.len()];
        for row in 0..self.starts.len().saturating_sub(1) {
            let (from, lengths) = self.row(row);
            for (&column, &length) in from.iter().zip(lengths) {
                let at = &mut free[column as usize];
                columns[*at] = row as u32;
                values[*at] = length;
                *at += 1;
            }
        }
        Self { starts, columns, values }
    }
}

/// One ray for each square of pixels of a view that the grid may fall on.
fn cast(
    carved: &Carved,
    view: &View,
    params: &DensityParams,
    control: &Control,
) -> Result<Vec<Ray>> {
    let grid = carved.alpha();
    let projector = view.camera.projector();
    let coverage = Coverage::new(&view.matte);
    let (low, high) = footprint(grid, &projector, view.camera.size);
    let bounds = grid.bounds();
    let middle = 0.5 * (bounds.min + bounds.max);
    let side = (grid.voxel() / (projector.pixel_size(middle) * params.rays)).max(1.0);
    let squares = ((high - low) / side - 1e-3).ceil().max(Vec2::ONE);
    let n = squares.x as u64 * squares.y as u64;
    control.limits.check(Resource::Voxels, n)?;
    let across = squares.x as usize;
    // Parallel rays have no eye to begin at.
    let from = if view.camera.eye().is_some() { 0.0 } else { f32::MIN };
    let shape = Shape::of(grid);
    (0..n as usize)
        .into_par_iter()
        .with_min_len(RAYS_AT_ONCE)
        .map(|i| {
            if i % RAYS_AT_ONCE == 0 {
                control.check()?;
            }
            let at = low + side * (Vec2::new((i % across) as f32, (i / across) as f32) + 0.5);
            let (on, along) = projector.ray(at);
            let mut n_entries = 0;
            shape.walk(on, along, from, |voxel, _| {
                n_entries += usize::from(carved.columns()[voxel] != NO_COLUMN);
            });
            let Some(alpha) = coverage.mean(at, Vec2::splat(0.5 * side)) else {
                return Ok(Ray { on, along, from, target: 0.0, n_entries: 0 });
            };
            let through = (1.0 - alpha).max(params.least_transparency);
            Ok(Ray { on, along, from, target: -libm::logf(through), n_entries })
        })
        .collect()
}

/// The part of the picture that the grid may fall on: all of it where a corner lies behind the camera.
fn footprint(grid: &Grid, projector: &Projector, size: Vec2) -> (Vec2, Vec2) {
    let (mut low, mut high) = (Vec2::MAX, Vec2::MIN);
    let bounds = grid.bounds();
    for corner in 0..8 {
        let pick = glam::BVec3::new(corner & 1 > 0, corner & 2 > 0, corner & 4 > 0);
        let Some(at) = projector.project(Vec3::select(pick, bounds.max, bounds.min)) else {
            return (Vec2::ZERO, size);
        };
        (low, high) = (low.min(at), high.max(at));
    }
    (low.clamp(Vec2::ZERO, size), high.clamp(Vec2::ZERO, size))
}

/// Walks all rays again and keeps the entries.
fn fill(carved: &Carved, rays: &[Ray], n_entries: usize, control: &Control) -> Result<Sparse> {
    let mut starts = Vec::with_capacity(rays.len() + 1);
    starts.push(0);
    let mut end = 0;
    starts.extend(rays.iter().map(|ray| {
        end += ray.n_entries;
        end
    }));
    let mut columns = vec![0; n_entries];
    let mut values = vec![0.0; n_entries];
    let mut work = Vec::new();
    let (mut rest, mut rest_values) = (&mut columns[..], &mut values[..]);
    for part in rays.chunks(RAYS_AT_ONCE) {
        let n = part.iter().map(|ray| ray.n_entries).sum();
        let (head, tail) = rest.split_at_mut(n);
        let (head_values, tail_values) = rest_values.split_at_mut(n);
        (rest, rest_values) = (tail, tail_values);
        work.push((part, head, head_values));
    }
    let shape = Shape::of(carved.alpha());
    work.into_par_iter().try_for_each(|(part, columns, values)| {
        control.check()?;
        let mut places = columns.iter_mut().zip(values);
        for ray in part {
            shape.walk(ray.on, ray.along, ray.from, |voxel, length| {
                let column = carved.columns()[voxel];
                if column != NO_COLUMN
                    && let Some((place, value)) = places.next()
                {
                    (*place, *value) = (column, length);
                }
            });
        }
        Ok::<(), ModelError>(())
    })?;
    Ok(Sparse { starts, columns, values })
}

/// Where a grid lies, without its values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    pub(super) corner: Vec3,
    pub(super) voxel: f32,
    pub(super) size: UVec3,
}

impl Shape {
    pub(super) fn of(grid: &Grid) -> Self {
        Self { corner: grid.corner(), voxel: grid.voxel(), size: grid.size() }
    }

    /// Centre of a voxel in metres.
    pub(super) fn center(&self, voxel: IVec3) -> Vec3 {
        self.corner + self.voxel * (voxel.as_vec3() + 0.5)
    }

    /// Visits the voxels along a line from `from` voxels beyond `on`, with the length in each in metres
    /// (Amanatides, Woo 1987).
    pub(super) fn walk(&self, on: Vec3, along: Vec3, from: f32, mut visit: impl FnMut(usize, f32)) {
        let origin = ((on - self.corner) / self.voxel).to_array();
        let (along, size) = (along.to_array(), self.size.as_ivec3().to_array());
        let (mut enter, mut leave) = (from, f32::MAX);
        for axis in 0..3 {
            let (o, d, n) = (origin[axis], along[axis], size[axis] as f32);
            if d.abs() < PARALLEL {
                if !(0.0..n).contains(&o) {
                    return;
                }
                continue;
            }
            let (a, b) = (-o / d, (n - o) / d);
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        if !(enter < leave && enter.is_finite() && leave.is_finite()) {
            return;
        }
        let (mut cell, mut step, mut next, mut apart) =
            ([0_i32; 3], [0_i32; 3], [f32::MAX; 3], [0.0; 3]);
        for axis in 0..3 {
            let (o, d) = (origin[axis], along[axis]);
            cell[axis] = ((o + d * enter).floor() as i32).clamp(0, size[axis] - 1);
            if d.abs() >= PARALLEL {
                let ahead = cell[axis] + i32::from(d > 0.0);
                (step[axis], next[axis]) = (d.signum() as i32, (ahead as f32 - o) / d);
                apart[axis] = 1.0 / d.abs();
            }
        }
        let mut at = enter;
        loop {
            let axis = if next[0] <= next[1] && next[0] <= next[2] {
                0
            } else {
                1 + usize::from(next[2] < next[1])
            };
            let end = next[axis].min(leave);
            if end > at {
                let row = (cell[2] * size[1] + cell[1]) * size[0] + cell[0];
                visit(row as usize, (end - at) * self.voxel);
                at = end;
            }
            cell[axis] += step[axis];
            if end >= leave || step[axis] == 0 || !(0..size[axis]).contains(&cell[axis]) {
                return;
            }
            next[axis] += apart[axis];
        }
    }
}

/// Lines that change less along an axis never leave a voxel across it.
const PARALLEL: f32 = 1e-6;
