//! The nearest top of the posterior, in all depths at once.

use super::densities::Densities;
use super::posterior::{Graph, State, Wiring};
use super::segments::STEEPEST;
use crate::error::Result;
use tree_core::Control;

/// What a climb goes by.
pub(super) struct Climb<'a> {
    pub(super) graph: &'a Graph,
    pub(super) omega: &'a Densities,
    pub(super) control: &'a Control,
}

impl Climb<'_> {
    /// Raises the posterior along all depths at once, in at most so many steps of a quasi-Newton method (BFGS; Nocedal & Wright 2006,
    /// section 6.1) on the segments' slopes, which stay within [`STEEPEST`]. Gradients are differences. Returns the posterior.
    pub(super) fn climb(&self, state: &mut State, steps: u32) -> Result<f64> {
        /// First guess of the curvature's inverse, and the longest step, in tangents.
        const FIRST: f64 = 0.03;
        const LONGEST: f64 = 0.5;
        /// A step that does not rise is tried again, so much shorter, so many times.
        const SHORTER: f64 = 0.4;
        const TRIES: u32 = 8;
        /// A step that gains less is the last.
        const LEAST_GAIN: f64 = 1e-8;
        let n = state.depths.len();
        let wiring = self.graph.wiring(&state.labels);
        let unit = |i: usize| (0..n).map(|j| if i == j { FIRST } else { 0.0 }).collect();
        let mut inverse: Vec<Vec<f64>> = (0..n).map(unit).collect();
        let mut total = self.graph.total(self.omega, state);
        let mut uphill = self.gradient(state, &wiring);
        for _ in 0..steps {
            self.control.check()?;
            let mut way: Vec<f64> = inverse.iter().map(|row| dot(row, &uphill)).collect();
            // What stands still has no gradient, and does not move.
            for (part, _) in way.iter_mut().zip(&uphill).filter(|(_, rise)| **rise == 0.0) {
                *part = 0.0;
            }
            let longest = way.iter().fold(LONGEST, |most, part| most.max(part.abs()));
            let tries =
                (0..TRIES).map(|number| LONGEST / longest * libm::pow(SHORTER, number.into()));
            let Some((value, next, moved)) = tries
                .map(|share| self.moved(state, &way, share))
                .map(|(next, moved)| (self.graph.total(self.omega, &next), next, moved))
                .find(|(value, next, _)| *value > total && !self.steeper(state, next))
            else {
                break;
            };
            let gain = value - total;
            (total, *state) = (value, next);
            if gain < LEAST_GAIN {
                break;
            }
            let before = std::mem::replace(&mut uphill, self.gradient(state, &wiring));
            let still = |i: usize| moved[i] == 0.0 || uphill[i] == 0.0;
            let change = |i: usize| if still(i) { 0.0 } else { before[i] - uphill[i] };
            update(&mut inverse, &moved, &(0..n).map(change).collect::<Vec<f64>>());
        }
        Ok(total)
    }

    /// How the posterior rises with each segment's slope when all that it bears goes along; 0 for those that cannot get any steeper.
    fn gradient(&self, state: &mut State, wiring: &Wiring) -> Vec<f64> {
        /// Differences are taken over this tangent.
        const DIFFERENCE: f64 = 1e-5;
        let mut rises = vec![0.0; state.depths.len()];
        for i in (1..rises.len()).rev().filter(|&i| !self.graph.pinned[i]) {
            let (here, slope, unit) = (state.depths[i], self.slope(state, i), self.unit(i));
            let mut at = |depth: f64| {
                state.depths[i] = depth;
                self.graph.around(self.omega, state, wiring, i)
            };
            let step = DIFFERENCE * unit;
            // Children have added what they rise by already.
            rises[i] += (at(here + step) - at(here - step)) / (2.0 * step);
            state.depths[i] = here;
            let parent = self.graph.segments().parent(i);
            if let Some(parent) = parent.filter(|&parent| !self.graph.pinned[parent]) {
                rises[parent] += rises[i];
            }
            let stuck = slope.abs() > STEEPEST * (1.0 - 1e-9) && slope * rises[i] > 0.0;
            rises[i] = if stuck { 0.0 } else { rises[i] * unit };
        }
        rises[0] = 0.0;
        rises
    }

    /// A state whose slopes are changed by a share of `way` and not too steep, and by how much they did change.
    fn moved(&self, state: &State, way: &[f64], share: f64) -> (State, Vec<f64>) {
        let (mut next, mut moved) = (state.clone(), vec![0.0; way.len()]);
        for i in (1..way.len()).filter(|&i| !self.graph.pinned[i]) {
            let before = self.slope(state, i);
            let slope = (before + share * way[i]).clamp(-STEEPEST, STEEPEST);
            let below = self.graph.segments().parent(i).map_or(0.0, |parent| next.depths[parent]);
            next.depths[i] = below + slope * self.unit(i);
            moved[i] = slope - before;
        }
        (next, moved)
    }

    /// Whether a known depth has become too steep, as its parent moved.
    fn steeper(&self, before: &State, after: &State) -> bool {
        let slope = |state, i| self.slope(state, i).abs();
        let mut known = (1..after.depths.len()).filter(|&i| self.graph.pinned[i]);
        known.any(|i| slope(after, i) > slope(before, i).max(STEEPEST))
    }

    /// Length in the plane, not quite 0.
    fn unit(&self, segment: usize) -> f64 {
        let segments = self.graph.segments();
        segments.chord(segment).length().max(0.01 * segments.extent)
    }

    fn slope(&self, state: &State, segment: usize) -> f64 {
        let below =
            self.graph.segments().parent(segment).map_or(0.0, |parent| state.depths[parent]);
        (state.depths[segment] - below) / self.unit(segment)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Corrects the inverse of the curvature by what a step did to the gradient.
fn update(inverse: &mut [Vec<f64>], step: &[f64], change: &[f64]) {
    let along = dot(step, change);
    // It stays positive definite.
    if along <= 1e-12 {
        return;
    }
    let ahead: Vec<f64> = inverse.iter().map(|row| dot(row, change)).collect();
    let factor = (1.0 + dot(change, &ahead) / along) / along;
    for (i, row) in inverse.iter_mut().enumerate() {
        for (j, cell) in row.iter_mut().enumerate() {
            *cell += factor * step[i] * step[j] - (ahead[i] * step[j] + step[i] * ahead[j]) / along;
        }
    }
}
