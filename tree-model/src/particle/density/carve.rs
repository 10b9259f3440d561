//! Back-projection and space carving (Neubert 2012, 3.3.1).

use super::super::camera::{Camera, Projector};
use super::super::grid::Grid;
use super::super::view::View;
use super::bounds::extent;
use super::coverage::Coverage;
use super::params::DensityParams;
use super::rounding::{Ellipse, ellipse};
use super::system::Shape;
use crate::error::{ModelError, Result};
use glam::{IVec3, Vec2};
use rayon::prelude::*;
use tree_core::Control;

/// Voxels of less weight are outside the crown.
const LEAST_WEIGHT: f32 = 0.02;
/// The column of a voxel that was thrown away.
pub(super) const NO_COLUMN: u32 = u32::MAX;

/// The voxels the tree may fill, and what they begin with.
#[derive(Clone, Debug, PartialEq)]
pub struct Carved {
    alpha: Grid,
    voxels: Vec<u32>,
    weights: Vec<f32>,
    columns: Vec<u32>,
    n_unseen: u64,
}

impl Carved {
    /// The least of the mattes that each voxel projects to, 0 to 1; 0 where it was thrown away (3.3.1).
    #[must_use]
    pub fn alpha(&self) -> &Grid {
        &self.alpha
    }

    /// The voxels that are left, as rows of the grid's values, rising.
    #[must_use]
    pub fn voxels(&self) -> &[u32] {
        &self.voxels
    }

    /// How far each voxel that is left lies inside the rounded crown, 0 to 1.
    #[must_use]
    pub fn weights(&self) -> &[f32] {
        &self.weights
    }

    /// Voxels that were thrown away although a view shows them.
    #[must_use]
    pub fn n_carved(&self) -> u64 {
        (self.columns.len() - self.voxels.len()) as u64 - self.n_unseen
    }

    /// Voxels that no picture shows.
    #[must_use]
    pub fn n_unseen(&self) -> u64 {
        self.n_unseen
    }

    /// For each voxel of the grid its place in [`voxels`](Self::voxels), or [`NO_COLUMN`].
    pub(super) fn columns(&self) -> &[u32] {
        &self.columns
    }
}

/// Lays a grid of cubes around what the views see and throws away those that a view shows to be empty.
///
/// What lies outside a picture is unknown there, and the other views decide. With
/// [`rounding`](DensityParams::rounding) also the corners are thrown away that the silhouettes leave open.
///
/// # Errors
/// [`ModelError::Parameter`] for parameters and cameras out of range, [`ModelError::View`] for a matte
/// that is not of its camera's size or shows no tree, or a view that leaves nothing of what the others
/// see; [`ModelError::Limit`] for too many voxels, before memory is taken; [`ModelError::Cancelled`].
///
/// # Complexity
/// O(pixels + voxels × views).
pub fn carve(views: &[View], params: &DensityParams, control: &Control) -> Result<Carved> {
    params.validate()?;
    check_views(views)?;
    control.report("density", 0.0)?;
    let coverages: Vec<Coverage> =
        views.par_iter().map(|view| Coverage::new(&view.matte)).collect();
    check_covered(&coverages)?;
    let cameras: Vec<(&Camera, Projector)> =
        views.iter().map(|view| (&view.camera, view.camera.projector())).collect();
    let Some(extent) = extent(&cameras, &coverages, params.resolution) else {
        let problem = "no ray through its tree comes near the tree's axis; check its camera";
        return Err(ModelError::View { view: 0, problem: problem.into() });
    };
    let size = ((extent.high - extent.low) / extent.voxel - 1e-3).ceil().max(glam::Vec3::ONE);
    let spare = 0.5 * (size * extent.voxel - (extent.high - extent.low));
    let corner = (extent.low - spare).with_y(extent.low.y);
    let mut alpha = Grid::new(corner, extent.voxel, size.as_uvec3(), &control.limits)
        .map_err(|error| bad_scale(error, views, extent.voxel))?;
    let sight = Sight { cameras, coverages, params };
    let weights = sight.carve(&mut alpha, control)?;
    sight.collect(alpha, &weights)
}

/// Checks that there are views, each with a camera for its matte.
pub(super) fn check_views(views: &[View]) -> Result<()> {
    crate::error::check("views.len()", views.len() as f64, 1.0, 1000.0)?;
    for (i, view) in views.iter().enumerate() {
        view.camera.validate(&format!("views[{i}].camera"))?;
        let size = Vec2::new(view.matte.width() as f32, view.matte.height() as f32);
        if view.camera.size != size {
            let problem = format!(
                "its camera is for a picture of {} × {} pixels, its matte has {} × {}",
                view.camera.size.x, view.camera.size.y, size.x, size.y
            );
            return Err(ModelError::View { view: i, problem });
        }
    }
    Ok(())
}

/// A grid of impossible voxels comes from a camera's scale: the error names it.
fn bad_scale(error: ModelError, views: &[View], voxel: f32) -> ModelError {
    let ModelError::Parameter(_) = error else { return error };
    let scale = |view: &usize| views[*view].camera.scale;
    let by_scale = |a: &usize, b: &usize| scale(a).total_cmp(&scale(b));
    let all = 0..views.len();
    let view = if voxel < 1.0 { all.min_by(by_scale) } else { all.max_by(by_scale) };
    let problem = format!("its camera's scale makes a tree of voxels of {voxel} m; check it");
    ModelError::View { view: view.unwrap_or(0), problem }
}

fn check_covered(coverages: &[Coverage]) -> Result<()> {
    match coverages.iter().position(|coverage| coverage.bounds().is_none()) {
        None => Ok(()),
        Some(view) => {
            let problem = "its matte shows no tree: no pixel is covered".into();
            Err(ModelError::View { view, problem })
        }
    }
}

/// What all views see.
struct Sight<'a> {
    cameras: Vec<(&'a Camera, Projector)>,
    coverages: Vec<Coverage>,
    params: &'a DensityParams,
}

impl Sight<'_> {
    /// Fills `alpha` with the least average of each voxel, NaN where no view shows it; returns weights.
    fn carve(&self, alpha: &mut Grid, control: &Control) -> Result<Vec<f32>> {
        let shape = Shape::of(alpha);
        let (nx, ny) = (shape.size.x as usize, shape.size.y as usize);
        let ellipses: Vec<Option<Ellipse>> = (0..ny)
            .map(|y| {
                let height = shape.corner.y + shape.voxel * (y as f32 + 0.5);
                ellipse(&self.cameras, &self.coverages, height, shape.voxel)
            })
            .collect();
        let mut weights = vec![0.0; alpha.values().len()];
        alpha
            .values_mut()
            .par_chunks_mut(nx)
            .zip(weights.par_chunks_mut(nx))
            .enumerate()
            .with_min_len(16)
            .try_for_each(|(line, (alpha, weights))| {
                control.check()?;
                for x in 0..nx {
                    let voxel = IVec3::new(x as i32, (line % ny) as i32, (line / ny) as i32);
                    let center = shape.center(voxel);
                    let round = ellipses[line % ny].as_ref().map_or(1.0, |ellipse| {
                        ellipse.weight(Vec2::new(center.x, center.z), shape.voxel)
                    });
                    weights[x] = 1.0 - self.params.rounding * (1.0 - round);
                    alpha[x] = (0..self.cameras.len())
                        .filter_map(|view| self.average(view, center, shape.voxel))
                        .fold(f32::NAN, f32::min);
                }
                Ok::<(), ModelError>(())
            })?;
        Ok(weights)
    }

    /// The average matte over a voxel in one view; `None` where the picture does not show it.
    fn average(&self, view: usize, center: glam::Vec3, voxel: f32) -> Option<f32> {
        let projector = &self.cameras[view].1;
        let at = projector.project(center)?;
        let half = 0.5 * voxel / projector.pixel_size(center);
        self.coverages[view].mean(at, Vec2::splat(half))
    }

    /// Throws away what is empty.
    fn collect(&self, mut alpha: Grid, weights: &[f32]) -> Result<Carved> {
        let threshold = self.params.threshold.max(f32::MIN_POSITIVE);
        let mut columns = vec![NO_COLUMN; weights.len()];
        let (mut voxels, mut kept_weights, mut n_unseen) = (Vec::new(), Vec::new(), 0);
        for (i, value) in alpha.values_mut().iter_mut().enumerate() {
            n_unseen += u64::from(value.is_nan());
            if *value >= threshold && weights[i] >= LEAST_WEIGHT {
                columns[i] = voxels.len() as u32;
                voxels.push(i as u32);
                kept_weights.push(weights[i]);
            } else {
                *value = 0.0;
            }
        }
        if voxels.is_empty() {
            return Err(self.culprit(&alpha));
        }
        Ok(Carved { alpha, voxels, weights: kept_weights, columns, n_unseen })
    }

    /// The view that throws away most of what all others keep.
    fn culprit(&self, grid: &Grid) -> ModelError {
        let n_views = self.cameras.len();
        let mut alone = vec![0_u64; n_views];
        let mut any = vec![0_u64; n_views];
        for i in 0..grid.values().len() {
            let center = grid.center(grid.voxel_of(i));
            let empty: Vec<usize> = (0..n_views)
                .filter(|&view| {
                    let average = self.average(view, center, grid.voxel());
                    average.is_some_and(|average| average < self.params.threshold)
                })
                .collect();
            for &view in &empty {
                any[view] += 1;
                alone[view] += u64::from(empty.len() == 1);
            }
        }
        let view = (0..n_views).max_by_key(|&view| (alone[view], any[view])).unwrap_or(0);
        let problem = if n_views == 1 {
            "its matte covers too little of every voxel: check the matte, raise \
             `density.resolution`, or lower `density.threshold`"
        } else {
            "nothing is left of the tree where it and the other views see one: \
             check its camera and matte, or lower `density.threshold`"
        };
        ModelError::View { view, problem: problem.into() }
    }
}
