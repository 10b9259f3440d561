//! Phyllotaxis: how leaves are arranged on a shoot.

use crate::error::{Result, check};
use std::f32::consts::{FRAC_PI_2, PI};

/// The golden angle, 137.508°: the usual divergence of spiral leaves.
pub(crate) const GOLDEN_ANGLE: f32 = 2.399_963_2;

/// The arrangement of leaves along a shoot, in the textbook's terms.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Phyllotaxis {
    /// One leaf a node, each turned by `divergence` radians from the last. Oak, poplar.
    Spiral {
        /// Divergence angle; [`Phyllotaxis::default`] has the golden angle.
        divergence: f32,
    },
    /// One leaf a node, in two rows. Beech, elm, linden.
    Distichous,
    /// Two leaves a node, all pairs in one plane.
    Opposite,
    /// Two leaves a node, each pair across the last. Maple, ash.
    Decussate,
    /// Three or more leaves a node, each whorl in the gaps of the last.
    Whorled {
        /// Leaves a node, 3 to 64.
        count: u32,
    },
}

impl Default for Phyllotaxis {
    fn default() -> Self {
        Self::GOLDEN
    }
}

impl Phyllotaxis {
    /// A spiral at the golden angle, the default.
    pub const GOLDEN: Self = Self::Spiral { divergence: GOLDEN_ANGLE };

    /// Leaves at one node.
    #[must_use]
    pub fn per_node(self) -> u32 {
        match self {
            Self::Spiral { .. } | Self::Distichous => 1,
            Self::Opposite | Self::Decussate => 2,
            Self::Whorled { count } => count.max(1),
        }
    }

    /// Turn from one node to the next in radians.
    #[must_use]
    pub fn divergence(self) -> f32 {
        match self {
            Self::Spiral { divergence } => divergence,
            Self::Distichous => PI,
            Self::Opposite => 0.0,
            Self::Decussate => FRAC_PI_2,
            Self::Whorled { count } => PI / count.max(1) as f32,
        }
    }

    /// Whether all leaves lie in one plane.
    pub(crate) const fn is_flat(self) -> bool {
        matches!(self, Self::Distichous | Self::Opposite)
    }

    /// Checks its numbers; `field` is what it is called by.
    pub(crate) fn validate(self, field: &str) -> Result<()> {
        match self {
            Self::Spiral { divergence } => {
                check(format!("{field}.divergence"), divergence, -2.0 * PI, 2.0 * PI)
            }
            Self::Whorled { count } => check(format!("{field}.count"), count, 3, 64),
            _ => Ok(()),
        }
    }
}
