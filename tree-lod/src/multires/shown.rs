//! What each branch shows of itself and of its leaves.
//!
//! From four sides the tree is laid on a grid. A cell of area `c` on which areas lie that are `a` together shows
//! c (1 − exp(−a / c)) of them, as if they lay by chance (Beer and Lambert), in equal shares. So a leaf in a dense crown is worth
//! less than one that stands alone.

use std::f64::consts::FRAC_1_SQRT_2;
use tree_core::{Foliage, Skeleton};

/// Where each side has its right: x and z.
const SIDES: [[f64; 2]; 4] =
    [[1.0, 0.0], [FRAC_1_SQRT_2, FRAC_1_SQRT_2], [0.0, 1.0], [-FRAC_1_SQRT_2, FRAC_1_SQRT_2]];
/// Cells along the tree's longest extent. From 32 to 128 the orders that come of it are equally good.
const CELLS: usize = 64;
/// Area of a leaf of length 1 on a picture: half as wide as long, and turned anyhow.
const LEAF_AREA: f64 = 0.25;

/// Area in m² that each branch shows, the mean of all sides. Branches are named by the node; `first` tells whether a node
/// is the first of its branch.
pub(super) fn shown(
    skeleton: &Skeleton,
    foliage: &Foliage,
    branch_of: &[u32],
    n_branches: usize,
    first: impl Fn(usize) -> bool,
) -> Vec<f64> {
    let mut areas = vec![0.0; n_branches];
    for side in SIDES {
        let grid = Grid::new(skeleton, side);
        let mut load = vec![0.0; CELLS * CELLS];
        grid.each(skeleton, foliage, &first, |_, cell, area| load[cell] += area);
        for load in &mut load {
            let layers = *load / grid.cell_area();
            *load = if layers > 1e-9 { (1.0 - libm::exp(-layers)) / layers } else { 1.0 };
        }
        grid.each(skeleton, foliage, &first, |node, cell, area| {
            areas[branch_of[node] as usize] += area * load[cell] / SIDES.len() as f64;
        });
    }
    areas
}

/// A tree seen from one side.
struct Grid {
    right: [f64; 2],
    /// What lies in its middle.
    center: [f64; 3],
    /// Metres along a cell.
    cell: f64,
}

impl Grid {
    fn new(skeleton: &Skeleton, right: [f64; 2]) -> Self {
        let bounds = skeleton.bounds();
        let [x, y, z] = bounds.size().to_array().map(f64::from);
        let extent = (x * x + z * z).sqrt().max(y).max(1e-6);
        let center = (0.5 * (bounds.min.as_dvec3() + bounds.max.as_dvec3())).to_array();
        Self { right, center, cell: 1.05 * extent / CELLS as f64 }
    }

    fn cell_area(&self) -> f64 {
        self.cell * self.cell
    }

    /// Columns and rows from the middle on.
    fn place(&self, point: glam::Vec3) -> [f64; 2] {
        let [x, y, z] = point.to_array().map(f64::from);
        let [cx, cy, cz] = self.center;
        let column = (x - cx) * self.right[0] + (z - cz) * self.right[1];
        [column / self.cell, (y - cy) / self.cell]
    }

    /// What lies beyond the grid counts at its rim.
    fn cell(place: [f64; 2]) -> usize {
        let half = 0.5 * CELLS as f64;
        let [column, row] = place.map(|x| (x + half).clamp(0.0, CELLS as f64 - 1.0) as usize);
        row * CELLS + column
    }

    /// Calls `each` with node, cell and area of all segments, cell by cell, and of all leaves.
    fn each(
        &self,
        skeleton: &Skeleton,
        foliage: &Foliage,
        first: impl Fn(usize) -> bool,
        mut each: impl FnMut(usize, usize, f64),
    ) {
        let (positions, radii) = (skeleton.positions(), skeleton.radii());
        for (parent, node) in skeleton.segments() {
            let (parent, node) = (parent as usize, node as usize);
            let (from, to) = (self.place(positions[parent]), self.place(positions[node]));
            let way = [to[0] - from[0], to[1] - from[1]];
            let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
            // A twig is not as wide as the limb that it stands on.
            let foot = if first(node) { radii[node] } else { radii[parent] };
            let area = length * self.cell * (f64::from(foot) + f64::from(radii[node]));
            let steps = length.ceil().clamp(1.0, 2.0 * CELLS as f64);
            for step in 0..steps as usize {
                let at = (step as f64 + 0.5) / steps;
                let cell = Self::cell([from[0] + at * way[0], from[1] + at * way[1]]);
                each(node, cell, area / steps);
            }
        }
        for leaf in foliage.iter() {
            let size = f64::from(leaf.size);
            let cell = Self::cell(self.place(leaf.position));
            each(leaf.node as usize, cell, LEAF_AREA * size * size);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Adt;
    use glam::{Quat, Vec3};
    use tree_core::{Foliage, Leaf, Skeleton, Species, Tree};

    /// A trunk with a twig to either side, as wide as long; so many leaves at the end of each.
    fn tree(leaves: [u32; 2]) -> Tree {
        let mut skeleton = Skeleton::builder(Vec3::ZERO, 0.05).unwrap();
        let fork = skeleton.add(0, 4.0 * Vec3::Y, 0.05).unwrap();
        let mut foliage = Foliage::default();
        for (side, n) in [-1.0, 1.0].into_iter().zip(leaves) {
            let position = Vec3::new(side, 5.0, 0.0);
            let node = skeleton.add(fork, position, 0.01).unwrap();
            let (rotation, size) = (Quat::IDENTITY, 0.1);
            (0..n).for_each(|_| {
                foliage.push(Leaf { node, position, rotation, size, kind: 0 }).unwrap();
            });
        }
        Tree::new(skeleton.finish(), foliage, Species::default()).unwrap()
    }

    #[test]
    fn what_lies_alone_shows_its_area() {
        let areas = Adt::of_skeleton(tree([0, 0]).skeleton()).areas().to_vec();
        // The trunk is 4 m long and 0.1 m wide; little is lost in cells that are nearly as wide.
        assert!(areas[0] > 0.2 && areas[0] < 0.4, "{areas:?}");
        // A twig is as wide as itself, not as the trunk; seen from four sides it is shorter than it is.
        let most = 0.02 * 2.0_f64.sqrt();
        assert!(areas[1] > 0.5 * most && areas[1] < most, "{areas:?}");
        assert!((areas[1] - areas[2]).abs() < 1e-6, "{areas:?}");
    }

    #[test]
    fn leaves_behind_leaves_show_less() {
        let bare = Adt::of_tree(&tree([0, 0])).areas().to_vec();
        let leafy = Adt::of_tree(&tree([1, 100])).areas().to_vec();
        let (one, many) = (leafy[1] - bare[1], leafy[2] - bare[2]);
        assert!(one > 0.0 && many > one && many < 50.0 * one, "{one} {many}");
    }
}
