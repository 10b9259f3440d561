//! Outlines drawn as leaves.

use crate::border::{Handle, call, free, tree_status};
use tree_model::silhouette::LeafOutline;

/// A drawn leaf in its own plane: base at the origin, tip at (0, 1), in triangles.
pub struct tree_leaf_outline(LeafOutline);

impl Handle for tree_leaf_outline {
    const NAME: &'static str = "tree_leaf_outline";
}

impl tree_leaf_outline {
    pub(crate) fn new(leaf: LeafOutline) -> Self {
        Self(leaf)
    }

    pub(crate) fn rust(&self) -> &LeafOutline {
        &self.0
    }
}

/// Frees a drawn leaf.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_outline_free(leaf: *mut tree_leaf_outline) -> tree_status {
    call(|| unsafe { free(leaf, "leaf") })
}
