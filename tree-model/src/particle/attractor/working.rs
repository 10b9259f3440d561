//! The working picture: the tree's part of matte and photograph, at the resolution of the search.

use super::plane::Plane;
use crate::particle::{Matte, Photo};
use glam::Vec2;

/// A pixel belongs to the tree's box from this alpha on: less is haze that matting leaves in the sky.
const BOX_ALPHA: f32 = 0.25;

/// Room around the tree's box, as a share of its height, so that the outside is seen at every silhouette.
const MARGIN: f32 = 0.04;

/// Widest working picture, in times its rows: bounds the work for pictures of very wide things.
const WIDEST: f32 = 3.0;

/// The tree's part of a picture, scaled down.
pub(super) struct Working {
    /// Where the working picture begins, in pixels of the whole.
    pub(super) corner: Vec2,
    /// Pixels of the whole in one working pixel, across and down, at least 1.
    pub(super) scale: f32,
    /// Coverage, 0 to 1.
    pub(super) alpha: Plane,
    /// Red, green and blue, 0 to 1, as seen where the tree covers; empty without a photograph.
    pub(super) colors: Vec<Plane>,
    /// Height of the tree's box in pixels of the whole.
    pub(super) tree_height: f32,
}

/// The box of all covered pixels as (lowest, highest) corner; `None` where nothing is covered.
pub(super) fn covered(matte: &Matte) -> Option<(Vec2, Vec2)> {
    let mut low = Vec2::splat(f32::INFINITY);
    let mut high = Vec2::splat(f32::NEG_INFINITY);
    let width = matte.width() as usize;
    for (y, row) in matte.alpha().chunks_exact(width).enumerate() {
        let is_tree = |&alpha: &f32| alpha >= BOX_ALPHA;
        if let (Some(first), Some(last)) =
            (row.iter().position(is_tree), row.iter().rposition(is_tree))
        {
            low = low.min(Vec2::new(first as f32, y as f32));
            high = high.max(Vec2::new((last + 1) as f32, (y + 1) as f32));
        }
    }
    (low.x < high.x).then_some((low, high))
}

impl Working {
    /// The part of the picture around the covered pixels and `points`, about `rows` working pixels high;
    /// `None` where nothing is covered. `photo` has the matte's size.
    ///
    /// O(pixels).
    pub(super) fn new(
        matte: &Matte,
        photo: Option<&Photo>,
        points: &[Vec2],
        rows: u32,
    ) -> Option<Self> {
        let (mut low, mut high) = covered(matte)?;
        let tree_height = high.y - low.y;
        let picture = Vec2::new(matte.width() as f32, matte.height() as f32);
        for &point in points {
            let point = point.clamp(Vec2::ZERO, picture);
            (low, high) = (low.min(point), high.max(point));
        }
        let margin = (MARGIN * (high.y - low.y)).max(1.0).ceil();
        let low = (low - margin).floor().max(Vec2::ZERO);
        let high = (high + margin).ceil().min(picture).max(low + 1.0);
        let size = high - low;
        let rows = rows as f32;
        let scale = (size.y / rows).max(size.x / (WIDEST * rows)).max(1.0);
        let count = |length: f32| ((length / scale).ceil() as usize).max(1);
        let (width, height) = (count(size.x), count(size.y));
        let mut working = Self {
            corner: low,
            scale,
            alpha: Plane::new(width, height),
            colors: vec![Plane::new(width, height); if photo.is_some() { 3 } else { 0 }],
            tree_height,
        };
        working.average(matte, photo, high);
        Some(working)
    }

    /// Fills the planes with means over the pixels whose centres lie in a working pixel. Colours are
    /// weighted with alpha, so that the sky between leaves does not count.
    fn average(&mut self, matte: &Matte, photo: Option<&Photo>, high: Vec2) {
        let width = self.alpha.width;
        let columns: Vec<usize> = (self.corner.x as usize..high.x as usize)
            .map(|x| (((x as f32 + 0.5 - self.corner.x) / self.scale) as usize).min(width - 1))
            .collect();
        let mut counts = vec![0.0_f32; self.alpha.values.len()];
        let mut weights = vec![1e-6_f32; counts.len()];
        let stride = matte.width() as usize;
        for y in self.corner.y as usize..high.y as usize {
            let row = ((y as f32 + 0.5 - self.corner.y) / self.scale) as usize;
            let start = row.min(self.alpha.height - 1) * width;
            for (i, &column) in columns.iter().enumerate() {
                let from = y * stride + self.corner.x as usize + i;
                let into = start + column;
                let alpha = matte.alpha()[from];
                counts[into] += 1.0;
                self.alpha.values[into] += alpha;
                let Some(photo) = photo else { continue };
                let weight = alpha + 1e-4;
                weights[into] += weight;
                for (plane, &value) in self.colors.iter_mut().zip(&photo.pixels()[from]) {
                    plane.values[into] += weight * f32::from(value) / 255.0;
                }
            }
        }
        let divide = |plane: &mut Plane, by: &[f32]| {
            plane.values.iter_mut().zip(by).for_each(|(value, by)| *value /= by.max(1e-6));
        };
        divide(&mut self.alpha, &counts);
        self.colors.iter_mut().for_each(|plane| divide(plane, &weights));
    }

    /// The working pixel that holds a point of the whole picture, or the nearest to it.
    pub(super) fn pixel(&self, point: Vec2) -> usize {
        let at = ((point - self.corner) / self.scale).max(Vec2::ZERO);
        let x = (at.x as usize).min(self.alpha.width - 1);
        let y = (at.y as usize).min(self.alpha.height - 1);
        y * self.alpha.width + x
    }

    /// Column and row of a working pixel.
    pub(super) fn column_row(&self, pixel: usize) -> (usize, usize) {
        (pixel % self.alpha.width, pixel / self.alpha.width)
    }

    /// The centre of a working pixel, in pixels of the whole.
    pub(super) fn center(&self, pixel: usize) -> Vec2 {
        let (x, y) = self.column_row(pixel);
        self.corner + self.scale * (Vec2::new(x as f32, y as f32) + 0.5)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn working_pixels_are_means_of_the_pixels_they_hold() {
        let alpha = (0..40 * 80).map(|i| if i % 40 < 20 { 1.0 } else { 0.0 }).collect();
        let matte = Matte::new(40, 80, alpha).unwrap();
        let photo = Photo::new(40, 80, vec![[255, 0, 51, 255]; 40 * 80]).unwrap();
        let working = Working::new(&matte, Some(&photo), &[], 40).unwrap();
        assert_eq!(working.scale, 2.0);
        assert!(working.alpha.values[0] == 1.0);
        assert!((working.colors[2].values[0] - 0.2).abs() < 1e-3);
        for pixel in 0..working.alpha.values.len() {
            assert_eq!(working.pixel(working.center(pixel)), pixel);
        }
    }

    #[test]
    fn nothing_covered_is_no_picture() {
        assert!(Working::new(&Matte::new(3, 3, vec![0.0; 9]).unwrap(), None, &[], 10).is_none());
    }
}
