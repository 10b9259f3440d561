//! Leaves and twigs of well-known trees, a row each.
//!
//! Sizes, arrangements and habits are those of floras; a row names the leaf kind of tree-mesh that is
//! its blade, leaflet or needle. Pictures of simple leaves have the upper part of the petiole on them,
//! which the petiole here goes without; those of leaflets and needles have none.

use super::arrangement::Phyllotaxis;
use super::form::{LeafForm, Palmate, Pinnate};
use super::params::LeafParams;
use super::twig::{Branching, TwigParams};
use crate::error::{ModelError, Result};
use std::f32::consts::TAU;

/// Leaves and twigs of one species.
///
/// ```
/// use tree_model::foliage::{Phyllotaxis, SpeciesPreset};
/// let maple = SpeciesPreset::find("maple")?;
/// assert_eq!(maple.leaves.arrangement, Phyllotaxis::Decussate);
/// # Ok::<(), tree_model::ModelError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SpeciesPreset {
    /// Name of the species.
    pub name: &'static str,
    /// Name of the leaf kind, for [`Species::leaf_kinds`](tree_core::Species::leaf_kinds); kind 0 of
    /// the leaves.
    pub leaf_kind: &'static str,
    /// Name of the bark of tree-mesh that comes nearest to its own, for
    /// [`Species::bark`](tree_core::Species::bark).
    pub bark: &'static str,
    /// Area of a blade, leaflet or needle as a share of its length squared.
    pub blade: f32,
    /// Its leaves.
    pub leaves: LeafParams,
    /// Its twigs.
    pub twigs: TwigParams,
}

impl SpeciesPreset {
    /// The species of this name.
    ///
    /// # Errors
    /// [`ModelError::UnknownPreset`] that lists the names there are.
    pub fn find(name: &str) -> Result<&'static Self> {
        SPECIES.iter().find(|species| species.name == name).ok_or_else(|| {
            let known: Vec<_> = SPECIES.iter().map(|species| species.name).collect();
            ModelError::UnknownPreset { name: name.into(), known: known.join(", ") }
        })
    }
}

const LEAVES: LeafParams = LeafParams { lamina_turn: 0.7, jitter: 0.25, ..LeafParams::DEFAULT };
const TWIGS: TwigParams = TwigParams::DEFAULT;
/// One leaf in each of five directions before a sixth stands over the first: 2/5 of a turn.
const TWO_FIFTHS: Phyllotaxis = Phyllotaxis::Spiral { divergence: 0.4 * TAU };

/// All species.
pub const SPECIES: &[SpeciesPreset] = &[
    SpeciesPreset {
        name: "oak",
        leaf_kind: "oak",
        bark: "oak",
        blade: 0.278,
        leaves: LeafParams {
            arrangement: TWO_FIFTHS,
            spacing: 0.022,
            bearing: 0.2,
            size: 0.1,
            size_gradient: -0.5,
            petiole: 0.04,
            pitch: 1.0,
            ..LEAVES
        },
        twigs: TwigParams {
            arrangement: TWO_FIFTHS,
            length: 0.22,
            taper: -0.4,
            angle: 0.95,
            jitter: 0.35,
            stiffness: 7.0,
            ..TWIGS
        },
    },
    SpeciesPreset {
        name: "maple",
        leaf_kind: "maple",
        bark: "smooth",
        blade: 0.309,
        leaves: LeafParams {
            arrangement: Phyllotaxis::Decussate,
            spacing: 0.05,
            bearing: 0.25,
            size: 0.14,
            size_gradient: 0.3,
            petiole: 0.5,
            pitch: 1.05,
            droop: 0.35,
            phototropism: 0.8,
            lamina_turn: 1.2,
            ..LEAVES
        },
        twigs: TwigParams {
            arrangement: Phyllotaxis::Decussate,
            internode: 0.05,
            per_metre: 6.0,
            angle: 0.75,
            phototropism: 1.2,
            ..TWIGS
        },
    },
    SpeciesPreset {
        name: "birch",
        leaf_kind: "birch",
        bark: "birch",
        blade: 0.259,
        leaves: LeafParams {
            arrangement: TWO_FIFTHS,
            spacing: 0.025,
            bearing: 0.4,
            size: 0.055,
            petiole: 0.15,
            pitch: 1.1,
            droop: 0.5,
            ..LEAVES
        },
        twigs: TwigParams {
            arrangement: TWO_FIFTHS,
            length: 0.55,
            stiffness: 0.35,
            tip_radius: 0.0006,
            radius_taper: 0.0015,
            per_metre: 12.0,
            ..TWIGS
        },
    },
    SpeciesPreset {
        name: "beech",
        leaf_kind: "beech",
        bark: "smooth",
        blade: 0.375,
        leaves: LeafParams {
            arrangement: Phyllotaxis::Distichous,
            spacing: 0.03,
            bearing: 0.35,
            size: 0.075,
            petiole: 0.04,
            pitch: 1.0,
            phototropism: 0.9,
            jitter: 0.15,
            ..LEAVES
        },
        twigs: TwigParams {
            branching: Branching::zigzag(0.35),
            arrangement: Phyllotaxis::Distichous,
            angle: 0.8,
            jitter: 0.12,
            phototropism: 0.2,
            ..TWIGS
        },
    },
    SpeciesPreset {
        name: "linden",
        leaf_kind: "linden",
        bark: "oak",
        blade: 0.379,
        leaves: LeafParams {
            arrangement: Phyllotaxis::Distichous,
            spacing: 0.04,
            bearing: 0.35,
            size: 0.1,
            petiole: 0.3,
            pitch: 1.1,
            droop: 0.45,
            phototropism: 0.85,
            lamina_turn: 0.9,
            jitter: 0.2,
            ..LEAVES
        },
        twigs: TwigParams {
            branching: Branching::zigzag(0.6),
            arrangement: Phyllotaxis::Distichous,
            internode: 0.04,
            length: 0.3,
            stiffness: 2.5,
            jitter: 0.15,
            ..TWIGS
        },
    },
    SpeciesPreset {
        name: "willow",
        leaf_kind: "willow",
        bark: "oak",
        blade: 0.105,
        leaves: LeafParams {
            arrangement: TWO_FIFTHS,
            spacing: 0.025,
            bearing: 0.9,
            size: 0.11,
            petiole: 0.03,
            pitch: 0.7,
            droop: 0.35,
            ..LEAVES
        },
        twigs: TwigParams {
            levels: 1,
            length: 1.0,
            taper: 0.2,
            per_metre: 20.0,
            angle: 0.9,
            stiffness: 1.2,
            phototropism: 0.0,
            tip_radius: 0.0007,
            radius_taper: 0.001,
            ..TWIGS
        },
    },
    SpeciesPreset {
        name: "poplar",
        leaf_kind: "poplar",
        bark: "birch",
        blade: 0.204,
        leaves: LeafParams {
            arrangement: TWO_FIFTHS,
            spacing: 0.035,
            bearing: 0.3,
            size: 0.075,
            petiole: 0.4,
            pitch: 0.9,
            droop: 0.5,
            phototropism: 0.35,
            jitter: 0.4,
            ..LEAVES
        },
        twigs: TwigParams {
            arrangement: TWO_FIFTHS,
            angle: 0.5,
            gravitropism: -2.5,
            stiffness: 8.0,
            ..TWIGS
        },
    },
    SpeciesPreset {
        name: "ash",
        leaf_kind: "ash-leaflet",
        bark: "oak",
        blade: 0.217,
        leaves: LeafParams {
            arrangement: Phyllotaxis::Decussate,
            form: LeafForm::Pinnate(Pinnate {
                pairs: 5,
                rachis: 2.6,
                angle: [1.15, 0.75],
                profile: [0.75, 1.0, 0.85],
                ..Pinnate::DEFAULT
            }),
            spacing: 0.06,
            bearing: 0.2,
            size: 0.085,
            petiole: 0.6,
            pitch: 0.95,
            ..LEAVES
        },
        twigs: TwigParams {
            arrangement: Phyllotaxis::Decussate,
            levels: 1,
            per_metre: 4.0,
            internode: 0.06,
            phototropism: 2.5,
            stiffness: 8.0,
            tip_radius: 0.002,
            ..TWIGS
        },
    },
    SpeciesPreset {
        name: "walnut",
        leaf_kind: "walnut-leaflet",
        bark: "oak",
        blade: 0.309,
        leaves: LeafParams {
            arrangement: TWO_FIFTHS,
            form: LeafForm::Pinnate(Pinnate {
                pairs: 3,
                rachis: 1.7,
                profile: [0.55, 0.85, 1.0],
                petiolule: 0.02,
                ..Pinnate::DEFAULT
            }),
            spacing: 0.04,
            bearing: 0.15,
            size: 0.13,
            petiole: 0.5,
            pitch: 0.95,
            ..LEAVES
        },
        twigs: TwigParams {
            arrangement: TWO_FIFTHS,
            levels: 1,
            per_metre: 5.0,
            tip_radius: 0.003,
            stiffness: 8.0,
            ..TWIGS
        },
    },
    SpeciesPreset {
        name: "mimosa",
        leaf_kind: "mimosa-leaflet",
        bark: "smooth",
        blade: 0.213,
        leaves: LeafParams {
            arrangement: TWO_FIFTHS,
            form: LeafForm::Pinnate(Pinnate {
                pairs: 8,
                odd: false,
                rachis: 14.0,
                droop: 0.5,
                angle: [1.2, 0.8],
                pinna_pairs: 14,
                pinna: 0.5,
                ..Pinnate::DEFAULT
            }),
            spacing: 0.05,
            bearing: 0.2,
            size: 0.018,
            petiole: 3.0,
            ..LEAVES
        },
        twigs: TwigParams { arrangement: TWO_FIFTHS, levels: 1, ..TWIGS },
    },
    SpeciesPreset {
        name: "horse-chestnut",
        leaf_kind: "horse-chestnut-leaflet",
        bark: "oak",
        blade: 0.24,
        leaves: LeafParams {
            arrangement: Phyllotaxis::Decussate,
            form: LeafForm::Palmate(Palmate::DEFAULT),
            spacing: 0.07,
            bearing: 0.15,
            size: 0.19,
            petiole: 0.8,
            pitch: 0.95,
            droop: 0.2,
            phototropism: 0.8,
            lamina_turn: 1.2,
            ..LEAVES
        },
        twigs: TwigParams {
            arrangement: Phyllotaxis::Decussate,
            levels: 1,
            per_metre: 4.0,
            internode: 0.07,
            phototropism: 2.5,
            tip_radius: 0.003,
            stiffness: 8.0,
            ..TWIGS
        },
    },
    SpeciesPreset {
        name: "spruce",
        leaf_kind: "needle",
        bark: "spruce",
        blade: 0.04,
        leaves: LeafParams {
            spacing: 0.0011,
            bearing: 0.35,
            size: 0.017,
            petiole: 0.03,
            pitch: 0.95,
            droop: 0.0,
            phototropism: 0.3,
            lamina_turn: 0.0,
            ..LEAVES
        },
        twigs: TwigParams {
            arrangement: Phyllotaxis::Opposite,
            per_metre: 25.0,
            taper: 0.75,
            lateral: 0.4,
            angle: 0.95,
            jitter: 0.1,
            stiffness: 10.0,
            phototropism: 0.0,
            ..TWIGS
        },
    },
    SpeciesPreset {
        name: "pine",
        leaf_kind: "needle",
        bark: "pine",
        blade: 0.04,
        leaves: LeafParams {
            form: LeafForm::Fascicle { needles: 2, spread: 0.14 },
            spacing: 0.0035,
            bearing: 0.22,
            size: 0.06,
            pitch: 0.75,
            droop: 0.0,
            phototropism: 0.0,
            ..LEAVES
        },
        twigs: TwigParams {
            arrangement: Phyllotaxis::Whorled { count: 4 },
            levels: 1,
            per_metre: 3.0,
            gravitropism: -3.0,
            tip_radius: 0.0025,
            ..TWIGS
        },
    },
    SpeciesPreset {
        name: "larch",
        leaf_kind: "needle",
        bark: "pine",
        blade: 0.04,
        leaves: LeafParams {
            form: LeafForm::Rosette { needles: 30, spread: 1.25 },
            spacing: 0.013,
            bearing: 0.5,
            size: 0.028,
            petiole: 0.1,
            petiole_radius: 0.05,
            pitch: 1.45,
            droop: 0.0,
            phototropism: 0.2,
            ..LEAVES
        },
        twigs: TwigParams { length: 0.4, levels: 1, stiffness: 1.0, angle: 1.1, ..TWIGS },
    },
    SpeciesPreset {
        name: "palm",
        leaf_kind: "palm-leaflet",
        bark: "palm",
        blade: 0.057,
        leaves: LeafParams {
            form: LeafForm::Pinnate(Pinnate {
                pairs: 60,
                rachis: 5.5,
                droop: 1.5,
                angle: [1.3, 0.35],
                profile: [0.6, 1.0, 0.35],
                fold: 0.25,
                petiolule: 0.0,
                ..Pinnate::DEFAULT
            }),
            spacing: 0.015,
            bearing: 0.35,
            size: 0.5,
            size_variation: 0.1,
            size_gradient: 0.3,
            petiole: 1.2,
            petiole_radius: 0.04,
            pitch: 1.0,
            droop: 0.05,
            phototropism: 0.0,
            terminal: false,
            ..LEAVES
        },
        twigs: TwigParams { levels: 1, ..TWIGS },
    },
];
