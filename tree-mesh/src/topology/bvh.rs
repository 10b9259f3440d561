//! Pairs of boxes that overlap: a tree of boxes over triangles along a space-filling curve.
//!
//! Triangles are sorted by the Morton code of their middles (Morton 1966) and put in groups of eight;
//! over the groups stands a complete binary tree of boxes, as in Lauterbach et al., "Fast BVH
//! Construction on GPUs", Eurographics 2009, but with halves of equal number instead of equal
//! codes, so the tree is an array. A uniform grid would suit neither trunks nor twigs.

use glam::Vec3;
use rayon::prelude::*;

/// Triangles in a leaf.
pub(super) const GROUP: usize = 8;
/// Steps of the curve along each axis; three times this many bits.
const STEPS: f32 = 2_097_151.0;

/// An axis-aligned box; its faces belong to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    low: Vec3,
    high: Vec3,
}

impl Extent {
    const EMPTY: Self = Self { low: Vec3::MAX, high: Vec3::MIN };

    pub(super) fn of([a, b, c]: [Vec3; 3]) -> Self {
        Self { low: a.min(b).min(c), high: a.max(b).max(c) }
    }

    fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    pub(super) fn overlaps(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }
}

/// Triangles in the order of the curve, with a tree of boxes over them.
pub(super) struct Bvh {
    /// Triangles by their place along the curve.
    pub(super) order: Vec<u32>,
    /// Their boxes, in that order.
    pub(super) extents: Vec<Extent>,
    /// Node 1 is the top, node i has the children 2i and 2i + 1; the last half are groups.
    nodes: Vec<Extent>,
}

impl Bvh {
    pub(super) fn new(triangles: &[[u32; 3]], place: impl Fn(u32) -> Vec3 + Sync) -> Self {
        let extent = |t: u32| Extent::of(triangles[t as usize].map(&place));
        let all = (0..triangles.len() as u32)
            .into_par_iter()
            .map(extent)
            .reduce(|| Extent::EMPTY, Extent::union);
        let size = (all.high - all.low).max_element();
        let scale = if size > 0.0 { STEPS / size } else { 0.0 };
        let mut keys: Vec<(u64, u32)> = (0..triangles.len() as u32)
            .into_par_iter()
            .map(|t| {
                let extent = extent(t);
                let middle = 0.5 * (extent.low - all.low) + 0.5 * (extent.high - all.low);
                (morton((scale * middle).to_array()), t)
            })
            .collect();
        keys.par_sort_unstable();
        let order: Vec<u32> = keys.into_iter().map(|(_, t)| t).collect();
        let extents: Vec<Extent> = order.par_iter().map(|&t| extent(t)).collect();
        let n_groups = extents.len().div_ceil(GROUP).max(1).next_power_of_two();
        let mut nodes = vec![Extent::EMPTY; 2 * n_groups];
        for (node, group) in nodes[n_groups..].iter_mut().zip(extents.chunks(GROUP)) {
            *node = group.iter().fold(Extent::EMPTY, |sum, &extent| sum.union(extent));
        }
        for i in (1..n_groups).rev() {
            nodes[i] = nodes[2 * i].union(nodes[2 * i + 1]);
        }
        Self { order, extents, nodes }
    }

    pub(super) fn n_groups(&self) -> usize {
        self.extents.len().div_ceil(GROUP)
    }

    /// Calls `visit` for every pair of triangles whose boxes overlap and of which the first is in
    /// `group` and the second after it along the curve. Stops at the first error.
    pub(super) fn pairs<E>(
        &self,
        group: usize,
        stack: &mut Vec<usize>,
        mut visit: impl FnMut(u32, u32) -> Result<(), E>,
    ) -> Result<(), E> {
        let n_leaves = self.nodes.len() / 2;
        let own = &self.nodes[n_leaves + group];
        let rows = |group: usize| group * GROUP..((group + 1) * GROUP).min(self.extents.len());
        stack.clear();
        stack.push(1);
        while let Some(node) = stack.pop() {
            // The last group under a node, shifted down to the leaves.
            let depth = n_leaves.ilog2() - node.ilog2();
            let last = ((node + 1) << depth) - 1 - n_leaves;
            if last < group || !own.overlaps(&self.nodes[node]) {
                continue;
            }
            if node < n_leaves {
                stack.extend([2 * node + 1, 2 * node]);
                continue;
            }
            for i in rows(group) {
                for j in rows(node - n_leaves) {
                    if j > i && self.extents[i].overlaps(&self.extents[j]) {
                        visit(self.order[i], self.order[j])?;
                    }
                }
            }
        }
        Ok(())
    }
}

/// Bits of the whole parts of three numbers in turn.
fn morton([x, y, z]: [f32; 3]) -> u64 {
    let spread = |x: f32| {
        let mut x = u64::from(x as u32) & 0x1f_ffff;
        x = (x | x << 32) & 0x1f_0000_0000_ffff;
        x = (x | x << 16) & 0x1f_0000_ff00_00ff;
        x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
        x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
        (x | x << 2) & 0x1249_2492_4924_9249
    };
    spread(x) << 2 | spread(y) << 1 | spread(z)
}
