//! Parameters of a stand.

use crate::error::{Result, check};
use crate::silhouette::session::SilhouetteParams;

/// How distances are read from a drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "lowercase")
)]
pub enum Perspective {
    /// The horizon follows from ground points and sizes; trees drawn on about one height stand on one line.
    #[default]
    Estimated,
    /// The horizon is at this height of the drawing: y in its units, downwards.
    Horizon(f32),
    /// There is none: all trees stand on one line, their sizes are as drawn.
    Flat,
}

/// From which tree a tree borrows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Lending {
    /// The tree that borrows: its place in the drawing, from 0.
    pub tree: usize,
    /// The tree that lends; `None` for nobody.
    pub from: Option<usize>,
}

/// All parameters of a stand.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct StandParams {
    /// Of each tree. `height` is that of the tallest.
    pub silhouette: SilhouetteParams,
    /// How distances are read. Default estimated.
    pub perspective: Perspective,
    /// Angle under which the width of all trees is seen in the drawing, in radians, 0.05 to 2.5: what turns sizes into
    /// distances. Default 0.9, as in a photograph. Unused without perspective.
    pub fov: f32,
    /// Without perspective: how far trees stand off their line, as a share of their mean distance, 0 to 10. Default 0.4.
    pub jitter: f32,
    /// Who borrows from whom, where that is not to be the detailed tree with the most similar crown. The last entry for a tree counts.
    pub lenders: Vec<Lending>,
    /// Borrowed branches and leaves are scaled as the crowns are, but at most by this factor up or down, 1 to 100. Default 3.
    pub scaling: f32,
}

impl Default for StandParams {
    fn default() -> Self {
        Self {
            silhouette: SilhouetteParams::default(),
            perspective: Perspective::Estimated,
            fov: 0.9,
            jitter: 0.4,
            lenders: Vec::new(),
            scaling: 3.0,
        }
    }
}

impl StandParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        self.silhouette.validate()?;
        if let Perspective::Horizon(y) = self.perspective {
            check("stand.horizon", y, -1e6_f32, 1e6_f32)?;
        }
        check("stand.fov", self.fov, 0.05_f32, 2.5_f32)?;
        check("stand.jitter", self.jitter, 0.0_f32, 10.0_f32)?;
        check("stand.scaling", self.scaling, 1.0_f32, 100.0_f32)
    }

    /// Checks that chosen trees are there.
    pub(super) fn check_lenders(&self, n_trees: usize) -> Result<()> {
        let last = n_trees.saturating_sub(1) as f64;
        for (i, lending) in self.lenders.iter().enumerate() {
            let from = lending.from.unwrap_or(0);
            check(format!("stand.lenders[{i}].tree"), lending.tree as f64, 0.0, last)?;
            check(format!("stand.lenders[{i}].from"), from as f64, 0.0, last)?;
        }
        Ok(())
    }
}
