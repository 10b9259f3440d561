//! Frames in space.

use glam::{Mat3, Quat, Vec2, Vec3};

/// A frame: x across the branch in its plane, y along its span, z out of its plane; and its unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    pub(super) origin: Vec3,
    pub(super) turn: Quat,
    pub(super) scale: f32,
}

impl Frame {
    /// A point of the frame in the frame's own surroundings.
    pub(super) fn point(&self, point: Vec3) -> Vec3 {
        self.origin + self.scale * (self.turn * point)
    }

    /// A frame within this one.
    pub(super) fn then(&self, inner: &Self) -> Self {
        Self {
            origin: self.point(inner.origin),
            turn: (self.turn * inner.turn).normalize(),
            scale: self.scale * inner.scale,
        }
    }
}

/// Directions at a place of a planar axis: along it, and across it at an azimuth. Azimuth 0 is its right side; it turns
/// towards z.
#[derive(Clone, Copy)]
pub(super) struct Around {
    pub(super) along: Vec3,
    pub(super) across: Vec3,
}

impl Around {
    pub(super) fn new(tangent: Vec2, azimuth: f32) -> Self {
        let (sin, cos) = libm::sincosf(azimuth);
        let right = Vec3::new(tangent.y, -tangent.x, 0.0);
        Self { along: tangent.extend(0.0), across: cos * right + sin * Vec3::Z }
    }

    /// The turn of a branch whose span leaves at an angle to the axis.
    pub(super) fn turn(&self, angle: f32) -> Quat {
        let (sin, cos) = libm::sincosf(angle);
        let y = cos * self.along + sin * self.across;
        let x = cos * self.across - sin * self.along;
        Quat::from_mat3(&Mat3::from_cols(x, y, x.cross(y))).normalize()
    }

    /// The turn of a leaf at an angle to the axis: midrib along y, upper face (z) towards the axis' tip.
    pub(super) fn leaf(&self, angle: f32) -> Quat {
        let (sin, cos) = libm::sincosf(angle);
        let y = cos * self.along + sin * self.across;
        let z = sin * self.along - cos * self.across;
        Quat::from_mat3(&Mat3::from_cols(y.cross(z), y, z)).normalize()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_branch_on_the_right_lies_in_the_plane_and_one_at_a_quarter_in_front() {
        let level = std::f32::consts::FRAC_PI_2;
        let right = Around::new(Vec2::Y, 0.0).turn(level);
        assert!((right * Vec3::Y).distance(Vec3::X) < 1e-6);
        assert!((right * Vec3::X).distance(Vec3::NEG_Y) < 1e-6, "the outer side is below");
        assert!((right * Vec3::Z).distance(Vec3::Z) < 1e-6);
        let front = Around::new(Vec2::Y, level).turn(level);
        assert!((front * Vec3::Y).distance(Vec3::Z) < 1e-6);
    }

    #[test]
    fn a_leaf_looks_up_from_a_branch() {
        let leaf = Around::new(Vec2::Y, 0.0).leaf(std::f32::consts::FRAC_PI_2);
        assert!((leaf * Vec3::Y).distance(Vec3::X) < 1e-6);
        assert!((leaf * Vec3::Z).distance(Vec3::Y) < 1e-6);
    }
}
