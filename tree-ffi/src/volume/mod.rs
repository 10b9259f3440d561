//! Solids: crowns, obstacles, paints.

use crate::border::{Handle, call, free, tree_status};
use tree_model::tree_core::Volume;

/// A solid, or a combination of solids.
pub struct tree_volume(Volume);

impl Handle for tree_volume {
    const NAME: &'static str = "tree_volume";
}

impl tree_volume {
    pub(crate) fn new(volume: Volume) -> Self {
        Self(volume)
    }

    pub(crate) fn rust(&self) -> &Volume {
        &self.0
    }
}

/// Ends a volume. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_free(volume: *mut tree_volume) -> tree_status {
    call(|| unsafe { free(volume, "volume") })
}
