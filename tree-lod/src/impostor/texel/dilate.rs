//! Colours spread outward into empty texels.

use super::bake::Tile;
use glam::Vec3;

/// What is spread, with the weight it has.
#[derive(Clone, Copy, Default)]
struct Cell {
    color: Vec3,
    normal: Vec3,
    depth: f32,
    weight: f32,
}

/// A texel with a neighbour's share below this counts as empty: its mean is not of anything.
const EMPTY: f32 = 1e-6;

impl Tile {
    /// Fills texels of no alpha with the mean of what is near, from coarse to fine. All other texels and
    /// all alpha stay as they are. A tile that is empty throughout stays so.
    ///
    /// # Complexity
    /// O(texels).
    pub(crate) fn dilate(&mut self) {
        let cells = (0..self.alpha.len()).map(|i| Cell {
            color: self.color[i],
            normal: self.normal[i],
            depth: self.depth[i],
            weight: self.alpha[i],
        });
        let mut levels = vec![(self.side as usize, cells.collect::<Vec<_>>())];
        while let Some((side, cells)) = levels.last()
            && *side > 1
        {
            let half = pulled(cells, *side);
            levels.push(half);
        }
        for fine in (1..levels.len()).rev() {
            let (finer, coarser) = levels.split_at_mut(fine);
            if let (Some((side, cells)), Some((half, above))) = (finer.last_mut(), coarser.first())
            {
                push(cells, *side, above, *half);
            }
        }
        let Some((_, cells)) = levels.first() else { return };
        for (i, cell) in cells.iter().enumerate().filter(|(i, _)| self.alpha[*i] <= 0.0) {
            (self.color[i], self.normal[i], self.depth[i]) = (cell.color, cell.normal, cell.depth);
        }
    }
}

/// The level of half the size, rounded up: means of four by weight.
fn pulled(cells: &[Cell], side: usize) -> (usize, Vec<Cell>) {
    let half = side.div_ceil(2);
    let mean = |i: usize| {
        let (x, y) = (2 * (i % half), 2 * (i / half));
        let mut sum = Cell::default();
        for row in y..(y + 2).min(side) {
            for cell in &cells[row * side + x..row * side + (x + 2).min(side)] {
                sum.color += cell.color * cell.weight;
                sum.normal += cell.normal * cell.weight;
                sum.depth += cell.depth * cell.weight;
                sum.weight += cell.weight;
            }
        }
        if sum.weight <= EMPTY {
            return Cell::default();
        }
        let by = 1.0 / sum.weight;
        let (color, normal, depth) = (sum.color * by, sum.normal * by, sum.depth * by);
        // One full texel is enough for a full one of the next level.
        Cell { color, normal, depth, weight: sum.weight.min(1.0) }
    };
    (half, (0..half * half).map(mean).collect())
}

/// Fills empty cells with those of the level above, between its middles.
fn push(cells: &mut [Cell], side: usize, above: &[Cell], half: usize) {
    for (i, cell) in cells.iter_mut().enumerate().filter(|(_, cell)| cell.weight <= EMPTY) {
        let (x, y) = (i % side, i / side);
        // Three quarters of the cell above, one of its neighbour on this side.
        let beside = |t: usize| {
            let other = if t.is_multiple_of(2) { (t / 2).saturating_sub(1) } else { t / 2 + 1 };
            [(t / 2, 0.75), (other.min(half - 1), 0.25)]
        };
        let mut sum = Cell::default();
        for (row, down) in beside(y) {
            for (column, right) in beside(x) {
                let near = &above[row * half + column];
                let share = down * right * if near.weight > EMPTY { 1.0 } else { 0.0 };
                sum.color += near.color * share;
                sum.normal += near.normal * share;
                sum.depth += near.depth * share;
                sum.weight += share;
            }
        }
        if sum.weight > EMPTY {
            let by = 1.0 / sum.weight;
            *cell = Cell {
                color: sum.color * by,
                normal: sum.normal * by,
                depth: sum.depth * by,
                weight: 1.0,
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn tile(side: u32, alpha: Vec<f32>) -> Tile {
        let n = alpha.len();
        let value = |i: usize| (i * 7 % 11) as f32 / 11.0;
        let shown = |i: usize, v: f32| if alpha[i] > 0.0 { v } else { 0.0 };
        Tile {
            side,
            color: (0..n).map(|i| Vec3::splat(shown(i, 0.2 + value(i)))).collect(),
            normal: (0..n).map(|i| Vec3::Y * shown(i, 1.0)).collect(),
            depth: (0..n).map(|i| shown(i, value(i))).collect(),
            alpha,
        }
    }

    proptest! {
        #[test]
        fn covered_texels_stay_and_others_lie_between_them(
            side in 1_u32..20, seed in proptest::collection::vec(0_u8..4, 400),
        ) {
            let n = (side * side) as usize;
            let before = tile(side, seed[..n].iter().map(|&a| f32::from(a / 3)).collect());
            let mut after = before.clone();
            after.dilate();
            prop_assert_eq!(&before.alpha, &after.alpha);
            let any = before.alpha.iter().any(|&a| a > 0.0);
            for i in 0..n {
                if before.alpha[i] > 0.0 {
                    prop_assert_eq!(before.color[i], after.color[i]);
                    prop_assert_eq!(before.depth[i], after.depth[i]);
                } else if any {
                    prop_assert!(after.color[i].x > 0.199, "dark fringe: {}", after.color[i]);
                    prop_assert!(after.normal[i].y > 0.99);
                }
            }
        }
    }
}
