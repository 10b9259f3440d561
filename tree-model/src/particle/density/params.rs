//! What a density depends on.

use crate::error::{Result, check};

/// What a density depends on.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct DensityParams {
    /// Voxels along the tree's height, 4 to 256. Default 48 (the thesis: 25). Memory and time grow with
    /// its cube. Trees more than four times as wide as high get larger voxels.
    pub resolution: u32,
    /// Voxels are thrown away where a view covers less of them than this, 0 to 1. Default 0.05. Higher
    /// values cut off thin foliage.
    pub threshold: f32,
    /// How far horizontal sections of the crown are rounded, 0 (the thesis alone: boxes from two views) to
    /// 1 (ellipses of the widths seen). Default 1.
    pub rounding: f32,
    /// Rays for every side of a voxel, 0.25 to 4, in each view. Default 1. Rays never lie closer than
    /// pixels. Memory and time grow with its square.
    pub rays: f32,
    /// Least transparency of a pixel, 1e-4 to 0.5: what is opaque counts as letting so much through.
    /// Default 0.02. Lower values make the densest parts denser.
    pub least_transparency: f32,
    /// Weight of the demand that densities are small and even (Tikhonov's λ, in units of what the rays
    /// demand of a voxel), 0.01 to 10. Default 0.7. Higher values thin out what is few voxels
    /// deep; lower ones leave specks where views differ, and take longer.
    pub evenness: f32,
    /// Most iterations of the solver, 1 to 100,000. Default 500.
    pub iterations: u32,
    /// The solver stops when the densities are surely within this share of the exact ones (of their root
    /// mean square), 1e-4 to 1. Default 0.02, which in truth comes out within 0.01.
    pub tolerance: f32,
}

impl Default for DensityParams {
    fn default() -> Self {
        Self {
            resolution: 48,
            threshold: 0.05,
            rounding: 1.0,
            rays: 1.0,
            least_transparency: 0.02,
            evenness: 0.7,
            iterations: 500,
            tolerance: 0.02,
        }
    }
}

impl DensityParams {
    /// Checks all numbers.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field.
    pub fn validate(&self) -> Result<()> {
        check("density.resolution", self.resolution, 4, 256)?;
        check("density.threshold", self.threshold, 0.0, 1.0)?;
        check("density.rounding", self.rounding, 0.0, 1.0)?;
        check("density.rays", self.rays, 0.25, 4.0)?;
        check("density.least_transparency", self.least_transparency, 1e-4_f32, 0.5)?;
        check("density.evenness", self.evenness, 0.01_f32, 10.0)?;
        check("density.iterations", self.iterations, 1, 100_000)?;
        check("density.tolerance", self.tolerance, 1e-4_f32, 1.0)
    }
}
