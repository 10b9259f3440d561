//! The angles at which laterals leave their axes.

use super::{length_below, place};
use crate::skeleton::{Axes, Continuation, Skeleton};
use glam::DVec3;

/// How far one lateral turns away from its parent axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LateralAngle {
    /// First node of the lateral, the one above the fork.
    pub node: u32,
    /// Between the axis below the fork and the lateral, in radians from 0 to π.
    pub angle: f32,
}

/// The angle of every lateral, in the order of axes; `rule` says what is axis and what lateral.
///
/// Both directions are chords: of the parent axis from `reach` metres below the fork to the fork, of the lateral
/// from the fork to `reach` metres along it. A chord is cut short where the axis begins or ends. With a reach of 0
/// the chords are the segments next to the fork; measured skeletons are rough there and want a reach of a few
/// diameters. Laterals at the root, which has nothing below, and those without length are left out.
///
/// # Complexity
/// O(nodes + laterals × nodes within reach).
#[must_use]
pub fn lateral_angles(skeleton: &Skeleton, rule: Continuation, reach: f32) -> Vec<LateralAngle> {
    let axes = skeleton.axes(rule);
    let reach = f64::from(reach.max(0.0));
    let angle = |nodes: &[u32]| {
        let &node = nodes.first()?;
        let fork = skeleton.parent(node)?;
        let below = place(skeleton, fork) - start_below(skeleton, &axes, fork, reach);
        let along = end_above(skeleton, nodes, reach) - place(skeleton, fork);
        let (below, along) = (below.try_normalize()?, along.try_normalize()?);
        let angle = libm::atan2(below.cross(along).length(), below.dot(along)) as f32;
        Some(LateralAngle { node, angle })
    };
    axes.iter().skip(1).filter_map(|axis| angle(axis.nodes)).collect()
}

/// The point `reach` metres below a fork on its own axis, or the axis's start.
fn start_below(skeleton: &Skeleton, axes: &Axes, fork: u32, reach: f64) -> DVec3 {
    let axis_of = |node: u32| axes.axis_of().get(node as usize);
    let (mut at, mut left) = (fork, reach);
    while let Some(below) = skeleton.parent(at) {
        let length = length_below(skeleton, at);
        // A step without length leads on.
        if length > 0.0 && length >= left {
            return towards(skeleton, at, below, left, length);
        }
        left -= length;
        let leaves_axis = axis_of(below) != axis_of(at);
        at = below;
        if leaves_axis {
            break;
        }
    }
    place(skeleton, at)
}

/// The point `reach` metres along an axis from the fork below it, or its tip.
fn end_above(skeleton: &Skeleton, nodes: &[u32], reach: f64) -> DVec3 {
    let mut left = reach;
    for &node in nodes {
        let length = length_below(skeleton, node);
        if let Some(below) = skeleton.parent(node)
            && length > 0.0
            && length >= left
        {
            return towards(skeleton, below, node, left, length);
        }
        left -= length;
    }
    place(skeleton, nodes.last().copied().unwrap_or(0))
}

/// The point `way` metres from one node to another that is `length` away; the other node itself for no way.
fn towards(skeleton: &Skeleton, from: u32, to: u32, way: f64, length: f64) -> DVec3 {
    let share = if way > 0.0 { way / length } else { 1.0 };
    place(skeleton, from).lerp(place(skeleton, to), share)
}
