//! A mesh of which every level is a prefix of its index buffers.

use super::grow::position;
use super::model::Multires;
use super::tube::Line;
use crate::error::{LodError, Result, check_range};
use crate::prune::vertices::compact;
use rayon::prelude::*;
use tree_core::{Control, Resource};
use tree_mesh::wind::{Branch, branches_of_lines};
use tree_mesh::{Look, Mesh, MeshParams, Surface, build_leaves};

/// Most paths whose numbers a shader tells apart.
const PATHS_MAX: f64 = 16_777_216.0;
/// Paths that are drawn between questions for cancellation.
const PATHS_A_CHECK: usize = 1024;

/// Tubes and leaves in the order of the paths: the mesh of a level is a prefix of each index buffer.
///
/// Each path is a tube of its own, as coarse as [`MeshParams::error`] allows. Branches begin inside the wood
/// that bears them, where they are open. Where trees are seen from near, [`tree_mesh::build`] makes one closed
/// skin of them.
#[derive(Clone, Debug, PartialEq)]
pub struct MultiMesh {
    mesh: Mesh,
    /// For each surface, for each number of levels from 0: indices.
    ends: Vec<Vec<u32>>,
    branches: Vec<Vec<[f32; 4]>>,
}

/// A prefix of a surface's index buffer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Draw {
    /// Number of the surface.
    pub surface: u32,
    /// Number of indices, from the first on; may be 0.
    pub index_count: u32,
}

impl MultiMesh {
    /// Draws a tree. Of the parameters, those of curves, strips, flares, tangents and light maps are not used: a
    /// tube has rings at nodes, those left out that lie within the error of it.
    ///
    /// # Errors
    /// As [`tree_mesh::build`]; [`LodError::Parameter`] for more than 2²⁴ levels.
    ///
    /// # Complexity
    /// O(nodes + leaves + vertices), leaves in parallel.
    pub fn new(
        multires: &Multires,
        look: &Look,
        params: &MeshParams,
        control: &Control,
    ) -> Result<Self> {
        params.validate().map_err(LodError::from)?;
        check_range("levels", multires.n_levels() as f64, 1.0, PATHS_MAX)?;
        let plain = MeshParams { tangents: false, lightmap: false, ..*params };
        let mut mesh = build_leaves(multires.tree(), look, &plain, &control.part(0.0, 0.5))?;
        mesh.branches = wind(multires);
        let leaves = mesh.surfaces.iter().skip(1).map(Surface::n_triangles).sum::<usize>();
        let (wood, ends, branches) = wood(multires, params, leaves, &control.part(0.5, 0.9))?;
        let mut this = Self { mesh, ends: vec![ends], branches: vec![branches] };
        match this.mesh.surfaces.first_mut() {
            Some(first) => *first = Surface { material: first.material, ..wood },
            None => return Err(LodError::Foliage("the mesh has no surfaces")),
        }
        for kind in 0..multires.tree().species().leaf_kinds.len() {
            this.leaves(multires, kind)?;
        }
        for (surface, branches) in this.mesh.surfaces.iter_mut().zip(&this.branches) {
            surface.branches = branches.iter().map(|&[.., path]| path as u32).collect();
        }
        control.report("done", 1.0)?;
        Ok(this)
    }

    /// All levels. Surface 0 is the wood, the others are leaves, one for each kind. Each path is a branch that moves
    /// in the [wind](tree_mesh::wind); a shader lets it grow first, then bends it.
    #[must_use]
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Number of levels.
    #[must_use]
    pub fn n_levels(&self) -> usize {
        self.ends.first().map_or(0, Vec::len).saturating_sub(1)
    }

    /// For each surface, for each vertex: the fork that its path stems from, in metres, and the number of the
    /// path from 0. What shaders need to let branches grow in ([`grow`](super::grow)).
    #[must_use]
    pub fn branches(&self) -> &[Vec<[f32; 4]>] {
        &self.branches
    }

    /// The prefix of each surface that is drawn at a fractional level, clamped to 1 and all: writes to `out`,
    /// in the order of the surfaces, and tells how many triangles that is.
    ///
    /// # Errors
    /// [`LodError::Length`] when `out` does not have a row for each surface; [`LodError::Parameter`] for NaN.
    ///
    /// # Complexity
    /// O(surfaces), nothing is allocated.
    pub fn draws(&self, level: f32, out: &mut [Draw]) -> Result<u64> {
        let (found, expected) = (out.len(), self.ends.len());
        if found != expected {
            return Err(LodError::Length { what: "draws", found, expected });
        }
        let whole = self.whole(level)?;
        let mut n_indices = 0;
        for (surface, (draw, ends)) in out.iter_mut().zip(&self.ends).enumerate() {
            let index_count = ends.get(whole).copied().unwrap_or_default();
            *draw = Draw { surface: surface as u32, index_count };
            n_indices += u64::from(index_count);
        }
        Ok(n_indices / 3)
    }

    /// Indices of the wood at a fractional level, clamped to 1 and all; all for NaN.
    ///
    /// # Complexity
    /// O(1).
    #[must_use]
    pub fn wood_indices(&self, level: f32) -> u32 {
        let whole = self.whole(level).unwrap_or(self.n_levels());
        self.ends.first().and_then(|ends| ends.get(whole)).copied().unwrap_or_default()
    }

    /// The greatest whole level with at most so many triangles of wood; at least 1.
    ///
    /// # Complexity
    /// O(log levels).
    #[must_use]
    pub fn level_of_wood(&self, n_triangles: u64) -> usize {
        let ends = self.ends.first().map_or(&[][..], |ends| ends);
        ends.partition_point(|&end| u64::from(end / 3) <= n_triangles).saturating_sub(1).max(1)
    }

    /// A fractional level as a plain mesh, what is not drawn left out.
    ///
    /// # Errors
    /// [`LodError::Parameter`] for NaN.
    ///
    /// # Complexity
    /// O(vertices + triangles), in parallel over surfaces.
    pub fn mesh_at(&self, level: f32) -> Result<Mesh> {
        let whole = self.whole(level)?;
        let level = level.clamp(1.0, self.n_levels() as f32);
        let mut mesh = self.mesh.clone();
        let rows = mesh.surfaces.par_iter_mut().zip(&self.ends).zip(&self.branches);
        rows.for_each(|((surface, ends), branches)| {
            surface.indices.truncate(ends.get(whole).copied().unwrap_or_default() as usize);
            for (p, &branch) in surface.positions.iter_mut().zip(branches) {
                *p = position(*p, branch, level);
            }
            if let Some(size) = surface.vertices_per_leaf().filter(|&size| size > 0) {
                let leaves = surface.anchors.iter_mut().zip(branches.iter().step_by(size));
                leaves.for_each(|(p, &branch)| *p = position(*p, branch, level));
            }
            let mut kept = vec![false; surface.positions.len()];
            surface.indices.iter().for_each(|&index| kept[index as usize] = true);
            compact(surface, &kept);
        });
        Ok(mesh)
    }

    /// How many levels are drawn, whole or in part.
    fn whole(&self, level: f32) -> Result<usize> {
        let n = self.n_levels();
        if level.is_nan() {
            check_range("level", level.into(), 1.0, n as f64)?;
        }
        Ok((level.ceil() as usize).clamp(1, n.max(1)))
    }

    /// Counts the indices of a kind of leaves level by level, and names the paths of its vertices.
    fn leaves(&mut self, multires: &Multires, kind: usize) -> Result<()> {
        let foliage = multires.tree().foliage();
        let drawn =
            |leaf: usize| usize::from(foliage.kinds()[leaf]) == kind && foliage.sizes()[leaf] > 0.0;
        let n = (0..foliage.len()).filter(|&leaf| drawn(leaf)).count();
        let Some(surface) = self.mesh.surfaces.get(kind + 1) else {
            return Err(LodError::Foliage("a kind of leaves has no surface"));
        };
        let per_leaf = |count: usize| count.checked_div(n).unwrap_or(0);
        let (n_vertices, n_indices) =
            (per_leaf(surface.positions.len()), per_leaf(surface.indices.len()));
        if n_vertices * n != surface.positions.len() || n_indices * n != surface.indices.len() {
            return Err(LodError::Foliage("leaves of one kind differ in their triangles"));
        }
        let (mut ends, mut branches) = (vec![0], Vec::with_capacity(surface.positions.len()));
        let mut count = 0;
        let mut first = 0;
        for path in 0..multires.n_levels() {
            let end = multires.counts(path + 1).1;
            let here = (first..end).filter(|&leaf| drawn(leaf)).count();
            let branch = branch(multires, path);
            branches.extend(std::iter::repeat_n(branch, here * n_vertices));
            count += here * n_indices;
            ends.push(count as u32);
            first = end;
        }
        self.ends.push(ends);
        self.branches.push(branches);
        Ok(())
    }
}

/// Where a path stems from, and its number.
fn branch(multires: &Multires, path: usize) -> [f32; 4] {
    let skeleton = multires.tree().skeleton();
    let first = if path == 0 { 0 } else { multires.counts(path).0 };
    let fork = skeleton.parent(first as u32).unwrap_or(0);
    skeleton.positions()[fork as usize].extend(path as f32).to_array()
}

/// Each path as the wind sees it: nodes are sorted, so those of a path follow one another.
fn wind(multires: &Multires) -> Vec<Branch> {
    let nodes: Vec<u32> = (0..multires.tree().skeleton().len() as u32).collect();
    let line = |path: usize| {
        let first = if path == 0 { 0 } else { multires.counts(path).0 };
        nodes.get(first..multires.counts(path + 1).0).unwrap_or_default()
    };
    branches_of_lines(multires.tree().skeleton(), (0..multires.n_levels()).map(line))
}

type Wood = (Surface, Vec<u32>, Vec<[f32; 4]>);

fn wood(
    multires: &Multires,
    params: &MeshParams,
    n_leaf_triangles: usize,
    control: &Control,
) -> Result<Wood> {
    let n = multires.n_levels();
    let (mut n_vertices, mut n_triangles) = (0, 0);
    for path in 0..n {
        if path.is_multiple_of(PATHS_A_CHECK) {
            control.report("wood", 0.3 * path as f32 / n as f32)?;
        }
        let (vertices, triangles) = Line::of_path(multires, path, params).size();
        n_vertices += vertices;
        n_triangles += triangles;
    }
    control.limits.check(Resource::Triangles, n_triangles + n_leaf_triangles as u64)?;
    check_range("vertices of the wood", n_vertices as f64, 0.0, f64::from(u32::MAX / 8))?;
    let mut surface = Surface::default();
    surface.positions.reserve_exact(n_vertices as usize);
    surface.indices.reserve_exact(3 * n_triangles as usize);
    let (mut ends, mut branches) = (vec![0], Vec::with_capacity(n_vertices as usize));
    for path in 0..n {
        if path.is_multiple_of(PATHS_A_CHECK) {
            control.report("wood", 0.3 + 0.7 * path as f32 / n as f32)?;
        }
        Line::of_path(multires, path, params).draw(params, &mut surface);
        branches.resize(surface.positions.len(), branch(multires, path));
        ends.push(surface.indices.len() as u32);
    }
    Ok((surface, ends, branches))
}
