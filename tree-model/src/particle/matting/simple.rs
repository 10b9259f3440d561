//! Mattes where the background is known: blue screen and difference matting (thesis, section 3.2.1).
//!
//! Both look at each pixel alone. A photograph's own alpha is ignored.

use super::super::{Matte, Photo};
use crate::error::{ModelError, Result, check};
use rayon::prelude::*;
use tree_core::Control;

/// Colour of the screen behind the tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum ScreenColor {
    /// Blue: right for green leaves.
    #[default]
    Blue,
    /// Green: for autumn leaves and bare branches.
    Green,
}

/// How [`screen`] finds the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct ScreenParams {
    /// Colour of the screen. Default blue.
    pub color: ScreenColor,
    /// The thesis' α₁: how fast alpha falls with the surplus of the screen's colour, 0 to 100. 1 over the
    /// surplus of the bare screen makes that fully transparent. Default 2.
    pub gain: f32,
    /// The thesis' α₂: how much of the screen's colour a pixel of the tree may hold for each part of the
    /// other one (green for blue, blue for green), 0 to 10. Default 1.
    pub balance: f32,
}

impl Default for ScreenParams {
    fn default() -> Self {
        Self { color: ScreenColor::Blue, gain: 2.0, balance: 1.0 }
    }
}

impl ScreenParams {
    /// Checks ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        check("gain", self.gain, 0.0_f32, 100.0_f32)?;
        check("balance", self.balance, 0.0_f32, 10.0_f32)
    }
}

/// Blue-screen matting after Smith and Blinn (1996): `α = 1 − α₁ (C_b − α₂ C_g)`, clamped to 0 to 1.
///
/// # Errors
/// [`ModelError::Parameter`], [`ModelError::Limit`], [`ModelError::Cancelled`].
///
/// # Complexity
/// O(pixels).
pub fn screen(photo: &Photo, params: &ScreenParams, control: &Control) -> Result<Matte> {
    params.validate()?;
    photo.check_limit(&control.limits)?;
    control.report("screen matting", 0.0)?;
    let alpha = photo.pixels().par_iter().map(|&[_, g, b, _]| {
        let (key, other) = match params.color {
            ScreenColor::Blue => (b, g),
            ScreenColor::Green => (g, b),
        };
        let surplus = f32::from(key) - params.balance * f32::from(other);
        1.0 - params.gain * surplus / 255.0
    });
    Matte::new(photo.width(), photo.height(), alpha.collect())
}

/// How [`difference`] tells the tree from the background.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct DifferenceParams {
    /// Difference of colours at which a pixel is half tree: distance in the RGB cube of side 1, 0 to 2.
    /// Default 0.15.
    pub threshold: f32,
    /// Width of the soft step around the threshold, 0 (hard) to 2. Default 0.15.
    pub softness: f32,
}

impl Default for DifferenceParams {
    fn default() -> Self {
        Self { threshold: 0.15, softness: 0.15 }
    }
}

impl DifferenceParams {
    /// Checks ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        check("threshold", self.threshold, 0.0_f32, 2.0_f32)?;
        check("softness", self.softness, 0.0_f32, 2.0_f32)
    }
}

/// Difference matting: the tree is where the photograph differs from `plate`, taken of the same view
/// without the tree. The thesis names a threshold; a soft one keeps thin twigs.
///
/// # Errors
/// [`ModelError::Picture`] when both differ in size; [`ModelError::Parameter`], [`ModelError::Limit`],
/// [`ModelError::Cancelled`].
///
/// # Complexity
/// O(pixels).
pub fn difference(
    photo: &Photo,
    plate: &Photo,
    params: &DifferenceParams,
    control: &Control,
) -> Result<Matte> {
    params.validate()?;
    photo.check_limit(&control.limits)?;
    if (photo.width(), photo.height()) != (plate.width(), plate.height()) {
        return Err(ModelError::Picture {
            problem: format!(
                "the photograph is {} × {} pixels, that without the tree {} × {}; they must be the same",
                photo.width(),
                photo.height(),
                plate.width(),
                plate.height()
            ),
        });
    }
    control.report("difference matting", 0.0)?;
    // Half of the step lies below the threshold. A hard step is a very narrow one.
    let width = params.softness.max(1e-6);
    let alpha = photo.pixels().par_iter().zip(plate.pixels()).map(|(&a, &b)| {
        let square =
            |i: usize| (f32::from(a[i]) - f32::from(b[i])) * (f32::from(a[i]) - f32::from(b[i]));
        let distance = (square(0) + square(1) + square(2)).sqrt() / 255.0;
        (distance - params.threshold) / width + 0.5
    });
    Matte::new(photo.width(), photo.height(), alpha.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn photo(pixels: &[[u8; 3]]) -> Photo {
        let pixels: Vec<_> = pixels.iter().map(|&[r, g, b]| [r, g, b, 255]).collect();
        Photo::new(pixels.len() as u32, 1, pixels).unwrap()
    }

    #[test]
    fn a_mixture_before_a_screen_gives_its_share() {
        // Grey has as much blue as green, and so no surplus; the screen is pure.
        let mixed = photo(&[[100, 100, 100], [50, 50, 177], [0, 0, 255]]);
        let params = ScreenParams { gain: 1.0, ..Default::default() };
        let matte = screen(&mixed, &params, &Control::default()).unwrap();
        for (found, expected) in matte.alpha().iter().zip([1.0, 0.5, 0.0]) {
            assert!((found - expected).abs() < 0.01, "{found} is not {expected}");
        }
        let mixed = photo(&[[100, 100, 100], [50, 177, 50], [0, 255, 0]]);
        let green = ScreenParams { color: ScreenColor::Green, ..params };
        let same = screen(&mixed, &green, &Control::default()).unwrap();
        assert_eq!(same, matte);
    }

    #[test]
    fn what_differs_from_the_plate_is_tree() {
        let plate = photo(&[[200, 200, 250]; 3]);
        let found = photo(&[[200, 200, 250], [178, 178, 228], [20, 60, 10]]);
        let matte = difference(&found, &plate, &Default::default(), &Control::default()).unwrap();
        assert_eq!(matte.alpha()[0], 0.0);
        assert!((matte.alpha()[1] - 0.5).abs() < 0.05, "{:?}", matte.alpha());
        assert_eq!(matte.alpha()[2], 1.0);
        let hard = DifferenceParams { threshold: 0.1, softness: 0.0 };
        let matte = difference(&found, &plate, &hard, &Control::default()).unwrap();
        assert_eq!(matte.alpha(), [0.0, 1.0, 1.0]);
    }

    #[test]
    fn bad_input_is_refused() {
        let (one, two) = (photo(&[[0; 3]]), photo(&[[0; 3]; 2]));
        let control = Control::default();
        let refused = difference(&one, &two, &Default::default(), &control);
        assert!(matches!(refused, Err(ModelError::Picture { .. })));
        let params = ScreenParams { gain: f32::NAN, ..Default::default() };
        assert!(matches!(screen(&one, &params, &control), Err(ModelError::Parameter(_))));
        let mut small = Control::default();
        small.limits.pixels = 1;
        assert!(matches!(screen(&two, &Default::default(), &small), Err(ModelError::Limit(_))));
    }
}
