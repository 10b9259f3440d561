//! How a mesh is read.

use crate::error::{Result, check};

/// How a mesh is read. Everything is relative, so the unit of the mesh does not matter.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct SkeletonizeParams {
    /// Vertices nearer than a quarter of this share of the mesh's size are one, 1e-7 to 0.01.
    /// Default 1e-5. Larger closes cracks and may melt twigs.
    pub weld: f32,
    /// Least distance between nodes in bent wood, in halves of the radius, 0.1 to 20. Default 1. Straight wood gets fewer
    /// nodes, up to ten radii apart.
    pub spacing: f32,
    /// How far a node may lie off the measured centre line, in radii, 0 to 0.5. Default 0.08.
    pub tolerance: f32,
    /// Side shoots that stand out of their parent by less than this share of its radius, and by
    /// less than their own radius, are bumps of the bark, 0 to 2. Default 0.25.
    pub prune: f32,
    /// Widest gap between separate pieces of wood that is bridged, as a share of the mesh's size, 0
    /// to 1. Default 0.05. Wood farther away is left out and reported.
    pub bridge: f32,
    /// Whether leaves are made. Default true.
    pub leaves: bool,
}

impl Default for SkeletonizeParams {
    fn default() -> Self {
        Self { weld: 1e-5, spacing: 1.0, tolerance: 0.08, prune: 0.25, bridge: 0.05, leaves: true }
    }
}

impl SkeletonizeParams {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field.
    pub fn validate(&self) -> Result<()> {
        check("skeletonize.weld", self.weld, 1e-7, 0.01)?;
        check("skeletonize.spacing", self.spacing, 0.1, 20.0)?;
        check("skeletonize.tolerance", self.tolerance, 0.0, 0.5)?;
        check("skeletonize.prune", self.prune, 0.0, 2.0)?;
        check("skeletonize.bridge", self.bridge, 0.0, 1.0)
    }
}
