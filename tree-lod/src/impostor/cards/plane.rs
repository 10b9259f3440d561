//! The six planes through opposite edges of a box.

use super::PLANES;
use crate::impostor::boxes::LeafBox;
use glam::{Vec2, Vec3};

/// A rectangle on which leaves are projected.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Its middle, that of the box, in metres.
    pub center: Vec3,
    /// Unit vector to the right of the picture: along the diagonal of a side of the box.
    pub right: Vec3,
    /// Unit vector up the picture: along an axis of the box.
    pub up: Vec3,
    /// Unit normal, to the viewer.
    pub normal: Vec3,
    /// Half width and half height in metres.
    pub half: Vec2,
    /// Half the depth of the box across the plane, in metres.
    pub reach: f32,
}

/// The planes of a box: two for each of its axes, which lies in both. Plane 2·k holds axis k and the
/// diagonal of the next two axes, plane 2·k + 1 the other diagonal.
#[must_use]
pub fn planes(leaf_box: &LeafBox) -> [Plane; PLANES] {
    let axes = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| leaf_box.turn * axis);
    let half = leaf_box.half.to_array();
    std::array::from_fn(|number| {
        let (a, b, c) = (number / 2, (number / 2 + 1) % 3, (number / 2 + 2) % 3);
        let sign = if number.is_multiple_of(2) { 1.0 } else { -1.0 };
        let diagonal = axes[b] * half[b] + axes[c] * (sign * half[c]);
        let length = diagonal.length();
        let (right, up) = (diagonal / length, axes[a]);
        Plane {
            center: leaf_box.center,
            right,
            up,
            normal: right.cross(up),
            half: Vec2::new(length, half[a]),
            // The corners off the plane.
            reach: 2.0 * half[b] * half[c] / length,
        }
    })
}
