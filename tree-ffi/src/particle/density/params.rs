//! What a density depends on.

use crate::border::{Result, Versioned, call, init, read, tree_status};
use tree_model::particle::density::DensityParams;

/// What a density depends on. Begin with `tree_density_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_density_params {
    /// `sizeof(tree_density_params)`.
    pub struct_size: usize,
    /// Voxels along the tree's height, 4 to 256. Default 48. Memory and time grow with its cube. Trees more
    /// than four times as wide as high get larger voxels.
    pub resolution: u32,
    /// Voxels are thrown away where a view covers less of them than this, 0 to 1. Default 0.05. Higher
    /// values cut off thin foliage.
    pub threshold: f32,
    /// How far horizontal sections of the crown are rounded, 0 (boxes from two views) to 1 (ellipses of the
    /// widths seen). Default 1.
    pub rounding: f32,
    /// Rays for every side of a voxel, 0.25 to 4, in each view. Default 1. Memory and time grow with its
    /// square.
    pub rays: f32,
    /// Least transparency of a pixel, 1e-4 to 0.5: what is opaque counts as letting so much through.
    /// Default 0.02. Lower values make the densest parts denser.
    pub least_transparency: f32,
    /// Weight of the demand that densities are small and even, 0.01 to 10. Default 0.7. Higher values thin
    /// out what is few voxels deep; lower ones leave specks where views differ, and take longer.
    pub evenness: f32,
    /// Most iterations of the solver, 1 to 100,000. Default 500.
    pub iterations: u32,
    /// The solver stops when the densities are surely within this share of the exact ones, 1e-4 to 1.
    /// Default 0.02.
    pub tolerance: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_density_params {
    const NAME: &'static str = "tree_density_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&DensityParams::default())
    }
}

impl tree_density_params {
    /// The parameters in C's form.
    pub(crate) fn of(params: &DensityParams) -> Self {
        let DensityParams {
            resolution,
            threshold,
            rounding,
            rays,
            least_transparency,
            evenness,
            iterations,
            tolerance,
        } = *params;
        Self {
            struct_size: size_of::<Self>(),
            resolution,
            threshold,
            rounding,
            rays,
            least_transparency,
            evenness,
            iterations,
            tolerance,
        }
    }

    /// The parameters in Rust's form, not yet checked against their ranges.
    pub(crate) fn rust(&self) -> DensityParams {
        DensityParams {
            resolution: self.resolution,
            threshold: self.threshold,
            rounding: self.rounding,
            rays: self.rays,
            least_transparency: self.least_transparency,
            evenness: self.evenness,
            iterations: self.iterations,
            tolerance: self.tolerance,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_density_params_init(
    params: *mut tree_density_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_density_params_check(
    params: *const tree_density_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// NULL is the default.
pub(super) unsafe fn density_params(params: *const tree_density_params) -> Result<DensityParams> {
    Ok(unsafe { crate::border::read_or_default(params, "params") }?.rust())
}
