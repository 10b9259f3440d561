//! Bumps of an outline.

use crate::border::{Versioned, call, init, read, tree_status};
use tree_model::silhouette::bump::BumpParams;

/// How bumps are found. Begin with `tree_bump_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_bump_params {
    /// `sizeof(tree_bump_params)`.
    pub struct_size: usize,
    /// How far a feature must stand out to be a bump, as a share of the width of what it stands on, 0.01 to 10.
    /// Between clear valleys half of it is enough, without any it takes twice as much. Default 0.2.
    pub prominence: f32,
    /// Features that stand out less than this share of the outline's size (the longer side of its box) are no
    /// bumps, 0.001 to 0.5. Default 0.02.
    pub detail: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_bump_params {
    const NAME: &'static str = "tree_bump_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&BumpParams::default())
    }
}

impl tree_bump_params {
    pub(crate) fn of(params: &BumpParams) -> Self {
        let BumpParams { prominence, detail } = *params;
        Self { struct_size: size_of::<Self>(), prominence, detail }
    }

    pub(crate) fn rust(&self) -> BumpParams {
        BumpParams { prominence: self.prominence, detail: self.detail }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bump_params_init(
    params: *mut tree_bump_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bump_params_check(params: *const tree_bump_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}
