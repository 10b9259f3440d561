//! Step 3a: the ground, where the scan shows some, is found and taken away.
//!
//! Seen from above, a cloud with ground has its lowest points on one slope almost everywhere, and open
//! air above them almost everywhere. Below a crown without ground the lowest points are the crown's,
//! at all heights; below a stump they lie level, but have wood above them.

use glam::{DMat3, DVec3, Vec3};

/// Cells along the longer side.
const CELLS: usize = 24;
/// The lowest points lie on the slope within this share of the height...
const ROUGH: f32 = 0.02;
/// ...or this many spacings.
const ROUGH_SPACINGS: f32 = 4.0;
/// Share of the cells that must lie on the slope...
const COVERED: f32 = 0.7;
/// ...and of those that must be open above.
const OPEN: f32 = 0.5;
/// Steepest slope, tangent.
const STEEP: f64 = 1.0;
/// Points this many spacings above the lowest of their cell belong to the ground.
const THICK: f32 = 3.0;
const ROUNDS: usize = 5;

/// The ground as a slope and what stands above it cell by cell.
#[derive(Debug)]
pub(super) struct Ground {
    low: Vec3,
    cell: f32,
    n: [usize; 2],
    /// Height of the ground in each cell.
    heights: Vec<f32>,
    thick: f32,
}

impl Ground {
    /// The ground, if there is one.
    pub(super) fn find(points: &[Vec3], spacing: f32) -> Option<Self> {
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for point in points {
            (low, high) = (low.min(*point), high.max(*point));
        }
        let size = high - low;
        let cell = (size.x.max(size.z) / CELLS as f32).max(2.0 * spacing);
        let n = [size.x, size.z].map(|side| (side / cell) as usize + 1);
        let mut ground = Self {
            low,
            cell,
            n,
            heights: vec![f32::INFINITY; n[0] * n[1]],
            thick: THICK * spacing,
        };
        for point in points {
            let cell = ground.cell_of(*point);
            ground.heights[cell] = ground.heights[cell].min(point.y);
        }
        let rough = (ROUGH * size.y).max(ROUGH_SPACINGS * spacing);
        let plane = ground.slope(low.y + 0.25 * size.y, f64::from(rough))?;
        let level: Vec<f32> =
            (0..ground.heights.len()).map(|cell| ground.at(plane, cell)).collect();
        let (mut open, mut covered, mut n_cells) = (vec![true; level.len()], 0, 0);
        for point in points {
            let cell = ground.cell_of(*point);
            let above = point.y - level[cell];
            open[cell] &= !(2.0 * rough..8.0 * rough).contains(&above);
        }
        let mut n_open = 0;
        for (cell, height) in ground.heights.iter().enumerate().filter(|(_, h)| h.is_finite()) {
            n_cells += 1;
            if (height - level[cell]).abs() <= rough {
                covered += 1;
                n_open += usize::from(open[cell]);
            }
        }
        let is_ground = covered as f32 >= COVERED * n_cells as f32
            && n_open as f32 >= OPEN * covered as f32
            && n_cells >= CELLS;
        // Where the lowest point is none of the ground, the slope goes on.
        for (height, level) in ground.heights.iter_mut().zip(level) {
            if !height.is_finite() || (*height - level).abs() > rough {
                *height = level;
            }
        }
        is_ground.then_some(ground)
    }

    /// Height of the ground under a point.
    pub(super) fn height(&self, point: Vec3) -> f32 {
        self.heights[self.cell_of(point)]
    }

    pub(super) fn holds(&self, point: Vec3) -> bool {
        point.y <= self.height(point) + self.thick
    }

    fn cell_of(&self, point: Vec3) -> usize {
        let at = (point - self.low) / self.cell;
        let (x, z) = ((at.x as usize).min(self.n[0] - 1), (at.z as usize).min(self.n[1] - 1));
        z * self.n[0] + x
    }

    /// Middle of a cell in the plane.
    fn middle(&self, cell: usize) -> [f64; 2] {
        [cell % self.n[0], cell / self.n[0]].map(|i| (i as f64 + 0.5) * f64::from(self.cell))
    }

    fn at(&self, plane: DVec3, cell: usize) -> f32 {
        let [x, z] = self.middle(cell);
        (plane.x * x + plane.y * z + plane.z) as f32
    }

    /// Least squares through the lowest points of cells, first those below `start`, then those near
    /// the slope so far.
    fn slope(&self, start: f32, rough: f64) -> Option<DVec3> {
        let mut plane: Option<DVec3> = None;
        for _ in 0..ROUNDS {
            let (mut matrix, mut right) = (DMat3::ZERO, DVec3::ZERO);
            for (cell, &height) in self.heights.iter().enumerate() {
                let [x, z] = self.middle(cell);
                let row = DVec3::new(x, z, 1.0);
                let near = match plane {
                    None => height <= start,
                    Some(plane) => (f64::from(height) - plane.dot(row)).abs() <= 2.0 * rough,
                };
                if near && height.is_finite() {
                    matrix += DMat3::from_cols(row * row.x, row * row.y, row);
                    right += f64::from(height) * row;
                }
            }
            let found = matrix.inverse() * right;
            if !found.is_finite() || found.truncate().length() > STEEP {
                return None;
            }
            plane = Some(found);
        }
        plane
    }
}
