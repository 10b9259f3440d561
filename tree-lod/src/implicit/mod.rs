//! A smooth hull around foliage: metaballs and their iso-surface.
//!
//! Source: Neubert 2012, §7.3.1, after Blinn 1982, "A Generalization of Algebraic Surface Drawing".
//!
//! 1. `field`: every element's centre is a ball that adds (1 − (distance / radius)²)² to the field.
//! 2. `grid`: the field at the nodes of a grid.
//! 3. `tetra`: the surface where the field has a small value, by marching tetrahedra.
//! 4. `hull`: the surface, with points evenly on it, and normals at the nearest point (`nearest`).
//!
//! Departures: Neubert takes marching cubes and the iso-value 0. There is no surface at exactly 0, for
//! the field is 0 everywhere outside; see [`HullParams::iso`]. Marching cubes and surface nets leave
//! holes or edges of four triangles in ambiguous cells; tetrahedra have no such cells, so the surface is
//! always a closed 2-manifold, of more triangles. Walls of hollows within the plant are left out: they
//! would count as hull in [`Hull::sample`], but are never seen.
//!
//! ```
//! use tree_lod::glam::Vec3;
//! use tree_lod::implicit::{Metaballs, HullParams, surface};
//! let field = Metaballs::new(&[Vec3::ZERO, 0.5 * Vec3::X], 1.0)?;
//! let hull = surface(&field, &HullParams::default(), &tree_core::Control::default())?;
//! assert!(hull.nearest_normal(3.0 * Vec3::X).dot(Vec3::X) > 0.99);
//! # Ok::<(), tree_lod::LodError>(())
//! ```

mod field;
mod grid;
mod hull;
mod nearest;
mod tetra;

#[cfg(test)]
mod tests;

pub(crate) use field::check_columns;
pub use field::{Metaballs, plant_height};
pub use hull::{Hull, Sample};

use crate::error::{Result, check_range};
use grid::Grid;
use tree_core::{Control, Resource};

/// Which surface of a field, and how finely.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HullParams {
    /// Value of the field on the surface, 0.001 to 0.5. Default 0.05: a lone element gets a ball of
    /// 0.88 times the radius of influence. Towards 0 the ball grows to the whole radius, but the slope
    /// of the field vanishes there, and normals with it.
    pub iso: f32,
    /// Cells of the grid along the radius of influence, 2 to 16. Default 3: finer grids show no more
    /// than the field has. Cost grows with the cube.
    pub detail: f32,
}

impl Default for HullParams {
    fn default() -> Self {
        Self { iso: 0.05, detail: 3.0 }
    }
}

impl HullParams {
    /// Checks all numbers.
    ///
    /// # Errors
    /// [`LodError::Parameter`](crate::LodError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("hull.iso", self.iso.into(), 0.001, 0.5)?;
        check_range("hull.detail", self.detail.into(), 2.0, 16.0)
    }
}

/// The surface on which the field has the value [`HullParams::iso`]: closed, a 2-manifold, facing
/// outwards, around every point of the field; in several pieces where points are far apart.
///
/// # Errors
/// [`LodError::Parameter`](crate::LodError::Parameter);
/// [`LodError::Foliage`](crate::LodError::Foliage) when the points stand so far from the origin that
/// numbers of 32 bits do not resolve the grid; [`LodError::Limit`](crate::LodError::Limit) over the
/// limit of voxels or triangles; [`LodError::Cancelled`](crate::LodError::Cancelled).
///
/// # Complexity
/// O(points · detail³ + voxels + vertices · points within the radius), in parallel over layers of the
/// grid; four bytes a voxel. The same bits for any number of threads.
pub fn surface(field: &Metaballs, params: &HullParams, control: &Control) -> Result<Hull> {
    params.validate()?;
    control.report("field", 0.0)?;
    let grid = Grid::new(field, params.detail, control)?;
    control.report("surface", 0.4)?;
    let mut vertices = tetra::vertices(field, &grid, params.iso, control)?;
    // A closed surface has two triangles a vertex, but for its handles.
    control.limits.check(Resource::Triangles, 2 * vertices.keys.len() as u64)?;
    control.report("surface", 0.8)?;
    let mut triangles = tetra::triangles(&grid, params.iso, &vertices.keys, control)?;
    tetra::without_hollows(&mut vertices, &mut triangles);
    control.report("tree of boxes", 0.9)?;
    Ok(Hull::new(vertices.positions, vertices.normals, triangles))
}
