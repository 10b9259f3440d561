//! Mattes: how much of each pixel the tree covers.

use super::photo::check_size;
use crate::error::{ModelError, Result};
use glam::Vec2;

/// How much of each pixel the tree covers, 0 (nothing) to 1 (all).
///
/// Pixel (0, 0) is at the top left; its area runs from (0, 0) to (1, 1), so its centre is (0.5, 0.5).
#[derive(Clone, PartialEq)]
pub struct Matte {
    width: u32,
    height: u32,
    alpha: Vec<f32>,
}

impl std::fmt::Debug for Matte {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Matte({} × {})", self.width, self.height)
    }
}

impl Matte {
    /// A matte of `alpha`, row by row from the top left. Values are clamped to 0 to 1.
    ///
    /// # Errors
    /// [`ModelError::Picture`] when there are no pixels or not `width` × `height` of them,
    /// [`ModelError::NotFinite`] when one is NaN.
    pub fn new(width: u32, height: u32, mut alpha: Vec<f32>) -> Result<Self> {
        check_size(width, height, alpha.len())?;
        for (index, value) in alpha.iter_mut().enumerate() {
            if value.is_nan() {
                return Err(ModelError::NotFinite { field: format!("alpha[{index}]") });
            }
            *value = value.clamp(0.0, 1.0);
        }
        Ok(Self { width, height, alpha })
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

    /// All values, row by row from the top left.
    #[must_use]
    pub fn alpha(&self) -> &[f32] {
        &self.alpha
    }

    /// The pixel in column `x` and row `y`; 0 outside the picture.
    #[must_use]
    #[inline]
    pub fn at(&self, x: i64, y: i64) -> f32 {
        let inside =
            (0..i64::from(self.width)).contains(&x) && (0..i64::from(self.height)).contains(&y);
        if inside { self.alpha[(y * i64::from(self.width) + x) as usize] } else { 0.0 }
    }

    /// The value at a point in pixels, between pixel centres by bilinear interpolation; 0 outside.
    #[must_use]
    pub fn sample(&self, point: Vec2) -> f32 {
        if !point.is_finite() {
            return 0.0;
        }
        let corner = point - 0.5;
        let (x, y) = (corner.x.floor(), corner.y.floor());
        let (fx, fy) = (corner.x - x, corner.y - y);
        let (x, y) = (i64::from(x as i32), i64::from(y as i32));
        let top = self.at(x, y) * (1.0 - fx) + self.at(x + 1, y) * fx;
        let bottom = self.at(x, y + 1) * (1.0 - fx) + self.at(x + 1, y + 1) * fx;
        top * (1.0 - fy) + bottom * fy
    }

    /// The matte with left and right exchanged.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let rows = self.alpha.chunks(self.width as usize);
        let alpha = rows.flat_map(|row| row.iter().rev().copied()).collect();
        Self { alpha, ..*self }
    }

    /// Covered area in pixels.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.alpha.iter().map(|&a| f64::from(a)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_meet_pixels_at_their_centres_and_fade_outside() {
        let matte = Matte::new(2, 1, vec![1.0, 0.5]).unwrap();
        assert_eq!(matte.sample(Vec2::new(0.5, 0.5)), 1.0);
        assert_eq!(matte.sample(Vec2::new(1.0, 0.5)), 0.75);
        assert_eq!(matte.sample(Vec2::new(0.0, 0.5)), 0.5);
        assert_eq!(matte.sample(Vec2::new(-1.0, 0.5)), 0.0);
        assert_eq!(matte.sample(Vec2::new(f32::NAN, 0.5)), 0.0);
        assert_eq!(matte.sample(Vec2::splat(1e30)), 0.0);
    }

    #[test]
    fn values_are_clamped_and_nan_is_refused() {
        assert_eq!(Matte::new(2, 1, vec![-1.0, 9.0]).unwrap().alpha(), [0.0, 1.0]);
        let error = Matte::new(2, 1, vec![0.0, f32::NAN]).unwrap_err();
        assert_eq!(error.to_string(), "alpha[1] is not finite");
    }
}
