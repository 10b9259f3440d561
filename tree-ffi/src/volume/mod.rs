//! Solids: crowns, obstacles, paints.

mod combine;
mod query;
mod solid;
mod view;

pub use combine::*;
pub use query::*;
pub use solid::*;
pub use view::*;

use crate::border::{Handle, Result, call, floats, free, tree_status};
use glam::Vec3;
use tree_model::tree_core::Volume;

/// A solid, or a combination of solids. Plain solids contain their surface; revolutions and meshes
/// contain one side of it, so that solids set side by side share no point there.
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

/// Frees a volume. What was made of it lives on. `TREE_ERROR_ORDER` for the volumes of presets, which
/// belong to the library.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_free(volume: *mut tree_volume) -> tree_status {
    call(|| unsafe { free(volume, "volume") })
}

/// Makes a volume of what `make` returns, and hands it out.
unsafe fn hand_out(
    place: *mut *mut tree_volume,
    make: impl FnOnce() -> Result<Volume>,
) -> tree_status {
    call(|| {
        let place = unsafe { crate::border::out(place, "volume") }?;
        place.put(tree_volume(make()?));
        Ok(())
    })
}

/// A point or direction.
pub(crate) unsafe fn vec3(first: *const f32, argument: &str) -> Result<Vec3> {
    unsafe { floats(first, argument) }.map(Vec3::from_array)
}
