//! Smaller levels of a picture that is alpha-tested.

use crate::error::Result;
use crate::preview::{Picture, Srgb};
use glam::Vec3;

/// Halvings when the factor on alpha is sought: finer than a byte.
const HALVINGS: usize = 16;
/// Largest factor on alpha. More would make single texels of thin twigs blink.
const GROWTH_MAX: f32 = 8.0;

/// The picture and its smaller levels, each half as wide and high (rounded down, at least 1), at most
/// `levels` in all and at least the picture itself. Colours are means in linear light, weighted by
/// alpha. Alpha is the mean, scaled so that the share of texels that pass a test against one half stays as
/// in the first level (Castaño 2010), as near as one factor comes to it.
///
/// # Errors
/// [`LodError::Picture`](crate::LodError::Picture) when the pixels do not fill the picture.
///
/// # Complexity
/// O(pixels).
///
/// ```
/// use tree_lod::{impostor::texel::mips, preview::Picture};
/// let picture = Picture { width: 4, height: 4, pixels: vec![255; 64] };
/// let sizes: Vec<u32> = mips(&picture, 9)?.iter().map(|level| level.width).collect();
/// assert_eq!(sizes, [4, 2, 1]);
/// # Ok::<(), tree_lod::LodError>(())
/// ```
pub fn mips(picture: &Picture, levels: usize) -> Result<Vec<Picture>> {
    picture.check()?;
    let srgb = Srgb::shared();
    let wanted = share(&picture.pixels, 1.0);
    let mut done = vec![picture.clone()];
    // Alpha is kept unscaled from level to level.
    let mut plain = picture.clone();
    while done.len() < levels && (plain.width > 1 || plain.height > 1) {
        plain = halved(&plain, srgb);
        let factor = factor_for(&plain.pixels, wanted);
        let mut scaled = plain.clone();
        for texel in scaled.pixels.as_chunks_mut::<4>().0 {
            texel[3] = grown(texel[3], factor);
        }
        done.push(scaled);
    }
    Ok(done)
}

fn grown(alpha: u8, factor: f32) -> u8 {
    (f32::from(alpha) * factor + 0.5).min(255.0) as u8
}

/// Share of texels whose scaled alpha passes.
fn share(pixels: &[u8], factor: f32) -> f64 {
    let (texels, _) = pixels.as_chunks::<4>();
    let passing = texels.iter().filter(|texel| grown(texel[3], factor) >= 128).count();
    passing as f64 / texels.len().max(1) as f64
}

/// Grows with the share that passes, so it is found by halving; of the last two, the nearer.
fn factor_for(pixels: &[u8], wanted: f64) -> f32 {
    let (mut low, mut high) = (0.0_f32, GROWTH_MAX);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if share(pixels, middle) < wanted { low = middle } else { high = middle }
    }
    let off = |factor| (share(pixels, factor) - wanted).abs();
    if off(low) < off(high) { low } else { high }
}

fn halved(picture: &Picture, srgb: &Srgb) -> Picture {
    let (width, height) = ((picture.width / 2).max(1), (picture.height / 2).max(1));
    let (texels, _) = picture.pixels.as_chunks::<4>();
    let mut pixels = Vec::with_capacity(4 * width as usize * height as usize);
    for y in 0..height {
        for x in 0..width {
            let (mut color, mut plain, mut alpha) = (Vec3::ZERO, Vec3::ZERO, 0.0);
            for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                let column = (2 * x + dx).min(picture.width - 1) as usize;
                let row = (2 * y + dy).min(picture.height - 1) as usize;
                let texel = texels[row * picture.width as usize + column];
                let linear = srgb.decode(texel);
                color += linear * f32::from(texel[3]);
                plain += linear;
                alpha += f32::from(texel[3]);
            }
            let mean = if alpha > 0.0 { color / alpha } else { 0.25 * plain };
            let [r, g, b] = mean.to_array().map(|v| srgb.encode(v));
            pixels.extend([r, g, b, (0.25 * alpha + 0.5) as u8]);
        }
    }
    Picture { width, height, pixels }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tree_core::{Seed, seed};

    /// Green discs on nothing, blurred at the edge.
    fn discs(side: u32, n: usize, radius: f32) -> Picture {
        let mut rng = Seed(5).rng();
        let mut at = || seed::uniform(&mut rng, 0.0, side as f32);
        let middles: Vec<[f32; 2]> = (0..n).map(|_| [at(), at()]).collect();
        let texel = |i: u32| {
            let (x, y) = ((i % side) as f32 + 0.5, (i / side) as f32 + 0.5);
            let far = |m: &[f32; 2]| ((m[0] - x) * (m[0] - x) + (m[1] - y) * (m[1] - y)).sqrt();
            let near = middles.iter().map(far).fold(f32::MAX, f32::min);
            [40, 120, 30, (255.0 * (radius + 0.5 - near).clamp(0.0, 1.0)) as u8]
        };
        Picture { width: side, height: side, pixels: (0..side * side).flat_map(texel).collect() }
    }

    #[test]
    fn the_covered_share_is_kept_at_every_level() {
        for (n, radius) in [(60, 3.0), (300, 1.6), (8, 20.0)] {
            let picture = discs(128, n, radius);
            let wanted = share(&picture.pixels, 1.0);
            for level in &mips(&picture, 5).unwrap() {
                let found = share(&level.pixels, 1.0);
                // One texel more or less at the small end.
                let tolerance = 0.03 * wanted + 2.0 / f64::from(level.width * level.height);
                assert!((found - wanted).abs() < tolerance, "{} {found} {wanted}", level.width);
            }
        }
    }

    #[test]
    fn colours_do_not_darken() {
        for level in &mips(&discs(64, 40, 2.0), 6).unwrap() {
            let (texels, _) = level.pixels.as_chunks::<4>();
            assert!(
                texels
                    .iter()
                    .all(|texel| texel[1].abs_diff(120) <= 1 && texel[0].abs_diff(40) <= 1)
            );
        }
    }

    #[test]
    fn odd_sizes_end_at_one_texel_and_unfilled_pictures_are_refused() {
        let picture = Picture { width: 5, height: 3, pixels: vec![9; 60] };
        let sizes: Vec<_> =
            mips(&picture, 9).unwrap().iter().map(|l| (l.width, l.height)).collect();
        assert_eq!(sizes, [(5, 3), (2, 1), (1, 1)]);
        assert!(mips(&Picture { pixels: vec![0; 59], ..picture }, 2).is_err());
    }
}
