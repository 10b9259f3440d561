//! The sky of a scene, and how much its trees react.

use crate::border::{Versioned, call, init, tree_status, write};
use glam::Vec3;
use tree_model::plastic::{Response, Sky};

/// The light of the sky: cos² of the angle to its brightest point, 0 beyond a right angle and below the horizon. Begin
/// with `tree_plastic_sky_init` or `tree_plastic_sky_towards`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_plastic_sky {
    /// `sizeof(tree_plastic_sky)`.
    pub struct_size: usize,
    /// Direction to the brightest point, of any length but 0, not below the horizon. Default 0, 1, 0.
    pub light: [f32; 3],
    /// Factor on all light, 0 to 10. Default 1. At 0 every branch starves but the trunk.
    pub brightness: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_plastic_sky {
    const NAME: &'static str = "tree_plastic_sky";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Sky::default())
    }
}

impl tree_plastic_sky {
    pub(super) fn of(sky: &Sky) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            light: sky.light.to_array(),
            brightness: sky.brightness,
        }
    }

    pub(super) fn rust(&self) -> Sky {
        Sky { light: Vec3::from(self.light), brightness: self.brightness }
    }
}

/// Makes `sky`, of `size` bytes, the default: brightest above.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_sky_init(
    sky: *mut tree_plastic_sky,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(sky, size) })
}

/// Makes `sky`, of `size` bytes, one that is brightest `elevation` radians above the horizon, 0 to π/2, in the direction
/// `azimuth`, in radians from +Z towards +X.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_sky_towards(
    sky: *mut tree_plastic_sky,
    size: usize,
    azimuth: f32,
    elevation: f32,
) -> tree_status {
    call(|| {
        let found = Sky::towards(azimuth, elevation);
        found.validate()?;
        unsafe { init(sky, size) }?;
        unsafe { write(sky, "sky", &tree_plastic_sky::of(&found)) }
    })
}

/// How much trees react. Begin with `tree_plastic_response_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_plastic_response {
    /// `sizeof(tree_plastic_response)`.
    pub struct_size: usize,
    /// Share of the bending that tropisms ask for, 0 (none) to 1 (all of it). Default 1.
    pub bending: f32,
    /// Strength of pruning, 0 (none) to 1. Default 0.8: a branch dies when it has less than 0.8 of the light per length on
    /// which it is known to have lived.
    pub pruning: f32,
    /// How strongly the foliage follows the light, 0 (not at all) to 4. Default 1: half the light, half the branchlets.
    pub density: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_plastic_response {
    const NAME: &'static str = "tree_plastic_response";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Response::default())
    }
}

impl tree_plastic_response {
    pub(super) fn of(response: &Response) -> Self {
        let Response { bending, pruning, density } = *response;
        Self { struct_size: size_of::<Self>(), bending, pruning, density, reserved: 0 }
    }

    pub(super) fn rust(&self) -> Response {
        Response { bending: self.bending, pruning: self.pruning, density: self.density }
    }
}

/// Makes `response`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_response_init(
    response: *mut tree_plastic_response,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(response, size) })
}
