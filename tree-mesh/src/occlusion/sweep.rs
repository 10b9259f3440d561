//! Light carried through the grid, direction by direction.

use super::grid::Grid;
use super::{OcclusionParams, directions};
use crate::error::Result;
use glam::Vec3;
use rayon::prelude::*;
use tree_core::Control;

/// Directions swept at a time: memory for that many grids is held.
const BATCH: usize = 8;
/// Cells summed by one piece of work.
const CELLS_PER_PART: usize = 16_384;

/// Light on faces that look along +x, −x, +y, −y, +z and −z.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Cube(pub(super) [f32; 6]);

impl Cube {
    /// Light on a face with this normal: three faces weighed by the squares of its components.
    pub(super) fn along(&self, normal: Vec3) -> f32 {
        let squares = normal * normal;
        let total = squares.element_sum();
        if total <= 0.0 {
            return self.0.iter().sum::<f32>() / 6.0;
        }
        let [px, nx, py, ny, pz, nz] = self.0;
        let pick = |component: f32, up: f32, down: f32| if component >= 0.0 { up } else { down };
        (squares.x * pick(normal.x, px, nx)
            + squares.y * pick(normal.y, py, ny)
            + squares.z * pick(normal.z, pz, nz))
            / total
    }
}

/// The light in every cell: 1 in a cube's face when nothing is in its way.
pub(super) fn light(grid: &Grid, params: &OcclusionParams, control: &Control) -> Result<Vec<Cube>> {
    let lights = directions(params.directions);
    let sky = |light: Vec3| if light.y < 0.0 { params.ground } else { 1.0 };
    let weights: Vec<[f32; 6]> = lights
        .iter()
        .map(|&light| {
            let [x, y, z] = light.to_array();
            [x, -x, y, -y, z, -z].map(|cosine| cosine.max(0.0) * sky(light))
        })
        .collect();
    // Each face is measured by what it would get in the open: 1 there, whichever way it looks.
    let open = weights.iter().fold([0.0_f32; 6], |mut sum, weights| {
        sum.iter_mut().zip(weights).for_each(|(sum, weight)| *sum += weight);
        sum
    });
    let mut cubes = vec![Cube::default(); grid.n_cells()];
    let mut sweeps: Vec<Vec<f32>> = vec![Vec::new(); BATCH.min(lights.len())];
    for (lights, weights) in lights.chunks(BATCH).zip(weights.chunks(BATCH)) {
        control.check()?;
        sweeps.par_iter_mut().zip(lights).for_each(|(arrived, &light)| carry(grid, light, arrived));
        cubes.par_chunks_mut(CELLS_PER_PART).enumerate().for_each(|(part, cubes)| {
            let first = part * CELLS_PER_PART;
            for (arrived, weights) in sweeps.iter().zip(weights) {
                let arrived = arrived.get(first..).unwrap_or_default();
                for (cube, &arrived) in cubes.iter_mut().zip(arrived) {
                    for (sum, weight) in cube.0.iter_mut().zip(weights) {
                        *sum += arrived * weight;
                    }
                }
            }
        });
    }
    cubes.par_iter_mut().for_each(|cube| {
        cube.0.iter_mut().zip(open).for_each(|(face, open)| *face /= open.max(f32::MIN_POSITIVE));
    });
    Ok(cubes)
}

/// Light that arrives in every cell from one direction.
///
/// Layer by layer along the axis it mostly runs along: a cell gets what passed the four cells of the
/// layer before that lie where it comes from, by their shares.
pub(super) fn carry(grid: &Grid, light: Vec3, arrived: &mut Vec<f32>) {
    arrived.clear();
    arrived.resize(grid.n_cells(), 1.0);
    let (sizes, strides) = (grid.size, grid.strides());
    let steps = light.abs().to_array();
    let main = if steps[0] >= steps[1] && steps[0] >= steps[2] {
        0
    } else if steps[1] >= steps[2] {
        1
    } else {
        2
    };
    let (first, second) = ([1, 2, 0][main], [2, 0, 1][main]);
    let layers = sizes[main];
    let towards = light.to_array();
    // Where light comes from, one layer back, in cells.
    let shift = |axis: usize| towards[axis] / steps[main].max(f32::MIN_POSITIVE);
    let (a, b) = (Offset::new(shift(first)), Offset::new(shift(second)));
    // A slanted way through a cell is longer.
    let slant = 1.0 / steps[main].max(f32::MIN_POSITIVE);
    let (rows, columns) = (sizes[second], sizes[first]);
    let mut passed = vec![1.0_f32; rows * columns];
    for layer in 0..layers {
        let at = if towards[main] > 0.0 { layers - 1 - layer } else { layer };
        let base = at * strides[main];
        if layer > 0 {
            for row in 0..rows {
                let (r0, r1) = (b.at(row, rows), b.next(row, rows));
                for column in 0..columns {
                    let (c0, c1) = (a.at(column, columns), a.next(column, columns));
                    let read = |r: Option<usize>, c: Option<usize>| match (r, c) {
                        (Some(r), Some(c)) => passed.get(r * columns + c).copied().unwrap_or(1.0),
                        _ => 1.0,
                    };
                    let near = read(r0, c0) + (read(r0, c1) - read(r0, c0)) * a.part;
                    let far = read(r1, c0) + (read(r1, c1) - read(r1, c0)) * a.part;
                    let cell = base + row * strides[second] + column * strides[first];
                    if let Some(arrived) = arrived.get_mut(cell) {
                        *arrived = near + (far - near) * b.part;
                    }
                }
            }
        }
        for row in 0..rows {
            for column in 0..columns {
                let cell = base + row * strides[second] + column * strides[first];
                let (Some(arrived), Some(&open)) = (arrived.get(cell), grid.open.get(cell)) else {
                    continue;
                };
                if let Some(passed) = passed.get_mut(row * columns + column) {
                    *passed = arrived * slanted(open, slant);
                }
            }
        }
    }
}

/// What passes a cell on a way `slant` (1 to √3) times as long: open^slant, to within 0.02.
fn slanted(open: f32, slant: f32) -> f32 {
    // Between the first and the second power, without a transcendental function for every cell.
    let share = slant - 1.0;
    open * (1.0 - share + share * open)
}

/// A shift by a part of a cell: whole cells and the rest.
struct Offset {
    whole: isize,
    part: f32,
}

impl Offset {
    fn new(shift: f32) -> Self {
        let floor = shift.floor();
        Self { whole: floor as isize, part: shift - floor }
    }

    fn at(&self, index: usize, count: usize) -> Option<usize> {
        index.checked_add_signed(self.whole).filter(|&index| index < count)
    }

    fn next(&self, index: usize, count: usize) -> Option<usize> {
        index.checked_add_signed(self.whole + 1).filter(|&index| index < count)
    }
}
