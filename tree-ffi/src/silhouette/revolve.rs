//! The surface between outlines, turned round an axis.

use crate::border::{Handle, call, free, tree_status};
use tree_model::silhouette::place::revolve::Surface;

/// A closed surface round an axis, through outlines in planes through it.
pub struct tree_revolved(Surface);

impl Handle for tree_revolved {
    const NAME: &'static str = "tree_revolved";
}

/// Frees a surface.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_revolved_free(revolved: *mut tree_revolved) -> tree_status {
    call(|| unsafe { free(revolved, "revolved") })
}
