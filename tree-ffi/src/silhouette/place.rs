//! How branches are arranged round their parent.

use crate::border::{Failure, Result};
use tree_model::silhouette::place::Arrangement;

/// A pattern of branches round their parent: a `TREE_ARRANGEMENT_` constant.
pub type tree_arrangement_kind = u32;

/// Evenly over length and azimuth, without a pattern. The default.
pub const TREE_ARRANGEMENT_SPREAD: u32 = 0;
/// One at a node, each turned against the last by `angle`.
pub const TREE_ARRANGEMENT_SPIRAL: u32 = 1;
/// Two at a node, all pairs in one plane.
pub const TREE_ARRANGEMENT_OPPOSITE: u32 = 2;
/// Two at a node, each pair across the last.
pub const TREE_ARRANGEMENT_DECUSSATE: u32 = 3;
/// `per_node` at a node, each whorl turned against the last by `angle`.
pub const TREE_ARRANGEMENT_WHORLED: u32 = 4;
/// Two at a node, all in the horizontal plane, which lies at the azimuth `angle`.
pub const TREE_ARRANGEMENT_HORIZONTAL: u32 = 5;
/// Any other: `per_node` at a node, each node turned against the last by `angle`.
pub const TREE_ARRANGEMENT_CUSTOM: u32 = 6;

/// How branches are arranged round their parent: in the paper's terms n:φ. A part of other structs; zeros are
/// `TREE_ARRANGEMENT_SPREAD`. `tree_arrangement_from_text` fills one in by name.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct tree_arrangement {
    /// Which pattern.
    pub kind: tree_arrangement_kind,
    /// Branches at a node, 1 to 64; read for whorls and custom patterns.
    pub per_node: u32,
    /// In radians, -2π to 2π: the turn from a node to the next of spirals, whorls and custom patterns, the azimuth
    /// of horizontal pairs.
    pub angle: f32,
}

impl tree_arrangement {
    pub(crate) fn of(arrangement: &Arrangement) -> Self {
        let of = |kind, angle| Self { kind, per_node: arrangement.per_node(), angle };
        match *arrangement {
            Arrangement::Spread => of(TREE_ARRANGEMENT_SPREAD, 0.0),
            Arrangement::Spiral { divergence } => of(TREE_ARRANGEMENT_SPIRAL, divergence),
            Arrangement::Opposite => of(TREE_ARRANGEMENT_OPPOSITE, 0.0),
            Arrangement::Decussate => of(TREE_ARRANGEMENT_DECUSSATE, arrangement.turn()),
            Arrangement::Whorled { turn, .. } => of(TREE_ARRANGEMENT_WHORLED, turn),
            Arrangement::HorizontalDecussate { azimuth } => {
                of(TREE_ARRANGEMENT_HORIZONTAL, azimuth)
            }
            Arrangement::Custom { turn, .. } => of(TREE_ARRANGEMENT_CUSTOM, turn),
        }
    }

    /// `argument` is the field that holds it.
    pub(crate) fn rust(&self, argument: &str) -> Result<Arrangement> {
        let Self { kind, per_node, angle } = *self;
        Ok(match kind {
            TREE_ARRANGEMENT_SPREAD => Arrangement::Spread,
            TREE_ARRANGEMENT_SPIRAL => Arrangement::Spiral { divergence: angle },
            TREE_ARRANGEMENT_OPPOSITE => Arrangement::Opposite,
            TREE_ARRANGEMENT_DECUSSATE => Arrangement::Decussate,
            TREE_ARRANGEMENT_WHORLED => Arrangement::Whorled { per_node, turn: angle },
            TREE_ARRANGEMENT_HORIZONTAL => Arrangement::HorizontalDecussate { azimuth: angle },
            TREE_ARRANGEMENT_CUSTOM => Arrangement::Custom { per_node, turn: angle },
            other => {
                let name = format!("{argument}.kind");
                return Err(Failure::not_one_of(&name, other, "TREE_ARRANGEMENT_"));
            }
        })
    }
}
