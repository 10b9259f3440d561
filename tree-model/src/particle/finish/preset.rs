//! Twigs and leaves of well-known trees for trees from photographs.

use super::params::FinishParams;
use crate::error::{ModelError, Result};
use crate::foliage::{LeafParams, SPECIES, SpeciesPreset};
use tree_core::Species;

/// A spray of needles or leaves: one card for what would take hundreds.
struct Spray {
    name: &'static str,
    /// The species whose twigs bear it.
    twigs: &'static str,
    leaf_kind: &'static str,
    size: f32,
    blade: f32,
    pitch: f32,
}

/// Conifers have too many needles to draw each, so their sprays come first; a species' own twigs with single
/// needles are there in [`FinishParams::of`].
const SPRAYS: [Spray; 3] = [
    Spray {
        name: "pine",
        twigs: "pine",
        leaf_kind: "pine-needles",
        size: 0.3,
        blade: 0.21,
        pitch: 0.6,
    },
    Spray {
        name: "spruce",
        twigs: "spruce",
        leaf_kind: "spruce-needles",
        size: 0.22,
        blade: 0.32,
        pitch: 0.7,
    },
    Spray {
        name: "larch",
        twigs: "larch",
        leaf_kind: "spruce-needles",
        size: 0.14,
        blade: 0.32,
        pitch: 0.7,
    },
];

impl FinishParams {
    /// All names that [`find`](Self::find) knows.
    pub fn names() -> impl Iterator<Item = &'static str> {
        SPECIES.iter().map(|species| species.name)
    }

    /// Twigs and leaves of the species of this name. Conifers get sprays of needles.
    ///
    /// # Errors
    /// [`ModelError::UnknownPreset`] that lists the names there are.
    pub fn find(name: &str) -> Result<Self> {
        let species: &SpeciesPreset = SpeciesPreset::find(name)?;
        let Some(spray) = SPRAYS.iter().find(|spray| spray.name == name) else {
            return Ok(Self::of(species));
        };
        let twigs: Result<&SpeciesPreset, ModelError> = SpeciesPreset::find(spray.twigs);
        let leaves = LeafParams {
            spacing: 0.25 * spray.size,
            bearing: 2.0 * spray.size,
            size: spray.size,
            pitch: spray.pitch,
            droop: 0.1,
            phototropism: 0.2,
            ..LeafParams::DEFAULT
        };
        Ok(Self {
            leaves: Some(leaves),
            blade: spray.blade,
            species: Species {
                name: name.into(),
                bark: species.bark.into(),
                leaf_kinds: vec![spray.leaf_kind.into()],
            },
            ..Self::of(twigs?)
        })
    }
}
