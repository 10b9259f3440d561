//! Photographs at working size: linear pictures of f32, shrunk by averaging.

use super::super::Photo;
use rayon::prelude::*;

/// Colours 0 to 1 (sRGB as it is: matting in light or in sRGB differs little, and the photographs' noise
/// is even in sRGB).
pub(super) struct Colors {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) rgb: Vec<[f32; 3]>,
}

/// Width and height of a picture shrunk so that its longer side is at most `max_side`.
pub(super) fn working_size(width: u32, height: u32, max_side: u32) -> (usize, usize) {
    let longer = width.max(height);
    if longer <= max_side {
        return (width as usize, height as usize);
    }
    let scaled = |side: u32| (u64::from(side) * u64::from(max_side)).div_ceil(u64::from(longer));
    (scaled(width).max(1) as usize, scaled(height).max(1) as usize)
}

impl Colors {
    /// The photograph shrunk to this size, each pixel the mean of the area it covers.
    pub(super) fn shrunk(photo: &Photo, width: usize, height: usize) -> Self {
        let (from_width, from_height) = (photo.width() as usize, photo.height() as usize);
        let columns = shares(from_width, width);
        let rows = shares(from_height, height);
        let mut rgb = vec![[0.0; 3]; width * height];
        rgb.par_chunks_mut(width).zip(&rows).for_each(|(out, row)| {
            for (y, weight) in row.iter() {
                let line = &photo.pixels()[y * from_width..][..from_width];
                for (color, column) in out.iter_mut().zip(&columns) {
                    for (x, share) in column.iter() {
                        let w = weight * share / 255.0;
                        for (sum, &value) in color.iter_mut().zip(&line[x]) {
                            *sum += w * f32::from(value);
                        }
                    }
                }
            }
        });
        Self { width, height, rgb }
    }

    /// The same at half the size; a last odd column or row is dropped into its neighbour.
    pub(super) fn halved(&self) -> Self {
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let mut rgb = Vec::with_capacity(width * height);
        for y in 0..height {
            for x in 0..width {
                let mut sum = [0.0; 3];
                for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                    let column = (2 * x + dx).min(self.width - 1);
                    let row = (2 * y + dy).min(self.height - 1);
                    for (s, v) in sum.iter_mut().zip(self.rgb[row * self.width + column]) {
                        *s += 0.25 * v;
                    }
                }
                rgb.push(sum);
            }
        }
        Self { width, height, rgb }
    }
}

/// Which of the old pixels a new one covers, and how much each counts.
struct Share {
    first: usize,
    inner: usize,
    /// Weight of the first, of those between, and of the last.
    weights: [f32; 3],
}

impl Share {
    fn iter(&self) -> impl Iterator<Item = (usize, f32)> + '_ {
        (0..self.inner).map(|i| {
            let weight = match i {
                0 => self.weights[0],
                i if i + 1 == self.inner => self.weights[2],
                _ => self.weights[1],
            };
            (self.first + i, weight)
        })
    }
}

/// The shares of `from` pixels in each of `to` pixels.
fn shares(from: usize, to: usize) -> Vec<Share> {
    let scale = from as f64 / to as f64;
    let share = |i: usize| {
        let (low, high) = (i as f64 * scale, ((i + 1) as f64 * scale).min(from as f64));
        let first = (low.floor() as usize).min(from - 1);
        let end = (high.ceil() as usize).clamp(first + 1, from);
        let whole = high - low;
        let overlap = |j: usize| (high.min((j + 1) as f64) - low.max(j as f64)) / whole;
        let weights = [overlap(first), 1.0 / whole, overlap(end - 1)].map(|w| w as f32);
        Share { first, inner: end - first, weights }
    };
    (0..to).map(share).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shrinking_keeps_the_mean() {
        let pixels: Vec<_> = (0..70_u8).map(|i| [3 * i, i, 255 - i, 255]).collect();
        let photo = Photo::new(10, 7, pixels).unwrap();
        for (width, height) in [(10, 7), (5, 7), (3, 2), (1, 1), (7, 5)] {
            let colors = Colors::shrunk(&photo, width, height);
            let mean = colors.rgb.iter().map(|c| c[0]).sum::<f32>() / (width * height) as f32;
            let expected = 3.0 * 34.5 / 255.0;
            assert!((mean - expected).abs() < 1e-4, "{width} × {height}: {mean}");
        }
    }

    #[test]
    fn working_size_keeps_proportions_and_one_pixel() {
        assert_eq!(working_size(100, 50, 200), (100, 50));
        assert_eq!(working_size(1000, 500, 200), (200, 100));
        assert_eq!(working_size(u32::MAX, 1, 200), (200, 1));
    }
}
