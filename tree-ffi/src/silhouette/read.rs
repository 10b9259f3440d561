//! Drawings of outlines, as they come in.

use crate::border::{Handle, call, free, tree_status};
use std::sync::Arc;
use tree_model::silhouette::read::OutlineDrawing;

/// A drawing of outlines: the strokes of one tree or several, by level.
pub struct tree_outline_drawing(Arc<OutlineDrawing>);

impl Handle for tree_outline_drawing {
    const NAME: &'static str = "tree_outline_drawing";
}

impl tree_outline_drawing {
    pub(crate) fn new(drawing: OutlineDrawing) -> Self {
        Self(Arc::new(drawing))
    }

    pub(crate) fn rust(&self) -> &OutlineDrawing {
        &self.0
    }
}

/// Frees a drawing of outlines. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_drawing_free(
    drawing: *mut tree_outline_drawing,
) -> tree_status {
    call(|| unsafe { free(drawing, "drawing") })
}
