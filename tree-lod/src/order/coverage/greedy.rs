//! Elements taken one by one, always the one that is worth most.

use super::footprint::Footprints;
use super::pivot::Pivots;
use super::state::State;
use super::{Scene, Task};
use crate::error::Result;
use crate::quality::Score;
use glam::Vec3;
use rayon::prelude::*;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Options of a candidate that are looked at again after the first time: the best ones.
const KEPT_OPTIONS: usize = 3;

/// Precision and recall that a run is expected to end with: right and wrong pixels are weighed
/// for it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Goal {
    precision: f64,
    recall: f64,
}

impl Default for Goal {
    fn default() -> Self {
        Self { precision: 0.98, recall: 0.96 }
    }
}

/// What was chosen.
#[derive(Debug, Default)]
pub(super) struct Run {
    /// Elements in the order they were taken, and their pivots.
    pub(super) chosen: Vec<(u32, Vec3)>,
    pub(super) growth: f32,
    pub(super) quality: f64,
    sum: Score,
}

impl Run {
    /// Precision and recall it ended with.
    pub(super) fn goal(&self) -> Goal {
        Goal { precision: self.sum.precision(), recall: self.sum.recall() }
    }
}

/// A candidate, what it was worth per triangle when that was last looked at, and when.
#[derive(Clone, Copy, Debug)]
struct Entry {
    worth: f64,
    candidate: u32,
    taken: u32,
}

impl PartialEq for Entry {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Entry {}

impl PartialOrd for Entry {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Entry {
    /// By worth; of equal ones the first candidate is the greater.
    fn cmp(&self, other: &Self) -> Ordering {
        self.worth.total_cmp(&other.worth).then(other.candidate.cmp(&self.candidate))
    }
}

/// Takes candidates until the budget of triangles is spent. `before` are drawn already, at their
/// own size.
///
/// # Errors
/// As [`Footprints::new`].
pub(super) fn run(
    task: &Task<'_>,
    before: &[u32],
    growth: f32,
    pivots: bool,
    goal: Goal,
) -> Result<Run> {
    let Task { scene, candidates, budget, control, .. } = *task;
    control.check()?;
    let pivots =
        if pivots { Pivots::rim(scene, candidates) } else { Pivots::centers(scene, candidates) };
    let mut state = State::new(scene.stage, (goal.precision, goal.recall));
    if !before.is_empty() {
        let centers = Pivots::centers(scene, before);
        let prints = Footprints::new(scene, before, 1.0, &centers, control)?;
        (0..before.len()).for_each(|row| state.add(prints.row(row)));
    }
    let prints = Footprints::new(scene, candidates, growth, &pivots, control)?;
    let chooser = Chooser { scene, candidates, prints: &prints };
    let (mut options, mut heap) = chooser.first(&state);
    let mut run = Run { growth, ..Run::default() };
    let cost = |candidate: usize| u64::from(scene.tier.cost(candidates[candidate] as usize));
    let cheapest = (0..candidates.len()).map(cost).min().unwrap_or(0);
    let mut spent = 0;
    while let Some(entry) = heap.pop() {
        let candidate = entry.candidate as usize;
        let taken = run.chosen.len() as u32;
        if entry.taken != taken {
            let worth = chooser.best(&state, candidate, &mut options[candidate]);
            let entry = Entry { worth, taken, ..entry };
            if heap.peek().is_some_and(|next| entry < *next) {
                heap.push(entry);
                continue;
            }
        }
        if spent + cheapest > budget {
            break;
        }
        if spent + cost(candidate) > budget {
            // Another may be small enough.
            continue;
        }
        spent += cost(candidate);
        let option = usize::from(options[candidate][0]);
        state.add(prints.row(candidate * prints.options + option));
        run.chosen.push((candidates[candidate], pivots.of(candidate)[option]));
    }
    run.quality = state.quality();
    run.sum = state.scores.iter().copied().sum();
    Ok(run)
}

struct Chooser<'a> {
    scene: &'a Scene<'a>,
    candidates: &'a [u32],
    prints: &'a Footprints,
}

/// The best options of a candidate, the best of all first.
type Options = [u8; KEPT_OPTIONS];

impl Chooser<'_> {
    /// Looks at all options of all candidates.
    fn first(&self, state: &State) -> (Vec<Options>, BinaryHeap<Entry>) {
        let all = self.prints.options;
        let found: Vec<(Options, Entry)> = (0..self.candidates.len())
            .into_par_iter()
            .with_min_len(64)
            .map(|candidate| {
                let mut worths: Vec<(f64, u8)> = (0..all)
                    .map(|option| {
                        (state.gain(self.prints.row(candidate * all + option)), option as u8)
                    })
                    .collect();
                worths.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
                let options = std::array::from_fn(|i| worths[i.min(all - 1)].1);
                let worth = worths[0].0 / self.cost(candidate);
                (options, Entry { worth, candidate: candidate as u32, taken: 0 })
            })
            .collect();
        (found.iter().map(|found| found.0).collect(), found.iter().map(|found| found.1).collect())
    }

    /// Looks at the kept options again and puts the best first.
    fn best(&self, state: &State, candidate: usize, options: &mut Options) -> f64 {
        let all = self.prints.options;
        let mut best = (f64::NEG_INFINITY, 0);
        for (place, &option) in options.iter().enumerate().take(all) {
            let gain = state.gain(self.prints.row(candidate * all + usize::from(option)));
            if gain > best.0 {
                best = (gain, place);
            }
        }
        options.swap(0, best.1);
        best.0 / self.cost(candidate)
    }

    fn cost(&self, candidate: usize) -> f64 {
        f64::from(self.scene.tier.cost(self.candidates[candidate] as usize).max(1))
    }
}
