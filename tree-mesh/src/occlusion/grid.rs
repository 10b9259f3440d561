//! A grid over the tree: how much light each cell lets through.

use super::sweep::Cube;
use crate::error::Result;
use crate::mesh::Surface;
use glam::Vec3;
use tree_core::{Aabb, Control};

/// Empty cells around the tree, so that light comes in unhindered and vertices look out of it.
const MARGIN: f32 = 2.0;
/// Share of its area that a triangle covers, seen from all directions in the mean.
const MEAN_COVER: f32 = 0.5;
/// Triangles between two questions whether the caller cancelled.
const TRIANGLES_PER_CHECK: usize = 1024;
/// Extents in metres outside which squares leave the range of 32-bit numbers.
const EXTENTS: std::ops::Range<f32> = 1e-12..1e12;

/// Smallest side of a cell as a share of the largest coordinate: about eight steps of it.
const CELL_MIN: f32 = 1e-6;

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
        let side = longest / cells as f32;
        let far = bounds.min.abs().max(bounds.max.abs()).max_element();
        // Cells of a few steps of the coordinates could not be told apart, nor triangles halved.
        if !EXTENTS.contains(&longest) || far > EXTENTS.end || side < far * CELL_MIN {
            return None;
        }
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
    pub(super) fn add(&mut self, surface: &Surface, opacity: f32, control: &Control) -> Result<()> {
        let mut pieces: Vec<([Vec3; 3], f32)> = Vec::new();
        for (number, corners) in surface.indices.chunks_exact(3).enumerate() {
            if number % TRIANGLES_PER_CHECK == 0 {
                control.check()?;
            }
            let [Some(&a), Some(&b), Some(&c)] = [0, 1, 2].map(|corner| {
                corners.get(corner).and_then(|&index| surface.positions.get(index as usize))
            }) else {
                continue;
            };
            let area = 0.5 * (b - a).cross(c - a).length() * opacity * MEAN_COVER;
            pieces.push(([a, b, c], area));
            while let Some(([a, b, c], area)) = pieces.pop() {
                // The longest side comes first, and is halved while it is longer than a cell.
                let [ab, bc, ca] = [a.distance(b), b.distance(c), c.distance(a)];
                let [a, b, c] = if ab >= bc && ab >= ca {
                    [a, b, c]
                } else if bc >= ca {
                    [b, c, a]
                } else {
                    [c, a, b]
                };
                if ab.max(bc).max(ca) > self.side {
                    let middle = (a + b) * 0.5;
                    pieces.push(([a, middle, c], 0.5 * area));
                    pieces.push(([middle, b, c], 0.5 * area));
                } else {
                    self.splat((a + b + c) / 3.0, area);
                }
            }
        }
        Ok(())
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
