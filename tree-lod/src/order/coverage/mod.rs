//! An order that keeps the pixels covered: ours.
//!
//! The heuristics of the paper (§7.3) guess from normals and density which elements will be seen; here
//! they are looked at. Elements are drawn as bit masks from many sides, and those are kept that
//! together make the best quality (eq. 7.7) of the masks.
//!
//! 1. *Stages* with falling λ: each chooses its elements from those of the stage before, so the
//!    sets are nested and every one is the beginning of one order. From the top down, because near
//!    the full model it matters much which leaves are there (their pixels are exact), while far from
//!    it leaves are large and many choices are as good.
//! 2. A stage tries several scales, each larger than that of the stage before, and keeps the best.
//! 3. With a scale given, elements are taken greedily: always the one that adds most quality per
//!    triangle, first order in right and wrong pixels (`state`). Gains change little from step to
//!    step, so old ones are trusted until they come to the top of a heap (Minoux 1978, "lazy greedy").
//! 4. Where leaves have grown, each chooses the point that it grows about (`pivot`): a leaf at the rim
//!    of the crown grows inwards. The point is stored per leaf, so a shader has no more to do.
//! 5. What is left when the first stage is full is taken by gain at its own size.
//!
//! Cost: some ten passes of drawing over the elements of the first stages, and O(picks × a few × views
//! × words of an element's mask); memory 12 bytes per word of every element's mask in every view.

mod footprint;
mod greedy;
mod pivot;
mod state;

#[cfg(test)]
mod tests;

use crate::cover::{Around, Stage};
use crate::element::Elements;
use crate::error::{Result, check_range};
use crate::outline::Tier;
use glam::Vec3;
use greedy::{Goal, Run};
use rayon::prelude::*;
use tree_core::Control;
use tree_mesh::Mesh;

/// How the order is made.
#[derive(Clone, Debug, PartialEq)]
pub struct CoverageParams {
    /// Views that are looked at. More views hold better for others, at proportional cost. Default 12
    /// azimuths at pitches of 0 and 0.35 rad, 256 pixels.
    pub around: Around,
    /// Shares of triangles for which the choice is made, falling, more than 0, less than 1, at most
    /// 32. Default 0.5, 0.35, 0.2, 0.1, 0.05, 0.02.
    pub stages: Vec<f32>,
    /// Whether leaves choose the point they grow about; otherwise it is their centre. Default true.
    pub pivots: bool,
}

impl Default for CoverageParams {
    fn default() -> Self {
        let around =
            Around { azimuths: 12, turn: 0.1, pitches: vec![0.0, 0.35], size: 256, fov: None };
        Self { around, stages: vec![0.5, 0.35, 0.2, 0.1, 0.05, 0.02], pivots: true }
    }
}

/// Triangles times views that are looked at by [`CoverageParams::for_triangles`].
const WORK: usize = 4_000_000;

impl CoverageParams {
    /// Fewer and smaller views and no pivots for a large model, whose leaves are small: the order of one
    /// of half a million triangles takes seconds.
    #[must_use]
    pub fn for_triangles(n_triangles: usize) -> Self {
        let mut params = Self::default();
        let views = WORK / n_triangles.max(1);
        if views < 24 {
            params.pivots = false;
            params.around.azimuths = (views / 2).max(4) as u32;
            params.around.size = 192;
        }
        params
    }

    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`LodError::Parameter`](crate::LodError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        self.around.validate()?;
        check_range("stages.len", self.stages.len() as f64, 1.0, 32.0)?;
        let mut above = 1.0 - f64::EPSILON;
        for &share in &self.stages {
            check_range("stages", share.into(), 1e-6, above)?;
            above = f64::from(share) - f64::EPSILON;
        }
        Ok(())
    }
}

/// An order, and the point that each element grows about.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ranking {
    /// All elements, the most important first.
    pub order: Vec<u32>,
    /// For each element (not rank) the point it is scaled about, in metres.
    pub pivots: Vec<Vec3>,
}

/// Scales (on length) that are tried in a stage, as factors on that of the stage before.
const GROWTHS: [f32; 5] = [1.0, 1.15, 1.35, 1.6, 1.9];
/// Around the best of them, these are tried next, with pivots.
const REFINED: [f32; 3] = [0.93, 1.0, 1.07];
/// Large leaves need fewer pixels: masks shrink as leaves grow, down to this size.
const SIZE_MIN: u32 = 96;
/// In stages above this λ, leaves keep their size: what is left covers nearly the same pixels.
const UNSCALED: f32 = 0.4;
/// In stages below this λ, pivots are looked at for every scale that is tried; above, there are many
/// candidates, and only for the best.
const PIVOT_TRIALS: f32 = 0.15;
/// Leaves that are scaled by less do not choose a pivot: it would move them by less than a pixel.
const PIVOT_GROWTH: f32 = 1.15;

/// The order of the elements of `mesh`, drawn as in `tier`: the full one, or, for leaves of many
/// triangles, one of about four triangles each, which takes a quarter of the time and gives nearly the
/// same order.
///
/// # Errors
/// As [`Stage::new`]; [`LodError::Parameter`](crate::LodError::Parameter); [`LodError::Foliage`](crate::LodError::Foliage) when there are no elements;
/// [`LodError::Length`](crate::LodError::Length) when tier and elements do not belong together.
///
/// # Complexity
/// See the module. Parallel inside.
pub fn coverage(
    mesh: &Mesh,
    elements: &Elements,
    tier: &Tier,
    params: &CoverageParams,
    control: &Control,
) -> Result<Ranking> {
    params.validate()?;
    elements.check(mesh)?;
    tier.check(mesh, elements)?;
    control.report("views", 0.0)?;
    let cameras = params.around.cameras();
    let view = |growth: f32| {
        let size = ((params.around.size as f32 / growth) as u32).max(SIZE_MIN);
        let size = size.min(params.around.size);
        Stage::new(mesh, &cameras, size, &elements.surfaces, control)
    };
    let mut stage = view(1.0)?;
    let mut pivots = elements.centers.clone();
    let mut candidates: Vec<u32> = (0..elements.len() as u32).collect();
    // Differences of the nested sets, the largest first.
    let mut parts: Vec<Vec<u32>> = Vec::new();
    let mut growth = 1.0;
    let mut goal = Goal::default();
    let total = tier.triangles.len() as f64;
    for (number, &share) in params.stages.iter().enumerate() {
        control.report("stages", number as f32 / params.stages.len() as f32)?;
        let budget = (total * f64::from(share)) as u64;
        if growth > 1.0 {
            stage = view(growth)?;
        }
        let scene = Scene { stage: &stage, elements, tier };
        let task = Task { scene: &scene, candidates: &candidates, budget, share, control };
        let best = task.best(growth, goal, params.pivots)?;
        if best.chosen.is_empty() {
            // Nothing is small enough, and less will be left in every later stage.
            break;
        }
        growth = best.growth;
        goal = best.goal();
        for &(element, pivot) in &best.chosen {
            pivots[element as usize] = pivot;
        }
        let chosen: Vec<u32> = best.chosen.iter().map(|&(element, _)| element).collect();
        parts.push(without(&candidates, &chosen, elements.len()));
        candidates = chosen;
        if candidates.len() < 2 {
            break;
        }
    }
    control.report("rest", 1.0)?;
    let mut order = candidates;
    let stage = view(1.0)?;
    let scene = Scene { stage: &stage, elements, tier };
    while let Some(part) = parts.pop() {
        order = if parts.is_empty() {
            let rest =
                Task { scene: &scene, candidates: &part, budget: u64::MAX, share: 1.0, control };
            let rest = greedy::run(&rest, &order, 1.0, false, goal)?;
            order.into_iter().chain(rest.chosen.iter().map(|&(element, _)| element)).collect()
        } else {
            order.into_iter().chain(part).collect()
        };
    }
    // What shows nothing comes last.
    order.sort_by_key(|&element| elements.areas[element as usize] <= 0.0);
    Ok(Ranking { order, pivots })
}

/// What is drawn, of what, and in which views.
pub(super) struct Scene<'a> {
    pub(super) stage: &'a Stage<'a>,
    pub(super) elements: &'a Elements,
    pub(super) tier: &'a Tier,
}

/// What a stage has to do.
pub(super) struct Task<'a> {
    pub(super) scene: &'a Scene<'a>,
    /// Elements it may take.
    pub(super) candidates: &'a [u32],
    /// Triangles it may spend, and their share of all.
    pub(super) budget: u64,
    share: f32,
    pub(super) control: &'a Control,
}

impl Task<'_> {
    /// The best of several scales, `growth` or larger.
    fn best(&self, growth: f32, goal: Goal, pivots: bool) -> Result<Run> {
        let coarse = if self.share > UNSCALED {
            greedy::run(self, &[], growth, false, goal)?
        } else {
            let few = self.share < PIVOT_TRIALS;
            let tries = GROWTHS.map(|factor| factor * growth);
            self.best_of(if few { &tries } else { &tries[..3] }, goal, pivots && few)?
        };
        if coarse.growth < PIVOT_GROWTH {
            return Ok(coarse);
        }
        let tries = REFINED.map(|factor| (factor * coarse.growth).max(1.0));
        self.best_of(&tries, coarse.goal(), pivots)
    }

    fn best_of(&self, tries: &[f32], goal: Goal, pivots: bool) -> Result<Run> {
        let run =
            |&growth: &f32| greedy::run(self, &[], growth, pivots && growth >= PIVOT_GROWTH, goal);
        let found: Vec<Run> = tries.par_iter().map(run).collect::<Result<_>>()?;
        Ok(found.into_iter().reduce(better).unwrap_or_default())
    }
}

/// The run of better quality, of equal ones the first.
fn better(a: Run, b: Run) -> Run {
    if b.quality > a.quality { b } else { a }
}

/// `all` without `some`, in its order.
fn without(all: &[u32], some: &[u32], n: usize) -> Vec<u32> {
    let mut taken = vec![false; n];
    some.iter().for_each(|&element| taken[element as usize] = true);
    all.iter().copied().filter(|&element| !taken[element as usize]).collect()
}
