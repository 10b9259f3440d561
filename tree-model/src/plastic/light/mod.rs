//! How much light reaches a point, and from where (Pirk et al. 2012, section 4.2, Eq. 3).
//!
//! The sky is a hemisphere of intensity cos² of the angle to its brightest point. What stands in the way lets a
//! share of the light through: a leaf cluster its translucency, a solid nothing; shares multiply.
//!
//! The integral is a sum over [`DIRECTIONS`] directions drawn in proportion to the intensity, so each carries the
//! same light. A caster covers a direction not wholly or not at all but by how far it reaches into the direction's
//! share of the sky: the sum follows a moving caster smoothly, and 64 directions do what thousands of rays
//! would ([`crate::plastic`] states the error).

mod convex;
mod sky;
mod veil;

#[cfg(test)]
mod tests;

pub(super) use convex::{Block, Convex, Plane};
pub use sky::Sky;
pub(super) use sky::{Bins, DIRECTIONS, Weights};
pub use veil::Ball;
pub(super) use veil::{may_shade, veil};

use glam::Vec3;

/// The light at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Light {
    /// Share of the open sky's light, 0 to 1.
    pub amount: f32,
    /// Unit vector towards where the light comes from on average; zero where there is none.
    pub direction: Vec3,
}

/// Amounts and directions are multiples of this. What changes them by less changes nothing, so that an edit is felt as
/// far as it matters and not through the whole forest.
pub(super) const STEP: f32 = 1.0 / 256.0;

impl Light {
    /// Sums up what the directions let through.
    pub(super) fn gather(bins: &Bins, through: &Weights) -> Self {
        let mut seen = *through;
        for (seen, weight) in seen.iter_mut().zip(&bins.weight) {
            *seen *= weight;
        }
        let amount = dot(&seen, &[1.0; DIRECTIONS]);
        let towards = Vec3::new(dot(&seen, &bins.x), dot(&seen, &bins.y), dot(&seen, &bins.z));
        let coarse = |value: f32| (value / STEP).round() * STEP;
        let towards = towards.normalize_or_zero();
        let towards = Vec3::new(coarse(towards.x), coarse(towards.y), coarse(towards.z));
        Self { amount: coarse(amount * bins.brightness), direction: towards.normalize_or_zero() }
    }
}

/// Eight sums side by side, which fit vector registers, and always the same order.
fn dot(a: &Weights, b: &Weights) -> f32 {
    let mut sums = [0.0_f32; 8];
    for (a, b) in a.chunks_exact(8).zip(b.chunks_exact(8)) {
        for ((sum, a), b) in sums.iter_mut().zip(a).zip(b) {
            *sum += a * b;
        }
    }
    sums.iter().sum()
}
