//! Bending towards the light and against gravity, and what a branch would be without it (Pirk et al. 2012, section 4.3).

use glam::Vec3;

/// The weights of a tree's tropisms over one internode.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tropisms {
    /// Towards the light, 0 or more.
    pub photo: f32,
    /// Upwards, or downwards where negative.
    pub gravi: f32,
}

impl Tropisms {
    /// Sum of the weights.
    #[must_use]
    pub fn sum(&self) -> f32 {
        self.photo + self.gravi.abs()
    }

    /// The combined tropism t of Eq. 6, of length up to 1; zero without any. `light` is a unit vector or, in the dark, zero; `up`
    /// a unit vector.
    #[must_use]
    pub fn combined(&self, light: Vec3, up: Vec3) -> Vec3 {
        let sum = self.sum();
        if sum <= 0.0 { Vec3::ZERO } else { (light * self.photo + up * self.gravi) / sum }
    }

    /// Weight `w_s` of a segment's own direction (Eq. 7), in (0, 1].
    #[must_use]
    pub fn own_weight(&self, length: f32, internode: f32) -> f32 {
        libm::powf(1.0 - self.sum(), length / internode).max(LEAST_WEIGHT)
    }
}

/// A segment many internodes long keeps at least this share of its own direction, or Eq. 8 could not be solved for it.
const LEAST_WEIGHT: f32 = 0.02;

/// The direction a segment takes that would grow in direction `own` (Eq. 6), not normalised. `weight` is
/// [`Tropisms::own_weight`], `tropism` [`Tropisms::combined`].
#[must_use]
pub fn bend(own: Vec3, weight: f32, tropism: Vec3) -> Vec3 {
    own * weight + tropism * (1.0 - weight)
}

/// The direction a segment would have grown in without tropisms, found from its direction `seen` (a unit vector): the inverse of
/// [`bend`] (Eq. 8, 9).
///
/// It is of length 1 where the tropisms may have led to `seen` at all; else it is longer, and the nearest that they may
/// have led to. [`bend`] of it has the direction of `seen` in either case.
#[must_use]
pub fn unbend(seen: Vec3, weight: f32, tropism: Vec3) -> Vec3 {
    let pull = tropism * (1.0 - weight);
    // p² - 2 p (h · t_w) + |t_w|² - w_s² = 0, with |h| = 1.
    let half = seen.dot(pull);
    let square = half * half - pull.length_squared() + weight * weight;
    let p = if square > 0.0 { half + square.sqrt() } else { half };
    // A segment that points against a tropism stronger than itself: p would turn it round.
    (seen * p.max(0.1 * weight) - pull) / weight
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn unit() -> impl Strategy<Value = Vec3> {
        (-1.0_f32..1.0, -1.0_f32..1.0, -1.0_f32..1.0)
            .prop_map(|(x, y, z)| Vec3::new(x, y, z).normalize_or(Vec3::X))
    }

    proptest! {
        #[test]
        fn bending_an_unbent_direction_gives_it_back(
            seen in unit(), light in unit(),
            photo in 0.0_f32..0.6, gravi in -0.3_f32..0.3, length in 0.01_f32..8.0,
        ) {
            let tropisms = Tropisms { photo, gravi };
            let weight = tropisms.own_weight(length, 1.0);
            let tropism = tropisms.combined(light, Vec3::Y);
            let back = bend(unbend(seen, weight, tropism), weight, tropism).normalize();
            prop_assert!(back.distance(seen) < 1e-4, "{seen} became {back}");
        }

        #[test]
        fn a_direction_that_was_bent_is_found_again(
            own in unit(), light in unit(), photo in 0.0_f32..0.4, length in 0.01_f32..1.0,
        ) {
            let tropisms = Tropisms { photo, gravi: 0.1 };
            let weight = tropisms.own_weight(length, 1.0);
            let tropism = tropisms.combined(light, Vec3::Y);
            let seen = bend(own, weight, tropism).normalize();
            prop_assert!(unbend(seen, weight, tropism).distance(own) < 1e-3);
        }
    }
}
