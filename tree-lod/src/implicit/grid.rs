//! The field at the nodes of a grid: every point adds to the nodes around it, layer by layer.
//!
//! A node sums in the order of the field's rows, whichever thread has its layer. Much cheaper than
//! asking the field at every node, which would visit cells without points within the radius again and
//! again.

use super::field::Metaballs;
use crate::error::{LodError, Result};
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Control, Resource};

/// A step of the grid must be this many times the step of 32-bit numbers at the farthest node, so that
/// no two vertices fall on one place ([`super::tetra`] keeps them a fiftieth of a step apart).
const RESOLVED: f32 = 1000.0;

/// Values at nodes; x runs fastest, then y, then z. All nodes on the border are 0.
pub(super) struct Grid {
    pub(super) nodes: [usize; 3],
    pub(super) step: f32,
    low: Vec3,
    pub(super) values: Vec<f32>,
}

impl Grid {
    pub(super) fn new(field: &Metaballs, detail: f32, control: &Control) -> Result<Self> {
        let step = field.radius() / detail;
        let margin = field.radius() + 1.5 * step;
        let (low, high) = (field.bounds().min - margin, field.bounds().max + margin);
        if step < RESOLVED * f32::EPSILON * low.abs().max(high.abs()).max_element() {
            return Err(LodError::Foliage(
                "the radius of influence is too small for where the elements stand: \
                 move them to the origin or take a larger share of the height",
            ));
        }
        let nodes = (high - low).to_array().map(|x| (f64::from(x) / f64::from(step)).ceil() + 1.0);
        // Saturates far above any limit.
        control.limits.check(Resource::Voxels, nodes.iter().product::<f64>() as u64)?;
        let nodes = nodes.map(|n| n as usize);
        let values = vec![0.0; nodes.iter().product()];
        let mut grid = Self { nodes, step, low, values };
        let mut values = std::mem::take(&mut grid.values);
        values
            .par_chunks_mut(nodes[0] * nodes[1])
            .enumerate()
            .try_for_each(|(z, layer)| control.check().map(|()| grid.fill(field, z, layer)))?;
        grid.values = values;
        Ok(grid)
    }

    fn fill(&self, field: &Metaballs, z: usize, layer: &mut [f32]) {
        let (radius, nodes_x) = (field.radius(), self.nodes[0]);
        let scale = 1.0 / (radius * radius);
        let height = self.place([0, 0, z]).z;
        for point in &field.points[field.rows_between(height - radius, height + radius)] {
            let left = radius * radius - (point.z - height) * (point.z - height);
            if left <= 0.0 {
                continue;
            }
            for y in self.reached(point.y, left.sqrt(), 1) {
                let far = point.y - self.coordinate(y, 1);
                let left = left - far * far;
                if left <= 0.0 {
                    continue;
                }
                for x in self.reached(point.x, left.sqrt(), 0) {
                    let far = point.x - self.coordinate(x, 0);
                    let share = (left - far * far).max(0.0) * scale;
                    layer[x + nodes_x * y] += share * share;
                }
            }
        }
    }

    /// Nodes along an axis within `reach` of a coordinate.
    fn reached(&self, x: f32, reach: f32, axis: usize) -> std::ops::Range<usize> {
        let from = ((x - reach - self.low[axis]) / self.step).ceil().max(0.0) as usize;
        let to = ((x + reach - self.low[axis]) / self.step).floor() as usize + 1;
        from..to.min(self.nodes[axis])
    }

    fn coordinate(&self, node: usize, axis: usize) -> f32 {
        self.low[axis] + node as f32 * self.step
    }

    pub(super) fn place(&self, node: [usize; 3]) -> Vec3 {
        Vec3::from_array([0, 1, 2].map(|axis| self.coordinate(node[axis], axis)))
    }

    /// Number of a node.
    pub(super) fn number(&self, [x, y, z]: [usize; 3]) -> usize {
        x + self.nodes[0] * (y + self.nodes[1] * z)
    }
}
