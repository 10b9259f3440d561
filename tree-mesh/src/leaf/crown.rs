//! Where the outside of the crown is: the direction soft normals are bent to.
//!
//! 1. Leaves are counted in a grid of cubes.
//! 2. What lies between leaves along two of the three axes is inside the crown: a crown with leaves
//!    only at its rim is as solid as a full one, and lobes stay lobes.
//! 3. The grid is blurred; the outside is down its slope. Deep inside, where it is level, and in crowns
//!    of few leaves, the ellipsoid that fills their bounds says more.
//!
//! Cost: O(leaves), counted in parallel (whole numbers, so the order does not matter), and at most
//! 28³ cells.

use glam::Vec3;
use rayon::prelude::*;
use tree_core::Aabb;

/// Most cells along the longest side of the crown.
const CELLS_MAX: f32 = 20.0;
/// Fewest; flat crowns are solid that way.
const CELLS_MIN: f32 = 4.0;
/// Empty cells on every side, for the blur to run out.
const PAD: usize = 3;
/// Rounds of blurring with weights 1, 2, 1: a standard deviation of 1.4 cells.
const ROUNDS: usize = 4;
/// Slope per cell of the blurred grid at the rim of a solid crown.
const RIM_SLOPE: f32 = 0.25;
/// Weight of the ellipsoid's direction beside that of a solid rim.
const ELLIPSOID: f32 = 0.2;
/// Leaves counted by one piece of work.
const LEAVES_PER_COUNT: usize = 1 << 16;

/// A field of directions that point out of the crown.
#[derive(Clone, Debug, Default)]
pub(crate) struct Crown {
    /// Middle of the first cell.
    low: Vec3,
    cells_per_metre: f32,
    size: [usize; 3],
    /// Unit vectors, x fastest. Empty when there is no crown.
    outward: Vec<Vec3>,
}

impl Crown {
    /// The crown of these leaves; one without direction when they are all in one place.
    pub(crate) fn of(positions: &[Vec3]) -> Self {
        let bounds = Aabb::of_points(positions);
        let extent = bounds.size();
        let longest = extent.max_element();
        if bounds.is_empty() || longest < 1e-3 {
            return Self::default();
        }
        let cells = libm::cbrtf(positions.len() as f32).clamp(CELLS_MIN, CELLS_MAX);
        let cell = longest / cells;
        let size = extent.to_array().map(|e| libm::ceilf(e / cell) as usize + 1 + 2 * PAD);
        let reach = Vec3::from_array(size.map(|n| (n - 1) as f32)) * cell;
        let mut crown = Self {
            low: bounds.center() - 0.5 * reach,
            cells_per_metre: 1.0 / cell,
            size,
            outward: Vec::new(),
        };
        let mut solid = crown.fill(&crown.count(positions));
        for _ in 0..ROUNDS {
            for axis in 0..3 {
                crown.blur(&mut solid, axis);
            }
        }
        crown.outward = crown.slope(&solid, bounds);
        crown
    }

    fn n_cells(&self) -> usize {
        self.size.iter().product()
    }

    /// Steps in memory to the next cell along each axis.
    fn strides(&self) -> [usize; 3] {
        [1, self.size[0], self.size[0] * self.size[1]]
    }

    /// Leaves in each cell.
    fn count(&self, positions: &[Vec3]) -> Vec<u32> {
        let strides = self.strides();
        let zeros = || vec![0_u32; self.n_cells()];
        let counted = |mut counts: Vec<u32>, leaves: &[Vec3]| {
            for &p in leaves {
                let at = (p - self.low) * self.cells_per_metre + 0.5;
                let cell = at.x as usize + at.y as usize * strides[1] + at.z as usize * strides[2];
                if let Some(count) = counts.get_mut(cell) {
                    *count = count.saturating_add(1);
                }
            }
            counts
        };
        let sum = |mut a: Vec<u32>, b: Vec<u32>| {
            a.iter_mut().zip(b).for_each(|(a, b)| *a = a.saturating_add(b));
            a
        };
        positions.par_chunks(LEAVES_PER_COUNT).fold(zeros, counted).reduce(zeros, sum)
    }

    /// Calls `visit` with the cells of every line along an axis.
    fn lines(&self, axis: usize, mut visit: impl FnMut(&mut dyn Iterator<Item = usize>)) {
        let strides = self.strides();
        let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
        for j in 0..self.size[b] {
            for k in 0..self.size[c] {
                let first = j * strides[b] + k * strides[c];
                visit(&mut (0..self.size[axis]).map(|i| first + i * strides[axis]));
            }
        }
    }

    /// How solid the crown is in each cell, 0 to 1.
    fn fill(&self, counts: &[u32]) -> Vec<f32> {
        let mut between = vec![0_u8; counts.len()];
        let mut line = Vec::new();
        for axis in 0..3 {
            self.lines(axis, |cells| {
                line.clear();
                line.extend(cells);
                let first = line.iter().position(|&cell| counts[cell] > 0);
                let last = line.iter().rposition(|&cell| counts[cell] > 0);
                if let (Some(first), Some(last)) = (first, last) {
                    line[first..=last].iter().for_each(|&cell| between[cell] += 1);
                }
            });
        }
        let (n, sum) = counts.iter().fold((0_u32, 0_u64), |(n, sum), &count| {
            (n + u32::from(count > 0), sum + u64::from(count))
        });
        let half = 0.5 * sum as f32 / n.max(1) as f32;
        let solid = |(&count, &between): (&u32, &u8)| match (count, between) {
            (0, 0..=1) => 0.0,
            (0, _) | (_, 3) => 1.0,
            _ => count as f32 / (count as f32 + half),
        };
        counts.iter().zip(&between).map(solid).collect()
    }

    fn blur(&self, values: &mut [f32], axis: usize) {
        self.lines(axis, |cells| {
            let (mut before, mut last) = (0.0, None);
            for cell in cells {
                let here = values[cell];
                if let Some(last) = last {
                    let middle: f32 = values[last];
                    values[last] = 0.25 * (before + here) + 0.5 * middle;
                    before = middle;
                }
                last = Some(cell);
            }
        });
    }

    /// The direction down the slope of `solid`, with the ellipsoid's.
    fn slope(&self, solid: &[f32], bounds: Aabb) -> Vec<Vec3> {
        let strides = self.strides();
        let half = (0.5 * bounds.size()).max(Vec3::splat(2.0 / self.cells_per_metre));
        let weights = (half.min_element() / half) * (half.min_element() / half);
        let mut outward = Vec::with_capacity(solid.len());
        for z in 0..self.size[2] {
            for y in 0..self.size[1] {
                for x in 0..self.size[0] {
                    let cell = [x, y, z];
                    let at = x + y * strides[1] + z * strides[2];
                    let value = |at: usize| solid.get(at).copied().unwrap_or(0.0);
                    let down = [0, 1, 2].map(|a| {
                        let inner = cell[a] > 0 && cell[a] + 1 < self.size[a];
                        if inner { value(at - strides[a]) - value(at + strides[a]) } else { 0.0 }
                    });
                    let place =
                        self.low + Vec3::new(x as f32, y as f32, z as f32) / self.cells_per_metre;
                    let round = ((place - bounds.center()) * weights).normalize_or_zero();
                    let sum = Vec3::from_array(down) * (0.5 / RIM_SLOPE) + round * ELLIPSOID;
                    outward.push(sum.normalize_or_zero());
                }
            }
        }
        outward
    }

    /// Points out of the crown at a place. At most of unit length, shorter where directions nearby
    /// disagree; zero when there is no crown.
    #[inline]
    pub(crate) fn outward(&self, place: Vec3) -> Vec3 {
        if self.outward.is_empty() {
            return Vec3::ZERO;
        }
        let most = Vec3::from_array(self.size.map(|n| (n - 2) as f32));
        let at = ((place - self.low) * self.cells_per_metre).clamp(Vec3::ZERO, most);
        let (x, y, z) = (at.x as usize, at.y as usize, at.z as usize);
        let share = at - Vec3::new(x as f32, y as f32, z as f32);
        let [_, up, deep] = self.strides();
        let first = x + y * up + z * deep;
        let pair = |at: usize| match self.outward.get(at..at + 2) {
            Some([a, b]) => *a + (*b - *a) * share.x,
            _ => Vec3::ZERO,
        };
        let (a, b) = (pair(first), pair(first + up));
        let (c, d) = (pair(first + deep), pair(first + up + deep));
        let (front, back) = (a + (b - a) * share.y, c + (d - c) * share.y);
        front + (back - front) * share.z
    }
}
