//! What is known of a photograph before it is matted: which pixels are tree, which are not.

use super::super::Photo;
use super::super::photo::check_size;
use crate::error::{ModelError, Result, check};
use glam::Vec2;
use rayon::prelude::*;

/// What is known of a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Level {
    /// Certainly not the tree.
    Background,
    /// To be found.
    #[default]
    Unknown,
    /// Certainly the tree.
    Foreground,
}

/// What is known of each pixel of a photograph.
#[derive(Clone, PartialEq, Eq)]
pub struct Trimap {
    width: u32,
    height: u32,
    levels: Vec<Level>,
}

impl std::fmt::Debug for Trimap {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Trimap({} × {})", self.width, self.height)
    }
}

/// A scribble over the photograph.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stroke {
    /// Its course in pixels from the top left corner. One point makes a dot.
    pub points: Vec<Vec2>,
    /// Its width in pixels, above 0 to 1e6.
    pub width: f32,
    /// Whether it marks the tree; otherwise the background.
    pub foreground: bool,
}

/// Colours picked from a photograph.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct ColorSamples {
    /// Colours of the tree (sRGB).
    pub foreground: Vec<[u8; 3]>,
    /// Colours of the background.
    pub background: Vec<[u8; 3]>,
    /// Pixels within this distance of a sample are known: a distance in the RGB cube of side 255, 0 to
    /// 442. Default 24.
    pub tolerance: f32,
}

impl Default for ColorSamples {
    fn default() -> Self {
        Self { foreground: Vec::new(), background: Vec::new(), tolerance: 24.0 }
    }
}

/// Grey levels below this are background, and above 255 less this foreground: between black, mid grey
/// and white, so that a compressed trimap still reads.
const DARK: u32 = 64;
/// Trimaps whose proportions differ from the photograph's by more than this share do not belong to it.
const ASPECT_TOLERANCE: f64 = 0.02;

impl Trimap {
    /// A trimap of `levels`, row by row from the top left.
    ///
    /// # Errors
    /// [`ModelError::Picture`] when there are no pixels, or not `width` × `height` of them.
    pub fn new(width: u32, height: u32, levels: Vec<Level>) -> Result<Self> {
        check_size(width, height, levels.len())?;
        Ok(Self { width, height, levels })
    }

    /// Reads a drawn trimap: black is background, white the tree, grey (and transparent) unknown.
    #[must_use]
    pub fn from_photo(photo: &Photo) -> Self {
        let level = |&[r, g, b, a]: &[u8; 4]| {
            let grey = (u32::from(r) + u32::from(g) + u32::from(b)) / 3;
            match grey {
                _ if a < 128 => Level::Unknown,
                0..DARK => Level::Background,
                grey if grey > 255 - DARK => Level::Foreground,
                _ => Level::Unknown,
            }
        };
        let levels = photo.pixels().par_iter().map(level).collect();
        Self { width: photo.width(), height: photo.height(), levels }
    }

    /// Paints strokes, in their order, over a trimap of which nothing is known.
    ///
    /// # Errors
    /// [`ModelError::Picture`] for a size of 0, [`ModelError::Parameter`] for a width out of range,
    /// [`ModelError::NotFinite`] for a point that is NaN or infinite.
    ///
    /// # Complexity
    /// O(pixels + painted area).
    pub fn from_strokes(width: u32, height: u32, strokes: &[Stroke]) -> Result<Self> {
        let n = u64::from(width) * u64::from(height);
        if n == 0 {
            check_size(width, height, 0)?;
        }
        let mut trimap = Self { width, height, levels: vec![Level::Unknown; n as usize] };
        for (index, stroke) in strokes.iter().enumerate() {
            check(format!("strokes[{index}].width"), stroke.width, f32::MIN_POSITIVE, 1e6_f32)?;
            if let Some(point) = stroke.points.iter().position(|point| !point.is_finite()) {
                return Err(ModelError::NotFinite {
                    field: format!("strokes[{index}].points[{point}]"),
                });
            }
            let level = if stroke.foreground { Level::Foreground } else { Level::Background };
            if let [point] = stroke.points[..] {
                trimap.paint(point, point, stroke.width, level);
            }
            for pair in stroke.points.windows(2) {
                trimap.paint(pair[0], pair[1], stroke.width, level);
            }
        }
        Ok(trimap)
    }

    /// Paints all pixels within half of `width` of a line, and those its ends lie in.
    fn paint(&mut self, from: Vec2, to: Vec2, width: f32, level: Level) {
        let radius = 0.5 * width;
        let size = Vec2::new(self.width as f32, self.height as f32);
        let low = (from.min(to) - radius).clamp(Vec2::ZERO, size).floor();
        let high = (from.max(to) + radius).clamp(Vec2::ZERO, size).ceil();
        // A line thinner than a pixel still marks the pixels it passes.
        let reach = radius.max(0.5);
        for y in low.y as usize..high.y as usize {
            for x in low.x as usize..high.x as usize {
                let center = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                if distance(center, from, to) <= reach {
                    self.levels[y * self.width as usize + x] = level;
                }
            }
        }
    }

    /// Marks the pixels that look like one of the sampled colours; where both sides do, the nearer
    /// sample decides.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] for a tolerance out of range, [`ModelError::Picture`] when either side
    /// has no sample.
    ///
    /// # Complexity
    /// O(pixels · samples).
    pub fn from_colors(photo: &Photo, samples: &ColorSamples) -> Result<Self> {
        check("tolerance", samples.tolerance, 0.0_f32, 442.0_f32)?;
        if samples.foreground.is_empty() || samples.background.is_empty() {
            let problem = "sample at least one colour of the tree and one of the background";
            return Err(ModelError::Picture { problem: problem.into() });
        }
        let near = |pixel: &[u8; 4], colors: &[[u8; 3]]| {
            let square = |i: usize, color: &[u8; 3]| {
                (i32::from(pixel[i]) - i32::from(color[i]))
                    * (i32::from(pixel[i]) - i32::from(color[i]))
            };
            colors
                .iter()
                .map(|c| square(0, c) + square(1, c) + square(2, c))
                .min()
                .unwrap_or(i32::MAX)
        };
        let limit = (samples.tolerance * samples.tolerance) as i32;
        let level = |pixel: &[u8; 4]| {
            let (tree, behind) =
                (near(pixel, &samples.foreground), near(pixel, &samples.background));
            match () {
                () if tree.min(behind) > limit => Level::Unknown,
                () if tree < behind => Level::Foreground,
                () => Level::Background,
            }
        };
        let levels = photo.pixels().par_iter().map(level).collect();
        Ok(Self { width: photo.width(), height: photo.height(), levels })
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

    /// All levels, row by row from the top left.
    #[must_use]
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// How many pixels are of this level.
    #[must_use]
    pub fn count(&self, level: Level) -> usize {
        self.levels.iter().filter(|&&found| found == level).count()
    }

    /// Whether it may belong to a photograph of this size: of the same proportions within 2 %, or within
    /// the pixel that rounding takes.
    ///
    /// # Errors
    /// [`ModelError::Picture`] otherwise.
    pub(super) fn check_fits(&self, width: u32, height: u32) -> Result<()> {
        let (w, h) = (f64::from(self.width), f64::from(self.height));
        let scale = w / f64::from(width);
        let off = (f64::from(height) * scale - h).abs();
        if off <= ASPECT_TOLERANCE * h || off < 1.0 {
            return Ok(());
        }
        Err(ModelError::Picture {
            problem: format!(
                "the trimap is {} × {} pixels, the photograph {width} × {height}; they must have the \
                 same proportions",
                self.width, self.height
            ),
        })
    }

    /// The level of the trimap's pixel under the centre of pixel (`x`, `y`) of a picture of this size.
    #[inline]
    pub(super) fn under(&self, x: usize, y: usize, width: usize, height: usize) -> Level {
        let (w, h) = (self.width as usize, self.height as usize);
        // Half pixels count twice, so that everything stays whole.
        let column = (2 * x + 1) * w / (2 * width);
        let row = (2 * y + 1) * h / (2 * height);
        self.levels[row.min(h - 1) * w + column.min(w - 1)]
    }
}

/// Distance of `point` from the line between `a` and `b`.
fn distance(point: Vec2, a: Vec2, b: Vec2) -> f32 {
    let along = b - a;
    let length = along.length_squared();
    let t = if length > 0.0 { ((point - a).dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
    point.distance(a + t * along)
}

#[cfg(test)]
mod tests {
    use super::Level::{Background as B, Foreground as F, Unknown as U};
    use super::*;

    #[test]
    fn black_grey_and_white_are_read() {
        let grey = |v: u8, a: u8| [v, v, v, a];
        let pixels = vec![grey(3, 255), grey(128, 255), grey(250, 255), grey(255, 0)];
        let trimap = Trimap::from_photo(&Photo::new(4, 1, pixels).unwrap());
        assert_eq!(trimap.levels(), [B, U, F, U]);
    }

    #[test]
    fn strokes_paint_in_their_order() {
        let stroke = |x: f32, foreground| Stroke {
            points: vec![Vec2::new(x, 0.5), Vec2::new(x + 2.0, 0.5)],
            width: 0.2,
            foreground,
        };
        let trimap = Trimap::from_strokes(6, 2, &[stroke(0.5, false), stroke(2.5, true)]).unwrap();
        assert_eq!(trimap.levels()[..6], [B, B, F, F, F, U]);
        assert_eq!(trimap.levels()[6..], [U; 6]);
    }

    #[test]
    fn strokes_far_outside_paint_nothing_and_nan_is_named() {
        let mut stroke = Stroke {
            points: vec![Vec2::splat(-1e30), Vec2::new(1e30, -1e30)],
            width: 3.0,
            foreground: true,
        };
        let trimap = Trimap::from_strokes(3, 3, std::slice::from_ref(&stroke)).unwrap();
        assert_eq!(trimap.count(U), 9);
        stroke.points[1].x = f32::NAN;
        let error = Trimap::from_strokes(3, 3, &[stroke.clone()]).unwrap_err();
        assert_eq!(error.to_string(), "strokes[0].points[1] is not finite");
        stroke.width = 0.0;
        assert!(Trimap::from_strokes(3, 3, &[stroke]).is_err());
        assert!(Trimap::from_strokes(0, 3, &[]).is_err());
    }

    #[test]
    fn pixels_near_a_sample_are_known() {
        let pixels = vec![[10, 80, 10, 255], [100, 100, 100, 255], [180, 200, 250, 255]];
        let photo = Photo::new(3, 1, pixels).unwrap();
        let samples = ColorSamples {
            foreground: vec![[20, 80, 20]],
            background: vec![[180, 200, 255]],
            ..Default::default()
        };
        let trimap = Trimap::from_colors(&photo, &samples).unwrap();
        assert_eq!(trimap.levels(), [F, U, B]);
        assert!(Trimap::from_colors(&photo, &ColorSamples::default()).is_err());
    }

    #[test]
    fn only_trimaps_of_like_proportions_fit() {
        let trimap = Trimap::new(100, 50, vec![U; 5000]).unwrap();
        assert!(trimap.check_fits(200, 100).is_ok());
        assert!(trimap.check_fits(201, 100).is_ok());
        assert!(trimap.check_fits(200, 150).is_err());
        assert!(trimap.check_fits(50, 100).is_err());
    }
}
