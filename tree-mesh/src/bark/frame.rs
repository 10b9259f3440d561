//! Frames that follow a curve without twisting about it.
//!
//! The double reflection method of Wang, Jüttler, Zheng and Liu, "Computation of Rotation Minimizing
//! Frames", ACM Transactions on Graphics 27(1), 2008: a frame is carried to the next point by two
//! mirrors, (1) one that maps this point onto the next, (2) one that maps the mirrored tangent onto
//! the next tangent. Fourth-order accurate, O(1) a step, no angle is ever computed.
//!
//! Departure: the result is made orthogonal again at every step. Without a step both mirrors are left
//! out, at an exact turn back the second.

use glam::Vec3;

/// Squared length under which a mirror has no direction. Points are at least a micrometre apart.
const MIRROR_MIN: f32 = 1e-20;
/// Length of the part of a hint across the tangent under which the hint is of no use.
const HINT_MIN: f32 = 0.05;

/// A unit tangent and a unit normal at right angles to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frame {
    pub(crate) tangent: Vec3,
    pub(crate) normal: Vec3,
}

impl Frame {
    /// A frame at the start of a curve. The normal lies as near to `hint` as it can.
    pub(crate) fn new(tangent: Vec3, hint: Vec3) -> Self {
        let across = hint - tangent * tangent.dot(hint);
        let normal = if across.length() > HINT_MIN {
            across.normalize()
        } else {
            tangent.any_orthonormal_vector()
        };
        Self { tangent, normal }
    }

    /// The third direction: `tangent × normal`. Turning from normal to binormal is
    /// counter-clockwise seen against the tangent.
    pub(crate) fn binormal(&self) -> Vec3 {
        self.tangent.cross(self.normal)
    }

    /// The frame after a `step` of the curve, where its unit tangent is `tangent`. Without a step the
    /// frame is only tilted: one mirror alone would turn it over.
    pub(crate) fn advance(&self, step: Vec3, tangent: Vec3) -> Self {
        let mut normal = self.normal;
        let squared = step.length_squared();
        if squared > MIRROR_MIN {
            normal -= step * (2.0 / squared * step.dot(normal));
            let carried = self.tangent - step * (2.0 / squared * step.dot(self.tangent));
            let mirror = tangent - carried;
            let squared = mirror.length_squared();
            if squared > MIRROR_MIN {
                normal -= mirror * (2.0 / squared * mirror.dot(normal));
            }
        }
        let across = normal - tangent * tangent.dot(normal);
        let normal = across.try_normalize().unwrap_or_else(|| tangent.any_orthonormal_vector());
        Self { tangent, normal }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_stay_orthonormal_and_planar_curves_do_not_twist() {
        // A quarter circle in the XY plane: the normal across the plane must stay put.
        let at = |i: u32| {
            let angle = std::f32::consts::FRAC_PI_2 * i as f32 / 20.0;
            let (sin, cos) = (libm::sinf(angle), libm::cosf(angle));
            (Vec3::new(sin, 1.0 - cos, 0.0), Vec3::new(cos, sin, 0.0))
        };
        let mut frame = Frame::new(at(0).1, Vec3::Z);
        for i in 1..=20 {
            frame = frame.advance(at(i).0 - at(i - 1).0, at(i).1);
            assert!((frame.normal - Vec3::Z).length() < 1e-5, "{frame:?}");
            assert!(frame.normal.dot(frame.tangent).abs() < 1e-6);
        }
    }

    #[test]
    fn a_helix_comes_back_with_the_angle_theory_gives() {
        // A helix of radius a and rise b per radian has torsion b/(a²+b²); after a turn of
        // arc length 2π√(a²+b²) the frame has turned by minus the total torsion against Frenet's.
        let (a, b, n) = (1.0_f32, 0.5_f32, 400);
        let c = (a * a + b * b).sqrt();
        let at = |i: u32| {
            let angle = std::f32::consts::TAU * i as f32 / n as f32;
            let (sin, cos) = (libm::sinf(angle), libm::cosf(angle));
            let position = Vec3::new(a * cos, a * sin, b * angle);
            (position, Vec3::new(-a * sin, a * cos, b) / c)
        };
        let start = Frame::new(at(0).1, -Vec3::X);
        let mut frame = start;
        for i in 1..=n {
            frame = frame.advance(at(i).0 - at(i - 1).0, at(i).1);
        }
        let turned =
            libm::atan2f(frame.normal.dot(start.binormal()), frame.normal.dot(start.normal));
        let expected = -std::f32::consts::TAU * b / c;
        let difference = libm::remainderf(turned - expected, std::f32::consts::TAU);
        assert!(difference.abs() < 1e-3, "{turned} against {expected}");
    }

    #[test]
    fn no_length_and_exact_turns_back_give_frames_still() {
        let frame = Frame::new(Vec3::Y, Vec3::Y);
        for (step, tangent) in [
            (Vec3::ZERO, Vec3::Y),
            (Vec3::ZERO, -Vec3::Y),
            (Vec3::Y, -Vec3::Y),
            (-Vec3::Y, Vec3::X),
        ] {
            let next = frame.advance(step, tangent);
            assert!((next.normal.length() - 1.0).abs() < 1e-5);
            assert!(next.normal.dot(tangent).abs() < 1e-5);
        }
    }
}
