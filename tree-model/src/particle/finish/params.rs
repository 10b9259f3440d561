//! Parameters of the finish.

use crate::error::{Result, check};
use crate::foliage::{LeafParams, SpeciesPreset, TwigParams};
use tree_core::Species;
use tree_core::allometry::PipeModel;

/// How traces become a tree.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct FinishParams {
    /// Passes of smoothing along branches, 0 to 100. Default 4.
    pub smoothing: u32,
    /// Nodes nearer to the one below than this share of the tree's height are left out, 0 to 0.1. Default 0.005.
    pub spacing: f32,
    /// How thick branches are. Without a trunk radius of its own, that measured in the images is taken, and where
    /// they show no bare trunk, `slenderness`. Default exponent Murray's.
    pub radii: PipeModel,
    /// Radius of the trunk as a share of the height where nothing tells it, 1e-4 to 0.2. Default 0.017.
    pub slenderness: f32,
    /// Twigs on the traces' ends; `None` for none. Default those of an oak.
    pub twigs: Option<TwigParams>,
    /// Leaves; `None` for a bare tree. Default sprays of an oak's leaves.
    pub leaves: Option<LeafParams>,
    /// Area of a blade as a share of its length squared, 1e-3 to 2: how much a leaf covers, and so how many it
    /// takes. Default 0.333, an oak's spray; an oak leaf has 0.28, a needle 0.04.
    pub blade: f32,
    /// Leaves against what the images ask for, 0 to 10. Default 1.
    pub fullness: f32,
    /// Times the leaves are counted in the images and their density put right, 0 to 10. Default 3.
    pub corrections: u32,
    /// Leaves and twigs where an image's matte is below this are discarded (section 5.4.1), 0 (none) to 1.
    /// Default 0.5.
    pub empty: f32,
    /// What kind of tree it is. Default an oak.
    pub species: Species,
}

impl Default for FinishParams {
    fn default() -> Self {
        Self::find("oak").unwrap_or_else(|_| Self::of(&crate::foliage::SPECIES[0]))
    }
}

impl FinishParams {
    /// The defaults with twigs and single leaves of a species; [`find`](Self::find) has sprays, which are far fewer.
    #[must_use]
    pub fn of(preset: &SpeciesPreset) -> Self {
        Self {
            smoothing: 4,
            spacing: 0.005,
            radii: PipeModel { exponent: PipeModel::MURRAY, ..PipeModel::default() },
            slenderness: 0.017,
            twigs: Some(preset.twigs.clone()),
            leaves: Some(preset.leaves.clone()),
            blade: preset.blade,
            fullness: 1.0,
            corrections: 3,
            empty: 0.5,
            species: Species {
                name: preset.name.into(),
                bark: preset.bark.into(),
                leaf_kinds: vec![preset.leaf_kind.into()],
            },
        }
    }

    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field;
    /// [`ModelError::Core`](crate::ModelError::Core) for the pipe model.
    pub fn validate(&self) -> Result<()> {
        check("finish.smoothing", self.smoothing, 0, 100)?;
        check("finish.spacing", self.spacing, 0.0, 0.1_f32)?;
        self.radii.validate()?;
        check("finish.slenderness", self.slenderness, 1e-4_f32, 0.2_f32)?;
        if let Some(twigs) = &self.twigs {
            twigs.validate()?;
        }
        if let Some(leaves) = &self.leaves {
            leaves.validate(self.species.leaf_kinds.len())?;
        }
        check("finish.blade", self.blade, 1e-3_f32, 2.0)?;
        check("finish.fullness", self.fullness, 0.0, 10.0)?;
        check("finish.corrections", self.corrections, 0, 10)?;
        check("finish.empty", self.empty, 0.0, 1.0)
    }
}
