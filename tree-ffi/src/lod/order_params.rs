//! Parameters of orders.

use super::hull::tree_hull_params;
use super::take::few;
use super::views::tree_around;
use crate::border::{Result, Versioned, call, init, read, read_or_default, tree_status};
use std::ptr::null;
use tree_lod::implicit::HullParams;
use tree_lod::order::{CoverageParams, OrderParams};

/// More stages than are allowed: Rust says how many are.
const STAGES_MAX: usize = 1 << 10;

/// What orders by density and orientation need to know. Begin with `tree_order_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_order_params {
    /// `sizeof(tree_order_params)`.
    pub struct_size: usize,
    /// The hull, for `tree_order_combined` and `tree_hull_of_elements`. NULL, the default: its defaults.
    pub hull: *const tree_hull_params,
    /// Height of the plant in metres, 0 to 1e9. Default 0: measured, as `tree_elements_plant_height` does it.
    pub height: f32,
    /// Radius of influence of an element, as a share of the height, 0.001 to 1. Default 0.05.
    pub radius: f32,
    /// When densities count as uniform and thinning by density ends: at this standard deviation of the
    /// densities of what is left, divided by their mean, 0 (never) to 10 (at once). Default 0.15.
    pub uniform: f32,
    /// Thinning by density ends at this share of the elements at the latest, 0 to 1. Default 0.25.
    pub least: f32,
    /// How much chance is added to priorities, which lie within 0 to 1; 0 (none) to 1. Default 0.05.
    pub randomness: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_order_params {
    const NAME: &'static str = "tree_order_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let params = OrderParams::default();
        Self {
            struct_size: size_of::<Self>(),
            hull: null(),
            height: params.height,
            radius: params.radius,
            uniform: params.uniform,
            least: params.least,
            randomness: params.randomness,
            reserved: 0,
        }
    }
}

impl tree_order_params {
    unsafe fn rust(&self) -> Result<OrderParams> {
        let hull = if self.hull.is_null() {
            HullParams::default()
        } else {
            unsafe { read(self.hull, "params.hull") }?.rust()
        };
        Ok(OrderParams {
            height: self.height,
            radius: self.radius,
            hull,
            uniform: self.uniform,
            least: self.least,
            randomness: self.randomness,
        })
    }

    /// The default for NULL.
    pub(super) unsafe fn read(params: *const Self) -> Result<OrderParams> {
        unsafe { read_or_default(params, "params")?.rust() }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_order_params_init(
    params: *mut tree_order_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_order_params_check(params: *const tree_order_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params")?.rust() }?.validate()?))
}

/// How the order by coverage is made. Begin with `tree_coverage_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_coverage_params {
    /// `sizeof(tree_coverage_params)`.
    pub struct_size: usize,
    /// Views that are looked at. More hold better for others, at proportional cost. NULL, the default: those of
    /// `tree_around_for_order`.
    pub around: *const tree_around,
    /// Shares of triangles for which the choice is made, falling, more than 0, less than 1. NULL, the default:
    /// 0.5, 0.35, 0.2, 0.1, 0.05, 0.02.
    pub stages: *const f32,
    /// Number of stages, at most 32; 0 for the default.
    pub n_stages: usize,
    /// Whether leaves choose the point they grow about; otherwise it is their centre. Default 1.
    pub pivots: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_coverage_params {
    const NAME: &'static str = "tree_coverage_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            around: null(),
            stages: null(),
            n_stages: 0,
            pivots: CoverageParams::default().pivots.into(),
            reserved: 0,
        }
    }
}

impl tree_coverage_params {
    /// For a model of so many triangles.
    unsafe fn rust(&self, n_triangles: usize) -> Result<CoverageParams> {
        let default = CoverageParams::for_triangles(n_triangles);
        let around = unsafe { tree_around::read_or(self.around, default.around.clone()) }?;
        let stages = unsafe { few(self.stages, self.n_stages, STAGES_MAX, "params.stages") }?;
        let mut params = CoverageParams { around, pivots: self.pivots != 0, ..default };
        if !stages.is_empty() {
            params.stages = stages.to_vec();
        }
        Ok(params)
    }

    /// The default for NULL.
    pub(super) unsafe fn read(params: *const Self, n_triangles: usize) -> Result<CoverageParams> {
        unsafe { read_or_default(params, "params")?.rust(n_triangles) }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_coverage_params_init(
    params: *mut tree_coverage_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_coverage_params_check(
    params: *const tree_coverage_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params")?.rust(0) }?.validate()?))
}
