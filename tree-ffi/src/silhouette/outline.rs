//! Outlines: closed polygons of the plane.

use crate::border::{Handle, call, free, tree_status};
use std::sync::Arc;
use tree_model::silhouette::{Outline, OutlineRepair};

/// A closed outline in metres, x to the right, y up: a simple polygon against the clock.
pub struct tree_outline {
    outline: Arc<Outline>,
    repairs: Vec<OutlineRepair>,
}

impl Handle for tree_outline {
    const NAME: &'static str = "tree_outline";
}

impl tree_outline {
    pub(crate) fn new(outline: Outline) -> Self {
        Self { outline: Arc::new(outline), repairs: Vec::new() }
    }

    pub(crate) fn rust(&self) -> &Outline {
        &self.outline
    }
}

/// Frees an outline. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_free(outline: *mut tree_outline) -> tree_status {
    call(|| unsafe { free(outline, "outline") })
}
