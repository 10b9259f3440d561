//! How a tree is analysed, and how much it reacts.

use super::light::Sky;
use crate::error::{ModelError, Result, check};

/// How a tree is analysed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct PlasticParams {
    /// Branches at least this share of the trunk's radius are bent and pruned one by one; thinner ones follow them
    /// as branchlets, 0 to 1. Default 0.04. At 0 every node takes part.
    pub main: f32,
    /// Length of an internode in metres, above 0; 0 (the default) takes the commonest distance between forks.
    pub internode: f32,
    /// Most seasons that are told apart, 1 to 200. Default 40. A tree that has more is told them several at a time.
    pub seasons: u32,
    /// Extent of a leaf cluster along the branches, as a share of the longest way from the root to a tip, 0.02 to 1.
    /// Default 0.2. Smaller ones follow the light more finely; the cost grows with the square of their number.
    pub lobe: f32,
    /// Share of the light that one metre of leaf cluster lets through, 0 to 1. Default 0.5 (γ of Eq. 4).
    pub translucency: f32,
    /// Strength of phototropism over one internode, 0 to 0.9. Default 0.25.
    pub phototropism: f32,
    /// Strength of gravitropism over one internode, -0.9 (down) to 0.9 (up). Default 0.12. The two strengths together stay
    /// under 1.
    pub gravitropism: f32,
    /// The sky the tree grew under.
    pub sky: Sky,
}

impl Default for PlasticParams {
    fn default() -> Self {
        Self {
            main: 0.04,
            internode: 0.0,
            seasons: 40,
            lobe: 0.2,
            translucency: 0.5,
            phototropism: 0.25,
            gravitropism: 0.12,
            sky: Sky::default(),
        }
    }
}

impl PlasticParams {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the field.
    pub fn validate(&self) -> Result<()> {
        check("plastic.main", self.main, 0.0, 1.0)?;
        check("plastic.internode", self.internode, 0.0, 1e6)?;
        check("plastic.seasons", self.seasons, 1, 200)?;
        check("plastic.lobe", self.lobe, 0.02, 1.0)?;
        check("plastic.translucency", self.translucency, 0.0, 1.0)?;
        check("plastic.phototropism", self.phototropism, 0.0, 0.9)?;
        check("plastic.gravitropism", self.gravitropism, -0.9, 0.9)?;
        let sum = self.phototropism + self.gravitropism.abs();
        check("plastic.phototropism + |plastic.gravitropism|", sum, 0.0, 0.95)?;
        self.sky.validate()
    }
}

/// How much trees react.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Response {
    /// Share of the bending that tropisms ask for, 0 (none) to 1 (all of it). Default 1.
    pub bending: f32,
    /// Strength of pruning, 0 (none) to 1 (c of Eq. 11). Default 0.8: a branch dies when it has less than 0.8 of the light
    /// per length on which it is known to have lived.
    pub pruning: f32,
    /// How strongly the foliage follows the light, 0 (not at all) to 4. Default 1: half the light, half the branchlets.
    pub density: f32,
}

impl Default for Response {
    fn default() -> Self {
        Self { bending: 1.0, pruning: 0.8, density: 1.0 }
    }
}

impl Response {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the field.
    pub fn validate(&self) -> Result<()> {
        check("response.bending", self.bending, 0.0, 1.0)?;
        check("response.pruning", self.pruning, 0.0, 1.0)?;
        check("response.density", self.density, 0.0, 4.0)
    }
}

/// A problem with something that was handed to a scene.
pub(super) fn scene_error(what: impl Into<String>, problem: impl Into<String>) -> ModelError {
    ModelError::Scene { what: what.into(), problem: problem.into() }
}
