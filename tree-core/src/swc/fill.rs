//! Radii for nodes that have none.

use crate::error::Result;
use crate::skeleton::Skeleton;

/// What is known of the radii above a node; for a node whose radius is known, that radius.
#[derive(Clone, Copy, Debug, Default)]
struct Above {
    /// The thickest of the nearest known radii, 0 where none is known.
    radius: f32,
    /// Path length to it in metres.
    distance: f32,
}

/// See [`UnknownRadius::Interpolate`](super::UnknownRadius::Interpolate).
///
/// One pass down gathers what is known above every node, one pass up fills: O(nodes).
pub(super) fn interpolate(skeleton: &mut Skeleton) -> Result<()> {
    let lengths = skeleton.segment_lengths();
    let mut radii = skeleton.radii().to_vec();
    let mut above = vec![Above::default(); skeleton.len()];
    for (node, &radius) in radii.iter().enumerate().rev() {
        if radius > 0.0 {
            above[node] = Above { radius, distance: 0.0 };
        }
        if let Some(parent) = skeleton.parent(node as u32) {
            // Of several the thickest, as it is the one that continues the axis.
            let from_parent = Above {
                radius: above[node].radius,
                distance: above[node].distance + lengths[node],
            };
            let best = &mut above[parent as usize];
            if from_parent.radius > best.radius {
                *best = from_parent;
            }
        }
    }
    for node in 0..radii.len() {
        if radii[node] > 0.0 {
            continue;
        }
        let below = skeleton.parent(node as u32).map_or(0.0, |parent| radii[parent as usize]);
        let Above { radius, distance } = above[node];
        radii[node] = if radius == 0.0 {
            below
        } else if below == 0.0 {
            radius
        } else {
            // The share of the way from the parent to the known radius that lies behind; half way
            // where there is no way, or where it is too long for an f32.
            let share = lengths[node] / (lengths[node] + distance);
            let share = if share.is_finite() { share } else { 0.5 };
            below + (radius - below) * share
        };
    }
    skeleton.set_radii(radii)
}
