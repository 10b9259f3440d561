//! What is covered so far, in all views, and what more is worth.

use crate::cover::Stage;
use crate::quality::Score;

/// Quality is flat where nothing is wrong or missing: below this share both count as if they were it.
const LEAST_ERROR: f64 = 1e-3;

/// Worth of a right and of a wrong pixel in one view.
#[derive(Clone, Copy, Debug)]
struct Worth {
    right: f64,
    wrong: f64,
}

/// Masks of all views, one after another, and their scores.
pub(super) struct State {
    covered: Vec<u64>,
    full: Vec<u64>,
    pub(super) scores: Vec<Score>,
    worths: Vec<Worth>,
}

impl State {
    /// Only what is never pruned is there. Worths are those of pictures of precision and recall
    /// `goal`.
    pub(super) fn new(stage: &Stage<'_>, goal: (f64, f64)) -> Self {
        let shots = stage.shots();
        let join = |pick: fn(&crate::cover::Shot) -> &crate::cover::Bits| {
            shots.iter().flat_map(|shot| pick(shot).words()).copied().collect::<Vec<u64>>()
        };
        let scores: Vec<Score> = shots.iter().map(|shot| shot.kept.score(&shot.full)).collect();
        let worths = shots.iter().map(|shot| Worth::new(shot.full.count(), goal)).collect();
        Self { covered: join(|shot| &shot.kept), full: join(|shot| &shot.full), scores, worths }
    }

    /// What a footprint would add to the sum of the views' qualities, to first order.
    #[inline]
    pub(super) fn gain<'a>(&self, print: impl Iterator<Item = (&'a [u32], &'a [u64])>) -> f64 {
        let mut sum = 0.0;
        for ((words, bits), worth) in print.zip(&self.worths) {
            let (mut right, mut wrong) = (0, 0);
            for (&word, &bits) in words.iter().zip(bits) {
                let new = bits & !self.covered[word as usize];
                let full = self.full[word as usize];
                right += (new & full).count_ones();
                wrong += (new & !full).count_ones();
            }
            sum += worth.right * f64::from(right) - worth.wrong * f64::from(wrong);
        }
        sum
    }

    /// Covers the pixels of a footprint.
    pub(super) fn add<'a>(&mut self, print: impl Iterator<Item = (&'a [u32], &'a [u64])>) {
        for ((words, bits), score) in print.zip(&mut self.scores) {
            for (&word, &bits) in words.iter().zip(bits) {
                let covered = &mut self.covered[word as usize];
                let new = bits & !*covered;
                *covered |= bits;
                let full = self.full[word as usize];
                let right = u64::from((new & full).count_ones());
                score.both += right;
                score.missed -= right;
                score.wrong += u64::from((new & !full).count_ones());
            }
        }
    }

    /// Mean quality of the views.
    pub(super) fn quality(&self) -> f64 {
        let sum: f64 = self.scores.iter().map(Score::quality).sum();
        sum / self.scores.len().max(1) as f64
    }
}

impl Worth {
    /// The gradient of eq. 7.7 in pixels, for a view of `full` pixels at precision `p` and
    /// recall `r`.
    fn new(full: u64, (p, r): (f64, f64)) -> Self {
        let full = full.max(1) as f64;
        // Where nothing would be right, any pixel is worth as much as the first.
        let both = r.max(LEAST_ERROR) * full;
        let drawn = both / p.max(LEAST_ERROR);
        let (off_p, off_r) = ((1.0 - p).max(LEAST_ERROR), (1.0 - r).max(LEAST_ERROR));
        let off = (off_p * off_p + off_r * off_r).sqrt();
        let wrong = drawn - both;
        Self {
            right: (off_r / full + off_p * wrong / (drawn * drawn)) / off,
            wrong: off_p * both / (drawn * drawn) / off,
        }
    }
}
