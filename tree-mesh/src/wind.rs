//! Wind: the branches that vertices move with, in a hierarchy.
//!
//! Every vertex names one [`Branch`] (column `branches` of a surface); everything else an engine
//! packs into its vertices follows from the table, the position and the level.

use glam::Vec3;
use tree_core::{Axes, Skeleton};

/// A branch as the wind sees it: a rod that turns about its pivot, carried by its parent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Branch {
    /// The branch that carries this one; itself for the trunk. Parents come first.
    pub parent: u32,
    /// 0 for the trunk, one more than the parent otherwise.
    pub level: u32,
    /// Where it is attached: the point it turns about, in metres.
    pub pivot: Vec3,
    /// Unit vector from pivot to tip.
    pub axis: Vec3,
    /// Length along its bends in metres.
    pub length: f32,
    /// Radius at the base in metres.
    pub radius: f32,
    /// Where in the swing it starts, 0 to 1: so that branches do not move in step.
    pub phase: f32,
    /// 1 does not give at all, 0 hangs in the wind.
    pub stiffness: f32,
}

/// One branch for each axis of the skeleton, in the same order.
///
/// # Complexity
/// O(nodes).
#[must_use]
pub fn branches(skeleton: &Skeleton, axes: &Axes) -> Vec<Branch> {
    let (positions, radii) = (skeleton.positions(), skeleton.radii());
    axes.iter()
        .map(|axis| {
            let first = axis.nodes.first().copied().unwrap_or(0);
            let fork = skeleton.parent(first).unwrap_or(first);
            let tip = axis.nodes.last().copied().unwrap_or(first);
            let pivot = positions[fork as usize];
            let mut last = pivot;
            let length = axis.nodes.iter().fold(0.0, |sum, &node| {
                let at = positions[node as usize];
                let step = at.distance(last);
                last = at;
                sum + step
            });
            let radius = radii[first as usize];
            Branch {
                parent: axes.axis_of()[fork as usize],
                level: axis.order,
                pivot,
                axis: (positions[tip as usize] - pivot).normalize_or(Vec3::Y),
                length,
                radius,
                phase: phase(axis.index),
                stiffness: if length > 0.0 { (radius / (0.1 * length)).min(1.0) } else { 1.0 },
            }
        })
        .collect()
}

/// The golden ratio's multiples spread evenly over 0 to 1, whatever their number.
fn phase(index: u32) -> f32 {
    index.wrapping_mul(0x9E37_79B9) as f32 / 4_294_967_296.0
}
