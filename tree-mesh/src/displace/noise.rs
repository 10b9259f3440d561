//! Gradient noise in space, with its derivative.
//!
//! Perlin, "Improving Noise", SIGGRAPH 2002: gradients along the twelve edges of a cube, quintic fade.
//! The derivative is that of the trilinear sum, term by term. Gradients are hashed with
//! [`Seed::child`]; no transcendental functions, the same bits everywhere.

use glam::DVec3;
use tree_core::Seed;

/// Brings the noise near to the range of -1 to 1; it stays within.
const HEIGHT: f64 = 0.96;
/// Share of the first octave when each has half the height of the one before.
const FIRST: f64 = 0.5;

/// Noise at a place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sample {
    /// -1 to 1, mean 0.
    pub(super) value: f64,
    /// Derivative of the value by the place.
    pub(super) gradient: DVec3,
}

/// Octaves of noise, each of twice the frequency and half the height; -1 to 1.
pub(super) fn fbm(place: DVec3, seed: Seed, octaves: u32) -> Sample {
    let (mut sum, mut share, mut frequency, mut total) = (Sample::default(), FIRST, 1.0, 0.0);
    for octave in 0..octaves {
        // Shifted, so that the zeros on the lattice do not coincide.
        let shift = DVec3::new(0.37, 0.71, 0.13) * f64::from(octave);
        let layer = gradient(frequency * place + shift, seed.child(octave.into()));
        sum.value += share * layer.value;
        sum.gradient += share * frequency * layer.gradient;
        total += share;
        share *= 0.5;
        frequency *= 2.0;
    }
    Sample { value: sum.value / total, gradient: sum.gradient / total }
}

/// One layer of noise with a wave about every two cells.
fn gradient(place: DVec3, seed: Seed) -> Sample {
    let cell = place.floor();
    let within = place - cell;
    let at = |x: f64| x as i64 as u64;
    let (x, y, z) = (at(cell.x), at(cell.y), at(cell.z));
    let fade = within.map(|t| t * t * t * (t * (t * 6.0 - 15.0) + 10.0));
    let rise = within.map(|t| 30.0 * t * t * (t * (t - 2.0) + 1.0));
    let mut sum = Sample::default();
    for corner in 0..8_u64 {
        let (i, j, k) = (corner & 1, corner >> 1 & 1, corner >> 2);
        let hash = hash(x.wrapping_add(i), y.wrapping_add(j), z.wrapping_add(k), seed);
        let direction = direction(hash);
        let arm = within - DVec3::new(i as f64, j as f64, k as f64);
        let height = direction.dot(arm);
        let weigh = |far: u64, fade: f64| if far == 1 { fade } else { 1.0 - fade };
        let slope = |far: u64, rise: f64| if far == 1 { rise } else { -rise };
        let (u, v, w) = (weigh(i, fade.x), weigh(j, fade.y), weigh(k, fade.z));
        let change = DVec3::new(
            slope(i, rise.x) * v * w,
            u * slope(j, rise.y) * w,
            u * v * slope(k, rise.z),
        );
        sum.value += HEIGHT * (u * v * w * height);
        sum.gradient += HEIGHT * (change * height + direction * (u * v * w));
    }
    sum
}

fn hash(x: u64, y: u64, z: u64, seed: Seed) -> u64 {
    let row = y.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ z.wrapping_mul(0xC2B2_AE3D_27D4_EB4F);
    seed.child(x ^ row).0
}

/// One of the twelve edges of a cube; four of them twice, which spares a division.
fn direction(hash: u64) -> DVec3 {
    let sign = |bit: u64| if hash >> bit & 1 == 1 { 1.0 } else { -1.0 };
    let (a, b) = (sign(60), sign(61));
    match hash >> 62 {
        0 => DVec3::new(a, b, 0.0),
        1 => DVec3::new(a, 0.0, b),
        2 => DVec3::new(0.0, a, b),
        _ => DVec3::new(a * b, a, 0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gradient_agrees_with_differences_and_values_stay_within_one() {
        let (mut sum, mut largest) = (0.0, 0.0_f64);
        for i in 0..20_000 {
            let t = f64::from(i);
            let place = DVec3::new(0.137 * t - 50.0, 0.071 * t, 9.0 - 0.0313 * t);
            let here = fbm(place, Seed(3), 3);
            sum += here.value;
            largest = largest.max(here.value.abs());
            if i % 100 == 0 {
                let step = 1e-6;
                let by = |d: DVec3| {
                    (fbm(place + step * d, Seed(3), 3).value
                        - fbm(place - step * d, Seed(3), 3).value)
                        / (2.0 * step)
                };
                let measured = DVec3::new(by(DVec3::X), by(DVec3::Y), by(DVec3::Z));
                assert!(measured.distance(here.gradient) < 1e-6, "{measured} {here:?}");
            }
        }
        assert!((sum / 20_000.0).abs() < 0.02, "{}", sum / 20_000.0);
        assert!((0.5..=1.0).contains(&largest), "{largest}");
    }

    #[test]
    fn seeds_differ() {
        let place = DVec3::splat(0.4);
        assert_ne!(fbm(place, Seed(1), 1).value, fbm(place, Seed(2), 1).value);
    }
}
