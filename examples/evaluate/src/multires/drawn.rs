//! Pixels of each branch, so that the quality of any order is counted and not drawn.

use super::Outcome;
use super::parts::Parts;
use rayon::prelude::*;
use tree_core::Control;
use tree_lod::cover::{Around, Bits, Stage};

/// What each branch covers in some views, and the whole tree.
pub(super) struct Drawn {
    /// For each branch its pixels, each once, sorted; those of all views are numbered on.
    pub(super) pixels: Vec<Vec<u32>>,
    /// Pixels of a view.
    area: u32,
    /// Pixels of the whole tree in each view.
    full: Vec<f64>,
}

impl Drawn {
    pub(super) fn new(parts: &Parts, around: &Around) -> Outcome<Self> {
        let cameras = around.cameras();
        let stage = Stage::new(&parts.mesh, &cameras, around.size, &[], &Control::default())?;
        let area = around.size * around.size;
        let of = |branch: u32| {
            let mut found = Vec::new();
            for view in 0..stage.n_views() {
                let begin = view as u32 * area;
                for (surface, triangles) in parts.triangles(branch) {
                    stage.runs_of(view, surface, triangles, |row, first, end| {
                        let row = begin + row * around.size;
                        found.extend(row + first..row + end);
                    });
                }
            }
            found.sort_unstable();
            found.dedup();
            found
        };
        let pixels = (0..parts.n_branches() as u32).into_par_iter().map(of).collect();
        let of_view = |view| stage.full(view).map_or(0.0, |full: &Bits| full.count() as f64);
        Ok(Self { pixels, area, full: (0..stage.n_views()).map(of_view).collect() })
    }

    /// Number of pixels of all views.
    pub(super) fn n_pixels(&self) -> usize {
        self.area as usize * self.full.len()
    }

    /// Quality (eq. 7.7) after each branch of an order, the mean over the views. What is drawn is a part of the
    /// whole tree: precision is 1, and the quality is the recall.
    pub(super) fn qualities(&self, order: &[u32]) -> Vec<f64> {
        let mut covered = vec![false; self.n_pixels()];
        let worth = self.full.iter().map(|n| 1.0 / (n.max(1.0) * self.full.len() as f64));
        let worth: Vec<f64> = worth.collect();
        let mut sum = 0.0;
        let mut after = |&branch: &u32| {
            for &pixel in &self.pixels[branch as usize] {
                if !std::mem::replace(&mut covered[pixel as usize], true) {
                    sum += worth[(pixel / self.area) as usize];
                }
            }
            sum
        };
        order.iter().map(&mut after).collect()
    }

    /// Pixels of each branch; one that `n` branches cover counts 1/n for each.
    pub(super) fn shares(&self) -> Vec<f64> {
        let mut counts = vec![0_u32; self.n_pixels()];
        self.pixels.iter().flatten().for_each(|&pixel| counts[pixel as usize] += 1);
        let share = |&pixel: &u32| 1.0 / f64::from(counts[pixel as usize]);
        self.pixels.iter().map(|pixels| pixels.iter().map(share).sum()).collect()
    }

    /// For each branch the pixels that none before it in an order covers.
    pub(super) fn added(&self, order: &[u32]) -> Vec<f64> {
        let mut covered = vec![false; self.n_pixels()];
        let mut added = vec![0.0; order.len()];
        for &branch in order {
            let new = |&&pixel: &&u32| !std::mem::replace(&mut covered[pixel as usize], true);
            added[branch as usize] = self.pixels[branch as usize].iter().filter(new).count() as f64;
        }
        added
    }
}
