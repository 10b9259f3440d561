//! A grid over the tree: how much light each cell lets through.

use super::sweep::Cube;
use crate::mesh::Surface;
use glam::Vec3;
use tree_core::Aabb;

/// Empty cells around the tree, so that light comes in unhindered and vertices look out of it.
const MARGIN: f32 = 2.0;
/// Share of its area that a triangle covers, seen from all directions in the mean.
const MEAN_COVER: f32 = 0.5;
/// Most pieces along the side of a triangle that is larger than a cell.
const PIECES_MAX: f32 = 1024.0;

/// Cells of equal sides, x first.
pub(super) struct Grid {
    low: Vec3,
    side: f32,
    pub(super) size: [usize; 3],
    /// First the area, then the share of light that passes.
    pub(super) open: Vec<f32>,
}

impl Grid {
    /// A grid with this many cells along the longest side of the bounds; nothing is allocated yet.
    pub(super) fn over(bounds: Aabb, cells: u32) -> Option<Self> {
        let size = bounds.size();
        let longest = size.max_element();
        if !(longest > 0.0 && longest.is_finite()) {
            return None;
        }
        let side = longest / cells as f32;
        let margin = 2 * MARGIN as u32;
        let count = |x: f32| (((x / side).ceil() as u32).clamp(1, cells) + margin + 1) as usize;
        let size = size.to_array().map(count);
        Some(Self { low: bounds.min - MARGIN * side, side, size, open: Vec::new() })
    }

    pub(super) fn allocate(&mut self) {
        self.open = vec![0.0; self.n_cells()];
    }

    pub(super) fn n_cells(&self) -> usize {
        self.size.iter().product()
    }

    /// Side of a cell in metres.
    pub(super) fn side(&self) -> f32 {
        self.side
    }

    /// Steps of the index along x, y and z.
    pub(super) fn strides(&self) -> [usize; 3] {
        [1, self.size[0], self.size[0] * self.size[1]]
    }

    /// The eight cells whose middles surround a point, and their shares.
    #[inline]
    fn around(&self, point: Vec3) -> [(usize, f32); 8] {
        // Just below the last middle, so that there always is a next cell.
        let most = Vec3::from_array(self.size.map(|count| count as f32 - 1.001));
        let at = ((point - self.low) / self.side - 0.5).clamp(Vec3::ZERO, most);
        let floor = at.floor();
        let part = at - floor;
        let [sx, sy, sz] = self.strides();
        let [x, y, z] = floor.to_array().map(|x| x as usize);
        let base = x * sx + y * sy + z * sz;
        let pick = |bit: bool, part: f32| if bit { part } else { 1.0 - part };
        std::array::from_fn(|i| {
            let (dx, dy, dz) = (i & 1 == 1, i & 2 == 2, i & 4 == 4);
            let step = usize::from(dx) * sx + usize::from(dy) * sy + usize::from(dz) * sz;
            (base + step, pick(dx, part.x) * pick(dy, part.y) * pick(dz, part.z))
        })
    }

    /// Adds the area of a surface's triangles, those larger than a cell in pieces.
    pub(super) fn add(&mut self, surface: &Surface, opacity: f32) {
        for corners in surface.indices.chunks_exact(3) {
            let [Some(&a), Some(&b), Some(&c)] = [0, 1, 2].map(|corner| {
                corners.get(corner).and_then(|&index| surface.positions.get(index as usize))
            }) else {
                continue;
            };
            let (u, v) = (b - a, c - a);
            let area = 0.5 * u.cross(v).length() * opacity * MEAN_COVER;
            let longest = u.length().max(v.length()).max((c - b).length());
            let pieces = (longest / self.side).ceil().clamp(1.0, PIECES_MAX);
            let n = pieces as u32;
            let share = area / (pieces * pieces);
            // n² equal triangles: of each row of the triangle those upright and those on their heads.
            for row in 0..n {
                for column in 0..n - row {
                    let at = |third: f32| {
                        let (s, t) = (row as f32 + third, column as f32 + third);
                        a + u * (s / pieces) + v * (t / pieces)
                    };
                    self.splat(at(1.0 / 3.0), share);
                    if column + row + 1 < n {
                        self.splat(at(2.0 / 3.0), share);
                    }
                }
            }
        }
    }

    fn splat(&mut self, point: Vec3, area: f32) {
        for (cell, share) in self.around(point) {
            if let Some(sum) = self.open.get_mut(cell) {
                *sum += area * share;
            }
        }
    }

    /// From areas to the share of light that passes a cell: exp(−area / face).
    pub(super) fn finish(&mut self) {
        let face = self.side * self.side;
        for open in &mut self.open {
            *open = if *open > 0.0 { libm::expf(-*open / face) } else { 1.0 };
        }
    }

    /// What the cubes hold at a point, between the eight cells around it.
    pub(super) fn between(&self, cubes: &[Cube], point: Vec3) -> Cube {
        let mut sum = Cube::default();
        for (cell, share) in self.around(point) {
            if let Some(cube) = cubes.get(cell) {
                for (sum, value) in sum.0.iter_mut().zip(cube.0) {
                    *sum += value * share;
                }
            }
        }
        sum
    }
}
