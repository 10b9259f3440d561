//! Numbers in 8 and 16 bits, as `KHR_mesh_quantization` allows.
//!
//! Positions are unsigned fractions of a cube around the mesh, whose corner and side become the
//! translation and scale of the node: one scale for all axes, so that normals stay as they are.

use glam::{Vec2, Vec3};
use tree_core::Aabb;

/// The cube whose fractions positions are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cube {
    pub(super) corner: Vec3,
    pub(super) side: f32,
}

impl Cube {
    pub(super) fn around(bounds: Aabb) -> Self {
        let side = bounds.size().max_element();
        let corner = if bounds.is_empty() { Vec3::ZERO } else { bounds.min };
        // A side of 0 would leave nothing to divide by, one that overflows nothing to multiply with.
        Self { corner, side: if side > 0.0 { side.min(f32::MAX) } else { 1.0 } }
    }

    pub(super) fn fraction(&self, position: Vec3) -> [u16; 3] {
        let axis = |value: f32, from: f32| {
            unsigned16((f64::from(value) - f64::from(from)) / f64::from(self.side))
        };
        [
            axis(position.x, self.corner.x),
            axis(position.y, self.corner.y),
            axis(position.z, self.corner.z),
        ]
    }
}

/// The rectangle whose fractions texture coordinates are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct UvRange {
    pub(super) offset: Vec2,
    pub(super) scale: Vec2,
}

impl UvRange {
    const UNIT: Self = Self { offset: Vec2::ZERO, scale: Vec2::ONE };

    /// The unit square where that holds all, what is in use otherwise.
    pub(super) fn around(uvs: &[Vec2]) -> Self {
        let min = uvs.iter().fold(Vec2::INFINITY, |min, &uv| min.min(uv));
        let max = uvs.iter().fold(Vec2::NEG_INFINITY, |max, &uv| max.max(uv));
        if min.cmpge(Vec2::ZERO).all() && max.cmple(Vec2::ONE).all() || uvs.is_empty() {
            return Self::UNIT;
        }
        let size = max - min;
        let side = |size: f32| if size > 0.0 { size.min(f32::MAX) } else { 1.0 };
        Self { offset: min, scale: Vec2::new(side(size.x), side(size.y)) }
    }

    pub(super) fn is_unit(&self) -> bool {
        *self == Self::UNIT
    }

    pub(super) fn fraction(&self, uv: Vec2) -> [u16; 2] {
        let axis = |value: f32, offset: f32, scale: f32| {
            unsigned16((f64::from(value) - f64::from(offset)) / f64::from(scale))
        };
        [axis(uv.x, self.offset.x, self.scale.x), axis(uv.y, self.offset.y, self.scale.y)]
    }
}

/// 0 to 1 as 0 to 65,535.
fn unsigned16(value: f64) -> u16 {
    (value * 65_535.0 + 0.5) as u16
}

/// 0 to 1 as 0 to 255.
pub(super) fn unsigned8(value: f32) -> u8 {
    (value * 255.0 + 0.5) as u8
}

/// −1 to 1 as −127 to 127.
pub(super) fn signed8(value: f32) -> i8 {
    libm::roundf(value * 127.0) as i8
}

/// −1 to 1 as −32,767 to 32,767.
pub(super) fn signed16(value: f32) -> i16 {
    libm::roundf(value * 32_767.0) as i16
}
