//! The area of an outline in cells.

use crate::silhouette::Outline;
use glam::Vec2;

/// Cells along the longer side.
const CELLS: usize = 64;

/// Cells of an outline, and which of them are covered.
pub(super) struct Raster {
    low: Vec2,
    high: Vec2,
    size: [usize; 2],
    pub(super) cell: f32,
    inside: Vec<bool>,
    covered: Vec<bool>,
}

impl Raster {
    pub(super) fn of(outline: &Outline) -> Self {
        let (low, high) = outline.bounds();
        let cell = ((high - low).max_element() / CELLS as f32).max(f32::MIN_POSITIVE);
        let count = |length: f32| ((length / cell).ceil() as usize).clamp(1, CELLS + 1);
        let size = [count(high.x - low.x), count(high.y - low.y)];
        let high = low + cell * Vec2::new(size[0] as f32, size[1] as f32);
        let inside = outline.mask(low, high, size[0], size[1]);
        let covered = vec![false; inside.len()];
        Self { low, high, size, cell, inside, covered }
    }

    fn cells(&self, outline: &Outline) -> Vec<bool> {
        outline.mask(self.low, self.high, self.size[0], self.size[1])
    }

    pub(super) fn add(&mut self, outline: &Outline) {
        let cells = self.cells(outline);
        self.covered.iter_mut().zip(cells).for_each(|(covered, cell)| *covered |= cell);
    }

    /// Cells of an outline, and those of them that are covered.
    pub(super) fn overlap(&self, outline: &Outline) -> (usize, usize) {
        let cells = self.cells(outline);
        let both = cells.iter().zip(&self.covered).filter(|&(&cell, &covered)| cell && covered);
        (cells.iter().filter(|&&cell| cell).count(), both.count())
    }

    /// Share of the inside that is covered.
    pub(super) fn covered(&self) -> f32 {
        let both =
            self.inside.iter().zip(&self.covered).filter(|&(&inside, &cover)| inside && cover);
        both.count() as f32 / self.inside.iter().filter(|&&inside| inside).count().max(1) as f32
    }

    pub(super) fn is_covered(&self, point: Vec2) -> bool {
        self.cell_of(point).is_some_and(|cell| self.covered[cell])
    }

    pub(super) fn is_inside(&self, point: Vec2) -> bool {
        self.cell_of(point).is_some_and(|cell| self.inside[cell])
    }

    fn cell_of(&self, point: Vec2) -> Option<usize> {
        let place = (point - self.low) / self.cell;
        let (x, y) = (place.x.floor() as i64, place.y.floor() as i64);
        let within = x >= 0 && y >= 0 && x < self.size[0] as i64 && y < self.size[1] as i64;
        within.then(|| y as usize * self.size[0] + x as usize)
    }
}
