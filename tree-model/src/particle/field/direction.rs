//! The field itself: a grid of directions over a picture.

use glam::Vec2;

/// Directions on a grid over a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectionField {
    /// Cells across and down.
    pub(super) size: [u32; 2],
    /// Pixels for a cell.
    pub(super) cell: f32,
    /// Where the grid begins, in pixels: the top left corner of its first cell.
    pub(super) corner: Vec2,
    /// One vector for each cell, row by row from the top left; x to the right, y up, length 0 to 1.
    pub(super) vectors: Vec<Vec2>,
}

impl DirectionField {
    /// Cells across and down.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Pixels for a cell.
    #[must_use]
    pub fn cell(&self) -> f32 {
        self.cell
    }

    /// One vector for each cell, row by row from the top left; x to the right, y *up*, length 0 to 1.
    #[must_use]
    pub fn vectors(&self) -> &[Vec2] {
        &self.vectors
    }

    /// The direction at a point of the picture, in pixels, between cells by bilinear interpolation;
    /// outside the grid that of the nearest cell. Zero where the field has none.
    #[must_use]
    #[inline]
    pub fn sample(&self, pixel: Vec2) -> Vec2 {
        let [nx, ny] = self.size;
        if nx == 0 || ny == 0 {
            return Vec2::ZERO;
        }
        let at = (pixel - self.corner) / self.cell - 0.5;
        let last = Vec2::new((nx - 1) as f32, (ny - 1) as f32);
        let at = at.max(Vec2::ZERO).min(last);
        let (x, y) = (at.x as u32, at.y as u32);
        let (fx, fy) = (at.x - x as f32, at.y - y as f32);
        let row = |y: u32| {
            let start = (y.min(ny - 1) * nx) as usize;
            let (a, b) = (x.min(nx - 1) as usize, (x + 1).min(nx - 1) as usize);
            self.vectors[start + a] * (1.0 - fx) + self.vectors[start + b] * fx
        };
        row(y) * (1.0 - fy) + row(y + 1) * fy
    }
}
