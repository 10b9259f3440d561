//! Seeds and their named streams: the same seed gives the same bits on every platform and for any
//! number of threads, because every independent piece of work draws from a stream of its own.

use glam::Vec3;
use rand::rngs::Xoshiro256PlusPlus;
use rand::{RngExt, SeedableRng};

/// The family's generator: documented as portable, unlike rand's `SmallRng` and `StdRng`.
pub type Rng = Xoshiro256PlusPlus;

/// Where randomness comes from. Cheap to copy; drawing from a [`Rng`] never changes the seed.
///
/// ```
/// use tree_core::Seed;
/// let seed = Seed(7);
/// // Work item 3 of stage "nodes" draws the same numbers, whichever thread runs it and when.
/// assert_eq!(seed.stream("nodes").child(3).rng(), seed.stream("nodes").child(3).rng());
/// assert_ne!(seed.stream("nodes"), seed.stream("edges"));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(transparent))]
pub struct Seed(pub u64);

impl Seed {
    /// The stream for a named stage of the work.
    #[must_use]
    pub const fn stream(self, name: &str) -> Self {
        // FNV-1a over the name (Fowler, Noll, Vo), then mixed with the seed.
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        let bytes = name.as_bytes();
        let mut i = 0;
        while i < bytes.len() {
            hash = (hash ^ bytes[i] as u64).wrapping_mul(0x0100_0000_01b3);
            i += 1;
        }
        Self(mix(self.0 ^ mix(hash)))
    }

    /// The stream for the `index`-th item of this stage.
    #[must_use]
    pub const fn child(self, index: u64) -> Self {
        Self(mix(mix(self.0).wrapping_add(index.wrapping_mul(0x9e37_79b9_7f4a_7c15))))
    }

    /// A generator at the start of this stream.
    #[must_use]
    pub fn rng(self) -> Rng {
        Rng::seed_from_u64(self.0)
    }

    /// One number in `[0, 1)` for the `index`-th item, without setting up a generator.
    ///
    /// For per-edge weights and the like, where a generator for each item would cost more than
    /// the number.
    #[must_use]
    #[inline]
    pub fn unit(self, index: u64) -> f32 {
        // The top 24 bits fill an f32's mantissa exactly.
        (self.child(index).0 >> 40) as f32 * (1.0 / 16_777_216.0)
    }
}

/// The finaliser of `SplitMix64` (Steele, Lea, Flood 2014): every input bit reaches every output bit.
const fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A number uniform in `[low, high)`; `low` if the range is empty.
#[inline]
pub fn uniform(rng: &mut Rng, low: f32, high: f32) -> f32 {
    low + (high - low).max(0.0) * rng.random::<f32>()
}

/// A standard normal number: the polar method (Marsaglia, Bray 1964), second value discarded.
pub fn normal(rng: &mut Rng) -> f32 {
    loop {
        let x = uniform(rng, -1.0, 1.0);
        let y = uniform(rng, -1.0, 1.0);
        let s = x * x + y * y;
        if s > 0.0 && s < 1.0 {
            return x * (-2.0 * libm::logf(s) / s).sqrt();
        }
    }
}

/// A point uniform in the unit ball, by rejection (no transcendental function).
pub fn in_unit_ball(rng: &mut Rng) -> Vec3 {
    loop {
        let p =
            Vec3::new(uniform(rng, -1.0, 1.0), uniform(rng, -1.0, 1.0), uniform(rng, -1.0, 1.0));
        if p.length_squared() <= 1.0 {
            return p;
        }
    }
}

/// A direction uniform on the unit sphere.
pub fn unit_vector(rng: &mut Rng) -> Vec3 {
    loop {
        if let Some(direction) = in_unit_ball(rng).try_normalize() {
            return direction;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_and_children_are_distinct() {
        let seed = Seed(1);
        let mut all: Vec<u64> = (0..1000).map(|i| seed.child(i).0).collect();
        all.extend(["a", "b", "ab", "ba", ""].map(|name| seed.stream(name).0));
        all.push(seed.0);
        let count = all.len();
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), count);
    }

    #[test]
    fn the_bits_of_a_stream_never_change() {
        // "Same seed, other bits" is a change users must be told of (CHANGELOG).
        assert_eq!(Seed(42).stream("nodes").0, 0xbae2_1cdd_5480_1d3e);
    }

    #[test]
    fn unit_numbers_fill_the_interval_evenly() {
        let mut bins = [0_u32; 10];
        for i in 0..100_000 {
            bins[(Seed(3).unit(i) * 10.0) as usize] += 1;
        }
        assert!(bins.iter().all(|&n| (9_600..10_400).contains(&n)), "{bins:?}");
    }

    #[test]
    fn normal_numbers_have_mean_zero_and_unit_variance() {
        let mut rng = Seed(5).rng();
        let draws: Vec<f32> = (0..50_000).map(|_| normal(&mut rng)).collect();
        let mean = draws.iter().sum::<f32>() / draws.len() as f32;
        let variance =
            draws.iter().map(|x| (x - mean) * (x - mean)).sum::<f32>() / draws.len() as f32;
        assert!(mean.abs() < 0.02 && (variance - 1.0).abs() < 0.03, "{mean} {variance}");
    }
}
