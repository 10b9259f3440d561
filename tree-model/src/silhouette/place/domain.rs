//! Positions on the unrolled surface of a parent branch, and where each may be (sections 5.2 and 5.3).

use crate::error::{Result, check};
use std::f32::consts::{FRAC_PI_4, PI, TAU};

/// Azimuths are at most this many radians, either way: beyond, an f32 no longer tells degrees apart.
const FARTHEST: f32 = 1e3;

/// What an f32 loses of an azimuth, in radians.
const ROUNDING: f32 = 1e-5;

/// How far a drawn branch may turn out of the drawing plane, in radians (section 5.3): 45°.
pub const DRAWN_SPREAD: f32 = FRAC_PI_4;

/// Where a branch stands on its parent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Site {
    /// Share of the parent's length, 0 to 1.
    pub along: f32,
    /// Azimuth round the parent in radians, 0 to 2π. 0 is the right side of the drawing.
    pub azimuth: f32,
    /// The node it stands at, counted from the parent's base; without a pattern its rank along the parent.
    pub node: u32,
}

/// Where a branch may stand.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Domain {
    /// Lowest and highest share of the parent's length, 0 to 1. Equal where the place is given.
    pub along: [f32; 2],
    /// First and last azimuth in radians, in the sense that azimuth turns; the last may be less than the first (the
    /// domain then passes 2π). 2π or more apart is all round.
    pub azimuth: [f32; 2],
}

impl Default for Domain {
    /// The whole cylinder.
    fn default() -> Self {
        Self { along: [0.0, 1.0], azimuth: [0.0, TAU] }
    }
}

impl Domain {
    /// Of a drawn branch: at `along`, and within 45° of the side it was drawn on.
    #[must_use]
    pub fn drawn(along: f32, left: bool) -> Self {
        let side = if left { PI } else { 0.0 };
        Self { along: [along; 2], azimuth: [side - DRAWN_SPREAD, side + DRAWN_SPREAD] }
    }

    /// Of a branch whose place is known.
    #[must_use]
    pub fn at(along: f32, azimuth: f32) -> Self {
        Self { along: [along; 2], azimuth: [azimuth; 2] }
    }

    /// Width in azimuth in radians, 0 to 2π.
    #[must_use]
    pub fn width(&self) -> f32 {
        let width = self.azimuth[1] - self.azimuth[0];
        if width >= TAU { TAU } else { width.rem_euclid(TAU) }
    }

    /// Whether a place lies in it, to the rounding of an azimuth.
    #[must_use]
    pub fn contains(&self, along: f32, azimuth: f32) -> bool {
        let past = (azimuth - self.azimuth[0] + ROUNDING).rem_euclid(TAU);
        (self.along[0]..=self.along[1]).contains(&along) && past <= self.width() + 2.0 * ROUNDING
    }

    /// How far an azimuth lies outside it, in radians, 0 to π. O(1).
    #[must_use]
    pub fn outside(&self, azimuth: f32) -> f32 {
        let (past, width) = ((azimuth - self.azimuth[0]).rem_euclid(TAU), self.width());
        if past <= width { 0.0 } else { (past - width).min(TAU - past) }
    }

    /// The azimuth in it that is nearest to another, 0 to 2π.
    pub(super) fn nearest(&self, azimuth: f32) -> f32 {
        let (past, width) = ((azimuth - self.azimuth[0]).rem_euclid(TAU), self.width());
        let kept = if past <= width {
            azimuth
        } else if past - width < TAU - past {
            self.azimuth[1]
        } else {
            self.azimuth[0]
        };
        in_turn(kept)
    }

    /// Whether there is but one place in it.
    pub(super) fn is_point(&self) -> bool {
        self.along[0] == self.along[1] && self.width() == 0.0
    }

    /// Checks that it is one.
    pub(super) fn validate(&self, index: usize) -> Result<()> {
        let [low, high] = self.along;
        check(format!("domains[{index}].along[0]"), low, 0.0, 1.0)?;
        check(format!("domains[{index}].along[1]"), high, low, 1.0)?;
        for (end, azimuth) in self.azimuth.into_iter().enumerate() {
            check(format!("domains[{index}].azimuth[{end}]"), azimuth, -FARTHEST, FARTHEST)?;
        }
        Ok(())
    }
}

/// The same azimuth, 0 to below 2π.
pub(super) fn in_turn(azimuth: f32) -> f32 {
    let turned = azimuth.rem_euclid(TAU);
    // The remainder of a tiny negative number rounds to 2π itself.
    if turned < TAU { turned } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_domain_may_pass_the_end_of_the_turn() {
        let right = Domain::drawn(0.5, false);
        assert!(right.contains(0.5, 0.1) && right.contains(0.5, TAU - 0.1));
        assert!(!right.contains(0.5, 1.0) && !right.contains(0.4, 0.0));
        assert!((right.outside(PI) - 0.75 * PI).abs() < 1e-5);
        assert!((right.nearest(1.0) - FRAC_PI_4).abs() < 1e-6);
        assert!((right.nearest(-1.0) - (TAU - FRAC_PI_4)).abs() < 1e-6);
    }

    #[test]
    fn the_whole_cylinder_holds_every_azimuth() {
        let whole = Domain::default();
        assert!((0..100).all(|i| whole.contains(0.3, i as f32) && whole.outside(i as f32) == 0.0));
    }

    #[test]
    fn domains_that_are_none_are_refused() {
        for along in [[-0.1, 0.5], [0.6, 0.5], [0.0, 1.1], [f32::NAN, 1.0], [0.0, f32::NAN]] {
            assert!(Domain { along, ..Domain::default() }.validate(0).is_err());
        }
        assert!(Domain { azimuth: [0.0, f32::INFINITY], ..Domain::default() }.validate(0).is_err());
    }
}
