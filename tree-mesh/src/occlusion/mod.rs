//! Ambient occlusion: how much of the light from all around arrives at a vertex.
//!
//! 1. A grid over the tree (`grid`) sums the area of triangles in each cell, leaves by their opacity:
//!    the share of light that a cell lets through. Area is spread over the eight nearest cells.
//! 2. For each of a number of directions, spread evenly over the sphere, one sweep over the grid
//!    carries light from cell to cell (`sweep`): leaves behind leaves get darker and darker, as in a
//!    real crown (Beer and Lambert's law, as in Monsi and Saeki 1953 for canopies).
//! 3. What arrives is kept for six directions of the normal, the ambient cube of Mitchell, McTaggart
//!    and Green 2006 ("Shading in Valve's Source engine"), so that a vertex costs the same however many
//!    directions there are. Wood looks along its normal from one cell above its bark; leaves, which
//!    take light from both sides, take the mean of all six.
//!
//! Cost: O(triangles + cells × directions + vertices) time; about 40 bytes a cell at once. Finer than a
//! cell (64 to the tree's longest side by default) nothing is told apart: shade under boughs and inside
//! the crown, but not the cracks of bark, which belong into the texture.
//!
//! The same bits for any number of threads: sweeps are independent, and summed in a fixed order.

mod grid;
mod sweep;

use crate::error::Result;
use crate::mesh::{Mesh, Surface};
use glam::Vec3;
use grid::Grid;
use rayon::prelude::*;
use sweep::Cube;
use tree_core::{Control, ParameterError, Resource};

/// How occlusion is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OcclusionParams {
    /// Cells along the longest side of the tree, 4 to 512. Default 64. Cost grows with its third power.
    pub cells: u32,
    /// Directions that light comes from, 6 to 1024. Default 48. Cost grows with it.
    pub directions: u32,
    /// Share of the light that a leaf keeps back, 0 to 1. Default 0.5: leaves let light pass, and their
    /// cards are not full.
    pub leaf_opacity: f32,
    /// Light from below the horizon as a share of that from above, 0.01 (dark ground) to 1. Default 0.5:
    /// what looks to the sky counts more than what looks to the ground.
    pub ground: f32,
}

impl Default for OcclusionParams {
    fn default() -> Self {
        Self { cells: 64, directions: 48, leaf_opacity: 0.5, ground: 0.5 }
    }
}

impl OcclusionParams {
    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`MeshError::Parameter`](crate::MeshError::Parameter), naming the first field at fault and its range.
    pub fn validate(&self) -> Result<()> {
        for (field, found, min, max) in [
            ("cells", f64::from(self.cells), 4.0, 512.0),
            ("directions", f64::from(self.directions), 6.0, 1024.0),
            ("leaf_opacity", f64::from(self.leaf_opacity), 0.0, 1.0),
            ("ground", f64::from(self.ground), 0.01, 1.0),
        ] {
            let slack = f64::from(f32::EPSILON);
            if !(min * (1.0 - slack)..=max).contains(&found) {
                return Err(ParameterError { field: field.into(), found, min, max }.into());
            }
        }
        Ok(())
    }
}

/// Fills [`Surface::occlusion`] of every surface: 1 where all light arrives, 0 where none does.
///
/// Copies of a vertex get the same value. A mesh without extent, larger than 10¹² m,
/// or so far from the origin that its coordinates do not tell cells apart, gets 1 everywhere.
///
/// # Errors
/// [`MeshError::Parameter`](crate::MeshError::Parameter); [`MeshError::Limit`](crate::MeshError::Limit) for the cells, before they are allocated; what
/// [`Mesh::check`] finds; [`MeshError::Cancelled`](crate::MeshError::Cancelled). The mesh is unchanged then.
pub fn bake(mesh: &mut Mesh, params: &OcclusionParams, control: &Control) -> Result<()> {
    params.validate()?;
    mesh.check()?;
    control.report("occlusion", 0.0)?;
    let Some(mut grid) = Grid::over(mesh.bounds(), params.cells) else {
        for surface in &mut mesh.surfaces {
            surface.occlusion = vec![1.0; surface.positions.len()];
        }
        return Ok(());
    };
    control.limits.check(Resource::Voxels, grid.n_cells() as u64)?;
    grid.allocate();
    for surface in &mesh.surfaces {
        // A ray through closed wood meets it twice; leaves are met once.
        let opacity = if is_leaves(surface) { params.leaf_opacity } else { 1.0 };
        grid.add(surface, opacity, control)?;
    }
    grid.finish();
    let cubes = sweep::light(&grid, params, control)?;
    control.report("vertices", 0.8)?;
    let columns: Vec<Vec<f32>> = mesh
        .surfaces
        .iter()
        .map(|surface| {
            control.check()?;
            Ok(look_up(surface, &grid, &cubes))
        })
        .collect::<Result<_>>()?;
    for (surface, occlusion) in mesh.surfaces.iter_mut().zip(columns) {
        surface.occlusion = occlusion;
    }
    Ok(control.report("done", 1.0)?)
}

fn is_leaves(surface: &Surface) -> bool {
    !surface.anchors.is_empty()
}

fn look_up(surface: &Surface, grid: &Grid, cubes: &[Cube]) -> Vec<f32> {
    let leaves = is_leaves(surface);
    let mut light: Vec<f32> = surface
        .positions
        .par_iter()
        .zip(&surface.normals)
        .map(|(&position, &normal)| {
            if leaves {
                let cube = grid.between(cubes, position);
                cube.0.iter().sum::<f32>() / 6.0
            } else {
                grid.between(cubes, position + normal * grid.side()).along(normal)
            }
            .clamp(0.0, 1.0)
        })
        .collect();
    for (vertex, &first) in surface.welds.iter().enumerate() {
        if let Some(&shared) = light.get(first as usize) {
            light[vertex] = shared;
        }
    }
    light
}

/// Directions spread evenly over the sphere: a spiral of golden angles (Vogel 1979), equal solid angle
/// each.
fn directions(count: u32) -> Vec<Vec3> {
    const GOLDEN_ANGLE: f32 = 2.399_963_2;
    (0..count)
        .map(|i| {
            let y = 1.0 - 2.0 * (i as f32 + 0.5) / count as f32;
            let (sin, cos) = libm::sincosf(i as f32 * GOLDEN_ANGLE);
            let across = (1.0 - y * y).max(0.0).sqrt();
            Vec3::new(across * cos, y, across * sin)
        })
        .collect()
}

#[cfg(test)]
mod tests;
