//! From a tree to a mesh: counts first, then memory, then triangles.
//!
//! 1. Parameters, look and extent are checked.
//! 2. The bark is planned ring by ring ([`crate::bark`]), leaves are counted ([`crate::leaf`]), and the
//!    sum is held against the limits, before any of it is allocated.
//! 3. Columns of their final length are cut into parts that threads fill. Where a part lies and what
//!    is in it depends on the tree alone, so the bytes are the same for any number of threads.
//!
//! Cost: O(nodes + leaves + vertices) time; the mesh, about 60 bytes a node, 80 a
//! ring, 250 an axis and 4 a leaf of memory.

use crate::bark::{self, Kind, Plan};
use crate::error::{MeshError, Result};
use crate::leaf::Leaves;
use crate::look::Look;
use crate::mesh::{Material, Mesh, Surface};
use crate::params::MeshParams;
use crate::wind;
use bytemuck::allocation::zeroed_vec;
use glam::Vec3;
use tree_core::{Control, Resource, Tree};

/// Largest coordinate, radius and leaf in metres. At this distance f32 steps are 6 cm; nothing
/// overflows far beyond.
const EXTENT_MAX: f32 = 1e6;
/// Most vertices in a surface; the last index is kept for engines that restart strips with it.
const MAX_VERTICES: u64 = u32::MAX as u64 - 1;
/// A mesh and what became of the tree on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Built {
    /// Surface 0 is the bark, surface 1 + k the leaves of kind k; those without triangles are there
    /// too. Materials are in the same order.
    pub mesh: Mesh,
    /// Counts.
    pub report: MeshReport,
}

/// What a mesh was made of and what was left out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct MeshReport {
    /// Vertices of all surfaces.
    pub n_vertices: usize,
    /// Triangles of all surfaces.
    pub n_triangles: usize,
    /// Vertices and triangles of each surface.
    pub surfaces: Vec<(usize, usize)>,
    /// Tubes drawn.
    pub n_tubes: usize,
    /// Axes of which so little comes out of the parent's wood that they are drawn as a point.
    pub n_stubs: usize,
    /// Axes not drawn because all their nodes lie at one place, or inside the parent's wood. What
    /// they carry is drawn on the axis below.
    pub n_skipped_axes: usize,
    /// Laterals whose base was turned or moved because another one has its place.
    pub n_moved_axes: usize,
    /// Nodes passed over because they lie within a tenth of a radius of the one before, or back inside
    /// the wood.
    pub n_skipped_nodes: usize,
    /// Leaves of size 0, not drawn.
    pub n_skipped_leaves: usize,
    /// Leaf kinds whose picture could not be outlined as their look asks (it has no mask, or nothing
    /// of it is visible): drawn as cards.
    pub leaf_fallbacks: Vec<u32>,
}

/// Builds bark tubes and leaf cards.
///
/// # Errors
/// [`MeshError::Parameter`], [`MeshError::LeafMaterials`], [`MeshError::TooLarge`] (coordinates beyond
/// 1000 km), [`MeshError::Limit`] and [`MeshError::TooManyVertices`], both before the memory of the mesh
/// is asked for, or [`MeshError::Cancelled`].
///
/// # Complexity
/// O(nodes + leaves + vertices); parallel over axes and leaves. A single axis is not divided.
pub fn build(tree: &Tree, look: &Look, params: &MeshParams, control: &Control) -> Result<Built> {
    Ok(build_numbered(tree, look, params, control)?.0)
}

/// Builds the leaves alone, for those who draw the wood themselves: the mesh of [`build`], where surface 0 is empty and vertices
/// have no wind.
///
/// # Errors
/// As [`build`]; limits count what is built.
///
/// # Complexity
/// O(nodes + leaves · vertices of one), parallel over leaves.
pub fn build_leaves(
    tree: &Tree,
    look: &Look,
    params: &MeshParams,
    control: &Control,
) -> Result<Mesh> {
    params.validate()?;
    look.check(tree.species())?;
    check_extent(tree)?;
    control.report("leaves", 0.0)?;
    let axes = tree.skeleton().axes(params.continuation);
    let leaves = Leaves::new(tree, look, params)?;
    control.limits.check(Resource::Triangles, count_leaves(&leaves)?)?;
    let mut surfaces = vec![Surface::default()];
    leaves.fill(tree, &axes, params, control, &mut surfaces)?;
    for surface in &mut surfaces {
        surface.branches = Vec::new();
    }
    control.report("done", 1.0)?;
    Ok(Mesh { surfaces, materials: materials(&leaves, look), branches: Vec::new() })
}

/// As [`build`]; with it the branch of each axis.
pub(crate) fn build_numbered(
    tree: &Tree,
    look: &Look,
    params: &MeshParams,
    control: &Control,
) -> Result<(Built, Vec<u32>)> {
    params.validate()?;
    look.check(tree.species())?;
    check_extent(tree)?;
    control.report("plan", 0.0)?;
    let skeleton = tree.skeleton();
    let axes = skeleton.axes(params.continuation);
    let plan = Plan::new(skeleton, &axes, params, control)?;
    let leaves = Leaves::new(tree, look, params)?;

    check_vertices(0, plan.n_vertices)?;
    let triangles = plan.n_triangles.saturating_add(count_leaves(&leaves)?);
    control.limits.check(Resource::Triangles, triangles)?;

    control.report("bark", 0.1)?;
    let mut bark = new_surface(plan.n_vertices as usize, 3 * plan.n_triangles as usize, 0);
    if params.tangents {
        bark.tangents = zeroed_vec(bark.positions.len());
    }
    if params.lightmap {
        bark.uvs2 = zeroed_vec(bark.positions.len());
    }
    bark.branches = zeroed_vec(bark.positions.len());
    bark.welds = zeroed_vec(bark.positions.len());
    bark::fill(&plan, params, &mut bark, control)?;
    let mut surfaces = vec![bark];
    control.report("leaves", 0.5)?;
    leaves.fill(tree, &axes, params, control, &mut surfaces)?;
    control.report("wind", 0.95)?;
    let mut branches = wind::branches(skeleton, &axes);
    let branch_of = wind::stand(&mut branches, &mut surfaces, &plan);
    control.report("done", 1.0)?;
    let mesh = Mesh { surfaces, materials: materials(&leaves, look), branches };
    let count_kind = |kind| plan.axes.iter().filter(|axis| axis.kind == kind).count();
    let report = MeshReport {
        n_vertices: mesh.n_vertices(),
        n_triangles: mesh.n_triangles(),
        surfaces: mesh
            .surfaces
            .iter()
            .map(|surface| (surface.positions.len(), surface.n_triangles()))
            .collect(),
        n_tubes: count_kind(Kind::Trunk) + count_kind(Kind::Lateral),
        n_stubs: count_kind(Kind::Stub),
        n_skipped_axes: count_kind(Kind::Skipped),
        n_moved_axes: plan.n_moved as usize,
        n_skipped_nodes: plan.curves.n_dropped as usize,
        n_skipped_leaves: tree.foliage().len() - leaves.len(),
        leaf_fallbacks: leaves.fallbacks(),
    };
    Ok((Built { mesh, report }, branch_of))
}

/// Triangles of all leaves; each surface is held against the most vertices there can be.
fn count_leaves(leaves: &Leaves) -> Result<u64> {
    leaves.sizes().enumerate().try_fold(0_u64, |sum, (kind, (n_vertices, n_triangles))| {
        check_vertices(kind + 1, n_vertices)?;
        Ok(sum.saturating_add(n_triangles))
    })
}

fn materials(leaves: &Leaves, look: &Look) -> Vec<Material> {
    std::iter::once(look.bark.clone()).chain(leaves.materials(look)).collect()
}

fn check_extent(tree: &Tree) -> Result<()> {
    let (skeleton, foliage) = (tree.skeleton(), tree.foliage());
    let check = |what, index, found: f32| {
        if found <= EXTENT_MAX {
            return Ok(());
        }
        Err(MeshError::TooLarge { what, index, found, max: EXTENT_MAX })
    };
    let all = |what, values: &mut dyn Iterator<Item = f32>| {
        values.enumerate().try_for_each(|(index, found)| check(what, index, found))
    };
    let reach = |p: &Vec3| p.abs().max_element();
    all("positions", &mut skeleton.positions().iter().map(reach))?;
    all("radii", &mut skeleton.radii().iter().copied())?;
    all("foliage positions", &mut foliage.positions().iter().map(reach))?;
    all("foliage sizes", &mut foliage.sizes().iter().copied())
}

fn check_vertices(surface: usize, found: u64) -> Result<()> {
    if found <= MAX_VERTICES {
        return Ok(());
    }
    Err(MeshError::TooManyVertices { surface: Some(surface), found, max: MAX_VERTICES })
}

/// A surface of zeros. The system hands out such pages lazily, so each is first touched by the thread
/// that fills it; writing zeros here cost a fifth more time with two threads.
fn new_surface(n_vertices: usize, n_indices: usize, material: usize) -> Surface {
    Surface {
        positions: zeroed_vec(n_vertices),
        normals: zeroed_vec(n_vertices),
        uvs: zeroed_vec(n_vertices),
        indices: zeroed_vec(n_indices),
        material: material as u32,
        ..Default::default()
    }
}

#[cfg(test)]
#[path = "build_tests.rs"]
mod tests;
