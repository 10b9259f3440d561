//! How leaves and twigs stand along a shoot.

use crate::border::{Failure, Result};
use tree_model::foliage::Phyllotaxis;

/// How leaves or twigs stand along a shoot: one of the `TREE_PHYLLOTAXIS_` constants.
pub type tree_phyllotaxis = u32;
/// One at a node, each turned by the same angle from the last. Oak, poplar.
pub const TREE_PHYLLOTAXIS_SPIRAL: u32 = 0;
/// One at a node, in two rows. Beech, elm, linden.
pub const TREE_PHYLLOTAXIS_DISTICHOUS: u32 = 1;
/// Two at a node, all pairs in one plane.
pub const TREE_PHYLLOTAXIS_OPPOSITE: u32 = 2;
/// Two at a node, each pair across the last. Maple, ash.
pub const TREE_PHYLLOTAXIS_DECUSSATE: u32 = 3;
/// Three or more at a node, each whorl in the gaps of the last.
pub const TREE_PHYLLOTAXIS_WHORLED: u32 = 4;

/// A [`Phyllotaxis`] as fields of a struct.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arrangement {
    pub(crate) kind: tree_phyllotaxis,
    /// Of a spiral.
    pub(crate) divergence: f32,
    /// Of whorls.
    pub(crate) whorl: u32,
}

impl Arrangement {
    /// As fields; those of other kinds have their defaults.
    pub(crate) fn of(arrangement: Phyllotaxis) -> Self {
        let default = Self {
            kind: TREE_PHYLLOTAXIS_SPIRAL,
            divergence: Phyllotaxis::GOLDEN.divergence(),
            whorl: 0,
        };
        match arrangement {
            Phyllotaxis::Spiral { divergence } => Self { divergence, ..default },
            Phyllotaxis::Distichous => Self { kind: TREE_PHYLLOTAXIS_DISTICHOUS, ..default },
            Phyllotaxis::Opposite => Self { kind: TREE_PHYLLOTAXIS_OPPOSITE, ..default },
            Phyllotaxis::Decussate => Self { kind: TREE_PHYLLOTAXIS_DECUSSATE, ..default },
            Phyllotaxis::Whorled { count } => {
                Self { kind: TREE_PHYLLOTAXIS_WHORLED, whorl: count, ..default }
            }
        }
    }

    /// `name` is the field that holds the kind.
    pub(crate) fn rust(self, name: &str) -> Result<Phyllotaxis> {
        match self.kind {
            TREE_PHYLLOTAXIS_SPIRAL => Ok(Phyllotaxis::Spiral { divergence: self.divergence }),
            TREE_PHYLLOTAXIS_DISTICHOUS => Ok(Phyllotaxis::Distichous),
            TREE_PHYLLOTAXIS_OPPOSITE => Ok(Phyllotaxis::Opposite),
            TREE_PHYLLOTAXIS_DECUSSATE => Ok(Phyllotaxis::Decussate),
            TREE_PHYLLOTAXIS_WHORLED => Ok(Phyllotaxis::Whorled { count: self.whorl }),
            other => Err(Failure::not_one_of(name, other, "TREE_PHYLLOTAXIS_")),
        }
    }
}
