//! Looking through a density, and measuring one.

use super::super::camera::Camera;
use super::super::grid::Grid;
use super::super::matte::Matte;
use super::system::Shape;
use crate::error::{ModelError, Result};
use glam::Vec2;
use rayon::prelude::*;
use tree_core::{Control, Resource};

/// The matte that a camera sees of a density: 1 − e^(−∫ density) along the ray of each pixel.
///
/// # Errors
/// [`ModelError::Parameter`] for a bad camera, [`ModelError::Limit`] for too many pixels,
/// [`ModelError::Cancelled`].
///
/// # Complexity
/// O(pixels × voxels along a ray).
pub fn look_through(grid: &Grid, camera: &Camera, control: &Control) -> Result<Matte> {
    camera.validate("camera")?;
    let (width, height) = (camera.size.x as u32, camera.size.y as u32);
    let n = u64::from(width) * u64::from(height);
    control.limits.check(Resource::Pixels, n)?;
    let projector = camera.projector();
    let shape = Shape::of(grid);
    let from = if camera.eye().is_some() { 0.0 } else { f32::MIN };
    let mut alpha = vec![0.0; n as usize];
    alpha.par_chunks_mut(width as usize).enumerate().try_for_each(|(y, row)| {
        control.check()?;
        for (x, alpha) in row.iter_mut().enumerate() {
            let (on, along) = projector.ray(Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
            let mut depth = 0.0;
            shape.walk(on, along, from, |voxel, length| depth += length * grid.values()[voxel]);
            *alpha = 1.0 - libm::expf(-depth);
        }
        Ok::<(), ModelError>(())
    })?;
    Matte::new(width, height, alpha)
}

/// Volume of the voxels above `threshold` (per metre) in cubic metres. O(voxels).
#[must_use]
pub fn crown_volume(grid: &Grid, threshold: f32) -> f64 {
    let n = grid.values().iter().filter(|&&value| value > threshold).count();
    let voxel = f64::from(grid.voxel());
    n as f64 * voxel * voxel * voxel
}

/// How well the voxels above `threshold` agree with those of `other` above its `other_threshold`: shared
/// volume over the volume of both together, 0 to 1, seen at the centres of `grid`'s voxels and of
/// `other`'s outside `grid`. 0 when both are empty. O(voxels of both).
#[must_use]
pub fn overlap(grid: &Grid, threshold: f32, other: &Grid, other_threshold: f32) -> f64 {
    let cube = |grid: &Grid| f64::from(grid.voxel()) * f64::from(grid.voxel() * grid.voxel());
    let (mut shared, mut together) = (0.0, 0.0);
    for (i, &value) in grid.values().iter().enumerate() {
        let there = other.nearest(grid.center(grid.voxel_of(i))) > other_threshold;
        let here = value > threshold;
        shared += f64::from(u8::from(here && there)) * cube(grid);
        together += f64::from(u8::from(here || there)) * cube(grid);
    }
    for (i, &value) in other.values().iter().enumerate() {
        if value > other_threshold {
            let at = grid.voxel_at(other.center(other.voxel_of(i)));
            together += if grid.index(at).is_none() { cube(other) } else { 0.0 };
        }
    }
    if together > 0.0 { shared / together } else { 0.0 }
}
