//! Who is apical and which place each lateral has: an assignment of children to labels.
//!
//! Section 4.6.1 tries all K! of them. The best assignment is found in O(K³) by successive shortest paths (Jonker &
//! Volgenant 1987), exactly.

use tree_core::assignment::Assignment;

/// The assignment of rows to columns with the largest sum of `score(row, column)`, both `0..n`; for each row its column. Scores
/// must be finite.
pub(super) fn best_assignment(n: usize, score: impl Fn(usize, usize) -> f64) -> Vec<usize> {
    Assignment::default().cheapest(n, n, |row, column| -score(row, column)).to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The best sum over all permutations.
    fn exhaustive(scores: &[Vec<f64>], row: usize, free: &mut Vec<usize>) -> f64 {
        if row == scores.len() {
            return 0.0;
        }
        (0..free.len())
            .map(|i| {
                let column = free.remove(i);
                let sum = scores[row][column] + exhaustive(scores, row + 1, free);
                free.insert(i, column);
                sum
            })
            .fold(f64::NEG_INFINITY, f64::max)
    }

    proptest! {
        #[test]
        fn no_permutation_is_better(
            scores in (1_usize..6).prop_flat_map(|n| prop::collection::vec(prop::collection::vec(-9.0_f64..9.0, n), n)),
        ) {
            let n = scores.len();
            let columns = best_assignment(n, |row, column| scores[row][column]);
            let mut seen = columns.clone();
            seen.sort_unstable();
            prop_assert_eq!(seen, (0..n).collect::<Vec<_>>());
            let sum: f64 = columns.iter().enumerate().map(|(row, &column)| scores[row][column]).sum();
            prop_assert!((sum - exhaustive(&scores, 0, &mut (0..n).collect())).abs() < 1e-9);
        }
    }
}
