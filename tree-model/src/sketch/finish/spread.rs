//! How many leaves there are, and where.

use glam::{IVec3, Vec3};
use tree_core::Skeleton;

/// Cells along the longest side of the box around a tree, in which places for leaves are counted.
const CELLS: f32 = 28.0;
/// How evenly leaves spread: a cell bears in proportion to its places to this power. 1 is as many everywhere as the
/// shoots have places, 0 the same in every cell.
const EVENNESS: f32 = 0.6;
/// Times the factor that makes the sum right is corrected for cells that bear all they can.
const ROUNDS: u32 = 6;

/// A box of cells.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    corner: Vec3,
    cell: f32,
    size: IVec3,
    counts: Vec<f32>,
}

impl Cells {
    /// Empty cells about a skeleton.
    pub(super) fn about(skeleton: &Skeleton) -> Self {
        let bounds = skeleton.bounds();
        let extent = bounds.size();
        let cell = (extent.max_element() / CELLS).max(f32::MIN_POSITIVE);
        // A cell more on each side: leaves stand off.
        let size = (extent / cell).ceil().as_ivec3() + IVec3::splat(3);
        let n = size.element_product().max(0) as usize;
        Self { corner: bounds.min - cell, cell, size, counts: vec![0.0; n] }
    }

    fn index(&self, point: Vec3) -> Option<usize> {
        let at = ((point - self.corner) / self.cell).floor();
        // Not a number is in no cell.
        if !(at.cmpge(Vec3::ZERO).all() && at.cmplt(self.size.as_vec3()).all()) {
            return None;
        }
        let at = at.as_ivec3();
        Some(((at.z * self.size.y + at.y) * self.size.x + at.x) as usize)
    }

    /// Counts points.
    pub(super) fn count(&mut self, points: impl Iterator<Item = Vec3>) {
        for point in points {
            self.add(point, 1.0);
        }
    }

    /// Adds to the count of the cell about `point`.
    pub(super) fn add(&mut self, point: Vec3, count: f32) {
        if let Some(i) = self.index(point) {
            self.counts[i] += count;
        }
    }

    /// Volume of the cells with a point in them.
    pub(super) fn volume(&self) -> f32 {
        let n = self.counts.iter().filter(|&&count| count > 0.0).count();
        n as f32 * self.cell * self.cell * self.cell
    }

    /// Area of the cells with a point in them as seen along an axis, on average of the three axes.
    pub(super) fn area(&self) -> f32 {
        let size = self.size.as_uvec3().to_array().map(|n| n as usize);
        let mut seen = [(1, 2), (0, 2), (0, 1)].map(|(a, b)| vec![false; size[a] * size[b]]);
        for (i, _) in self.counts.iter().enumerate().filter(|&(_, &count)| count > 0.0) {
            let (x, y, z) = (i % size[0], i / size[0] % size[1], i / (size[0] * size[1]));
            seen[0][z * size[1] + y] = true;
            seen[1][z * size[0] + x] = true;
            seen[2][y * size[0] + x] = true;
        }
        let n = seen.iter().flatten().filter(|&&seen| seen).count();
        n as f32 / 3.0 * self.cell * self.cell
    }

    /// Turns counts of places into how many leaves are to stand at each, `wanted` in all and at most `most` at one.
    pub(super) fn spread(mut self, wanted: f32, most: f32) -> Self {
        // A place may be asked about a little beside where it was counted: an empty cell is as one with one place.
        let shares = self.counts.iter().map(|&count| libm::powf(count.max(1.0), EVENNESS - 1.0));
        let shares: Vec<f32> = shares.collect();
        let mut factor = 0.0;
        let (mut full, mut open) = (0.0, 0.0);
        for _ in 0..ROUNDS {
            let (was_full, was_open) = (full, open);
            (full, open) = (0.0, 0.0);
            for (&count, &share) in self.counts.iter().zip(&shares) {
                if factor * share >= most { full += most * count } else { open += share * count }
            }
            factor = (wanted - full).max(0.0) / open.max(f32::MIN_POSITIVE);
            if (was_full, was_open) == (full, open) {
                break;
            }
        }
        for (count, share) in self.counts.iter_mut().zip(shares) {
            *count = (factor * share).min(most);
        }
        self
    }

    /// The number of the cell about `point`; 0 outside.
    pub(super) fn at(&self, point: Vec3) -> f32 {
        self.index(point).map_or(0.0, |i| self.counts[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stick() -> Skeleton {
        let mut builder = Skeleton::builder(Vec3::ZERO, 0.1).unwrap();
        builder.add(0, 28.0 * Vec3::Y, 0.1).unwrap();
        builder.finish()
    }

    #[test]
    fn as_many_leaves_are_asked_for_as_wanted() {
        let mut cells = Cells::about(&stick());
        let points: Vec<Vec3> =
            (0..300).map(|i| (i as f32 * i as f32 / 3300.0) * Vec3::Y).collect();
        cells.count(points.iter().copied());
        let cells = cells.spread(100.0, 4.0);
        let asked: f32 = points.iter().map(|&p| cells.at(p)).sum();
        assert!((asked - 100.0).abs() < 1.0, "{asked}");
        assert!(cells.at(points[0]) < cells.at(points[299]));
    }

    #[test]
    fn what_lies_outside_gets_none() {
        let mut cells = Cells::about(&stick());
        cells.count([Vec3::splat(1e9), Vec3::NAN].into_iter());
        assert_eq!((cells.volume(), cells.at(Vec3::splat(1e9))), (0.0, 0.0));
    }

    #[test]
    fn area_is_that_of_what_is_seen() {
        let mut cells = Cells::about(&stick());
        cells.count((0..28).map(|i| (i as f32 + 0.5) * Vec3::Y));
        assert!((cells.area() - 57.0 / 3.0).abs() < 0.1, "{}", cells.area());
        assert!((cells.volume() - 28.0).abs() < 0.1, "{}", cells.volume());
    }
}
