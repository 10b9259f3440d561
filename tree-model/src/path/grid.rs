//! A uniform grid over sorted points: the points of a run of cells along x are one slice.
//!
//! Cells are numbered brick by brick, so that points near in space are near in memory and a search
//! that spreads through them stays within few pages. A small grid is one brick.

use glam::Vec3;
use tree_core::{Aabb, LimitError, Resource};

/// At most this many cells for each point expected. A thin slanted volume fills little of its box;
/// without a cap its cells would outweigh its points.
const CELLS_PER_POINT: f32 = 6.0;

/// Grids up to this many cells are one brick: they fit a core's cache as they are.
const ONE_BRICK: u64 = 4096;

/// Binary logarithms of a brick's edges in cells: 16 × 8 × 8, some 400 points.
const BRICK: [u32; 3] = [4, 3, 3];

/// Where each cell's points begin, cells in bricks, x first in each.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    pub(crate) origin: Vec3,
    /// Edge of a cell in metres.
    pub(crate) cell: f32,
    per_metre: f32,
    pub(crate) dims: [u32; 3],
    /// Binary logarithms of a brick's edges in cells, and the number of bricks along x and y.
    brick: [u32; 3],
    bricks: [u32; 3],
    starts: Vec<u32>,
}

impl Grid {
    /// Cells of edge `cell`, or longer ones where that would be too many.
    ///
    /// # Errors
    /// [`LimitError`] when 32 bits do not number the cells; its cap is about the number of points whose
    /// cells they would.
    pub(crate) fn new(bounds: Aabb, cell: f32, n_points: u32) -> Result<Self, LimitError> {
        let size = bounds.size();
        let cap = CELLS_PER_POINT * n_points as f32 + 64.0;
        let mut cell = cell.max(f32::MIN_POSITIVE);
        let dims = |cell: f32| size.to_array().map(|side| (side / cell).floor() + 1.0);
        while dims(cell).iter().product::<f32>() > cap {
            cell *= 1.26; // the cube root of 2: half the cells
        }
        // A thin grid may have more cells along one side than 32 bits number.
        let dims = dims(cell).map(|n| n as u64);
        let small = dims.iter().product::<u64>() <= ONE_BRICK;
        // No brick is longer than the grid: thin grids would be mostly empty cells.
        let most = if small { [u32::MAX; 3] } else { BRICK };
        let brick = std::array::from_fn(|i| dims[i].next_power_of_two().ilog2().min(most[i]));
        let bricks: [u64; 3] = std::array::from_fn(|i| ((dims[i] - 1) >> brick[i]) + 1);
        let n_cells = bricks.iter().product::<u64>() << brick.iter().sum::<u32>();
        if n_cells > u64::from(u32::MAX) {
            let (requested, held) = (u64::from(n_points), u64::from(u32::MAX));
            // Cells grow in number as points do. The product of 32-bit numbers fits.
            let cap = requested * held / n_cells;
            return Err(LimitError { resource: Resource::GraphNodes, requested, cap });
        }
        let [dims, bricks] = [dims, bricks].map(|sides| sides.map(|n| n as u32));
        let per_metre = cell.recip();
        Ok(Self { origin: bounds.min, cell, per_metre, dims, brick, bricks, starts: Vec::new() })
    }

    /// Cell of a point; points outside count to the nearest cell.
    #[inline]
    pub(crate) fn cell_of(&self, point: Vec3) -> [u32; 3] {
        let cell = ((point - self.origin) * self.per_metre).to_array();
        // A cast from float saturates: below 0 becomes 0.
        std::array::from_fn(|i| (cell[i] as u32).min(self.dims[i] - 1))
    }

    /// Number of a cell.
    #[inline]
    fn number(&self, [x, y, z]: [u32; 3]) -> u32 {
        let [lx, ly, lz] = self.brick;
        let brick = ((z >> lz) * self.bricks[1] + (y >> ly)) * self.bricks[0] + (x >> lx);
        let within = |n: u32, log: u32| n & ((1 << log) - 1);
        let layer = (brick << lz) + within(z, lz);
        let row = (layer << ly) + within(y, ly);
        (row << lx) + within(x, lx)
    }

    #[inline]
    pub(crate) fn number_of(&self, point: Vec3) -> u32 {
        self.number(self.cell_of(point))
    }

    /// Number of cells, those that fill up bricks included.
    pub(crate) fn n_cells(&self) -> usize {
        let n_bricks: usize = self.bricks.iter().map(|&n| n as usize).product();
        n_bricks << self.brick.iter().sum::<u32>()
    }

    /// Sorts points, given by cell number, into the grid; returns each one's place.
    pub(crate) fn fill(&mut self, cells: &[u32]) -> Vec<u32> {
        let mut starts = vec![0_u32; self.n_cells() + 1];
        for &cell in cells {
            starts[cell as usize + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let places = cells
            .iter()
            .map(|&cell| {
                let slot = &mut next[cell as usize];
                *slot += 1;
                *slot - 1
            })
            .collect();
        self.starts = starts;
        places
    }

    /// Calls `visit` with runs of point indices that cover the points after point `a`, which lies at
    /// `point`, within `reach` of it: half of all neighbours, so that each pair is seen once. Points
    /// outside the grid's box are found too, because they count to its outermost cells.
    #[inline]
    pub(crate) fn for_runs_after(
        &self,
        a: usize,
        point: Vec3,
        reach: f32,
        mut visit: impl FnMut(std::ops::Range<usize>),
    ) {
        let low = self.cell_of(point - reach);
        let high = self.cell_of(point + reach);
        let log = self.brick[0];
        for z in low[2]..=high[2] {
            for y in low[1]..=high[1] {
                // A row of cells along x is contiguous within each brick it passes.
                let mut x = low[0];
                while x <= high[0] {
                    let last = high[0].min(x | ((1 << log) - 1));
                    let first = self.number([x, y, z]) as usize;
                    let end = self.starts[first + (last - x) as usize + 1] as usize;
                    let start = (self.starts[first] as usize).max(a + 1);
                    if start < end {
                        visit(start..end);
                    }
                    x = last + 1;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_beyond_32_bits_are_an_error_in_every_shape() {
        for size in [Vec3::ONE, Vec3::new(1.0, 1e-9, 1e-9), Vec3::new(1.0, 1.0, 1e-9)] {
            let bounds = Aabb::new(Vec3::ZERO, size);
            for n_points in [1_500_000_000, u32::MAX] {
                let error = Grid::new(bounds, f32::MIN_POSITIVE, n_points).unwrap_err();
                assert_eq!(error.requested, u64::from(n_points));
                let cap = u32::try_from(error.cap).unwrap();
                assert!((100_000_000..n_points).contains(&cap), "{size}: {cap}");
            }
            let grid = Grid::new(bounds, f32::MIN_POSITIVE, 100_000_000).unwrap();
            let cell = grid.cell_of(size);
            assert_eq!(cell, grid.dims.map(|n| n - 1));
            assert!((grid.number(cell) as usize) < grid.n_cells());
        }
    }
}
