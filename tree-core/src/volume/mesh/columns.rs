//! Winding numbers by a vertical ray, through a grid of columns.
//!
//! Seen from above, a triangle covers a point where the outline of the triangle winds round it; that is
//! the sum over its edges of signed crossings with a ray towards +X. Each crossing is decided by a
//! half-open rule in Z and by one predicate on the edge, always taken from its lower to its higher end
//! in Z. So the two triangles at an edge, or all those at a corner, get answers that fit together to
//! the last bit, whether or not the point lies exactly above the edge, and no count is ever off by one.
//! Only points within rounding of the surface itself can go either way.

use super::Corners;
use crate::bounds::Aabb;
use glam::DVec3;

/// Entries in the grid for each triangle. Meshes with many large triangles would fill
/// (triangles x cells); with fewer, wider cells they stay below this.
const MAX_ENTRIES_PER_TRIANGLE: u64 = 16;

/// Cells for each triangle. A closed mesh covers the ground about twice, so that a cell then meets
/// the neighbourhood of few triangles; more cells only cost memory.
const CELLS_PER_TRIANGLE: f64 = 1.0;

/// Grid over X and Z; each cell lists the triangles above and below it, highest first.
#[derive(Debug)]
pub(super) struct Columns {
    min: [f64; 2],
    cells_per_metre: [f64; 2],
    n_cells: [usize; 2],
    starts: Vec<u32>,
    entries: Vec<u32>,
}

impl Columns {
    /// `bounds` encloses all triangles and has depth along every axis.
    pub(super) fn new(triangles: &[Corners], bounds: Aabb) -> Self {
        let size = bounds.max.as_dvec3() - bounds.min.as_dvec3();
        let n_triangles = triangles.len();
        let n_wanted = (n_triangles as f64 * CELLS_PER_TRIANGLE).max(1.0);
        let side = (size.x * size.z / n_wanted).sqrt();
        let along_x = ((size.x / side) as usize).clamp(1, n_triangles);
        let along_z = ((size.z / side) as usize).clamp(1, (n_triangles / along_x).max(1));
        let mut columns = Self {
            min: [f64::from(bounds.min.x), f64::from(bounds.min.z)],
            cells_per_metre: [0.0; 2],
            n_cells: [along_x, along_z],
            starts: Vec::new(),
            entries: Vec::new(),
        };
        loop {
            let [n_x, n_z] = columns.n_cells;
            columns.cells_per_metre = [n_x as f64 / size.x, n_z as f64 / size.z];
            let total: u64 = triangles
                .iter()
                .map(|corners| columns.cells_of(corners))
                .map(|[x, z]| (x.len() * z.len()) as u64)
                .sum();
            if n_x * n_z == 1 || total <= MAX_ENTRIES_PER_TRIANGLE * n_triangles as u64 {
                break;
            }
            columns.n_cells = [n_x.div_ceil(2), n_z.div_ceil(2)];
        }
        columns.fill(triangles);
        columns
    }

    fn fill(&mut self, triangles: &[Corners]) {
        let [n_x, n_z] = self.n_cells;
        let mut counts = vec![0_u32; n_x * n_z];
        self.each_cell(triangles, 0..triangles.len() as u32, |cell, _| {
            counts[cell] += 1;
        });
        let mut end = 0;
        self.starts = vec![0];
        self.starts.extend(counts.iter().map(|&count| {
            end += count;
            end
        }));
        let mut highest_first: Vec<u32> = (0..triangles.len() as u32).collect();
        highest_first
            .sort_by(|&i, &j| top(&triangles[j as usize]).total_cmp(&top(&triangles[i as usize])));
        let mut next = self.starts.clone();
        let mut entries = vec![0; end as usize];
        self.each_cell(triangles, highest_first.into_iter(), |cell, triangle| {
            entries[next[cell] as usize] = triangle;
            next[cell] += 1;
        });
        self.entries = entries;
    }

    fn each_cell(
        &self,
        triangles: &[Corners],
        order: impl Iterator<Item = u32>,
        mut visit: impl FnMut(usize, u32),
    ) {
        for triangle in order {
            let [along_x, along_z] = self.cells_of(&triangles[triangle as usize]);
            for z in along_z {
                for x in along_x.clone() {
                    visit(z * self.n_cells[0] + x, triangle);
                }
            }
        }
    }

    /// Never falls as the coordinate rises, so what covers a point is listed in the point's cell.
    #[inline]
    fn cell(&self, axis: usize, coordinate: f64) -> usize {
        // `as` takes NaN and what is below the range to 0.
        (((coordinate - self.min[axis]) * self.cells_per_metre[axis]) as usize)
            .min(self.n_cells[axis] - 1)
    }

    /// Cells of the triangle's rectangle, along X and along Z.
    fn cells_of(&self, corners: &Corners) -> [std::ops::Range<usize>; 2] {
        let [a, b, c] = corners;
        let (low, high) = (a.min(*b).min(*c), a.max(*b).max(*c));
        [(0, low.x, high.x), (1, low.z, high.z)].map(|(axis, low, high)| {
            self.cell(axis, f64::from(low))..self.cell(axis, f64::from(high)) + 1
        })
    }

    /// How often the surface winds round the point.
    #[inline]
    pub(super) fn winding(&self, triangles: &[Corners], p: DVec3) -> i32 {
        let cell = self.cell(1, p.z) * self.n_cells[0] + self.cell(0, p.x);
        let entries = &self.entries[self.starts[cell] as usize..self.starts[cell + 1] as usize];
        let mut winding = 0;
        for &triangle in entries {
            let corners = &triangles[triangle as usize];
            if f64::from(top(corners)) < p.y {
                break;
            }
            let [a, b, c] = corners.map(|corner| corner.as_dvec3());
            let covers = crossing(a, b, p) + crossing(b, c, p) + crossing(c, a, p);
            if covers != 0 && lies_below(p, a, b, c, covers) {
                winding += covers;
            }
        }
        winding
    }
}

#[inline]
fn top([a, b, c]: &Corners) -> f32 {
    a.y.max(b.y).max(c.y)
}

/// Signed crossing of the edge, seen from above, with the ray from `p` towards +X.
#[inline]
fn crossing(a: DVec3, b: DVec3, p: DVec3) -> i32 {
    let rises = a.z <= p.z;
    if rises == (b.z <= p.z) {
        return 0;
    }
    let (low, high) = if rises { (a, b) } else { (b, a) };
    // The rectangle first: a point beside it is decided without rounding, so what is listed in no
    // cell of the point cannot count either.
    let crosses = if p.x < low.x.min(high.x) {
        true
    } else if p.x >= low.x.max(high.x) {
        false
    } else {
        (p.x - low.x) * (high.z - low.z) < (high.x - low.x) * (p.z - low.z)
    };
    match (crosses, rises) {
        (false, _) => 0,
        (true, true) => 1,
        (true, false) => -1,
    }
}

/// Whether the point lies below a triangle that covers it. Outside the triangle's range of heights
/// there is nothing to compute, so an almost vertical triangle cannot mislead.
#[inline]
fn lies_below(p: DVec3, a: DVec3, b: DVec3, c: DVec3, covers: i32) -> bool {
    if p.y < a.y.min(b.y).min(c.y) {
        return true;
    }
    // Counter-clockwise from +Z to +X is a normal downwards, and `covers` has that sense.
    let normal = (b - a).cross(c - a);
    normal.dot(p - a) * f64::from(covers) > 0.0
}
