//! Boxes along the branches: which leaves are seen as one (Lluch et al. 2010, §4.2.1 and §4.2.4).
//!
//! 1. [`Bearers`]: which node of the skeleton carries each leaf.
//! 2. `grow`: going up from the root, a subtree gets a box when its volume is a good deal smaller than that
//!    of the box it is in, yet not tiny; up to a number of levels. What gets none stays with the box it is
//!    in, as its *own* leaves.
//!    Leaves whose branches are all too small for a box of their own are put together by place.
//! 3. `fit`: the box of a branch has the frame of a turtle at its base: heading, left, up.
//! 4. Leaves are brought into an order in which those of each box are one range.
//!
//! Departures: the paper opens a box at every PUSH. Where a fork goes on as nearly the same crown that gives
//! chains of boxes with nearly the same content, so here a child must be smaller than a share
//! ([`BoxParams::most_volume`]). It leaves what is on small branches to the larger box, which draws it as
//! geometry once it opens: most of a fern, or of a crown of many equal twigs. The heading is that from the base to the middle of the leaves: that of the
//! first segment is mostly noise.
//!
//! Cost: O(nodes + leaves × levels).

mod bearer;
mod fit;
mod grow;
#[cfg(test)]
mod tests;

pub use bearer::Bearers;
pub use grow::BoxParams;

use crate::error::{LodError, Result};
use glam::{Quat, Vec3};
use std::ops::Range;

/// No parent: the box of the whole tree.
pub const NO_BOX: u32 = u32::MAX;

/// The box of a branch with all its leaves.
#[derive(Clone, Debug, PartialEq)]
pub struct LeafBox {
    /// The box it is in, or [`NO_BOX`].
    pub parent: u32,
    /// 0 for the whole tree.
    pub level: u32,
    /// The node of the skeleton it begins at; of leaves that are put together by place, that of the box they are
    /// in.
    pub node: u32,
    /// Middle in metres.
    pub center: Vec3,
    /// Half the sides in metres, along its own axes; none is 0.
    pub half: Vec3,
    /// Turns its own axes into those of the tree: x to the left of the branch, y along it, z up.
    pub turn: Quat,
    /// Rows of [`Boxes::order`]: all leaves in it, those of its children included.
    pub leaves: Range<u32>,
    /// Rows of [`Boxes::order`]: leaves that are in no child. They begin where `leaves` does.
    pub own: Range<u32>,
    /// First of its children, which lie one after another, and their number.
    pub children: Range<u32>,
}

impl LeafBox {
    /// Volume in m³.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.half.to_array().iter().map(|&half| 2.0 * f64::from(half)).product()
    }

    /// Distance in metres from a point to the box, 0 inside.
    #[must_use]
    pub fn distance(&self, point: Vec3) -> f32 {
        let local = self.turn.inverse() * (point - self.center);
        (local.abs() - self.half).max(Vec3::ZERO).length()
    }
}

/// A tree of boxes: parents come before children, siblings lie side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct Boxes {
    boxes: Vec<LeafBox>,
    order: Vec<u32>,
    report: BoxReport,
}

/// What became of the leaves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct BoxReport {
    /// Number of boxes.
    pub n_boxes: usize,
    /// Number of levels, the whole tree being one.
    pub n_levels: usize,
    /// Leaves in all.
    pub n_leaves: usize,
    /// Leaves that are in no box but that of the whole tree.
    pub n_in_root_only: usize,
    /// Branches that got no box because it would have been too small.
    pub n_dropped: usize,
}

impl Boxes {
    /// The boxes, that of the whole tree first.
    #[must_use]
    pub fn boxes(&self) -> &[LeafBox] {
        &self.boxes
    }

    /// Numbers of leaves (elements), in the order in which every box has one range.
    #[must_use]
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// What became of the leaves.
    #[must_use]
    pub fn report(&self) -> BoxReport {
        self.report
    }

    /// The leaves of a range of rows; empty when the range is not within the order.
    #[must_use]
    pub fn leaves(&self, rows: Range<u32>) -> &[u32] {
        self.order.get(rows.start as usize..rows.end as usize).unwrap_or(&[])
    }

    /// Box `number`.
    ///
    /// # Errors
    /// [`LodError::Impostor`] when there is none.
    pub fn get(&self, number: u32) -> Result<&LeafBox> {
        let none = LodError::Impostor("there is no box of this number");
        self.boxes.get(number as usize).ok_or(none)
    }
}
