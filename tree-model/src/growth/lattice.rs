//! A grid that grows with what is put into it.

use crate::error::Result;
use glam::IVec3;
use tree_core::{Limits, Resource};

/// Cells added beyond what was asked for, as a share of the side: fewer moves for more memory.
const SPARE_SHARE: i64 = 4;

/// Cells in a box of whole numbers; cells outside are the default.
#[derive(Clone, Debug)]
pub(super) struct Lattice<T> {
    low: IVec3,
    size: IVec3,
    cells: Vec<T>,
}

impl<T: Copy + Default> Lattice<T> {
    pub(super) fn new() -> Self {
        Self { low: IVec3::ZERO, size: IVec3::ZERO, cells: Vec::new() }
    }

    /// Where in `cells` a cell within the range stands; z runs fastest.
    #[inline]
    pub(super) fn place(&self, cell: IVec3) -> usize {
        let c = cell - self.low;
        ((c.x as usize * self.size.y as usize) + c.y as usize) * self.size.z as usize + c.z as usize
    }

    #[inline]
    pub(super) fn holds(&self, cell: IVec3) -> bool {
        let c = cell - self.low;
        c.cmpge(IVec3::ZERO).all() && c.cmplt(self.size).all()
    }

    #[inline]
    pub(super) fn get(&self, cell: IVec3) -> T {
        if self.holds(cell) { self.cells[self.place(cell)] } else { T::default() }
    }

    #[inline]
    pub(super) fn cells(&self) -> &[T] {
        &self.cells
    }

    #[inline]
    pub(super) fn cells_mut(&mut self) -> &mut [T] {
        &mut self.cells
    }

    /// Makes room for all cells from `low` to `high`.
    pub(super) fn cover(&mut self, low: IVec3, high: IVec3, limits: &Limits) -> Result<()> {
        if self.holds(low) && self.holds(high) {
            return Ok(());
        }
        let (mut lows, mut sizes) = ([0_i64; 3], [0_i64; 3]);
        for axis in 0..3 {
            let (old_low, old_size) = (i64::from(self.low[axis]), i64::from(self.size[axis]));
            let (want_low, want_high) = (i64::from(low[axis]), i64::from(high[axis]));
            if old_size == 0 {
                (lows[axis], sizes[axis]) = (want_low, want_high - want_low + 1);
                continue;
            }
            let spare = old_size / SPARE_SHARE + 1;
            let old_high = old_low + old_size - 1;
            let new_low = if want_low < old_low { want_low - spare } else { old_low };
            let new_high = if want_high > old_high { want_high + spare } else { old_high };
            (lows[axis], sizes[axis]) = (new_low, new_high - new_low + 1);
        }
        let count = sizes.iter().fold(1_u64, |count, &n| count.saturating_mul(n as u64));
        limits.check(Resource::Voxels, count)?;
        self.move_to(lows, sizes, count as usize);
        Ok(())
    }

    fn move_to(&mut self, lows: [i64; 3], sizes: [i64; 3], count: usize) {
        let old = std::mem::replace(self, Self::new());
        self.low = IVec3::from_array(lows.map(|n| n as i32));
        self.size = IVec3::from_array(sizes.map(|n| n as i32));
        self.cells = vec![T::default(); count];
        let depth = old.size.z as usize;
        for x in 0..old.size.x {
            for y in 0..old.size.y {
                let cell = old.low + IVec3::new(x, y, 0);
                let (from, to) = (old.place(cell), self.place(cell));
                self.cells[to..to + depth].copy_from_slice(&old.cells[from..from + depth]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_stay_where_they_are_as_it_grows() {
        let limits = Limits::default();
        let mut lattice = Lattice::<u32>::new();
        let mut rng = tree_core::Seed(1).rng();
        let mut put = Vec::new();
        for value in 1..200 {
            let mut axis = || tree_core::seed::uniform(&mut rng, -9.0, 9.0) as i32;
            let cell = IVec3::new(axis(), axis(), axis());
            assert_eq!(lattice.get(cell + 1000), 0);
            lattice.cover(cell, cell, &limits).unwrap();
            let place = lattice.place(cell);
            lattice.cells_mut()[place] = value;
            put.retain(|&(other, _)| other != cell);
            put.push((cell, value));
        }
        assert!(put.iter().all(|&(cell, value)| lattice.get(cell) == value));
    }

    #[test]
    fn too_many_cells_are_an_error_and_change_nothing() {
        let limits = Limits { voxels: 1000, ..Default::default() };
        let mut lattice = Lattice::<u8>::new();
        lattice.cover(IVec3::ZERO, IVec3::splat(2), &limits).unwrap();
        assert!(lattice.cover(IVec3::ZERO, IVec3::splat(1 << 20), &limits).is_err());
        assert_eq!(lattice.cells().len(), 27);
    }
}
