//! Averages of a matte over boxes (summed-area table, Crow 1984), and how far it reaches in each row.

use super::super::matte::Matte;
use glam::Vec2;
use rayon::prelude::*;

/// Larger pictures are reduced to this many pixels along their longer side: eight for each of the most
/// voxels there can be.
const WORKING_SIZE: u32 = 2048;
/// Pixels covered less than this are haze: they do not widen the tree.
const HAZE: f32 = 0.1;
/// Share of a row's covered area beyond which it does not reach, on either side: a few specks do not
/// widen the tree.
const TRIM: f32 = 0.01;

/// A matte ready to be averaged over boxes. Lengths are in pixels of the matte itself.
#[derive(Debug)]
pub(super) struct Coverage {
    /// Size of the picture.
    size: Vec2,
    /// Pixels for a cell.
    cell: f32,
    nx: usize,
    ny: usize,
    /// Sum of all cells above and to the left of each corner; (nx + 1) × (ny + 1).
    sums: Vec<f64>,
    /// First and last point of each row of cells that the tree covers.
    reach: Vec<Reach>,
}

/// First and last point of a row that the tree covers; `None` where it covers nothing.
type Reach = Option<(f32, f32)>;

impl Coverage {
    pub(super) fn new(matte: &Matte) -> Self {
        let (width, height) = (matte.width(), matte.height());
        let cell = width.max(height).div_ceil(WORKING_SIZE);
        let (nx, ny) = (width.div_ceil(cell) as usize, height.div_ceil(cell) as usize);
        let rows: Vec<(Vec<f64>, Reach)> = (0..ny)
            .into_par_iter()
            .with_min_len(16)
            .map(|y| {
                let row = reduced_row(matte, cell as usize, nx, y);
                let reach = reach(&row, cell as f32);
                let mut sum = 0.0;
                let sums = std::iter::once(0.0)
                    .chain(row.iter().map(|&alpha| {
                        sum += f64::from(alpha);
                        sum
                    }))
                    .collect();
                (sums, reach)
            })
            .collect();
        let mut sums = Vec::with_capacity((nx + 1) * (ny + 1));
        sums.resize(nx + 1, 0.0);
        for (y, (row, _)) in rows.iter().enumerate() {
            let above = y * (nx + 1);
            for (x, sum) in row.iter().enumerate() {
                sums.push(sums[above + x] + sum);
            }
        }
        let reach = rows.into_iter().map(|(_, reach)| reach).collect();
        let size = Vec2::new(width as f32, height as f32);
        Self { size, cell: cell as f32, nx, ny, sums, reach }
    }

    /// The average over a box around `center`, of what of it lies in the picture; `None` where less than
    /// half of it does.
    pub(super) fn mean(&self, center: Vec2, half: Vec2) -> Option<f32> {
        let half = half.max(Vec2::splat(1e-3));
        let low = (center - half).clamp(Vec2::ZERO, self.size);
        let high = (center + half).clamp(Vec2::ZERO, self.size);
        let inside = high - low;
        let area = inside.x * inside.y;
        if area.is_nan() || area < 0.5 * 4.0 * half.x * half.y {
            return None;
        }
        let (a, b) = (low / self.cell, high / self.cell);
        let sum = self.sum(b.x, b.y) - self.sum(a.x, b.y) - self.sum(b.x, a.y) + self.sum(a.x, a.y);
        let cells = f64::from(b.x - a.x) * f64::from(b.y - a.y);
        Some((sum / cells.max(1e-12)).clamp(0.0, 1.0) as f32)
    }

    /// The sum over all cells above and to the left of a point: bilinear between the corners, which is
    /// exact for cells of one value each.
    fn sum(&self, x: f32, y: f32) -> f64 {
        let column = (x as usize).min(self.nx - 1);
        let row = (y as usize).min(self.ny - 1);
        let (fx, fy) = (f64::from(x) - column as f64, f64::from(y) - row as f64);
        let at = row * (self.nx + 1) + column;
        let below = at + self.nx + 1;
        let top = self.sums[at] * (1.0 - fx) + self.sums[at + 1] * fx;
        let bottom = self.sums[below] * (1.0 - fx) + self.sums[below + 1] * fx;
        top * (1.0 - fy) + bottom * fy
    }

    /// How far the tree reaches to the left and right around the row `y`: the mean over the covered rows
    /// within `half`, near ones counting more. `None` where no row is covered, or all lie outside.
    pub(super) fn reach(&self, y: f32, half: f32) -> Reach {
        if !y.is_finite() {
            return None;
        }
        let half = half.max(self.cell);
        let first = ((y - half) / self.cell).floor().max(0.0) as usize;
        let last = ((y + half) / self.cell).ceil().clamp(0.0, self.ny as f32) as usize;
        let (mut sum, mut weights) = (Vec2::ZERO, 0.0);
        for row in first..last {
            let Some((left, right)) = self.reach[row] else { continue };
            let off = ((row as f32 + 0.5) * self.cell - y).abs() / half;
            let weight = (1.0 - off).max(0.0);
            sum += weight * Vec2::new(left, right);
            weights += weight;
        }
        (weights > 0.0).then(|| (sum.x / weights, sum.y / weights))
    }

    /// The box around what is covered; `None` when nothing is.
    pub(super) fn bounds(&self) -> Option<(Vec2, Vec2)> {
        let mut bounds: Option<(Vec2, Vec2)> = None;
        for (row, reach) in self.reach.iter().enumerate() {
            let Some((left, right)) = *reach else { continue };
            let top = row as f32 * self.cell;
            let bottom = (top + self.cell).min(self.size.y);
            let (low, high) = bounds.unwrap_or((Vec2::new(left, top), Vec2::new(right, bottom)));
            bounds = Some((low.min(Vec2::new(left, top)), high.max(Vec2::new(right, bottom))));
        }
        bounds
    }

    /// Size of the picture in pixels.
    pub(super) fn size(&self) -> Vec2 {
        self.size
    }
}

/// Averages of `cell` × `cell` pixels, one row of them.
fn reduced_row(matte: &Matte, cell: usize, nx: usize, y: usize) -> Vec<f32> {
    let width = matte.width() as usize;
    let pixels = matte.alpha().chunks_exact(width).skip(y * cell).take(cell);
    let mut row = vec![0.0; nx];
    let mut counts = vec![0_u32; nx];
    for line in pixels {
        for (x, part) in line.chunks(cell).enumerate() {
            row[x] += part.iter().sum::<f32>();
            counts[x] += part.len() as u32;
        }
    }
    for (value, &count) in row.iter_mut().zip(&counts) {
        *value /= count.max(1) as f32;
    }
    row
}

/// First and last point of a row that the tree covers.
fn reach(row: &[f32], cell: f32) -> Reach {
    let covered = |&alpha: &f32| if alpha < HAZE { 0.0 } else { alpha };
    let total: f32 = row.iter().map(covered).sum();
    if total <= 0.0 {
        return None;
    }
    let end = |sum_to: f32, values: &mut dyn Iterator<Item = &f32>| {
        let mut sum = 0.0;
        values
            .take_while(|alpha| {
                sum += covered(alpha);
                sum <= sum_to
            })
            .count()
    };
    let left = end(TRIM * total, &mut row.iter());
    let right = row.len() - end(TRIM * total, &mut row.iter().rev());
    Some((left as f32 * cell, right.max(left + 1) as f32 * cell))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_are_averaged_exactly_also_between_pixels() {
        let matte = Matte::new(3, 2, vec![1.0, 0.0, 0.5, 0.0, 1.0, 0.0]).unwrap();
        let coverage = Coverage::new(&matte);
        let mean = |x, y, w, h| coverage.mean(Vec2::new(x, y), Vec2::new(w, h));
        assert!((mean(1.5, 1.0, 1.5, 1.0).unwrap() - 2.5 / 6.0).abs() < 1e-6);
        assert!((mean(1.0, 0.5, 0.5, 0.5).unwrap() - 0.5).abs() < 1e-6);
        assert!((mean(2.5, 0.5, 0.1, 0.1).unwrap() - 0.5).abs() < 1e-5);
        assert_eq!(mean(-1.0, 0.5, 0.5, 0.5), None);
        assert_eq!(mean(f32::NAN, 0.5, 0.5, 0.5), None);
    }

    #[test]
    fn a_row_reaches_from_its_first_to_its_last_pixel_but_not_to_haze() {
        let matte = Matte::new(5, 1, vec![0.05, 0.0, 1.0, 1.0, 0.0]).unwrap();
        let coverage = Coverage::new(&matte);
        assert_eq!(coverage.reach(0.5, 1.0), Some((2.0, 4.0)));
        assert_eq!(coverage.reach(7.0, 1.0), None);
        assert_eq!(coverage.bounds(), Some((Vec2::new(2.0, 0.0), Vec2::new(4.0, 1.0))));
        assert_eq!(Coverage::new(&Matte::new(1, 1, vec![0.0]).unwrap()).bounds(), None);
    }
}
