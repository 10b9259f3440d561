//! How a mesh is read.

use crate::border::{Versioned, call, init, tree_status};
use tree_model::skeletonize::SkeletonizeParams;

/// How a mesh of a tree is read. Everything is relative, so the unit of the mesh does not matter. Begin
/// with `tree_skeletonize_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_skeletonize_params {
    /// `sizeof(tree_skeletonize_params)`.
    pub struct_size: usize,
    /// Vertices nearer than a quarter of this share of the mesh's size are one, 1e-7 to 0.01. Default
    /// 1e-5. Larger closes cracks and may melt twigs.
    pub weld: f32,
    /// Least distance between nodes in bent wood, in halves of the radius, 0.1 to 20. Default 1. Straight
    /// wood gets fewer nodes, up to ten radii apart.
    pub spacing: f32,
    /// How far a node may lie off the measured centre line, in radii, 0 to 0.5. Default 0.08.
    pub tolerance: f32,
    /// Side shoots that stand out of their parent by less than this share of its radius, and by less than
    /// their own radius, are bumps of the bark, 0 to 2. Default 0.25.
    pub prune: f32,
    /// Widest gap between separate pieces of wood that is bridged, as a share of the mesh's size, 0 to 1.
    /// Default 0.05. Wood farther away is left out and reported.
    pub bridge: f32,
    /// Whether leaves are made. Default 1.
    pub leaves: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_skeletonize_params {
    const NAME: &'static str = "tree_skeletonize_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let SkeletonizeParams { weld, spacing, tolerance, prune, bridge, leaves } =
            SkeletonizeParams::default();
        let leaves = leaves.into();
        Self { struct_size: size_of::<Self>(), weld, spacing, tolerance, prune, bridge, leaves }
    }
}

impl tree_skeletonize_params {
    pub(super) fn rust(&self) -> SkeletonizeParams {
        SkeletonizeParams {
            weld: self.weld,
            spacing: self.spacing,
            tolerance: self.tolerance,
            prune: self.prune,
            bridge: self.bridge,
            leaves: self.leaves != 0,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeletonize_params_init(
    params: *mut tree_skeletonize_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}
