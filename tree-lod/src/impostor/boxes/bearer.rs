//! Which node carries each leaf.

use crate::element::Elements;
use crate::error::{LodError, Result};
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Skeleton, Tree};
use tree_mesh::Mesh;

/// The node of the skeleton that carries each element of a mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bearers(pub Vec<u32>);

/// Nodes that a leaf is compared with per cell of the grid, on average.
const NODES_PER_CELL: f32 = 4.0;
/// Most cells along a side.
const CELLS_MAX: f32 = 64.0;

impl Bearers {
    /// Of a mesh that was built from this tree: leaf by leaf, exactly. Elements must be whole leaves
    /// ([`Grain::Leaf`](crate::Grain::Leaf)); surface 1 + k has those of kind k.
    ///
    /// # Errors
    /// [`LodError::Impostor`] when mesh and tree have different numbers of leaves.
    pub fn of_tree(tree: &Tree, mesh: &Mesh, elements: &Elements) -> Result<Self> {
        let foliage = tree.foliage();
        let mut of_surface: Vec<Vec<u32>> = vec![Vec::new(); mesh.surfaces.len()];
        // Leaves without size are not in the mesh.
        for leaf in foliage.iter().filter(|leaf| leaf.size > 0.0) {
            if let Some(nodes) = of_surface.get_mut(usize::from(leaf.kind) + 1) {
                nodes.push(leaf.node);
            }
        }
        let mut next = vec![0_usize; mesh.surfaces.len()];
        let node = |&surface: &u32| {
            let at = next.get_mut(surface as usize)?;
            *at += 1;
            of_surface[surface as usize].get(*at - 1).copied()
        };
        let nodes: Option<Vec<u32>> = elements.surface.iter().map(node).collect();
        let wanted: usize = elements.surfaces.iter().map(|&s| of_surface[s as usize].len()).sum();
        nodes.filter(|nodes| nodes.len() == wanted).map(Self).ok_or(LodError::Impostor(
            "the mesh has another number of leaves than the tree: elements must be whole leaves",
        ))
    }

    /// The nearest node to the middle of each element, for meshes whose leaves are not known to a tree.
    ///
    /// # Complexity
    /// O(nodes + elements), if nodes are spread evenly; in parallel over elements.
    #[must_use]
    pub fn nearest(skeleton: &Skeleton, elements: &Elements) -> Self {
        let grid = Cells::new(skeleton.positions());
        Self(elements.centers.par_iter().map(|&center| grid.nearest(center)).collect())
    }
}

/// Points in cells.
struct Cells<'a> {
    points: &'a [Vec3],
    min: Vec3,
    per_metre: f32,
    n: [i32; 3],
    starts: Vec<u32>,
    rows: Vec<u32>,
}

impl<'a> Cells<'a> {
    fn new(points: &'a [Vec3]) -> Self {
        let bounds = tree_core::Aabb::of_points(points);
        let size = bounds.size().max(Vec3::splat(1e-6));
        let along = libm::cbrtf(points.len() as f32 / NODES_PER_CELL).clamp(1.0, CELLS_MAX);
        let per_metre = along / size.max_element();
        let n = (size * per_metre).to_array().map(|n| n as i32 + 1);
        let mut grid =
            Self { points, min: bounds.min, per_metre, n, starts: Vec::new(), rows: Vec::new() };
        let cells: Vec<usize> = points.iter().map(|&p| grid.number(grid.cell(p))).collect();
        let mut starts = vec![0_u32; (n[0] * n[1] * n[2]) as usize + 1];
        cells.iter().for_each(|&cell| starts[cell + 1] += 1);
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        grid.rows = vec![0; points.len()];
        for (point, &cell) in cells.iter().enumerate() {
            grid.rows[next[cell] as usize] = point as u32;
            next[cell] += 1;
        }
        grid.starts = starts;
        grid
    }

    fn cell(&self, p: Vec3) -> [i32; 3] {
        let at = ((p - self.min) * self.per_metre).to_array();
        [0, 1, 2].map(|axis| (at[axis] as i32).clamp(0, self.n[axis] - 1))
    }

    fn number(&self, [x, y, z]: [i32; 3]) -> usize {
        ((z * self.n[1] + y) * self.n[0] + x) as usize
    }

    /// Shells of cells around the point, until no nearer point can follow.
    fn nearest(&self, p: Vec3) -> u32 {
        let middle = self.cell(p);
        let mut best = (f32::INFINITY, 0);
        let widest = self.n.into_iter().max().unwrap_or(1);
        // A point outside the box lies at its side, not in the cell.
        let mut clear = 0.0;
        for shell in 0..=widest {
            if clear > 0.0 && best.0 <= clear * clear {
                break;
            }
            self.shell(middle, shell, |row| {
                let far = self.points[row as usize].distance_squared(p);
                if (far, row) < best {
                    best = (far, row);
                }
            });
            clear = shell as f32 / self.per_metre;
        }
        best.1
    }

    fn shell(&self, [x, y, z]: [i32; 3], radius: i32, mut each: impl FnMut(u32)) {
        let range = |middle: i32, n: i32| (middle - radius).max(0)..=(middle + radius).min(n - 1);
        for k in range(z, self.n[2]) {
            for j in range(y, self.n[1]) {
                let inner = (k - z).abs() < radius && (j - y).abs() < radius;
                for i in range(x, self.n[0]) {
                    if inner && (i - x).abs() < radius {
                        continue;
                    }
                    let cell = self.number([i, j, k]);
                    let rows = self.starts[cell] as usize..self.starts[cell + 1] as usize;
                    self.rows[rows].iter().for_each(|&row| each(row));
                }
            }
        }
    }
}
