//! Twigs and leaves of well-known trees for trees from photographs.

use super::params::FinishParams;
use crate::error::Result;
use crate::foliage::{LeafParams, SPECIES, SpeciesPreset};
use tree_core::Species;

/// A spray of needles or leaves: one card for what would take hundreds.
struct Spray {
    name: &'static str,
    leaf_kind: &'static str,
    size: f32,
    blade: f32,
    pitch: f32,
}

/// A spray of seven to nine leaves.
const fn cluster(name: &'static str, leaf_kind: &'static str, blade: f32) -> Spray {
    Spray { name, leaf_kind, size: 0.24, blade, pitch: 0.8 }
}

/// A tree of ten metres has some two hundred thousand leaves and millions of needles: sprays are what a renderer
/// can bear. [`FinishParams::of`] has each leaf.
const SPRAYS: [Spray; 11] = [
    cluster("oak", "oak-cluster", 0.333),
    cluster("maple", "maple-cluster", 0.354),
    cluster("birch", "birch-cluster", 0.355),
    cluster("beech", "beech-cluster", 0.409),
    cluster("linden", "linden-cluster", 0.355),
    cluster("willow", "willow-cluster", 0.176),
    cluster("poplar", "poplar-cluster", 0.329),
    Spray { name: "ash", leaf_kind: "ash", size: 0.3, blade: 0.178, pitch: 0.9 },
    Spray { name: "pine", leaf_kind: "pine-needles", size: 0.3, blade: 0.21, pitch: 0.6 },
    Spray { name: "spruce", leaf_kind: "spruce-needles", size: 0.22, blade: 0.32, pitch: 0.7 },
    Spray { name: "larch", leaf_kind: "spruce-needles", size: 0.14, blade: 0.32, pitch: 0.7 },
];

impl FinishParams {
    /// All names that [`find`](Self::find) knows.
    pub fn names() -> impl Iterator<Item = &'static str> {
        SPECIES.iter().map(|species| species.name)
    }

    /// Twigs of the species of this name, with sprays of its leaves or needles where tree-mesh has a picture of
    /// one, and single leaves where not.
    ///
    /// # Errors
    /// [`ModelError::UnknownPreset`](crate::ModelError::UnknownPreset) that lists the names there are.
    pub fn find(name: &str) -> Result<Self> {
        let species: &SpeciesPreset = SpeciesPreset::find(name)?;
        let Some(spray) = SPRAYS.iter().find(|spray| spray.name == name) else {
            return Ok(Self::of(species));
        };
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
            ..Self::of(species)
        })
    }
}
