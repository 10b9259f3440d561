//! Finer and rounder: Loop subdivision of a surface, with its creases kept.
//!
//! Loop, *Smooth Subdivision Surfaces Based on Triangles*, 1987; creases and corners as in Hoppe et
//! al., "Piecewise Smooth Surface Reconstruction", SIGGRAPH 1994; edges beside a crease as in Biermann,
//! Levin & Zorin, "Piecewise Smooth Subdivision Surfaces with Normal Control", SIGGRAPH 2000, which
//! Neubert 2012 (§5.3, Fig. 5.6) applies twice to closed bifurcations.
//!
//! 1. Copies at seams are welded: the rules see points ([`crate::topology`]).
//! 2. An edge is a *crease* where the surface was drawn with one: where the normals of its two triangles
//!    differ by more than [`SubdivideParams::crease`] at both of its ends, as on the rim between a
//!    trunk's wall and its bottom. Edges that are not shared by two triangles of like orientation are
//!    creases too. Tubes of three sides have sharp edges between their triangles but smooth normals, so
//!    they become round, as meant. Without split normals the whole surface is smooth.
//! 3. At each level every triangle becomes four. New points stand on edges: 3/8 of either end and 1/8
//!    of either opposite point; in the middle of a crease. Old points move: by Loop's weights when
//!    smooth, along the crease (1/8, 6/8, 1/8) with two creased edges; with more they are *corners* and
//!    stay. A point with one creased edge (a dart) is smooth.
//! 4. Edges that leave a crease point or dart weigh their ends by 3/4 − γ and γ = 1/2 − 1/4 cos θ,
//!    with θ = π/k in a sector of k triangles and 2π/k about a dart (Biermann et al., §3.3): without
//!    that the surface folds at crease points of uncommon valence. At corners the common weights.
//! 5. Columns are carried: texture coordinates and occlusion at the middle of each copy's own edge, so
//!    nothing is smeared over a seam; a new vertex belongs to the lower of its ends' branches.
//! 6. Normals are new: mean of the triangles' normals about a point, within creases, weighted as in
//!    Max, "Weights for Computing Vertex Normals from Facet Normals", JGT 4(2), 1999. Tangents
//!    are made orthogonal to them.
//!
//! Departures: Loop's surface lies inside convex shapes: tubes of three sides become half as thick.
//! Since a branch has a radius, the points are first moved outwards so far that the limit surface passes
//! through where they were ([`SubdivideParams::fit`]): what the limit misses is added, as often as
//! told (Jacobi's method; the largest error of a tube of three sides halves each time). In the end points
//! are put on the limit surface (Loop 1987; Hoppe et al. 1994).
//!
//! A closed surface stays closed, and its Euler characteristic stays the same.

mod level;
mod normals;
mod tags;

use crate::error::{MeshError, Result};
use crate::mesh::Surface;
use crate::topology::welded;
use tree_core::{Control, Resource, check_parameter};

/// Most levels: each is four times the triangles of the last.
const MAX_LEVELS: u32 = 8;
/// Most rounds of fitting: then nothing is left to gain in f32.
const ROUNDS_MAX: u32 = 20;

/// How a surface is subdivided.
///
/// ```
/// use tree_mesh::subdivide::SubdivideParams;
/// assert!(SubdivideParams { levels: 3, ..Default::default() }.validate().is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SubdivideParams {
    /// How often each triangle becomes four, 0 to 8. Default 2, as in Neubert's Fig. 5.6.
    pub levels: u32,
    /// Angle between normals in radians above which an edge is a crease, 0 to π. Default 1.
    pub crease: f32,
    /// Rounds in which the limit surface is brought to the old points, 0 (Loop's own, which shrinks) to
    /// 20. Default 1. More is for coarse meshes: where rings stand much closer than they are wide, as at
    /// the joints of a fine mesh, each round overshoots and the surface can fold. Fine meshes shrink
    /// little: 0 or 1 is enough.
    pub fit: u32,
}

impl Default for SubdivideParams {
    fn default() -> Self {
        Self { levels: 2, crease: 1.0, fit: 1 }
    }
}

impl SubdivideParams {
    /// Checks all numbers.
    ///
    /// # Errors
    /// [`MeshError::Parameter`].
    pub fn validate(&self) -> Result<()> {
        let found = f64::from(self.crease);
        // π as an f32 is a little more than π.
        let max = f64::from(std::f32::consts::PI);
        for (field, found, max) in
            [("levels", self.levels, MAX_LEVELS), ("fit", self.fit, ROUNDS_MAX)]
        {
            check_parameter(field, found, 0.0, max)?;
        }
        Ok(check_parameter("crease", found, 0.0, max)?)
    }
}

/// Subdivides a surface; see the [module](self).
///
/// # Errors
/// [`MeshError::Parameter`]; [`MeshError::Leaves`] for leaves; as [`welded`] for a surface that is not
/// valid; [`MeshError::Limit`] and [`MeshError::TooManyVertices`] before the memory is asked for,
/// [`MeshError::Cancelled`].
///
/// # Complexity
/// O(triangles of the result), about 150 bytes for each of them on the way.
pub fn subdivide(
    surface: &Surface,
    params: &SubdivideParams,
    control: &Control,
) -> Result<Surface> {
    params.validate()?;
    if !surface.anchors.is_empty() {
        return Err(MeshError::Leaves { found: surface.anchors.len() });
    }
    let points = welded(surface)?;
    let n_triangles = (surface.n_triangles() as u64).saturating_mul(4_u64.pow(params.levels));
    control.limits.check(Resource::Triangles, n_triangles)?;
    // Half-edges have 32-bit numbers.
    let (found, max) = (n_triangles.saturating_mul(3), u64::from(u32::MAX) - 1);
    if found > max {
        return Err(MeshError::TooManyVertices { surface: None, found, max });
    }
    if params.levels == 0 {
        return Ok(surface.clone());
    }
    let mut work = level::Work::new(surface, points, params.crease);
    work.fit(params.fit);
    for level in 0..params.levels {
        control.report("subdivide", level as f32 / params.levels as f32)?;
        work.refine(control)?;
    }
    let refined = work.finish();
    control.report("done", 1.0)?;
    Ok(refined)
}

#[cfg(test)]
mod tests;
