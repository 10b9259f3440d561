//! A uniform grid over sorted points: the points of a run of cells along x are one slice.

use glam::Vec3;
use tree_core::Aabb;

/// At most this many cells for each point expected. A thin slanted volume fills little of its box;
/// without a cap its cells would outweigh its points.
const CELLS_PER_POINT: f32 = 6.0;

/// Where each cell's points begin. Cells are numbered x first, then y, then z.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    pub(crate) origin: Vec3,
    /// Edge of a cell in metres.
    pub(crate) cell: f32,
    per_metre: f32,
    pub(crate) dims: [u32; 3],
    starts: Vec<u32>,
}

impl Grid {
    /// Cells of edge `cell`, or longer ones where that would be too many.
    pub(crate) fn new(bounds: Aabb, cell: f32, n_points: u32) -> Self {
        let size = bounds.size();
        let cap = CELLS_PER_POINT * n_points as f32 + 64.0;
        let mut cell = cell.max(f32::MIN_POSITIVE);
        let dims = |cell: f32| size.to_array().map(|side| (side / cell).floor() + 1.0);
        while dims(cell).iter().product::<f32>() > cap {
            cell *= 1.26; // the cube root of 2: half the cells
        }
        let dims = dims(cell).map(|n| n as u32);
        Self { origin: bounds.min, cell, per_metre: cell.recip(), dims, starts: Vec::new() }
    }

    /// Cell of a point; points outside count to the nearest cell.
    #[inline]
    pub(crate) fn cell_of(&self, point: Vec3) -> [u32; 3] {
        let cell = ((point - self.origin) * self.per_metre).to_array();
        // A cast from float saturates: below 0 becomes 0.
        std::array::from_fn(|i| (cell[i] as u32).min(self.dims[i] - 1))
    }

    #[inline]
    pub(crate) fn index_of(&self, point: Vec3) -> u32 {
        let [x, y, z] = self.cell_of(point);
        (z * self.dims[1] + y) * self.dims[0] + x
    }

    /// Sorts points, given by cell, into the grid; returns each one's place.
    pub(crate) fn fill(&mut self, cells: &[u32]) -> Vec<u32> {
        let n_cells = self.dims.iter().product::<u32>() as usize;
        let mut starts = vec![0_u32; n_cells + 1];
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
    /// `point`, within `reach` of it. Half of all neighbours, so that each pair is seen once. Points
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
        let here = self.cell_of(point);
        let high = self.cell_of(point + reach);
        let start = |x: u32, y: u32, z: u32| {
            self.starts[((z * self.dims[1] + y) * self.dims[0] + x) as usize] as usize
        };
        let end = |x: u32, y: u32, z: u32| {
            self.starts[((z * self.dims[1] + y) * self.dims[0] + x) as usize + 1] as usize
        };
        // What is left of the own row, then the rows after it.
        visit(a + 1..end(high[0], here[1], here[2]));
        for z in here[2]..=high[2] {
            let first = if z == here[2] { here[1] + 1 } else { low[1] };
            for y in first..=high[1] {
                visit(start(low[0], y, z)..end(high[0], y, z));
            }
        }
    }
}
