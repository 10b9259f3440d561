//! Parameters of every step to a hybrid model.

use crate::border::{Result, Versioned, call, init, read, read_or_default, tree_status};
use crate::impostor::{tree_card_choose_params, tree_card_params, tree_leaf_box_params};
use crate::mesh::{mesh_params, tree_mesh_params};
use crate::multires::{metric, tree_metric_params};
use std::ptr::null;
use tree_lod::hybrid::HybridParams;
use tree_model::tree_core::Limits;

/// Parameters of every step to a hybrid model. Begin with `tree_hybrid_params_init`. A part that is NULL, as all are
/// then, is its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_hybrid_params {
    /// `sizeof(tree_hybrid_params)`.
    pub struct_size: usize,
    /// What branches are worth.
    pub metric: *const tree_metric_params,
    /// How wood and leaves are drawn.
    pub mesh: *const tree_mesh_params,
    /// How leaves are put into boxes.
    pub boxes: *const tree_leaf_box_params,
    /// The pictures of the boxes.
    pub cards: *const tree_card_params,
    /// When pictures take the place of leaves.
    pub choose: *const tree_card_choose_params,
    /// For `TREE_METRIC_RANDOM` alone. Default 0.
    pub seed: u64,
    /// Side in pixels, 0.01 to 100, of the square that a path must cover, seen from the side, to be drawn. Less shows
    /// finer twigs, more saves triangles. Default 0.5.
    pub wood_pixels: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_hybrid_params {
    const NAME: &'static str = "tree_hybrid_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            metric: null(),
            mesh: null(),
            boxes: null(),
            cards: null(),
            choose: null(),
            seed: 0,
            wood_pixels: HybridParams::default().wood_pixels,
            reserved: 0,
        }
    }
}

impl tree_hybrid_params {
    /// In Rust's form, not yet checked.
    pub(super) unsafe fn rust(&self, limits: &Limits) -> Result<HybridParams> {
        Ok(HybridParams {
            metric: unsafe { metric(self.metric, self.seed, limits) }?,
            mesh: unsafe { mesh_params(self.mesh) }?,
            boxes: unsafe { read_or_default(self.boxes, "params.boxes") }?.rust(),
            cards: unsafe { read_or_default(self.cards, "params.cards") }?.rust(),
            choose: unsafe { read_or_default(self.choose, "params.choose") }?.rust(),
            wood_pixels: self.wood_pixels,
        })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_params_init(
    params: *mut tree_hybrid_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params` and of its parts; `TREE_ERROR_PARAMETER` or `TREE_ERROR_ENUM` names the first at
/// fault.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_params_check(
    params: *const tree_hybrid_params,
) -> tree_status {
    call(|| {
        let params = unsafe { read(params, "params") }?;
        Ok(unsafe { params.rust(&Limits::default()) }?.validate()?)
    })
}
