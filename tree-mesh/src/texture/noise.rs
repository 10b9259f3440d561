//! Periodic noise on the unit square: every function repeats when `u` or `v` grows by one.
//!
//! Lattice noise after Perlin (1985, quintic fade of 2002), cells after Worley (1996) with the distance
//! to the border between cells instead of to the second point, so that cracks have one width.
//! No transcendental functions: the same bits everywhere.

use tree_core::Seed;

/// One source of noise; the seed makes it independent of others.
#[derive(Clone, Copy, Debug)]
pub(super) struct Noise(u32);

/// Where a point lies among jittered cells.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// Random bits of the cell.
    pub(super) id: u32,
    /// Distance to the cell's border, in widths of a cell: 0 on the border, about 0.5 in the middle.
    pub(super) edge: f32,
}

/// Cells or waves across and along the unit square.
pub(super) type Count = [u32; 2];

impl Noise {
    pub(super) fn new(seed: Seed, name: &str) -> Self {
        Self((seed.stream(name).0 >> 32) as u32)
    }

    /// Gradient noise in about -1 to 1, mean 0, with `count` waves across the square.
    #[inline]
    pub(super) fn gradient(self, u: f32, v: f32, count: Count) -> f32 {
        let (x0, fx) = split(u, count[0]);
        let (y0, fy) = split(v, count[1]);
        let (x1, y1) = (next(x0, count[0]), next(y0, count[1]));
        let (sx, sy) = (fade(fx), fade(fy));
        // Perlin's permutation: looked up faster than hashed, and this is the hot loop.
        let [s0, s1, ..] = self.0.to_le_bytes();
        let (px0, px1) = (permute(x0 as u8 ^ s0), permute(x1 as u8 ^ s0));
        let (y0, y1) = (y0 as u8 ^ s1, y1 as u8 ^ s1);
        let corner = |px: u8, y: u8, dx: f32, dy: f32| {
            let [a, b] = GRADIENTS[usize::from(permute(px ^ y))];
            a * dx + b * dy
        };
        let top = mix(corner(px0, y0, fx, fy), corner(px1, y0, fx - 1.0, fy), sx);
        let low = mix(corner(px0, y1, fx, fy - 1.0), corner(px1, y1, fx - 1.0, fy - 1.0), sx);
        1.6 * mix(top, low, sy)
    }

    /// Octaves of gradient noise, each of twice the frequency and half the height; about -1 to 1.
    #[inline]
    pub(super) fn fbm(self, u: f32, v: f32, count: Count, octaves: u32) -> f32 {
        let (mut sum, mut height, mut count) = (0.0, 0.62, count);
        let (mut u, mut v) = (u, v);
        for octave in 0..octaves {
            sum += height * Self(self.0 ^ octave.wrapping_mul(0x9e37_79b9)).gradient(u, v, count);
            height *= 0.5;
            count = count.map(|n| n.saturating_mul(2));
            // Shifted, so that the zeros of the octaves do not coincide.
            u += 0.37;
            v += 0.71;
        }
        sum
    }

    /// Random bits for the cell that holds the point and the distance to the cell's border.
    /// `jitter` is 0 for a regular grid to 1.
    #[inline]
    pub(super) fn cell(self, u: f32, v: f32, count: Count, jitter: f32) -> Cell {
        let (x0, fx) = split(u, count[0]);
        let (y0, fy) = split(v, count[1]);
        let mut points = [[0.0_f32; 2]; 9];
        let (mut best, mut nearest, mut id) = (f32::MAX, [0.0; 2], 0);
        for (k, point) in points.iter_mut().enumerate() {
            let (i, j) = ((k % 3) as u32, (k / 3) as u32);
            let h = self.hash(around(x0 + i, count[0]), around(y0 + j, count[1]));
            let a = (h & 0xffff) as f32 * (1.0 / 65536.0) - 0.5;
            let b = (h >> 16) as f32 * (1.0 / 65536.0) - 0.5;
            *point = [i as f32 - 0.5 + jitter * a - fx, j as f32 - 0.5 + jitter * b - fy];
            let distance = point[0] * point[0] + point[1] * point[1];
            if distance < best {
                (best, nearest, id) = (distance, *point, h);
            }
        }
        let squat = count[1] as f32 / count[0] as f32;
        let mut edge = 1.0_f32;
        for point in points {
            let [dx, dy] = [point[0] - nearest[0], point[1] - nearest[1]];
            // The border's normal, measured on the square instead of in cells.
            let length = dx * dx + squat * squat * dy * dy;
            if length > 1e-6 {
                let mx = 0.5 * (point[0] + nearest[0]);
                let my = 0.5 * (point[1] + nearest[1]);
                edge = edge.min((mx * dx + my * dy) / length.sqrt());
            }
        }
        Cell { id: scramble(id), edge }
    }

    #[inline]
    pub(super) fn hash(self, x: u32, y: u32) -> u32 {
        scramble(self.0 ^ x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77).rotate_left(13))
    }
}

/// The lattice cell of a coordinate, wrapped, and the place in it (0 to 1).
#[inline]
pub(super) fn split(u: f32, count: u32) -> (u32, f32) {
    // Wrapping first spares the integer division.
    let x = fraction(u) * count as f32;
    let cell = x - 0.5 + ROUND;
    let index = (cell.to_bits() & 0x3f_ffff).min(count.saturating_sub(1));
    (index, x - index as i32 as f32)
}

/// Adding this leaves no bits for fractions, so that it rounds, and the low bits are the number:
/// cheaper than a saturating cast. For numbers below 2²².
const ROUND: f32 = 12_582_912.0;

/// What is above the next lower whole number, 0 to 1 (at whole numbers either end).
#[inline]
pub(super) fn fraction(x: f32) -> f32 {
    x - ((x - 0.5 + ROUND) - ROUND)
}

#[inline]
fn next(x: u32, count: u32) -> u32 {
    if x + 1 == count { 0 } else { x + 1 }
}

/// `x - 1`, wrapped, for `x` up to one beyond the count.
#[inline]
fn around(x: u32, count: u32) -> u32 {
    match x {
        0 => count - 1,
        x if x > count => x - 1 - count,
        x => x - 1,
    }
}

#[inline]
fn fade(t: f32) -> f32 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

/// From `a` to `b` as `t` goes from 0 to 1.
#[inline]
pub(super) fn mix(a: f32, b: f32, t: f32) -> f32 {
    a + (b - a) * t
}

/// 0 below `low`, 1 above `high`, smooth between; falling if `high < low`.
#[inline]
pub(super) fn smoothstep(low: f32, high: f32, x: f32) -> f32 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// A number in 0 to 1 out of 8 random bits, starting at `shift`.
#[inline]
pub(super) fn unit(bits: u32, shift: u32) -> f32 {
    ((bits >> shift) & 0xff) as f32 * (1.0 / 255.0)
}

/// The numbers 0 to 255 shuffled (Fisher, Yates).
static PERMUTATION: [u8; 256] = {
    let mut all = [0_u8; 256];
    let mut i = 0;
    while i < 256 {
        all[i] = i as u8;
        i += 1;
    }
    while i > 1 {
        let j = scramble(i as u32) as usize % i;
        i -= 1;
        let kept = all[i];
        all[i] = all[j];
        all[j] = kept;
    }
    all
};

/// Gradients uniform in the square from -1 to 1.
static GRADIENTS: [[f32; 2]; 256] = {
    let mut all = [[0.0; 2]; 256];
    let mut i = 0;
    while i < 256 {
        let h = scramble(i as u32 + 1000);
        let a = (h & 0xffff) as f32 * (2.0 / 65535.0) - 1.0;
        let b = (h >> 16) as f32 * (2.0 / 65535.0) - 1.0;
        all[i] = [a, b];
        i += 1;
    }
    all
};

#[inline]
fn permute(x: u8) -> u8 {
    PERMUTATION[usize::from(x)]
}

/// Finaliser of `MurmurHash3` (Appleby 2011).
#[inline]
const fn scramble(mut h: u32) -> u32 {
    h = (h ^ (h >> 16)).wrapping_mul(0x85eb_ca6b);
    h = (h ^ (h >> 13)).wrapping_mul(0xc2b2_ae35);
    h ^ (h >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_repeats_and_has_mean_zero() {
        let noise = Noise::new(Seed(1), "test");
        let mut sum = 0.0;
        for i in 0..1000 {
            let (u, v) = (i as f32 / 1000.0, (i * 37 % 1000) as f32 / 1000.0);
            sum += noise.gradient(u, v, [7, 5]);
            for count in [[1, 1], [2, 1], [7, 5]] {
                let near = noise.fbm(u, v, count, 3);
                assert!(near.abs() < 1.6);
                for (du, dv) in [(1.0, 0.0), (0.0, -1.0), (-2.0, 3.0)] {
                    assert!((near - noise.fbm(u + du, v + dv, count, 3)).abs() < 1e-3);
                    let (a, b) =
                        (noise.cell(u, v, count, 0.8), noise.cell(u + du, v + dv, count, 0.8));
                    assert!((a.edge - b.edge).abs() < 1e-3 && a.edge > -1e-4);
                }
            }
        }
        assert!((sum / 1000.0).abs() < 0.1);
    }
}
