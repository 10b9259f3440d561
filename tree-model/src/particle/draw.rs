//! Simple drawing onto photographs: lines, arrows and dots, for pictures of what a stage did.
//!
//! Coordinates are pixels from the top left. Coverage is the distance to the line, so that edges are smooth;
//! what lies outside the picture is cut off. O(length · width) for a line.

use super::photo::check_size;
use super::{Matte, Photo};
use crate::error::Result;
use glam::{DVec2, Vec2};
use tree_core::{Limits, Resource};

/// A colour: red, green, blue (sRGB) and how much it covers, 0 to 255.
pub type Color = [u8; 4];

/// Share of an arrow's length that its head takes.
const HEAD: f32 = 0.35;

/// Length of the pieces in which a line is drawn, in times its half width.
const PIECE: f32 = 4.0;

/// Largest half width of a line in pixels, so that squares of lengths stay numbers; wider ones are drawn so wide.
const RADIUS_MAX: f32 = 1e6;

/// A picture to draw on.
#[derive(Clone, Debug)]
pub struct Canvas {
    width: u32,
    height: u32,
    pixels: Vec<Color>,
}

impl Canvas {
    /// A copy of a photograph.
    #[must_use]
    pub fn over(photo: &Photo) -> Self {
        Self { width: photo.width(), height: photo.height(), pixels: photo.pixels().to_vec() }
    }

    /// A matte in grey: white where the tree covers.
    #[must_use]
    pub fn of_matte(matte: &Matte) -> Self {
        let grey = |&alpha: &f32| {
            let value = (255.0 * alpha + 0.5) as u8;
            [value, value, value, 255]
        };
        let pixels = matte.alpha().iter().map(grey).collect();
        Self { width: matte.width(), height: matte.height(), pixels }
    }

    /// One colour all over.
    ///
    /// # Errors
    /// [`ModelError::Picture`](crate::ModelError::Picture) for a size of 0,
    /// [`ModelError::Limit`](crate::ModelError::Limit) for more pixels than `limits` allow.
    pub fn blank(width: u32, height: u32, color: Color, limits: &Limits) -> Result<Self> {
        let n = u64::from(width) * u64::from(height);
        limits.check(Resource::Pixels, n)?;
        check_size(width, height, n as usize)?;
        Ok(Self { width, height, pixels: vec![color; n as usize] })
    }

    /// The picture.
    ///
    /// # Errors
    /// None that can happen: a canvas is never empty.
    pub fn finish(self) -> Result<Photo> {
        Photo::new(self.width, self.height, self.pixels)
    }

    /// Draws lines from end to end, each with its width in pixels.
    pub fn segments(&mut self, segments: &[(Vec2, Vec2, f32)], color: Color) {
        for &(from, to, width) in segments {
            self.line(from, to, width, color);
        }
    }

    /// Draws a line with round ends. A line that is not finite is left out.
    pub fn line(&mut self, from: Vec2, to: Vec2, width: f32, color: Color) {
        if !width.is_finite() {
            return;
        }
        let radius = (0.5 * width).clamp(0.0, RADIUS_MAX);
        let reach = radius + 1.0;
        let Some((from, to)) = self.clip(from, to, reach) else { return };
        let along = to - from;
        let per_length2 = 1.0 / along.length_squared().max(1e-12);
        // In short pieces, so that the box around a long slanted line is not walked in full.
        let pieces = ((along.length() / (PIECE * reach)).ceil() as u32).max(1);
        for piece in 0..pieces {
            let end = |piece: u32| from + along * (piece as f32 / pieces as f32);
            let (a, b) = (end(piece), end(piece + 1));
            let (low, high) = ((a.min(b) - reach).max(Vec2::ZERO), a.max(b) + reach);
            let x1 = (high.x.max(0.0) as u32).saturating_add(1).min(self.width);
            let y1 = (high.y.max(0.0) as u32).saturating_add(1).min(self.height);
            for y in low.y as u32..y1 {
                for x in low.x as u32..x1 {
                    let point = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                    let t = ((point - from).dot(along) * per_length2).clamp(0.0, 1.0);
                    // A pixel belongs to one piece, so that none is painted twice.
                    if ((t * pieces as f32) as u32).min(pieces - 1) == piece {
                        let aside = point.distance(from + along * t);
                        let coverage = (radius + 0.5 - aside).clamp(0.0, 1.0) * width.min(1.0);
                        self.blend(x, y, color, coverage);
                    }
                }
            }
        }
    }

    /// Draws a line with a head at `to`.
    pub fn arrow(&mut self, from: Vec2, to: Vec2, width: f32, color: Color) {
        self.line(from, to, width, color);
        let back = HEAD * (from - to);
        for side in [back.perp(), -back.perp()] {
            self.line(to, to + back + 0.5 * side, width, color);
        }
    }

    /// Fills the pixels whose corners lie from `low` up to `high`.
    pub fn fill(&mut self, low: Vec2, high: Vec2, color: Color) {
        let (low, high) = (low.max(Vec2::ZERO), high.max(Vec2::ZERO));
        for y in low.y as u32..(high.y as u32).min(self.height) {
            for x in low.x as u32..(high.x as u32).min(self.width) {
                self.blend(x, y, color, 1.0);
            }
        }
    }

    /// Draws a disc.
    pub fn dot(&mut self, at: Vec2, radius: f32, color: Color) {
        self.line(at, at, 2.0 * radius, color);
    }

    /// The part of a line that can be seen, `reach` beyond the picture included.
    fn clip(&self, from: Vec2, to: Vec2, reach: f32) -> Option<(Vec2, Vec2)> {
        if !(from.is_finite() && to.is_finite()) {
            return None;
        }
        // In f64: the difference of two f32 may be beyond f32.
        let (from, to, reach) = (from.as_dvec2(), to.as_dvec2(), f64::from(reach));
        let low = DVec2::splat(-reach);
        let high = DVec2::new(f64::from(self.width), f64::from(self.height)) + reach;
        let along = to - from;
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        for axis in 0..2 {
            if along[axis] == 0.0 {
                if from[axis] < low[axis] || from[axis] > high[axis] {
                    return None;
                }
                continue;
            }
            let a = (low[axis] - from[axis]) / along[axis];
            let b = (high[axis] - from[axis]) / along[axis];
            first = first.max(a.min(b));
            last = last.min(a.max(b));
        }
        // Rounding takes ends of enormous lines far out again.
        let inside = |share: f64| (from + along * share).max(low).min(high).as_vec2();
        (first <= last).then(|| (inside(first), inside(last)))
    }

    /// Lays a colour over a pixel.
    fn blend(&mut self, x: u32, y: u32, color: Color, coverage: f32) {
        let share = coverage * f32::from(color[3]) / 255.0;
        if share <= 0.0 {
            return;
        }
        let row = y as usize * self.width as usize + x as usize;
        if let Some(pixel) = self.pixels.get_mut(row) {
            for channel in 0..3 {
                let (old, new) = (f32::from(pixel[channel]), f32::from(color[channel]));
                pixel[channel] = (old + share * (new - old) + 0.5) as u8;
            }
            pixel[3] = pixel[3].max((255.0 * share) as u8);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn canvas() -> Canvas {
        Canvas::blank(40, 30, [0, 0, 0, 255], &Limits::default()).unwrap()
    }

    fn sum(canvas: &Canvas) -> f32 {
        canvas.pixels.iter().map(|pixel| f32::from(pixel[0]) / 255.0).sum()
    }

    #[test]
    fn a_line_covers_its_area_once() {
        let mut canvas = canvas();
        canvas.line(Vec2::new(5.0, 5.0), Vec2::new(33.0, 25.0), 3.0, [255; 4]);
        let (length, caps) = (34.41, std::f32::consts::PI * 1.5 * 1.5);
        let area = sum(&canvas);
        assert!((area - (3.0 * length + caps)).abs() < 3.0, "{area}");
    }

    #[test]
    fn lines_outside_or_not_finite_leave_the_picture_as_it_is() {
        let mut canvas = canvas();
        for far in [1e9, -1e9, f32::NAN, f32::INFINITY] {
            canvas.line(Vec2::new(far, 1.0), Vec2::new(far, 9.0), 2.0, [255; 4]);
            canvas.arrow(Vec2::splat(far), Vec2::splat(far), 2.0, [255; 4]);
        }
        assert_eq!(sum(&canvas), 0.0);
        canvas.line(Vec2::new(-1e9, 10.5), Vec2::new(1e9, 10.5), 1.0, [255; 4]);
        assert!((sum(&canvas) - 40.0).abs() < 1.0);
    }

    #[test]
    fn enormous_lines_are_drawn_as_fast_as_others() {
        for (from, to, width) in [
            (Vec2::new(-3e38, 10.5), Vec2::new(3e38, 10.5), 1.0),
            (Vec2::splat(-3e38), Vec2::splat(3e38), 1.0),
            (Vec2::splat(-3e38), Vec2::splat(3e38), 3e38),
            (Vec2::new(1.0, -3e38), Vec2::new(3e38, 1.0), 1e30),
        ] {
            let mut canvas = canvas();
            canvas.line(from, to, width, [255; 4]);
            assert!(sum(&canvas) <= 1200.0);
        }
    }
}
