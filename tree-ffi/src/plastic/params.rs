//! How a tree is analysed.

use crate::border::{Versioned, call, init, read, tree_status};
use glam::Vec3;
use tree_model::plastic::{PlasticParams, Sky};

/// How a tree is analysed. Begin with `tree_plastic_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_plastic_params {
    /// `sizeof(tree_plastic_params)`.
    pub struct_size: usize,
    /// Branches at least this share of the trunk's radius are bent and pruned one by one; thinner ones follow them as
    /// branchlets, 0 to 1. Default 0.04. At 0 every node takes part.
    pub main: f32,
    /// Length of an internode in metres, above 0 to 1e6. Default 0: the commonest distance between forks.
    pub internode: f32,
    /// Most seasons that are told apart, 1 to 200. Default 40. A tree that has more is told them several at a time.
    pub seasons: u32,
    /// Extent of a leaf cluster along the branches, as a share of the longest way from the root to a tip, 0.02 to 1.
    /// Default 0.2. Smaller ones follow the light more finely; the cost grows with the square of their number.
    pub lobe: f32,
    /// Share of the light that one metre of leaf cluster lets through, 0 to 1. Default 0.5.
    pub translucency: f32,
    /// Strength of phototropism over one internode, 0 to 0.9. Default 0.25.
    pub phototropism: f32,
    /// Strength of gravitropism over one internode, -0.9 (down) to 0.9 (up). Default 0.12. The two strengths together stay
    /// under 0.95.
    pub gravitropism: f32,
    /// The sky the tree grew under: direction to its brightest point, as in `tree_plastic_sky`. Default 0, 1, 0.
    pub sky_light: [f32; 3],
    /// Factor on all its light, 0 to 10. Default 1.
    pub sky_brightness: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_plastic_params {
    const NAME: &'static str = "tree_plastic_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&PlasticParams::default())
    }
}

impl tree_plastic_params {
    pub(super) fn of(params: &PlasticParams) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            main: params.main,
            internode: params.internode,
            seasons: params.seasons,
            lobe: params.lobe,
            translucency: params.translucency,
            phototropism: params.phototropism,
            gravitropism: params.gravitropism,
            sky_light: params.sky.light.to_array(),
            sky_brightness: params.sky.brightness,
            reserved: 0,
        }
    }

    pub(super) fn rust(&self) -> PlasticParams {
        PlasticParams {
            main: self.main,
            internode: self.internode,
            seasons: self.seasons,
            lobe: self.lobe,
            translucency: self.translucency,
            phototropism: self.phototropism,
            gravitropism: self.gravitropism,
            sky: Sky { light: Vec3::from(self.sky_light), brightness: self.sky_brightness },
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_params_init(
    params: *mut tree_plastic_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_params_check(
    params: *const tree_plastic_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}
