//! Who gets which part of the light map that all surfaces of a mesh share.
//!
//! The unit square is halved: bark lies in v from 0 to ½, leaves from ½ to 1. Leaves lie in a grid of
//! square cells, one for each leaf over all kinds, row after row. With 20 million leaves a cell is
//! 1.6e-4 wide and its margin 1e-5, two hundred times the step of 32-bit numbers just below 1.

use glam::Vec2;

/// Lower and upper end in v of what bark may use.
pub(crate) const BARK: (f32, f32) = (0.0, 0.5);
/// Lower and upper end in v of what leaves may use.
const LEAVES: (f32, f32) = (0.5, 1.0);
const _: () = assert!(BARK.1 <= LEAVES.0, "bark and leaves do not overlap");
/// Empty share on each side of a leaf's cell.
const MARGIN: f64 = 0.06;

/// The grid of leaf cells.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LeafCells {
    columns: u64,
    /// Side of a cell, in f64: rounding must not add up over a thousand of them.
    side: f64,
}

impl LeafCells {
    /// The largest square cells of which `n_leaves` fit.
    pub(crate) fn new(n_leaves: u64) -> Self {
        let height = f64::from(LEAVES.1 - LEAVES.0);
        let mut columns = libm::ceil(libm::sqrt(n_leaves.max(1) as f64 / height)) as u64;
        while n_leaves.div_ceil(columns) as f64 / columns as f64 > height {
            columns += 1;
        }
        Self { columns, side: 1.0 / columns as f64 }
    }

    /// Side of the part of a cell that may be used.
    pub(crate) fn size(&self) -> f32 {
        (self.side * (1.0 - 2.0 * MARGIN)) as f32
    }

    /// Lowest usable corner of a leaf's cell; leaves are numbered over all kinds.
    pub(crate) fn corner(&self, leaf: u64) -> Vec2 {
        let at = |cell: u64| (cell as f64 + MARGIN) * self.side;
        let v = f64::from(LEAVES.0) + at(leaf / self.columns);
        Vec2::new(at(leaf % self.columns) as f32, v as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_lie_in_their_half_and_apart_even_for_millions() {
        for n in [1, 2, 3, 7, 1000, 1_300_000, 20_000_000] {
            let cells = LeafCells::new(n);
            let size = cells.size();
            let (first, last) = (cells.corner(0), cells.corner(n - 1));
            assert!(first.y > BARK.1 && last.y + size < LEAVES.1, "{n}: {first} {last}");
            for leaf in [0, n / 3, n / 2, n.saturating_sub(2)] {
                let (a, b) = (cells.corner(leaf), cells.corner(leaf + 1));
                assert!(a.x + size < 1.0, "{n}");
                let apart = (b.x - a.x).abs().max((b.y - a.y).abs()) - size;
                assert!(apart > 0.05 * size, "{n}, {leaf}: {apart}");
            }
        }
    }
}
