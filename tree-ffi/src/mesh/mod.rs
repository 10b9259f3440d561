//! Meshes: built of trees, viewed column by column, finished.

use crate::border::{Handle, call, free, tree_status};
use ::tree_mesh::Mesh;
use std::sync::Arc;

/// Surfaces with their materials, and the branches that move in the wind.
pub struct tree_mesh(Arc<Mesh>);

impl Handle for tree_mesh {
    const NAME: &'static str = "tree_mesh";
}

impl tree_mesh {
    pub(crate) fn new(mesh: Mesh) -> Self {
        Self(Arc::new(mesh))
    }

    pub(crate) fn rust(&self) -> &Mesh {
        &self.0
    }
}

/// Ends a mesh, and with it all views of it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_free(mesh: *mut tree_mesh) -> tree_status {
    call(|| unsafe { free(mesh, "mesh") })
}
