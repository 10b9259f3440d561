//! How trees are compared.

use crate::border::{Failure, Result, Versioned, call, init, tree_status};
use tree_core::distance::{EditParams, Reduction, Weight};

/// What a node weighs, the price of deleting or inserting it: one of the `TREE_EDIT_WEIGHT_` constants.
pub type tree_edit_weight = u32;
/// Its radius in metres; of a run or an axis, the mean over its length. The default.
pub const TREE_EDIT_WEIGHT_RADIUS: u32 = 0;
/// Radius times length of its segment in square metres, which goes with the bark, however finely a shoot is divided.
pub const TREE_EDIT_WEIGHT_RADIUS_TIMES_LENGTH: u32 = 1;
/// Radius squared times length in cubic metres, which goes with the wood.
pub const TREE_EDIT_WEIGHT_RADIUS_SQUARED_TIMES_LENGTH: u32 = 2;
/// 1 each: structure only.
pub const TREE_EDIT_WEIGHT_UNIT: u32 = 3;

/// What becomes one node before trees are compared: one of the `TREE_EDIT_REDUCTION_` constants.
pub type tree_edit_reduction = u32;
/// Every node stays one.
pub const TREE_EDIT_REDUCTION_NONE: u32 = 0;
/// An unbranched run, from above a fork up to the next fork or a tip: how finely shoots are divided does not matter.
/// The default.
pub const TREE_EDIT_REDUCTION_RUNS: u32 = 1;
/// An axis with all its nodes; its laterals are its children, wherever they leave it.
pub const TREE_EDIT_REDUCTION_AXES: u32 = 2;

/// How trees are compared. Begin with `tree_edit_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_edit_params {
    /// `sizeof(tree_edit_params)`.
    pub struct_size: usize,
    /// What a node weighs. Default `TREE_EDIT_WEIGHT_RADIUS`.
    pub weight: tree_edit_weight,
    /// What becomes one node. Default `TREE_EDIT_REDUCTION_RUNS`.
    pub reduction: tree_edit_reduction,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_edit_params {
    const NAME: &'static str = "tree_edit_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            weight: TREE_EDIT_WEIGHT_RADIUS,
            reduction: TREE_EDIT_REDUCTION_RUNS,
        }
    }
}

impl tree_edit_params {
    pub(super) fn rust(&self, mapping: bool) -> Result<EditParams> {
        Ok(EditParams {
            weight: match self.weight {
                TREE_EDIT_WEIGHT_RADIUS => Weight::Radius,
                TREE_EDIT_WEIGHT_RADIUS_TIMES_LENGTH => Weight::RadiusTimesLength,
                TREE_EDIT_WEIGHT_RADIUS_SQUARED_TIMES_LENGTH => Weight::RadiusSquaredTimesLength,
                TREE_EDIT_WEIGHT_UNIT => Weight::Unit,
                other => {
                    return Err(Failure::not_one_of("params.weight", other, "TREE_EDIT_WEIGHT_"));
                }
            },
            reduction: match self.reduction {
                TREE_EDIT_REDUCTION_NONE => Reduction::None,
                TREE_EDIT_REDUCTION_RUNS => Reduction::Runs,
                TREE_EDIT_REDUCTION_AXES => Reduction::Axes,
                other => {
                    let name = "params.reduction";
                    return Err(Failure::not_one_of(name, other, "TREE_EDIT_REDUCTION_"));
                }
            },
            mapping,
        })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_edit_params_init(
    params: *mut tree_edit_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_are_those_of_rust() {
        let params = tree_edit_params::default_value().rust(false).unwrap();
        assert_eq!(params, EditParams::default());
    }
}
