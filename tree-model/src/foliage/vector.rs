//! Small vector geometry that leaves and twigs share.

use glam::{Mat3, Quat, Vec3};

/// The largest exponent that [`turn_toward`] tells from an infinite one.
const FULL_TURN: f32 = 40.0;

/// The unit part of `v` across `axis`; `None` when they are nearly parallel.
pub(super) fn across(v: Vec3, axis: Vec3) -> Option<Vec3> {
    let part = v - axis * v.dot(axis);
    if part.length_squared() < 1e-6 { None } else { part.try_normalize() }
}

/// Turns the unit vector `from` towards the unit vector `target` (away from it for a negative
/// `amount`) as a growing or bending shoot turns: the rate is the sine of the angle θ that is left,
/// dθ/ds = -sin θ over 0..amount.
///
/// The exact solution: tan(θ/2) shrinks by the factor exp(-amount). So it never turns past the
/// target, whatever the amount, and a vector straight away from the target stays where it is.
pub(super) fn turn_toward(from: Vec3, target: Vec3, amount: f32) -> Vec3 {
    let (target, amount) = if amount < 0.0 { (-target, -amount) } else { (target, amount) };
    let cos = from.dot(target).clamp(-1.0, 1.0);
    let shrink = libm::expf(-amount.min(FULL_TURN));
    // tan²(θ/2) = (1 - cos θ) / (1 + cos θ), so no trigonometric function is needed.
    let (near, far) = (1.0 + cos, shrink * shrink * (1.0 - cos));
    let sum = near + far;
    if sum < 1e-12 {
        return from;
    }
    let turned = target * (near - far) + (from - target * cos) * (2.0 * shrink);
    (turned / sum).try_normalize().unwrap_or(from)
}

/// The shortest turn from one unit vector to another. Unlike glam's it does not take small angles, of
/// which a shoot has many, for none.
pub(super) fn arc(from: Vec3, to: Vec3) -> Quat {
    let half = 1.0 + from.dot(to);
    if half < 1e-6 {
        return Quat::from_rotation_arc(from, to);
    }
    Quat::from_vec4(from.cross(to).extend(half)).normalize()
}

/// The frame with +Y along `along` and +Z as near to `up` as that allows.
pub(super) fn frame(along: Vec3, up: Vec3) -> Quat {
    let face = across(up, along).unwrap_or_else(|| along.any_orthonormal_vector());
    Quat::from_mat3(&Mat3::from_cols(along.cross(face), along, face)).normalize()
}

/// A turn about +Z that leads +Y towards +X.
pub(super) fn to_the_right(angle: f32) -> Quat {
    Quat::from_rotation_z(-angle)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turning_follows_its_differential_equation() {
        let (mut stepped, target) = (Vec3::new(0.8, 0.6, 0.0), Vec3::NEG_Y);
        for _ in 0..10_000 {
            let sin = stepped.cross(target).length();
            let axis = stepped.cross(target).normalize();
            stepped = Quat::from_axis_angle(axis, 1e-4 * sin) * stepped;
        }
        let exact = turn_toward(Vec3::new(0.8, 0.6, 0.0), target, 1.0);
        assert!(exact.distance(stepped) < 2e-3, "{exact} {stepped}");
    }

    #[test]
    fn turning_ends_at_the_target_and_never_beyond() {
        for amount in [0.0, 0.1, 3.0, 1e9, f32::INFINITY] {
            let turned = turn_toward(Vec3::X, Vec3::Y, amount);
            assert!(turned.is_normalized() && turned.x >= 0.0 && turned.y >= 0.0, "{amount}");
        }
        assert!(turn_toward(Vec3::X, Vec3::Y, f32::INFINITY).distance(Vec3::Y) < 1e-5);
        assert!(turn_toward(Vec3::X, Vec3::Y, -5.0).y < -0.99);
        assert_eq!(turn_toward(Vec3::NEG_Y, Vec3::Y, 2.0), Vec3::NEG_Y);
    }
}
