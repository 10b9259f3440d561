//! Textures at all sizes: so that far leaves neither flicker nor vanish.
//!
//! 1. Each level is half the size of the one before; colours are averaged in linear light,
//!    weighted by alpha, so that what lies beside a leaf does not bleed into it.
//! 2. Averaged alpha would thin leaves out (a twig of one pixel becomes 25 % and is cut off).
//!    Castaño (2010, "Computing alpha mipmaps") scales alpha until the covered share is that of
//!    the original; scaling by s is the same as dividing the cutoff by s, so each level gets a
//!    cutoff of its own here, read off its histogram. Where no cutoff comes near (stripes finer
//!    than a pixel all have the same alpha), alpha is dithered by error diffusion instead, which
//!    keeps the share exactly (Yuksel 2018, "Alpha distribution for alpha testing").
//! 3. Levels end at [`SMALLEST`], where a shape is still a shape.

use super::raster::{Filter, Mask};
use glam::{Vec2, Vec3};
use std::sync::OnceLock;
use tree_mesh::Texture;

/// Below this many texels per sample (an area) alpha is interpolated.
const MAGNIFIED: f32 = 0.4;

/// Levels are not made smaller than this many pixels. Larger keeps shapes but lets far leaves
/// flicker, smaller turns them into full squares.
const SMALLEST: u32 = 8;

/// The levels of one texture under one cutoff, largest first.
#[derive(Debug)]
pub(crate) struct Pyramid {
    pub(super) levels: Vec<Level>,
}

/// An image of a [`Pyramid`].
#[derive(Debug)]
pub(crate) struct Level {
    pub(super) width: u32,
    pub(super) height: u32,
    /// sRGB and alpha; empty in a pyramid without colours.
    texels: Vec<[u8; 4]>,
    /// Alpha alone, for the rasteriser.
    alpha: Vec<u8>,
    /// Smallest alpha that is drawn.
    cutoff: u16,
}

impl Pyramid {
    /// `cutoff` is the smallest alpha (0 to 255) that is drawn at full size. Without `colors` only
    /// alpha can be asked for.
    pub(super) fn new(texture: &Texture, cutoff: u16, colors: bool, srgb: &Srgb) -> Self {
        let (texels, _) = texture.pixels.as_chunks::<4>();
        let mut level = Level {
            width: texture.width,
            height: texture.height,
            texels: texels.to_vec(),
            alpha: texels.iter().map(|texel| texel[3]).collect(),
            cutoff,
        };
        let covered = level.alpha.iter().filter(|&&a| u16::from(a) >= cutoff).count();
        let covered = covered as f64 / level.alpha.len().max(1) as f64;
        let mut levels = Vec::new();
        while level.width.min(level.height) >= 2 * SMALLEST {
            let mut next = level.halved(srgb);
            next.keep_covered(covered);
            levels.push(std::mem::replace(&mut level, next));
        }
        levels.push(level);
        if !colors {
            levels.iter_mut().for_each(|level| level.texels = Vec::new());
        }
        Self { levels }
    }

    /// Share of the picture that is drawn.
    pub(super) fn covered(&self) -> f32 {
        let Some(level) = self.levels.last() else { return 1.0 };
        let drawn = level.alpha.iter().filter(|&&a| u16::from(a) >= level.cutoff).count();
        drawn as f32 / level.alpha.len().max(1) as f32
    }

    /// How a triangle of twice the area `area`, in samples, reads this texture.
    #[inline]
    pub(crate) fn mask(&self, area: f32, uvs: [Vec2; 3]) -> Mask<'_> {
        let texels = self.texel_area(uvs) / area;
        let filter = if texels < MAGNIFIED {
            Filter::Smooth
        } else if uvs.iter().all(|uv| uv.min_element() >= 0.0 && uv.max_element() <= 1.0) {
            Filter::Within
        } else {
            Filter::Repeat
        };
        Mask { level: self.level(texels), filter }
    }

    /// Twice the area a triangle has in texture space, in texels of the largest level.
    #[inline]
    pub(super) fn texel_area(&self, uvs: [Vec2; 3]) -> f32 {
        let (a, b) = (uvs[1] - uvs[0], uvs[2] - uvs[0]);
        let level = &self.levels[0];
        a.perp_dot(b).abs() * level.width as f32 * level.height as f32
    }

    /// The level for so many texels of the largest level per sample of the picture (an area).
    #[inline]
    pub(super) fn level(&self, texels_per_sample: f32) -> &Level {
        // The exponent of a float is its log₂, rounded down; half of it, rounded, is the level.
        let exponent = (texels_per_sample.max(1.0).to_bits() >> 23) as usize - 127;
        let level = exponent.div_ceil(2).min(self.levels.len() - 1);
        &self.levels[level]
    }
}

/// How far, relatively, the covered share may be off before alpha is dithered. Less makes more edges
/// noisy, more changes how dense far trees are.
const COVER_TOLERANCE: f64 = 0.15;

/// The alpha that leaves a share as near as possible to `covered` at or above it, and that share.
fn cutoff_for(alpha: &[u8], covered: f64) -> (u16, f64) {
    let mut histogram = [0_usize; 256];
    for &a in alpha {
        histogram[usize::from(a)] += 1;
    }
    let per_texel = 1.0 / alpha.len().max(1) as f64;
    let (mut above, mut best) = (0, (256, 0.0));
    for a in (1..256).rev() {
        above += histogram[a];
        let share = above as f64 * per_texel;
        if (share - covered).abs() < (best.1 - covered).abs() {
            best = (a as u16, share);
        }
    }
    best
}

impl Level {
    fn halved(&self, srgb: &Srgb) -> Self {
        let (width, height) = (self.width / 2, self.height / 2);
        let mut texels = Vec::with_capacity(width as usize * height as usize);
        for y in 0..height as usize {
            let rows = [2 * y, 2 * y + 1].map(|row| row * self.width as usize);
            for x in 0..width as usize {
                let (mut color, mut plain, mut alpha) = (Vec3::ZERO, Vec3::ZERO, 0);
                for row in rows {
                    for column in [2 * x, 2 * x + 1] {
                        let texel = self.texels[row + column];
                        let linear = srgb.decode(texel);
                        color += linear * f32::from(texel[3]);
                        plain += linear;
                        alpha += u16::from(texel[3]);
                    }
                }
                let mean = if alpha > 0 { color / f32::from(alpha) } else { plain * 0.25 };
                let [r, g, b] = mean.to_array().map(|v| srgb.encode(v));
                texels.push([r, g, b, ((alpha + 2) / 4) as u8]);
            }
        }
        let alpha = texels.iter().map(|texel| texel[3]).collect();
        Self { width, height, texels, alpha, cutoff: self.cutoff }
    }

    /// Chooses what is drawn, so that it is a share of `covered`.
    fn keep_covered(&mut self, covered: f64) {
        let (cutoff, share) = cutoff_for(&self.alpha, covered);
        self.cutoff = cutoff;
        if (share - covered).abs() <= COVER_TOLERANCE * covered {
            return;
        }
        // Floyd, Steinberg 1976, on alpha scaled to the wanted mean.
        let sum: u64 = self.alpha.iter().map(|&a| u64::from(a)).sum();
        let scale = (covered * self.alpha.len() as f64 / sum.max(1) as f64) as f32;
        let width = self.width as usize;
        let (mut errors, mut next) = (vec![0.0_f32; width + 2], vec![0.0_f32; width + 2]);
        for row in self.alpha.chunks_exact_mut(width) {
            for (x, a) in row.iter_mut().enumerate() {
                let wanted = f32::from(*a) * scale + errors[x + 1];
                let drawn = wanted >= 0.5;
                let error = wanted - f32::from(u8::from(drawn));
                errors[x + 2] += error * (7.0 / 16.0);
                next[x] += error * (3.0 / 16.0);
                next[x + 1] += error * (5.0 / 16.0);
                next[x + 2] += error * (1.0 / 16.0);
                *a = if drawn { 255 } else { 0 };
            }
            std::mem::swap(&mut errors, &mut next);
            next.fill(0.0);
        }
        self.cutoff = 128;
    }

    /// Whether the texel at these coordinates is drawn.
    #[inline]
    pub(crate) fn covers(&self, u: f32, v: f32) -> bool {
        let x = (wrap(u) * self.width as f32) as u32;
        let y = (wrap(v) * self.height as f32) as u32;
        let texel =
            y.min(self.height - 1) as usize * self.width as usize + x.min(self.width - 1) as usize;
        u16::from(self.alpha[texel]) >= self.cutoff
    }

    /// As [`covers`](Self::covers), for coordinates that should lie within 0 to 1: what rounding
    /// throws out is brought back to the border.
    #[inline]
    pub(crate) fn covers_within(&self, u: f32, v: f32) -> bool {
        let texel = nearest(v, self.height) * self.width as usize + nearest(u, self.width);
        u16::from(self.alpha[texel]) >= self.cutoff
    }

    /// As [`covers`](Self::covers), with alpha interpolated between texels: for close-ups.
    #[inline]
    pub(crate) fn covers_smoothly(&self, u: f32, v: f32) -> bool {
        let (texels, weights) = self.around(u, v);
        let alpha: f32 = (0..4).map(|i| weights[i] * f32::from(self.alpha[texels[i]])).sum();
        alpha >= f32::from(self.cutoff)
    }

    /// Linear colour between the four texels around, weighted by their alpha if `masked`.
    #[inline]
    pub(super) fn color(&self, u: f32, v: f32, masked: bool, srgb: &Srgb) -> Vec3 {
        let (texels, weights) = self.around(u, v);
        let (mut sum, mut total) = (Vec3::ZERO, 0.0);
        for (&texel, weight) in texels.iter().zip(weights) {
            let texel = self.texels[texel];
            let weight = if masked { weight * (f32::from(texel[3]) + 0.1) } else { weight };
            sum += srgb.decode(texel) * weight;
            total += weight;
        }
        sum / total
    }

    /// Indices and weights of the four texels around.
    #[inline]
    fn around(&self, u: f32, v: f32) -> ([usize; 4], [f32; 4]) {
        let place = |t: f32, size: u32| {
            let x = wrap(t) * size as f32 + (size as f32 - 0.5);
            let low = x as u32;
            ((low % size) as usize, ((low + 1) % size) as usize, x - low as f32)
        };
        let (x0, x1, fx) = place(u, self.width);
        let (y0, y1, fy) = place(v, self.height);
        let (y0, y1) = (y0 * self.width as usize, y1 * self.width as usize);
        (
            [y0 + x0, y0 + x1, y1 + x0, y1 + x1],
            [(1.0 - fx) * (1.0 - fy), fx * (1.0 - fy), (1.0 - fx) * fy, fx * fy],
        )
    }
}

/// The texel of a row of `size` at `t`, 0 to 1, brought back to the border from outside.
#[inline]
fn nearest(t: f32, size: u32) -> usize {
    // 2²³ + x has x, rounded, in its low bits: faster than a cast, which must saturate.
    const SHIFT: f32 = 8_388_608.0;
    let (x, last) = (t * size as f32 - 0.5, (size - 1) as f32);
    let x = if x > 0.0 { x } else { 0.0 };
    let x = if x < last { x } else { last };
    ((x + SHIFT).to_bits() & 0x007f_ffff) as usize
}

/// The fractional part, 0 to 1. (`f32::floor` is a call on plain x86-64, this is not.)
#[inline]
fn wrap(t: f32) -> f32 {
    let fraction = t - (t as i32) as f32;
    // Beyond 2³¹ repeats there is no fraction left to find.
    let fraction = if fraction < 0.0 { fraction + 1.0 } else { fraction };
    fraction.clamp(0.0, 1.0)
}

/// Tables between sRGB bytes and linear light.
#[derive(Debug)]
pub(crate) struct Srgb {
    decode: [f32; 256],
    encode: Vec<u8>,
}

/// Entries of the encoding table: ten per step of the darkest bytes.
const ENCODE_STEPS: usize = 32_768;

impl Srgb {
    /// The tables, made once.
    pub(crate) fn shared() -> &'static Self {
        static TABLES: OnceLock<Srgb> = OnceLock::new();
        TABLES.get_or_init(Self::new)
    }

    fn new() -> Self {
        let decode = std::array::from_fn(|byte| {
            let c = byte as f32 / 255.0;
            if c <= 0.04045 { c / 12.92 } else { libm::powf((c + 0.055) / 1.055, 2.4) }
        });
        let encode =
            (0..=ENCODE_STEPS).map(|i| srgb_byte(i as f32 / ENCODE_STEPS as f32)).collect();
        Self { decode, encode }
    }

    #[inline]
    pub(crate) fn decode(&self, texel: [u8; 4]) -> Vec3 {
        let [r, g, b, _] = texel.map(|byte| self.decode[usize::from(byte)]);
        Vec3::new(r, g, b)
    }

    #[inline]
    pub(crate) fn encode(&self, linear: f32) -> u8 {
        self.encode[((linear * ENCODE_STEPS as f32 + 0.5) as usize).min(ENCODE_STEPS)]
    }
}

/// The sRGB byte of a linear value, 0 to 1.
pub(super) fn srgb_byte(linear: f32) -> u8 {
    (srgb(linear) * 255.0 + 0.5) as u8
}

/// The sRGB value, 0 to 1, of a linear one (IEC 61966-2-1).
pub(super) fn srgb(linear: f32) -> f32 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * libm::powf(linear, 1.0 / 2.4) - 0.055
    }
}

#[cfg(test)]
#[path = "texture_tests.rs"]
mod tests;
