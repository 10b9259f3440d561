//! The whole of what was drawn.

use super::{Lateral, System};
use crate::silhouette::outline::LeafOutline;

/// A leaf as it was drawn.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct DrawnLeaf {
    /// Its outline, one long.
    pub outline: LeafOutline,
    /// Its length in metres.
    pub length: f32,
}

/// A tree in the plane, level in level.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Plan {
    /// Trunk, crown and main branches.
    pub system: System,
    /// The leaf, where one was drawn.
    pub leaf: Option<DrawnLeaf>,
    /// Branches of other trees, with their systems, whose styles this one may copy.
    pub lenders: Vec<Lateral>,
}

impl Plan {
    /// How many levels of outlines were drawn: 1 for the crown only, 2 with that of a branch, and so on.
    #[must_use]
    pub fn n_levels(&self) -> u32 {
        let lent = self.lenders.iter().filter_map(|lateral| lateral.system.as_deref());
        depth(&self.system).max(1 + lent.map(depth).max().unwrap_or(0))
    }
}

fn depth(system: &System) -> u32 {
    let below = system.laterals.iter().filter_map(|lateral| lateral.system.as_deref());
    1 + below.map(depth).max().unwrap_or(0)
}
