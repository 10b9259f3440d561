//! Meshes: built of trees, viewed column by column, finished.

mod branches;
mod build;
mod finish;
mod import;
mod materials;
mod params;
mod topology;
mod view;

pub use branches::*;
pub use build::*;
pub use finish::*;
pub use import::*;
pub use materials::*;
pub use params::*;
pub use topology::*;
pub use view::*;

use crate::border::{Handle, Result, Shared, call, free, tree_status};
use crate::memory::ask;
use ::tree_mesh::Mesh;

/// Surfaces with their materials, and the branches that move in the wind.
pub struct tree_mesh {
    /// Of its own, or part of an instanced tree, a pruned model, a mesh with levels or a hybrid model.
    held: Shared<Mesh>,
    /// Leaf kinds drawn as cards for want of an outline, for the report of the mesh's making.
    leaf_fallbacks: Vec<u32>,
}

impl Handle for tree_mesh {
    const NAME: &'static str = "tree_mesh";
}

impl tree_mesh {
    pub(crate) fn new(mesh: Mesh) -> Self {
        Self::part(Shared::new(mesh))
    }

    /// A mesh that is part of something.
    pub(crate) fn part(held: Shared<Mesh>) -> Self {
        Self { held, leaf_fallbacks: Vec::new() }
    }

    fn built(mesh: Mesh, leaf_fallbacks: Vec<u32>) -> Self {
        Self { leaf_fallbacks, ..Self::new(mesh) }
    }

    pub(crate) fn rust(&self) -> &Mesh {
        self.held.get()
    }

    fn leaf_fallbacks(&self) -> *const u32 {
        column(&self.leaf_fallbacks)
    }
}

/// What a copy of a mesh counts as against the cap on triangles: vertices, branches and materials need
/// not have any.
pub(crate) fn copy_size(mesh: &Mesh) -> u64 {
    let triangles = mesh.n_triangles().max(mesh.n_vertices().div_ceil(3));
    let few = mesh.branches.len() + mesh.surfaces.len() + mesh.materials.len();
    triangles.max(few).max(1) as u64
}

/// Where a column begins; NULL when it is empty.
pub(crate) fn column<T>(column: &[T]) -> *const T {
    if column.is_empty() { std::ptr::null() } else { column.as_ptr() }
}

/// Asks the memory budget for work that takes as much as `times` copies of the meshes' columns and that
/// cannot be stopped on the way.
pub(crate) fn ask_for_copies<'a>(
    meshes: impl IntoIterator<Item = &'a Mesh>,
    times: u64,
) -> Result<()> {
    let bytes: usize = meshes
        .into_iter()
        .flat_map(|mesh| &mesh.surfaces)
        .map(|surface| {
            size_of_val(surface.positions.as_slice())
                + size_of_val(surface.normals.as_slice())
                + size_of_val(surface.uvs.as_slice())
                + size_of_val(surface.tangents.as_slice())
                + size_of_val(surface.uvs2.as_slice())
                + size_of_val(surface.branches.as_slice())
                + size_of_val(surface.occlusion.as_slice())
                + size_of_val(surface.welds.as_slice())
                + size_of_val(surface.anchors.as_slice())
                + size_of_val(surface.indices.as_slice())
        })
        .sum();
    ask(times.saturating_mul(bytes as u64))
}

/// Frees a mesh, and with it all views of it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_free(mesh: *mut tree_mesh) -> tree_status {
    call(|| unsafe { free(mesh, "mesh") })
}
