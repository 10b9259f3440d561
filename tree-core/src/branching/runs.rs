//! Unbranched runs: from a fork, or the root, to the next fork or a tip.

use super::length_below;
use crate::skeleton::{NO_PARENT, Skeleton};

/// One unbranched run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Run {
    /// The run below; [`NO_PARENT`] for run 0.
    pub parent: u32,
    /// Its upper end: a fork or a tip.
    pub end: u32,
    /// Whether it ends in a tip.
    pub is_tip: bool,
    /// Its segments, the one above the fork included: at least 1, but for a root that is a fork or a tip.
    pub n_segments: u32,
    /// Length from the fork below to the end, in metres.
    pub length: f64,
    /// Mean radius in metres: of each segment the radius of its upper end, weighted by length; segments with a
    /// radius of 0 are left out, as it means unknown in measured trees. 0 where nothing is known. A run without
    /// length has the radius of its end.
    pub radius: f64,
}

/// All unbranched runs of a skeleton. Runs below come first; run 0 starts at the root and has no length where
/// the root is a fork.
#[derive(Clone, Debug, PartialEq)]
pub struct Runs {
    runs: Vec<Run>,
    run_of: Vec<u32>,
}

impl Runs {
    /// Splits a skeleton into runs.
    ///
    /// # Complexity
    /// O(nodes), two passes.
    #[must_use]
    pub fn of(skeleton: &Skeleton) -> Self {
        let children = skeleton.children();
        let mut run_of = vec![0_u32; skeleton.len()];
        let mut runs: Vec<Run> = Vec::new();
        // Length that has a radius, per run.
        let mut known: Vec<f64> = Vec::new();
        for node in 0..skeleton.len() as u32 {
            let parent = skeleton.parent(node);
            let below = parent.map_or(NO_PARENT, |parent| run_of[parent as usize]);
            let run = match parent {
                Some(parent) if children.of(parent).len() == 1 => below,
                _ => {
                    let (length, radius) = (0.0, 0.0);
                    let (is_tip, n_segments) = (false, 0);
                    runs.push(Run { parent: below, end: node, is_tip, n_segments, length, radius });
                    known.push(0.0);
                    runs.len() as u32 - 1
                }
            };
            run_of[node as usize] = run;
            let length = length_below(skeleton, node);
            let radius = f64::from(skeleton.radii()[node as usize]);
            let (run, known) = (&mut runs[run as usize], &mut known[run as usize]);
            run.end = node;
            run.is_tip = children.is_tip(node);
            run.n_segments += u32::from(parent.is_some());
            run.length += length;
            if radius > 0.0 {
                *known += length;
                run.radius += length * radius;
            }
        }
        for (run, known) in runs.iter_mut().zip(known) {
            let at_end = f64::from(skeleton.radii()[run.end as usize]);
            run.radius = if known > 0.0 { run.radius / known } else { at_end };
        }
        Self { runs, run_of }
    }

    /// The runs, those below first; never empty.
    #[must_use]
    pub fn as_slice(&self) -> &[Run] {
        &self.runs
    }

    /// The run that each node lies on; a fork lies on the run below it.
    #[must_use]
    pub fn run_of(&self) -> &[u32] {
        &self.run_of
    }
}
