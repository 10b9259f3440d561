//! Parameters of a session.

use crate::error::{Result, check};
use crate::silhouette::branch::BranchingAngles;
use crate::silhouette::grow::GrowParams;
use crate::silhouette::outline::OutlineParams;
use crate::silhouette::plan::SystemParams;

/// All parameters from strokes to a tree.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct SilhouetteParams {
    /// How strokes become outlines.
    pub outline: OutlineParams,
    /// How branches are found in outlines.
    pub system: SystemParams,
    /// Angles of the branches on the trunk, until branches are redrawn.
    pub angles: BranchingAngles,
    /// How the plan becomes a tree.
    pub grow: GrowParams,
    /// A stroke redraws a branch when its ends are on average no farther off than this share of the branch's span, 0 to 10; else
    /// it adds one. Default 0.35.
    pub near: f32,
    /// Height in metres of the tallest tree of a drawing, 0.001 to 1000. Default 10.
    pub height: f32,
}

impl Default for SilhouetteParams {
    fn default() -> Self {
        Self {
            outline: OutlineParams::default(),
            system: SystemParams::default(),
            angles: BranchingAngles::default(),
            grow: GrowParams::default(),
            near: 0.35,
            height: 10.0,
        }
    }
}

impl SilhouetteParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        self.outline.validate()?;
        self.system.validate()?;
        self.angles.validate("angles")?;
        self.grow.validate()?;
        check("near", self.near, 0.0_f32, 10.0_f32)?;
        check("height", self.height, 0.001_f32, 1000.0_f32)
    }
}
