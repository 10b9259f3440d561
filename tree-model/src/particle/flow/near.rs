//! Nearest neighbours among particles, in a uniform grid that is made anew every step.

use glam::{IVec3, Vec3};
use tree_core::Aabb;

/// Most cells for each particle: fewer would crowd them, more would only cost time to clear.
const CELLS_PER_POINT: f32 = 4.0;
/// Most cells along an axis.
const MAX_SIDE: f32 = 1024.0;

/// Points sorted into cells.
#[derive(Default)]
pub(super) struct Cells {
    corner: Vec3,
    side: f32,
    size: IVec3,
    /// Where each cell's points begin in `order`.
    starts: Vec<u32>,
    /// Points cell by cell, in ascending order within each.
    order: Vec<u32>,
    /// Their positions in the same order, so that a search reads memory in sequence.
    points: Vec<Vec3>,
    /// Cell of each point.
    cells: Vec<u32>,
}

impl Cells {
    /// Sorts the points; cells are no smaller than `least`. O(points + cells).
    pub(super) fn fill(&mut self, points: impl ExactSizeIterator<Item = Vec3> + Clone, least: f32) {
        let n = points.len();
        let bounds = points.clone().fold(Aabb::EMPTY, Aabb::including);
        let extent = if n == 0 { Vec3::ZERO } else { bounds.size() }.max(Vec3::splat(least));
        let volume = extent.x * extent.y * extent.z;
        let even = libm::cbrtf(volume / (CELLS_PER_POINT * n.max(1) as f32));
        self.side = even.max(least).max(extent.max_element() / MAX_SIDE);
        self.corner = if n == 0 { Vec3::ZERO } else { bounds.min };
        self.size = (extent / self.side).as_ivec3() + 1;
        let n_cells = (self.size.x * self.size.y * self.size.z) as usize;
        self.starts.clear();
        self.starts.resize(n_cells + 1, 0);
        self.cells.clear();
        for point in points.clone() {
            let cell = self.cell(self.cell_of(point)) as u32;
            self.cells.push(cell);
            self.starts[cell as usize + 1] += 1;
        }
        for i in 0..n_cells {
            self.starts[i + 1] += self.starts[i];
        }
        self.order.resize(n, 0);
        self.points.resize(n, Vec3::ZERO);
        // Each start walks to its cell's end, and is then that of the cell after it.
        for (i, point) in points.enumerate() {
            let at = &mut self.starts[self.cells[i] as usize];
            self.order[*at as usize] = i as u32;
            self.points[*at as usize] = point;
            *at += 1;
        }
        self.starts.rotate_right(1);
        self.starts[0] = 0;
    }

    fn cell_of(&self, point: Vec3) -> IVec3 {
        ((point - self.corner) / self.side).as_ivec3().clamp(IVec3::ZERO, self.size - 1)
    }

    fn cell(&self, at: IVec3) -> usize {
        ((at.z * self.size.y + at.y) * self.size.x + at.x) as usize
    }

    /// The nearest other point within `reach`, and its squared distance; the lower number of two that
    /// are equally near.
    pub(super) fn nearest(&self, i: u32, point: Vec3, reach: f32) -> Option<(u32, f32)> {
        let middle = self.cell_of(point);
        let mut best = (f32::INFINITY, u32::MAX);
        let last = (reach / self.side).ceil() as i32;
        for ring in 0..=last {
            self.search_ring(i, point, middle, ring, &mut best);
            // What is in the next ring is at least this far away.
            let safe = ring as f32 * self.side;
            if best.0 <= safe * safe {
                break;
            }
        }
        (best.0 <= reach * reach).then_some((best.1, best.0))
    }

    fn search_ring(&self, i: u32, point: Vec3, middle: IVec3, ring: i32, best: &mut (f32, u32)) {
        let low = (middle - ring).max(IVec3::ZERO);
        let high = (middle + ring).min(self.size - 1);
        for z in low.z..=high.z {
            for y in low.y..=high.y {
                let on_face = (z - middle.z).abs() == ring || (y - middle.y).abs() == ring;
                if on_face {
                    self.search_row(i, point, IVec3::new(low.x, y, z), high.x, best);
                    continue;
                }
                for x in [middle.x - ring, middle.x + ring] {
                    if (low.x..=high.x).contains(&x) {
                        self.search_row(i, point, IVec3::new(x, y, z), x, best);
                    }
                }
            }
        }
    }

    /// Cells of one row are one run of points.
    fn search_row(&self, i: u32, point: Vec3, from: IVec3, to_x: i32, best: &mut (f32, u32)) {
        let first = self.cell(from);
        let last = first + (to_x - from.x) as usize;
        let run = self.starts[first] as usize..self.starts[last + 1] as usize;
        for (&other, &at) in self.order[run.clone()].iter().zip(&self.points[run]) {
            let square = at.distance_squared(point);
            if other != i && (square, other) < *best {
                *best = (square, other);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_nearest_is_that_of_a_search_through_all(
            raw in prop::collection::vec((0_u8..40, 0_u8..40, 0_u8..20), 1..120),
            least in 0.01_f32..5.0,
            reach in 0.1_f32..30.0,
        ) {
            // Few different coordinates: many ties and coincident points.
            let points: Vec<Vec3> = raw
                .iter()
                .map(|&(x, y, z)| Vec3::new(x.into(), y.into(), z.into()) * 0.5)
                .collect();
            let mut cells = Cells::default();
            cells.fill(points.iter().copied(), least);
            for (i, &point) in (0_u32..).zip(&points) {
                let brute = (0_u32..)
                    .zip(&points)
                    .filter(|&(j, _)| j != i)
                    .map(|(j, p)| (p.distance_squared(point), j))
                    .filter(|&(square, _)| square <= reach * reach)
                    .min_by(|a, b| a.partial_cmp(b).unwrap())
                    .map(|(square, j)| (j, square));
                prop_assert_eq!(cells.nearest(i, point, reach), brute);
            }
        }
    }

    #[test]
    fn no_points_and_one_point_have_no_neighbours() {
        let mut cells = Cells::default();
        cells.fill([].into_iter(), 1.0);
        cells.fill([Vec3::ONE].into_iter(), 1.0);
        assert_eq!(cells.nearest(0, Vec3::ONE, 100.0), None);
    }
}
