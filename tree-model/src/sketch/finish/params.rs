//! Parameters of the finish.

use crate::error::{Result, check};
use crate::foliage::{LeafForm, Phyllotaxis, SpeciesPreset};
use crate::particle::finish;
use tree_core::allometry::PipeModel;

/// Species that bear leaves on the trunk's tip, or on drawn fronds, and no twigs.
const TWIGLESS: [&str; 1] = ["palm"];
/// Along a drawn frond, leaflets stand this share of their length apart.
const LEAFLET_SPACING: f32 = 0.07;

/// How branches become a tree.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct FinishParams {
    /// Whose twigs and leaves: a name of [`SPECIES`](crate::foliage::SPECIES). Default "oak".
    pub species: String,
    /// Whether there are leaves. Default true.
    pub leaves: bool,
    /// Whether there are twigs. Default true.
    pub twigs: bool,
    /// Radius of the trunk as a share of the height, 1e-4 to 0.2. Default 0.018.
    pub slenderness: f32,
    /// How radii add up at forks: Δ of the pipe model, 1 to 10. Default Murray's.
    pub exponent: f32,
    /// Leaves against those of a tree in full leaf, 0 to 10. Default 1.
    pub fullness: f32,
    /// Length of twigs against the usual of the species, 0.05 to 20. Default 1.
    pub twig_length: f32,
}

impl Default for FinishParams {
    fn default() -> Self {
        Self {
            species: "oak".into(),
            leaves: true,
            twigs: true,
            slenderness: 0.018,
            exponent: PipeModel::MURRAY,
            fullness: 1.0,
            twig_length: 1.0,
        }
    }
}

impl FinishParams {
    /// Checks all ranges and the species.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field;
    /// [`ModelError::UnknownPreset`](crate::ModelError::UnknownPreset) for the species.
    pub fn validate(&self) -> Result<()> {
        SpeciesPreset::find(&self.species)?;
        check("finish.slenderness", self.slenderness, 1e-4_f32, 0.2_f32)?;
        check("finish.exponent", self.exponent, 1.0, 10.0)?;
        check("finish.fullness", self.fullness, 0.0, 10.0)?;
        check("finish.twig_length", self.twig_length, 0.05_f32, 20.0)
    }

    /// The species' twigs and leaves, as far as they are wanted; `fronds` is the length of a palm's drawn fronds in
    /// metres, where there are any.
    pub(super) fn sprays(&self, fronds: Option<f32>) -> Result<finish::FinishParams> {
        let mut params = finish::FinishParams::find(&self.species)?;
        let twigless = TWIGLESS.contains(&self.species.as_str());
        if !self.twigs || twigless {
            params.twigs = None;
        }
        if let Some(twigs) = &mut params.twigs {
            twigs.length *= self.twig_length;
        }
        if !self.leaves {
            params.leaves = None;
        }
        if let (true, Some(length), Some(leaves)) = (twigless, fronds, &mut params.leaves) {
            leaves.form = LeafForm::Simple;
            leaves.arrangement = Phyllotaxis::Distichous;
            leaves.size = leaves.size.min(0.35 * length);
            leaves.spacing = LEAFLET_SPACING * leaves.size;
            leaves.bearing = 0.9 * length;
            leaves.petiole = 0.0;
            leaves.terminal = true;
        }
        Ok(params)
    }

    /// Whether branches of the species are fronds.
    pub(in crate::sketch) fn has_fronds(&self) -> bool {
        TWIGLESS.contains(&self.species.as_str())
    }
}
