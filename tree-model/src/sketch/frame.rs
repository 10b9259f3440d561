//! How a segment lies to its parent: length ratio, divergence and roll (Neubert 2012, sections 4.5 and 4.5.2).
//!
//! A frame goes along each axis: the direction of its segment and the *side*, a unit vector across it that points where
//! the axis' last lateral left. From one segment to the next the side is carried without twist. The roll γ of a lateral
//! is its turn about the axis from that side, so γ is the divergence angle of phyllotaxis; laterals of one fork
//! are spread evenly from the first on.
//!
//! Departure: in the thesis the frame turns with the bend of each apical segment, `R_y(γ) R_x(α)`. A straight axis has no
//! bend to turn with, and its frame would be noise. The thesis' own K = 2 (the apical bends away from the lateral)
//! makes both the same where the bend is there.

use glam::DVec3;

/// Turns below this are none: the direction of a shorter vector is rounding.
const TINY: f64 = 1e-12;

/// The angle between two vectors in radians, 0 to π; 0 where one has no length.
pub(super) fn angle(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b))
}

/// An angle brought to −π..π.
pub(super) fn wrapped(angle: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    let turn = angle - TAU * (angle / TAU).round();
    if turn > PI { turn - TAU } else { turn }
}

/// The part of `v` across `axis` (a unit vector), of unit length; `None` where `v` lies along it.
pub(super) fn across(v: DVec3, axis: DVec3) -> Option<DVec3> {
    let part = v - axis * v.dot(axis);
    (part.length_squared() > TINY).then(|| part.normalize())
}

/// Carries `side` from a segment along `from` to one along `to` (unit vectors) by the smallest turn.
pub(super) fn carried(side: DVec3, from: DVec3, to: DVec3) -> DVec3 {
    let cos = from.dot(to);
    if cos < -0.999_999 {
        // Straight back: any half turn is smallest. That about the side leaves it.
        return side;
    }
    let sum = from + to;
    let moved = side - sum * (side.dot(to) / (1.0 + cos));
    across(moved, to).unwrap_or(side)
}

/// The turn about `axis` (a unit vector) from `side` to `v`, right-handed, −π..π.
pub(super) fn roll(axis: DVec3, side: DVec3, v: DVec3) -> f64 {
    libm::atan2(axis.dot(side.cross(v)), side.dot(v) - axis.dot(v) * axis.dot(side))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn a_quarter_turn_about_y_leads_from_z_to_x() {
        let turn = roll(DVec3::Y, DVec3::Z, DVec3::new(2.0, 5.0, 0.0));
        assert!((turn - FRAC_PI_2).abs() < 1e-12, "{turn}");
    }

    #[test]
    fn angles_are_brought_to_half_a_turn_either_way() {
        for (found, right) in [(3.5 * PI, -0.5 * PI), (-7.0, -7.0 + 2.0 * PI), (0.3, 0.3)] {
            assert!((wrapped(found) - right).abs() < 1e-12);
        }
    }

    proptest! {
        #[test]
        fn a_carried_side_stays_across_and_keeps_its_turn_to_the_bend(
            a in prop::array::uniform3(-1.0_f64..1.0), b in prop::array::uniform3(-1.0_f64..1.0),
            c in prop::array::uniform3(-1.0_f64..1.0),
        ) {
            let [a, b, c] = [a, b, c].map(DVec3::from);
            prop_assume!(a.length() > 0.1 && b.length() > 0.1 && a.cross(b).length() > 0.01);
            let (a, b) = (a.normalize(), b.normalize());
            prop_assume!(across(c, a).is_some());
            let side = across(c, a).unwrap();
            let moved = carried(side, a, b);
            prop_assert!(moved.dot(b).abs() < 1e-9);
            prop_assert!((moved.length() - 1.0).abs() < 1e-9);
            // About the common normal nothing turns.
            let normal = a.cross(b).normalize();
            prop_assert!((moved.dot(normal) - side.dot(normal)).abs() < 1e-6);
        }
    }
}
