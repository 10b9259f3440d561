//! How leaves are projected onto planes, and what was baked.

use crate::border::{Versioned, call, init, read, tree_status};
use tree_lod::impostor::cards::{CardParams, CardReport};

/// How leaves are projected onto planes. Begin with `tree_card_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_card_params {
    /// `sizeof(tree_card_params)`.
    pub struct_size: usize,
    /// Side of a picture in texels, gutters included, 16 to 1024. Default 64.
    pub size: u32,
    /// Samples of a texel in each direction, 1 to 8. Default 4.
    pub samples: u32,
    /// Texels around each picture that repeat what is at its edge, 1 to 8 and at most a quarter of `size`: so that
    /// filters do not mix pictures. Default 1.
    pub gutter: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_card_params {
    const NAME: &'static str = "tree_card_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let CardParams { size, samples, gutter } = CardParams::default();
        Self { struct_size: size_of::<Self>(), size, samples, gutter, reserved: 0 }
    }
}

impl tree_card_params {
    pub(crate) fn rust(&self) -> CardParams {
        CardParams { size: self.size, samples: self.samples, gutter: self.gutter }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_params_init(
    params: *mut tree_card_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_params_check(params: *const tree_card_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// What was baked.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_cards_report {
    /// `sizeof(tree_cards_report)`.
    pub struct_size: usize,
    /// Number of boxes.
    pub n_boxes: usize,
    /// Number of pictures: six for each box.
    pub n_images: usize,
    /// Texels of all pictures.
    pub n_texels: u64,
    /// Bytes of both atlases, as they are in memory.
    pub bytes: usize,
    /// Pictures in which nothing covers half a texel.
    pub n_empty: usize,
    /// Side of a picture in texels, gutters included.
    pub size: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_cards_report {
    const NAME: &'static str = "tree_cards_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&CardReport::default(), 0)
    }
}

impl tree_cards_report {
    pub(super) fn of(report: &CardReport, size: u32) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_boxes: report.n_boxes,
            n_images: report.n_images,
            n_texels: report.n_texels,
            bytes: report.bytes,
            n_empty: report.n_empty,
            size,
            reserved: 0,
        }
    }
}
