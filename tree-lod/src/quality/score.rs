//! Precision, recall and quality.

/// Pixels of a simplified model against those of the full one; of one view, or summed over many.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Score {
    /// Covered by both.
    pub both: u64,
    /// Covered by the simplified model only.
    pub wrong: u64,
    /// Covered by the full model only.
    pub missed: u64,
}

impl Score {
    /// Share of the simplified model's pixels that are right (eq. 7.3), 0 to 1; 1 when it has none.
    #[must_use]
    pub fn precision(&self) -> f64 {
        share(self.both, self.wrong)
    }

    /// Share of the full model's pixels that are there (eq. 7.4), 0 to 1; 1 when it has none.
    #[must_use]
    pub fn recall(&self) -> f64 {
        share(self.both, self.missed)
    }

    /// 1 − √((1 − P)² + (1 − R)²) (eq. 7.7): 1 is perfect, 0 and less is useless.
    #[must_use]
    pub fn quality(&self) -> f64 {
        quality(self.precision(), self.recall())
    }
}

impl std::ops::Add for Score {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            both: self.both.saturating_add(other.both),
            wrong: self.wrong.saturating_add(other.wrong),
            missed: self.missed.saturating_add(other.missed),
        }
    }
}

impl std::iter::Sum for Score {
    fn sum<I: Iterator<Item = Self>>(scores: I) -> Self {
        scores.fold(Self::default(), |sum, score| sum + score)
    }
}

/// Quality of precision `p` and recall `r` (eq. 7.7).
pub(crate) fn quality(p: f64, r: f64) -> f64 {
    1.0 - ((1.0 - p) * (1.0 - p) + (1.0 - r) * (1.0 - r)).sqrt()
}

fn share(right: u64, other: u64) -> f64 {
    let all = right as f64 + other as f64;
    if all > 0.0 { right as f64 / all } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_full_model_is_perfect_and_an_empty_one_is_not() {
        let full = Score { both: 9, wrong: 0, missed: 0 };
        assert_eq!((full.precision(), full.recall(), full.quality()), (1.0, 1.0, 1.0));
        let empty = Score { both: 0, wrong: 0, missed: 9 };
        assert_eq!((empty.precision(), empty.recall(), empty.quality()), (1.0, 0.0, 0.0));
    }

    #[test]
    fn precision_and_recall_are_those_of_the_definition() {
        let score: Score =
            [Score { both: 2, wrong: 1, missed: 0 }, Score { both: 1, wrong: 0, missed: 2 }]
                .into_iter()
                .sum();
        assert_eq!((score.precision(), score.recall()), (0.75, 0.6));
        assert!((score.quality() - (1.0 - 0.2225_f64.sqrt())).abs() < 1e-12);
    }
}
