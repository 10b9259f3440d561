//! Matchings of two sets of siblings: who is compared with whom, and who is deleted or inserted whole.

use crate::assignment::Assignment;

/// Finds the matching that saves most against deleting and inserting all, with memory of its own.
#[derive(Default)]
pub(super) struct Matcher {
    assignment: Assignment,
    savings: Vec<f64>,
    /// Pairs of the last matching, as places in the two sets.
    pub(super) pairs: Vec<(usize, usize)>,
}

impl Matcher {
    /// The most that can be saved by pairing some of `n_first` with some of `n_second` siblings, where
    /// the pair (s, t) saves `saving(s, t)`; pairs that save nothing are not made.
    pub(super) fn most(
        &mut self,
        n_first: usize,
        n_second: usize,
        saving: impl Fn(usize, usize) -> f64,
    ) -> f64 {
        match (n_first, n_second) {
            (0, _) | (_, 0) => 0.0,
            (1, _) => (0..n_second).fold(0.0, |best, t| saving(0, t).max(best)),
            (_, 1) => (0..n_first).fold(0.0, |best, s| saving(s, 0).max(best)),
            (2, _) => most_of_two(n_second, saving),
            (_, 2) => most_of_two(n_first, |t, s| saving(s, t)),
            _ => {
                self.pair(n_first, n_second, saving);
                let saved = |&(s, t): &(usize, usize)| self.savings[s * n_second + t];
                self.pairs.iter().map(saved).sum()
            }
        }
    }

    /// The same, and leaves the pairs in `pairs`.
    pub(super) fn pair(
        &mut self,
        n_first: usize,
        n_second: usize,
        saving: impl Fn(usize, usize) -> f64,
    ) {
        self.savings.clear();
        let all = (0..n_first).flat_map(|s| (0..n_second).map(move |t| (s, t)));
        self.savings.extend(all.map(|(s, t)| saving(s, t).max(0.0)));
        let (savings, pairs) = (&self.savings, &mut self.pairs);
        pairs.clear();
        // Fewer rows than columns: every row gets one, if only for a saving of 0.
        if n_first <= n_second {
            let cost = |s: usize, t: usize| -savings[s * n_second + t];
            let columns = self.assignment.cheapest(n_first, n_second, cost);
            pairs.extend(columns.iter().copied().enumerate());
        } else {
            let cost = |t: usize, s: usize| -savings[s * n_second + t];
            let columns = self.assignment.cheapest(n_second, n_first, cost);
            pairs.extend(columns.iter().copied().enumerate().map(|(t, s)| (s, t)));
            pairs.sort_unstable();
        }
        pairs.retain(|&(s, t)| savings[s * n_second + t] > 0.0);
    }
}

/// Two rows: the best column of each, or where that is the same one, one of them takes its second.
fn most_of_two(n_columns: usize, saving: impl Fn(usize, usize) -> f64) -> f64 {
    let mut best = [(0.0, usize::MAX); 2];
    let mut second = [0.0; 2];
    for row in 0..2 {
        for column in 0..n_columns {
            let saved = saving(row, column);
            if saved > best[row].0 {
                second[row] = best[row].0;
                best[row] = (saved, column);
            } else if saved > second[row] {
                second[row] = saved;
            }
        }
    }
    if best[0].1 != best[1].1 || best[0].1 == usize::MAX {
        return best[0].0 + best[1].0;
    }
    (best[0].0 + second[1]).max(second[0] + best[1].0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_short_cuts_save_as_much_as_the_assignment(
            (n_first, n_second, savings) in (0_usize..5, 0_usize..5).prop_flat_map(|(n, m)| {
                (Just(n), Just(m), prop::collection::vec(-1_i32..6, n * m))
            })
        ) {
            let saving = |s: usize, t: usize| f64::from(savings[s * n_second + t]);
            let mut matcher = Matcher::default();
            let most = matcher.most(n_first, n_second, saving);
            matcher.pair(n_first, n_second, saving);
            let paired: f64 = matcher.pairs.iter().map(|&(s, t)| saving(s, t)).sum();
            prop_assert_eq!(most, paired);
        }
    }
}
