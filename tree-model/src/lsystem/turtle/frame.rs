//! Where the turtle looks: three axes at right angles, in f64.

use crate::glam::DVec3;

/// Heading H, left L and up U of the turtle, a right-handed triple: H × L = U (ABOP, section 1.5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frame {
    pub(crate) heading: DVec3,
    pub(crate) left: DVec3,
    pub(crate) up: DVec3,
}

/// Sine and cosine of an angle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn {
    pub(crate) sin: f64,
    pub(crate) cos: f64,
}

/// Below this sine of the angle to the vertical there is no horizontal direction to roll to.
const VERTICAL: f64 = 1e-9;

impl Frame {
    /// Upright, seen from +Z: the left is −X, and the turtle's back looks at the viewer.
    pub(crate) const START: Self = Self { heading: DVec3::Y, left: DVec3::NEG_X, up: DVec3::Z };

    /// `+`: turns left, about U.
    #[inline]
    pub(crate) fn yaw(&mut self, turn: Turn) {
        let (heading, left) = (self.heading, self.left);
        self.heading = turn.cos * heading + turn.sin * left;
        self.left = turn.cos * left - turn.sin * heading;
    }

    /// `&`: pitches down, about L.
    #[inline]
    pub(crate) fn pitch(&mut self, turn: Turn) {
        let (heading, up) = (self.heading, self.up);
        self.heading = turn.cos * heading - turn.sin * up;
        self.up = turn.cos * up + turn.sin * heading;
    }

    /// `\`: rolls about H, left over up.
    #[inline]
    pub(crate) fn roll(&mut self, turn: Turn) {
        let (left, up) = (self.left, self.up);
        self.left = turn.cos * left + turn.sin * up;
        self.up = turn.cos * up - turn.sin * left;
    }

    /// `|`: turns round, about U.
    #[inline]
    pub(crate) fn around(&mut self) {
        self.heading = -self.heading;
        self.left = -self.left;
    }

    /// `$`: rolls until L is horizontal and the back looks up (ABOP, p. 57). A vertical heading stays.
    pub(crate) fn level(&mut self) {
        let side = DVec3::Y.cross(self.heading);
        let length = side.length();
        if length > VERTICAL {
            self.left = side / length;
            self.up = self.heading.cross(self.left);
        }
    }

    /// Bends towards `tropism` by the angle e |H × T| (ABOP, p. 58).
    pub(crate) fn bend(&mut self, tropism: DVec3, elasticity: f64) {
        let torque = self.heading.cross(tropism);
        let size = torque.length();
        if size <= 0.0 || elasticity == 0.0 {
            return;
        }
        let (axis, turn) = (torque / size, Turn::radians(elasticity * size));
        for vector in [&mut self.heading, &mut self.left, &mut self.up] {
            let v = *vector;
            *vector =
                turn.cos * v + turn.sin * axis.cross(v) + (1.0 - turn.cos) * axis.dot(v) * axis;
        }
    }
}

impl Turn {
    pub(crate) fn radians(angle: f64) -> Self {
        let (sin, cos) = libm::sincos(angle);
        Self { sin, cos }
    }

    /// Right angles are exact, so that rectangular curves stay on their grid.
    pub(crate) fn degrees(angle: f64) -> Self {
        let rest = libm::fmod(angle, 360.0);
        match rest {
            0.0 => Self { sin: 0.0, cos: 1.0 },
            90.0 | -270.0 => Self { sin: 1.0, cos: 0.0 },
            180.0 | -180.0 => Self { sin: 0.0, cos: -1.0 },
            270.0 | -90.0 => Self { sin: -1.0, cos: 0.0 },
            _ => Self::radians(rest.to_radians()),
        }
    }

    #[inline]
    pub(crate) fn back(self) -> Self {
        Self { sin: -self.sin, cos: self.cos }
    }
}

/// Remembers the turns of angles: a word has few different ones.
#[derive(Debug)]
pub(super) struct Turns {
    slots: Vec<(u64, Turn)>,
}

/// Angles remembered at a time; a power of 2.
const SLOTS: usize = 256;
/// Spreads the bits of an angle over the slots (the golden ratio times 2⁶⁴).
const SPREAD: u64 = 0x9e37_79b9_7f4a_7c15;

impl Turns {
    pub(super) fn new() -> Self {
        Self { slots: vec![(0, Turn::degrees(0.0)); SLOTS] }
    }

    #[inline]
    pub(super) fn degrees(&mut self, angle: f64) -> Turn {
        let bits = angle.to_bits();
        let slot = &mut self.slots[(bits.wrapping_mul(SPREAD) >> 56) as usize];
        if slot.0 != bits {
            *slot = (bits, Turn::degrees(angle));
        }
        slot.1
    }
}
