//! From a tree to a mesh.

use super::{mesh_params, tree_mesh, tree_mesh_params};
use crate::border::{Versioned, call, foresee, get, get_opt, out, tree_status, view};
use crate::control::{run, tree_control};
use crate::look::{or_built_in, tree_look};
use crate::tree::tree_tree;
use ::tree_mesh::{Built, MeshReport};

/// What a mesh was made of and what was left out.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_mesh_report {
    /// `sizeof(tree_mesh_report)`.
    pub struct_size: usize,
    /// Vertices of all surfaces.
    pub n_vertices: u64,
    /// Triangles of all surfaces.
    pub n_triangles: u64,
    /// Tubes drawn.
    pub n_tubes: u64,
    /// Axes of which so little comes out of the parent's wood that they are drawn as a point.
    pub n_stubs: u64,
    /// Axes not drawn because all their nodes lie at one place, or inside the parent's wood. What they
    /// carry is drawn on the axis below.
    pub n_skipped_axes: u64,
    /// Laterals whose base was turned or moved because another one has its place.
    pub n_moved_axes: u64,
    /// Nodes passed over because they lie within a tenth of a radius of the one before, or back inside
    /// the wood.
    pub n_skipped_nodes: u64,
    /// Leaves of size 0, not drawn.
    pub n_skipped_leaves: u64,
    /// Number of leaf kinds whose picture could not be outlined as their look asks (it has no mask, or
    /// nothing of it is visible): drawn as cards.
    pub n_leaf_fallbacks: u64,
    /// Those leaf kinds, or NULL for none. Part of the mesh: valid until it is freed.
    pub leaf_fallbacks: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_mesh_report {
    const NAME: &'static str = "tree_mesh_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&MeshReport::default())
    }
}

impl tree_mesh_report {
    /// Without the list of leaf kinds, which a mesh has to hold.
    fn of(report: &MeshReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_vertices: report.n_vertices as u64,
            n_triangles: report.n_triangles as u64,
            n_tubes: report.n_tubes as u64,
            n_stubs: report.n_stubs as u64,
            n_skipped_axes: report.n_skipped_axes as u64,
            n_moved_axes: report.n_moved_axes as u64,
            n_skipped_nodes: report.n_skipped_nodes as u64,
            n_skipped_leaves: report.n_skipped_leaves as u64,
            n_leaf_fallbacks: report.leaf_fallbacks.len() as u64,
            leaf_fallbacks: std::ptr::null(),
        }
    }
}

/// Builds bark and leaves of a tree: surface 0 is the bark, surface 1 + k the leaves of kind k; those
/// without triangles are there too. Materials are in the same order.
///
/// `look` may be NULL: the built-in textures that the tree's species names, as `tree_look_of_tree` gives
/// them; to build many meshes, make a look once. `params` may be NULL. `report` may be NULL. Free the mesh
/// with `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_build(
    tree: *const tree_tree,
    look: *const tree_look,
    params: *const tree_mesh_params,
    control: *const tree_control,
    report: *mut tree_mesh_report,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        unsafe { foresee(report, "report") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let params = unsafe { mesh_params(params) }?;
        let look = unsafe { get_opt(look, "look") }?.map(tree_look::rust);
        let Built { mesh, report: made } = unsafe {
            run(control, |control| {
                let look = or_built_in(look, tree.species())?;
                Ok(::tree_mesh::build(tree, &look, &params, control)?)
            })
        }?;
        let mut values = tree_mesh_report::of(&made);
        let mesh = tree_mesh::built(mesh, made.leaf_fallbacks);
        values.leaf_fallbacks = mesh.leaf_fallbacks();
        unsafe { view(report, "report", &values) }?;
        place.put(mesh);
        Ok(())
    })
}

/// Builds the leaves alone, for those who draw the wood themselves: the mesh of `tree_mesh_build`, where surface 0 is
/// empty and vertices have no wind. `look` and `params` are as there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_build_leaves(
    tree: *const tree_tree,
    look: *const tree_look,
    params: *const tree_mesh_params,
    control: *const tree_control,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let params = unsafe { mesh_params(params) }?;
        let look = unsafe { get_opt(look, "look") }?.map(tree_look::rust);
        let mesh = unsafe {
            run(control, |control| {
                let look = or_built_in(look, tree.species())?;
                Ok(::tree_mesh::build_leaves(tree, &look, &params, control)?)
            })
        }?;
        place.put(tree_mesh::new(mesh));
        Ok(())
    })
}
