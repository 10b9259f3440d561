//! Pictures and masks, and the way from light to bytes.

use super::texture::{srgb, srgb_byte};
use crate::error::{LodError, Result};
use glam::Vec3;

/// A picture: RGBA, 8 bits, sRGB, straight alpha, rows from top to bottom.
#[derive(Clone, PartialEq, Eq)]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// `4 * width * height` bytes.
    pub pixels: Vec<u8>,
}

impl std::fmt::Debug for Picture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Picture({} × {})", self.width, self.height)
    }
}

impl Picture {
    /// The bytes of a pixel; None outside the picture.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 4]> {
        if x >= self.width || y >= self.height {
            return None;
        }
        let at = u128::from(y) * u128::from(self.width) + u128::from(x);
        let at = usize::try_from(4 * at).ok()?;
        self.pixels.get(at..)?.first_chunk().copied()
    }

    /// Checks that the pixels fill width and height, neither of which is 0.
    ///
    /// # Errors
    /// [`LodError::Picture`].
    pub fn check(&self) -> Result<()> {
        // Sides of 32 bits: 64 would not hold four times their product.
        let expected = u128::from(self.width) * u128::from(self.height) * 4;
        if self.pixels.len() as u128 == expected && expected > 0 {
            return Ok(());
        }
        Err(LodError::Picture {
            width: self.width,
            height: self.height,
            found: self.pixels.len(),
            expected: usize::try_from(expected.max(4)).unwrap_or(usize::MAX),
        })
    }

    /// The picture as a PNG file in memory.
    ///
    /// # Errors
    /// What [`Picture::check`] finds, or [`LodError::Image`] if the encoder fails.
    #[cfg(feature = "image")]
    pub fn to_png(&self) -> Result<Vec<u8>> {
        use image::ImageEncoder;
        self.check()?;
        let mut bytes = Vec::new();
        image::codecs::png::PngEncoder::new(&mut bytes).write_image(
            &self.pixels,
            self.width,
            self.height,
            image::ExtendedColorType::Rgba8,
        )?;
        Ok(bytes)
    }

    /// Writes a PNG file, whole or not at all.
    ///
    /// # Errors
    /// As [`Picture::to_png`], and [`LodError::Core`] with the path.
    #[cfg(feature = "image")]
    pub fn save_png(&self, path: impl AsRef<std::path::Path>) -> Result<()> {
        let path = path.as_ref();
        let bytes = self.to_png()?;
        tree_core::file::write_atomic(path, |out| {
            out.write_all(&bytes).map_err(|error| tree_core::CoreError::io(path, error).into())
        })
    }
}

/// How much of each pixel a mesh covers.
#[derive(Clone, PartialEq, Eq)]
pub struct Mask {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// One byte per pixel, row by row: 0 is empty, 255 is full.
    pub coverage: Vec<u8>,
}

impl std::fmt::Debug for Mask {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Mask({} × {})", self.width, self.height)
    }
}

impl Mask {
    /// Covered area in pixels.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.coverage.iter().map(|&c| u64::from(c)).sum::<u64>() as f64 / 255.0
    }

    /// Per pixel, whether at least half of it is covered.
    pub fn bits(&self) -> impl ExactSizeIterator<Item = bool> + '_ {
        self.coverage.iter().map(|&c| c >= 128)
    }

    /// The mask in black on white. A mask whose coverage does not fill it gives a picture that
    /// [`Picture::check`] refuses.
    #[must_use]
    pub fn to_picture(&self) -> Picture {
        let bytes: Vec<u8> = (0..=255_u16).map(|c| srgb_byte(1.0 - f32::from(c) / 255.0)).collect();
        let pixels = self.coverage.iter().flat_map(|&c| {
            let grey = bytes[usize::from(c)];
            [grey, grey, grey, 255]
        });
        Picture { width: self.width, height: self.height, pixels: pixels.collect() }
    }
}

/// From linear light to bytes.
pub(super) struct Tone {
    /// sRGB in 1 / 256 of a byte.
    table: Vec<u16>,
    exposure: f32,
}

/// Entries of the tone table.
const STEPS: usize = 16_384;

impl Tone {
    pub(super) fn new(exposure: f32) -> Self {
        // Entry i stands for the light x with x / (1 + x) = i / STEPS.
        let table = (0..STEPS).map(|i| {
            let t = (i as f32 + 0.5) / STEPS as f32;
            (255.0 * 256.0 * srgb(filmic(t / (1.0 - t)).clamp(0.0, 1.0))) as u16
        });
        Self { table: table.collect(), exposure }
    }

    /// The bytes of a pixel; its place decides how fractions of a byte are rounded, so that a sky
    /// has no visible steps.
    pub(super) fn bytes(&self, light: Vec3, x: u32, y: u32) -> [u8; 4] {
        // A lattice without visible pattern, 0 to 255 (Roberts 2018: powers of the plastic number).
        let dither = (x.wrapping_mul(3_242_174_889).wrapping_add(y.wrapping_mul(2_447_445_414))
            >> 24) as u16;
        let [r, g, b] = (light.max(Vec3::ZERO) * self.exposure).to_array().map(|x| {
            let i = (x / (1.0 + x) * STEPS as f32) as usize;
            ((self.table[i.min(STEPS - 1)] + dither) >> 8) as u8
        });
        [r, g, b, 255]
    }
}

/// Film: shadows keep their depth, highlights roll off (Narkowicz 2015, a fit of the ACES curve).
fn filmic(x: f32) -> f32 {
    x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_that_is_not_filled_is_refused_without_panic() {
        let odd = [(2, 2, 15), (2, 2, 17), (0, 0, 0), (0, 1, 0), (u32::MAX, u32::MAX, 4)];
        for (width, height, n) in odd.into_iter().chain([(1 << 31, 1 << 31, 0)]) {
            let picture = Picture { width, height, pixels: vec![0; n] };
            let error = picture.check().unwrap_err();
            assert!(matches!(error, LodError::Picture { found, .. } if found == n), "{error}");
            assert_eq!(picture.pixel(u32::MAX, u32::MAX), None);
            assert_eq!(picture.pixel(width, height.wrapping_sub(1)), None);
            assert_eq!(picture.pixel(width.wrapping_sub(1), height), None);
            #[cfg(feature = "image")]
            assert!(matches!(picture.to_png(), Err(LodError::Picture { .. })));
            #[cfg(feature = "image")]
            assert!(matches!(picture.save_png("/no/such/a.png"), Err(LodError::Picture { .. })));
        }
        Picture { width: 1, height: 2, pixels: vec![0; 8] }.check().unwrap();
    }

    #[test]
    fn a_mask_that_is_not_filled_becomes_a_picture_that_is_refused() {
        let mask = Mask { width: 3, height: 2, coverage: vec![0, 255] };
        assert!(mask.to_picture().check().is_err());
    }
}
