//! Assignment: rows to columns at the least total cost.
//!
//! Successive shortest augmenting paths on the dense matrix (Jonker & Volgenant 1987), exact. This is
//! the min-cost flow of a bipartite graph whose arcs all have capacity 1.

/// Solves assignments one after the other and keeps its memory between them.
///
/// ```
/// use tree_core::assignment::Assignment;
/// let costs = [[4.0, 1.0, 3.0], [2.0, 0.0, 5.0]];
/// let mut assignment = Assignment::default();
/// assert_eq!(assignment.cheapest(2, 3, |row, column| costs[row][column]), [1, 0]);
/// ```
#[derive(Clone, Debug, Default)]
pub struct Assignment {
    /// Prices of rows and columns, from 1; 0 is the row that seeks its place, in a column of its own.
    row_prices: Vec<f64>,
    column_prices: Vec<f64>,
    /// Row of each column; 0 for none.
    taken: Vec<usize>,
    slack: Vec<f64>,
    from: Vec<usize>,
    done: Vec<bool>,
    columns: Vec<usize>,
}

impl Assignment {
    /// For each of `0..n_rows` its own column out of `0..n_columns`, so that the sum of
    /// `cost(row, column)` is least. Rows beyond the number of columns are left out: their column is
    /// `usize::MAX`, and the others are assigned as if they were not there.
    ///
    /// Costs must be finite and may be negative; with others the answer is some assignment.
    ///
    /// # Complexity
    /// O(rows² columns) time, O(rows + columns) memory.
    pub fn cheapest(
        &mut self,
        n_rows: usize,
        n_columns: usize,
        cost: impl Fn(usize, usize) -> f64,
    ) -> &[usize] {
        self.reset(n_rows, n_columns);
        for row in 1..=n_rows.min(n_columns) {
            self.place(row, n_columns, &cost);
        }
        for (column, &row) in self.taken.iter().enumerate().skip(1) {
            if row > 0 {
                self.columns[row - 1] = column - 1;
            }
        }
        &self.columns
    }

    fn reset(&mut self, n_rows: usize, n_columns: usize) {
        refill(&mut self.row_prices, n_rows + 1, 0.0);
        refill(&mut self.column_prices, n_columns + 1, 0.0);
        refill(&mut self.taken, n_columns + 1, 0);
        refill(&mut self.columns, n_rows, usize::MAX);
    }

    /// Gives `row` a column by the cheapest path of exchanges that ends at a free one.
    fn place(&mut self, row: usize, n_columns: usize, cost: &impl Fn(usize, usize) -> f64) {
        refill(&mut self.slack, n_columns + 1, f64::INFINITY);
        refill(&mut self.from, n_columns + 1, 0);
        refill(&mut self.done, n_columns + 1, false);
        self.taken[0] = row;
        let mut column = 0;
        loop {
            self.done[column] = true;
            let current = self.taken[column];
            let (mut step, mut nearest) = (f64::INFINITY, 0);
            for other in 1..=n_columns {
                if self.done[other] {
                    continue;
                }
                let cost = cost(current - 1, other - 1)
                    - self.row_prices[current]
                    - self.column_prices[other];
                if cost < self.slack[other] {
                    (self.slack[other], self.from[other]) = (cost, column);
                }
                if self.slack[other] < step || nearest == 0 {
                    (step, nearest) = (self.slack[other], other);
                }
            }
            self.reprice(step, n_columns);
            column = nearest;
            if self.taken[column] == 0 {
                break;
            }
        }
        while column != 0 {
            self.taken[column] = self.taken[self.from[column]];
            column = self.from[column];
        }
    }

    fn reprice(&mut self, step: f64, n_columns: usize) {
        for other in 0..=n_columns {
            if self.done[other] {
                self.row_prices[self.taken[other]] += step;
                self.column_prices[other] -= step;
            } else {
                self.slack[other] -= step;
            }
        }
    }
}

fn refill<T: Clone>(column: &mut Vec<T>, len: usize, value: T) {
    column.clear();
    column.resize(len, value);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The least sum over all ways to give rows from `row` on a free column.
    fn exhaustive(costs: &[Vec<f64>], row: usize, used: &mut Vec<bool>) -> f64 {
        if row == costs.len() {
            return 0.0;
        }
        let mut best = f64::INFINITY;
        for column in 0..used.len() {
            if !used[column] {
                used[column] = true;
                best = best.min(costs[row][column] + exhaustive(costs, row + 1, used));
                used[column] = false;
            }
        }
        best
    }

    proptest! {
        #[test]
        fn no_other_assignment_is_cheaper(
            costs in (1_usize..5, 0_usize..3).prop_flat_map(|(rows, more)| {
                prop::collection::vec(prop::collection::vec(-9.0_f64..9.0, rows + more), rows)
            })
        ) {
            let n_columns = costs[0].len();
            let mut assignment = Assignment::default();
            let columns = assignment.cheapest(costs.len(), n_columns, |r, c| costs[r][c]);
            let sum: f64 = columns.iter().enumerate().map(|(r, &c)| costs[r][c]).sum();
            let best = exhaustive(&costs, 0, &mut vec![false; n_columns]);
            prop_assert!((sum - best).abs() < 1e-9);
            let mut seen = columns.to_vec();
            seen.sort_unstable();
            seen.dedup();
            prop_assert_eq!(seen.len(), costs.len());
        }
    }

    #[test]
    fn rows_beyond_the_columns_are_left_out() {
        let mut assignment = Assignment::default();
        assert_eq!(assignment.cheapest(2, 1, |_, _| 1.0), [0, usize::MAX]);
        assert_eq!(assignment.cheapest(2, 0, |_, _| 1.0), [usize::MAX; 2]);
        assert!(assignment.cheapest(0, 3, |_, _| 1.0).is_empty());
    }

    #[test]
    fn costs_that_are_not_numbers_end() {
        let mut assignment = Assignment::default();
        assert_eq!(assignment.cheapest(3, 3, |_, _| f64::NAN).len(), 3);
    }
}
