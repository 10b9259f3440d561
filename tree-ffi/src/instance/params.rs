//! How a tree is divided into twigs, and what came of it.

use crate::border::{Versioned, call, init, tree_status};
use ::tree_mesh::instance::{InstancingParams, InstancingReport};
use tree_model::tree_core::Seed;

/// How a tree is divided into twigs. Begin with `tree_instancing_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_instancing_params {
    /// `sizeof(tree_instancing_params)`.
    pub struct_size: usize,
    /// Most unique twigs, 1 to 1000. Default 30.
    pub max_twigs: u32,
    /// How many times smaller than the flattened tree the result should be, 1 to 1000. Default 11: ten,
    /// and some room. The truest way that reaches it is taken. Small trees may not reach it: see `ratio`
    /// of `tree_instancing_report`.
    pub ratio: f32,
    /// Length of twigs in metres along the longest path in them, 0.001 to 1000. Default 0: it is chosen.
    pub reach: f32,
    /// Not used; 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_instancing_params {
    const NAME: &'static str = "tree_instancing_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let InstancingParams { max_twigs, ratio, reach, seed: _ } = InstancingParams::default();
        let struct_size = size_of::<Self>();
        Self { struct_size, max_twigs, ratio, reach: reach.unwrap_or(0.0), reserved: 0 }
    }
}

impl tree_instancing_params {
    pub(super) fn rust(&self, seed: u64) -> InstancingParams {
        InstancingParams {
            max_twigs: self.max_twigs,
            ratio: self.ratio,
            // NaN is not 0, and refused with the other ranges.
            reach: (self.reach != 0.0).then_some(self.reach),
            seed: Seed(seed),
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_instancing_params_init(
    params: *mut tree_instancing_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// What an instanced tree weighs and how near it comes.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_instancing_report {
    /// `sizeof(tree_instancing_report)`.
    pub struct_size: usize,
    /// Unique twigs.
    pub n_twigs: u64,
    /// Instances of all twigs.
    pub n_instances: u64,
    /// Bytes of the columns of base and twigs, and of the instances.
    pub bytes: u64,
    /// Bytes of the columns of the flattened tree.
    pub bytes_flat: u64,
    /// Leaves of the tree.
    pub n_leaves: u64,
    /// Leaves of the instanced tree.
    pub n_leaves_instanced: u64,
    /// `bytes_flat / bytes`.
    pub ratio: f32,
    /// Length that twigs were limited to, in metres.
    pub reach: f32,
    /// How far middle and spread of a subtree's leaves are off those of the twig that stands for it, in
    /// metres: root mean square over all leaves.
    pub deviation: f32,
    /// Not used; 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_instancing_report {
    const NAME: &'static str = "tree_instancing_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&InstancingReport::default())
    }
}

impl tree_instancing_report {
    pub(super) fn of(report: &InstancingReport) -> Self {
        let (n_leaves, n_leaves_instanced) = report.n_leaves;
        Self {
            struct_size: size_of::<Self>(),
            n_twigs: report.n_twigs as u64,
            n_instances: report.n_instances as u64,
            bytes: report.bytes,
            bytes_flat: report.bytes_flat,
            n_leaves,
            n_leaves_instanced,
            ratio: report.ratio,
            reach: report.reach,
            deviation: report.deviation,
            reserved: 0,
        }
    }
}
