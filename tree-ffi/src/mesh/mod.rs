//! Meshes: built of trees, viewed column by column, finished.

mod branches;
mod build;
mod continuation;
mod params;
mod view;

pub use branches::*;
pub use build::*;
pub use continuation::*;
pub use params::*;
pub use view::*;

use crate::border::{Handle, call, free, tree_status};
use ::tree_mesh::Mesh;
use std::sync::Arc;

/// Surfaces with their materials, and the branches that move in the wind.
pub struct tree_mesh {
    mesh: Arc<Mesh>,
    /// Leaf kinds drawn as cards for want of an outline, for the report of the mesh's making.
    leaf_fallbacks: Vec<u32>,
}

impl Handle for tree_mesh {
    const NAME: &'static str = "tree_mesh";
}

impl tree_mesh {
    #[allow(dead_code, reason = "until it has users")]
    pub(crate) fn new(mesh: Mesh) -> Self {
        Self::shared(Arc::new(mesh))
    }

    /// One more handle of a mesh.
    pub(crate) fn shared(mesh: Arc<Mesh>) -> Self {
        Self { mesh, leaf_fallbacks: Vec::new() }
    }

    pub(crate) fn built(mesh: Mesh, leaf_fallbacks: Vec<u32>) -> Self {
        Self { mesh: Arc::new(mesh), leaf_fallbacks }
    }

    pub(crate) fn rust(&self) -> &Mesh {
        &self.mesh
    }

    fn leaf_fallbacks(&self) -> *const u32 {
        column(&self.leaf_fallbacks)
    }
}

/// Where a column begins; NULL when it is empty.
pub(crate) fn column<T>(column: &[T]) -> *const T {
    if column.is_empty() { std::ptr::null() } else { column.as_ptr() }
}

/// Ends a mesh, and with it all views of it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_free(mesh: *mut tree_mesh) -> tree_status {
    call(|| unsafe { free(mesh, "mesh") })
}
