//! Which branches get a box, and what became of the leaves.

use crate::border::{Versioned, call, init, read, tree_status};
use tree_lod::impostor::boxes::{BoxParams, BoxReport};

/// Which branches get a box. Begin with `tree_leaf_box_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_leaf_box_params {
    /// `sizeof(tree_leaf_box_params)`.
    pub struct_size: usize,
    /// A branch gets no box when its volume is less than this share of that of the box it is in, 0 to 1. Less makes more
    /// boxes. Default 0.02.
    pub least_volume: f64,
    /// Nor when it is more than this share: its pictures would hardly be sharper. Its own branches are looked at
    /// instead. 0.01 to 1. Default 0.4.
    pub most_volume: f64,
    /// Levels below the box of the whole tree, 0 to 16. Default 4.
    pub levels: u32,
    /// A branch gets no box when it has fewer leaves, 1 to 1,000,000: those are cheap as they are. Default 24.
    pub least_leaves: u32,
    /// Most boxes, 1 to 4096; larger ones come first. Default 64.
    pub most_boxes: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_leaf_box_params {
    const NAME: &'static str = "tree_leaf_box_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let default = BoxParams::default();
        Self {
            struct_size: size_of::<Self>(),
            least_volume: default.least_volume,
            most_volume: default.most_volume,
            levels: default.levels,
            least_leaves: default.least_leaves,
            most_boxes: default.most_boxes,
            reserved: 0,
        }
    }
}

impl tree_leaf_box_params {
    pub(crate) fn rust(&self) -> BoxParams {
        BoxParams {
            levels: self.levels,
            least_volume: self.least_volume,
            most_volume: self.most_volume,
            least_leaves: self.least_leaves,
            most_boxes: self.most_boxes,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_box_params_init(
    params: *mut tree_leaf_box_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_box_params_check(
    params: *const tree_leaf_box_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// What became of the leaves.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_leaf_boxes_report {
    /// `sizeof(tree_leaf_boxes_report)`.
    pub struct_size: usize,
    /// Number of boxes.
    pub n_boxes: usize,
    /// Number of levels, the whole tree being one.
    pub n_levels: usize,
    /// Leaves in all.
    pub n_leaves: usize,
    /// Leaves that are in no box but that of the whole tree.
    pub n_in_root_only: usize,
    /// Branches that got no box because it would have been too small.
    pub n_dropped: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_leaf_boxes_report {
    const NAME: &'static str = "tree_leaf_boxes_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&BoxReport::default())
    }
}

impl tree_leaf_boxes_report {
    pub(super) fn of(report: &BoxReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_boxes: report.n_boxes,
            n_levels: report.n_levels,
            n_leaves: report.n_leaves,
            n_in_root_only: report.n_in_root_only,
            n_dropped: report.n_dropped,
        }
    }
}
