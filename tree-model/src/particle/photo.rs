//! Photographs in memory.

use crate::error::{ModelError, Result};
use tree_core::{Limits, Resource};

/// A picture of 8-bit sRGB colours with alpha.
#[derive(Clone, PartialEq, Eq)]
pub struct Photo {
    width: u32,
    height: u32,
    pixels: Vec<[u8; 4]>,
}

impl std::fmt::Debug for Photo {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Photo({} × {})", self.width, self.height)
    }
}

impl Photo {
    /// A picture of `pixels` row by row from the top left: red, green, blue (sRGB) and alpha (straight,
    /// not multiplied in).
    ///
    /// # Errors
    /// [`ModelError::Picture`] when there are no pixels, or not `width` × `height` of them.
    pub fn new(width: u32, height: u32, pixels: Vec<[u8; 4]>) -> Result<Self> {
        check_size(width, height, pixels.len())?;
        Ok(Self { width, height, pixels })
    }

    /// Width in pixels, at least 1.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels, at least 1.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// All pixels, row by row from the top left.
    #[must_use]
    pub fn pixels(&self) -> &[[u8; 4]] {
        &self.pixels
    }

    /// The picture with left and right exchanged.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let rows = self.pixels.chunks(self.width as usize);
        let pixels = rows.flat_map(|row| row.iter().rev().copied()).collect();
        Self { pixels, ..*self }
    }

    /// Whether any pixel is not fully opaque.
    #[must_use]
    pub fn has_alpha(&self) -> bool {
        self.pixels.iter().any(|pixel| pixel[3] < 255)
    }

    /// Whether it holds more pixels than `limits` allow.
    pub(crate) fn check_limit(&self, limits: &Limits) -> Result<()> {
        Ok(limits.check(Resource::Pixels, self.pixels.len() as u64)?)
    }
}

/// Checks that `found` pixels fill a picture of this size, and that there is one.
pub(super) fn check_size(width: u32, height: u32, found: usize) -> Result<()> {
    let expected = u64::from(width) * u64::from(height);
    let problem = if expected == 0 {
        format!("it is {width} × {height} pixels; it needs at least one")
    } else if found as u64 != expected {
        format!("it is {width} × {height} pixels, which takes {expected}, but holds {found}")
    } else {
        return Ok(());
    };
    Err(ModelError::Picture { problem })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_must_fill_the_picture() {
        assert!(Photo::new(2, 2, vec![[0; 4]; 4]).is_ok());
        for (width, height, n) in [(0, 0, 0), (0, 5, 0), (2, 2, 3), (u32::MAX, u32::MAX, 1)] {
            let error = Photo::new(width, height, vec![[0; 4]; n]).unwrap_err();
            assert!(matches!(error, ModelError::Picture { .. }), "{error}");
        }
    }
}
