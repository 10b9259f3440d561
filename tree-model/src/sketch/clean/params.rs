//! How drawings are cleaned.

use crate::error::{ModelError, Result, check};
use glam::Vec2;

/// What becomes of strokes that lie far from the rest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum Isolated {
    /// A straight line joins them, however far they are.
    #[default]
    Bridge,
    /// Those beyond [`reach`](CleanParams::reach) are left out.
    Drop,
    /// Those beyond [`reach`](CleanParams::reach) are an error.
    Refuse,
}

/// How a drawing is cleaned and joined. Shares are of the drawing's height (or of a tenth of its width, where that
/// is more).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct CleanParams {
    /// Height of branches and crown together in metres, 0.01 to 1000. Default 10.
    pub height: f32,
    /// Distance between nodes, a share, 0.001 to 0.2. Default 0.01. Corners get nodes of their own. Very long
    /// drawings are sampled more coarsely.
    pub spacing: f32,
    /// Gaps up to this share count as drawn to touch, 0 to 0.2. Default 0.03. Ends that stick out beyond the stroke
    /// they join by up to this share are cut off.
    pub snap: f32,
    /// A stroke that runs along another within this share is the same, 0 to 0.1. Default 0.012. 0: nothing is merged.
    pub merge: f32,
    /// How far a stroke may be from the rest, a share, 0 to 10. Default 0.25. See [`Isolated`].
    pub reach: f32,
    /// What becomes of strokes beyond the reach. Default: bridged.
    pub isolated: Isolated,
    /// Where the tree's base is, in units of the drawing. Default: found.
    pub root: Option<Vec2>,
    /// Whether strokes without a role may be taken for a crown, the ground, sides of a trunk or marks on its bark.
    /// Default true; false: what is not marked is a branch.
    pub guess: bool,
    /// Forks of one stroke that are closer together than this share, or this close to its beginning or its end, are one: whorls and
    /// opposite branches, 0 to 0.1. Default 0.01. 0: forks stay where they are.
    pub gather: f32,
}

impl Default for CleanParams {
    fn default() -> Self {
        Self {
            height: 10.0,
            spacing: 0.01,
            snap: 0.03,
            merge: 0.012,
            reach: 0.25,
            isolated: Isolated::Bridge,
            root: None,
            guess: true,
            gather: 0.01,
        }
    }
}

impl CleanParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] or [`ModelError::NotFinite`] naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("clean.height", self.height, 0.01_f32, 1000.0_f32)?;
        check("clean.spacing", self.spacing, 0.001_f32, 0.2_f32)?;
        check("clean.snap", self.snap, 0.0_f32, 0.2_f32)?;
        check("clean.merge", self.merge, 0.0_f32, 0.1_f32)?;
        check("clean.reach", self.reach, 0.0_f32, 10.0_f32)?;
        check("clean.gather", self.gather, 0.0_f32, 0.1_f32)?;
        match self.root {
            Some(root) if !root.is_finite() => {
                Err(ModelError::NotFinite { field: "clean.root".into() })
            }
            _ => Ok(()),
        }
    }
}
