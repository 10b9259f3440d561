//! Crowns: what was drawn as a crown becomes closed polygons and a solid.

use crate::border::{Handle, Result, call, free, get, out, tree_status, write};
use crate::control::{limits, run, tree_control};
use crate::photo::{strokes, tree_strokes, tree_strokes_columns};
use std::sync::Arc;
use tree_model::sketch::crown::{Crown, CrownReport};

/// A crown: polygons in the plan, and the solid they stand for.
pub struct tree_crown {
    crown: Arc<Crown>,
    polygons: tree_strokes,
    report: CrownReport,
}

impl Handle for tree_crown {
    const NAME: &'static str = "tree_crown";
}

impl tree_crown {
    pub(crate) fn new(crown: Crown, report: CrownReport) -> Self {
        let polygons = tree_strokes::new(crown.polygons().to_vec());
        Self { crown: Arc::new(crown), polygons, report }
    }

    pub(crate) fn rust(&self) -> &Crown {
        &self.crown
    }
}

/// Frees a crown. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_free(crown: *mut tree_crown) -> tree_status {
    call(|| unsafe { free(crown, "crown") })
}
