//! Rotations that turn a frame where it should look, and numbers with few decimals.

use crate::glam::DVec3;
use crate::lsystem::turtle::frame::{Frame, Turn};

/// `+(yaw)` and then `&(pitch)` in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Aim {
    pub(super) yaw: f64,
    pub(super) pitch: f64,
}

impl Aim {
    /// The pair that turns the frame's heading onto a direction.
    pub(super) fn at(frame: &Frame, direction: DVec3) -> Self {
        let h = direction.dot(frame.heading);
        let l = direction.dot(frame.left);
        let u = direction.dot(frame.up);
        let flat = libm::hypot(h, l);
        // Straight along U any yaw will do.
        let yaw = if flat > 0.0 { libm::atan2(l, h).to_degrees() } else { 0.0 };
        Self { yaw, pitch: libm::atan2(-u, flat).to_degrees() }
    }

    pub(super) fn rounded(self, step: f64) -> Self {
        Self { yaw: round(self.yaw, step), pitch: round(self.pitch, step) }
    }

    pub(super) fn turn(self, frame: &mut Frame) {
        frame.yaw(Turn::degrees(self.yaw));
        frame.pitch(Turn::degrees(self.pitch));
    }
}

/// The roll `\` in degrees after which a frame's up looks along `up`.
pub(super) fn roll(frame: &Frame, up: DVec3) -> f64 {
    libm::atan2(-up.dot(frame.left), up.dot(frame.up)).to_degrees()
}

/// Fewest decimals tried and most.
const DECIMALS: i32 = 15;

/// The number with as few decimals as keep it within half a `step`; itself where `step` is 0.
pub(super) fn round(value: f64, step: f64) -> f64 {
    if step.is_nan() || step <= 0.0 {
        return value;
    }
    let decimals = (-libm::floor(libm::log10(step)) as i32).min(DECIMALS);
    if decimals <= 0 {
        return libm::round(value);
    }
    // Dividing by a power of ten gives the f64 nearest to the decimal, which is written short.
    let power = libm::pow(10.0, f64::from(decimals));
    // Adding 0 makes -0 a plain 0.
    libm::round(value * power) / power + 0.0
}
