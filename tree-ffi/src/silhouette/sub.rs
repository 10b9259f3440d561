//! Sub-silhouettes: the part of an outline that is one branch's.

use crate::border::{Versioned, call, init, read, tree_status};
use tree_model::silhouette::sub::SubParams;

/// How sub-silhouettes are cut out. Begin with `tree_sub_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sub_params {
    /// `sizeof(tree_sub_params)`.
    pub struct_size: usize,
    /// Opening of the cone at a sharp feature, in radians, 0.02 to 3. Default 20°.
    pub narrow: f32,
    /// Opening where the radius at the end is the branch's span or more, in radians, 0.02 to 3. Default 110°.
    pub wide: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_sub_params {
    const NAME: &'static str = "tree_sub_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&SubParams::default())
    }
}

impl tree_sub_params {
    pub(crate) fn of(params: &SubParams) -> Self {
        let SubParams { narrow, wide } = *params;
        Self { struct_size: size_of::<Self>(), narrow, wide }
    }

    pub(crate) fn rust(&self) -> SubParams {
        SubParams { narrow: self.narrow, wide: self.wide }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sub_params_init(
    params: *mut tree_sub_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sub_params_check(params: *const tree_sub_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}
