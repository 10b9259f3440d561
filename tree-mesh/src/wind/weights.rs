//! What each vertex does in the wind, as numbers from 0 to 1.

use super::{Branch, phase};
use crate::error::{MeshError, Result};
use crate::mesh::{Mesh, Surface};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// A vertex in the wind. All but the anchor lie within 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct VertexWind {
    /// The branch it moves with, in [`Mesh::branches`]; 0 when the mesh has none.
    pub branch: u32,
    /// How far along the branch it lies; leaves as far as the place they are attached.
    pub reach: f32,
    /// Leaves: how far from the anchor, 0 there and 1 at the leaf's farthest vertex. 0 for wood.
    pub flutter: f32,
    /// Leaves: where in its flutter the leaf starts. 0 for wood.
    pub leaf_phase: f32,
    /// Leaves: where the leaf is attached. Wood: the vertex itself.
    pub anchor: Vec3,
}

/// Share of its branch's turn that a point at this reach makes: 0 at the collar, 1 at the tip.
///
/// A beam clamped at one end, under an even load, is deflected by t² (6 − 4t + t²) / 3 of the
/// deflection at its tip (Gere, Timoshenko: Mechanics of Materials, appendix G). A turn by this share
/// about the pivot moves a point by reach times the share, so the share has one t less.
#[must_use]
pub fn sway(reach: f32) -> f32 {
    let t = reach.clamp(0.0, 1.0);
    t * (6.0 - 4.0 * t + t * t) / 3.0
}

/// Where in its flutter a leaf starts, 0 to 1, by its number in the surface.
#[must_use]
pub fn leaf_phase(leaf: u32) -> f32 {
    phase(leaf)
}

/// Every vertex of a surface in the wind.
///
/// # Errors
/// [`MeshError::Length`] or [`MeshError::Dangling`] when the columns do not fit (as [`Mesh::check`]).
///
/// # Complexity
/// One pass over the vertices.
pub fn vertices(mesh: &Mesh, number: usize) -> Result<Vec<VertexWind>> {
    let surface = mesh.surface(number)?;
    check(surface, number, mesh.branches.len())?;
    let size = surface.vertices_per_leaf().filter(|&size| size > 0);
    let branch_of = |vertex: usize| surface.branches.get(vertex).copied().unwrap_or(0);
    let reach = |branch: u32, at: Vec3| {
        mesh.branches.get(branch as usize).map_or(0.0, |branch: &Branch| branch.reach(at))
    };
    let Some(size) = size else {
        return Ok(surface
            .positions
            .iter()
            .enumerate()
            .map(|(vertex, &anchor)| {
                let branch = branch_of(vertex);
                let reach = reach(branch, anchor);
                VertexWind { branch, reach, anchor, ..VertexWind::default() }
            })
            .collect());
    };
    let mut all = Vec::with_capacity(surface.positions.len());
    for (leaf, (corners, &anchor)) in
        surface.positions.chunks_exact(size).zip(&surface.anchors).enumerate()
    {
        let far = corners.iter().fold(0.0_f32, |far, p| far.max(p.distance(anchor)));
        let leaf_phase = leaf_phase(leaf as u32);
        for &corner in corners {
            let branch = branch_of(all.len());
            let flutter = if far > 0.0 { (corner.distance(anchor) / far).min(1.0) } else { 0.0 };
            let reach = reach(branch, anchor);
            all.push(VertexWind { branch, reach, flutter, leaf_phase, anchor });
        }
    }
    Ok(all)
}

fn check(surface: &Surface, number: usize, n_branches: usize) -> Result<()> {
    let expected = surface.positions.len();
    let found = surface.branches.len();
    if found != expected && found != 0 {
        return Err(MeshError::Length {
            surface: Some(number),
            field: "branches",
            found,
            expected,
        });
    }
    if expected.checked_rem(surface.anchors.len()).is_some_and(|rest| rest != 0) {
        let found = surface.anchors.len();
        return Err(MeshError::Length { surface: Some(number), field: "anchors", found, expected });
    }
    match surface.branches.iter().find(|&&branch| branch as usize >= n_branches) {
        Some(&found) => Err(MeshError::Dangling {
            surface: Some(number),
            what: "branch",
            found,
            count: n_branches,
        }),
        None => Ok(()),
    }
}
