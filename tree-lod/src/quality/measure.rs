//! Scale and quality of a model for each share of geometry (§7.2.2), measured.
//!
//! For every λ the pruned model is drawn into masks from all sides, at several scales, and compared with
//! the full one; the scale of best mean quality is kept (eq. 7.6). The search begins at the scale of the
//! λ above, for scales grow as λ falls: first in large steps, past a small dip, because quality may have
//! two peaks (leaves as they are, in the right places; or large ones that fill the gaps), then in small
//! ones.
//!
//! Cost: for each λ about ten drawings of λ · triangles in every view, in parallel over views.

use super::score::Score;
use super::table::{Row, Table, cook_scale};
use crate::cover::{Around, Bits, Piece, Stage};
use crate::element::Elements;
use crate::error::{LodError, Result, check_range};
use crate::order::Ranking;
use crate::outline::Tier;
use crate::prune::{Cut, Schedule};
use rayon::prelude::*;
use tree_core::Control;
use tree_mesh::Mesh;

/// What is measured: a model, its elements, what they are drawn with, and their order.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The full model.
    pub mesh: &'a Mesh,
    /// Its elements.
    pub elements: &'a Elements,
    /// Triangles of the elements, the full model first; at least one tier.
    pub tiers: &'a [Tier],
    /// Order and pivots.
    pub ranking: &'a Ranking,
    /// Elements with which each tier begins, or empty: see [`Schedule::new`].
    pub kept: &'a [u32],
}

/// Which scale is measured.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Scale {
    /// The best for each λ (eq. 7.6). Default.
    #[default]
    Best,
    /// 1 / λ (Cook et al. 2007).
    Cook,
    /// Always 1: leaves keep their size.
    Kept,
    /// This one, a factor on area, 0.01 to 10⁴.
    Fixed(f32),
}

/// How a table is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct TableParams {
    /// Views. Default 8 azimuths, level, 256 pixels.
    pub around: Around,
    /// Rows of the table: rising from 10⁻⁵ or more, the last 1, at most 256. Default 17 from 0.01 to 1.
    pub lambdas: Vec<f32>,
    /// Which scale is measured.
    pub scale: Scale,
}

impl Default for TableParams {
    fn default() -> Self {
        Self {
            around: Around { size: 256, turn: 0.25, ..Around::default() },
            lambdas: vec![
                0.01, 0.015, 0.02, 0.03, 0.05, 0.075, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6,
                0.75, 0.9, 1.0,
            ],
            scale: Scale::Best,
        }
    }
}

/// Triangles times views that [`TableParams::for_triangles`] looks at.
const WORK: usize = 2_000_000;

impl TableParams {
    /// Fewer views for a large model: the table of one of half a million triangles takes seconds.
    #[must_use]
    pub fn for_triangles(n_triangles: usize) -> Self {
        let mut params = Self::default();
        params.around.azimuths = (WORK / n_triangles.max(1)).clamp(4, 8) as u32;
        if n_triangles > 100_000 {
            params.around.size = 160;
        }
        params
    }

    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`LodError::Parameter`], naming the field, or [`LodError::Table`] for λ that do not rise to 1.
    pub fn validate(&self) -> Result<()> {
        self.around.validate()?;
        check_range("lambdas.len", self.lambdas.len() as f64, 1.0, 256.0)?;
        check_range("lambdas", self.lambdas[0].into(), 1e-5, 1.0)?;
        let row = |&lambda: &f32| Row { lambda, scale: 1.0, ..Row::default() };
        Table::new(self.lambdas.iter().map(row).collect())?;
        match self.scale {
            Scale::Fixed(scale) => check_range("scale", scale.into(), 0.01, 1e4),
            _ => Ok(()),
        }
    }
}

/// Factors on the scale (on length) of the λ above that are tried first, rising.
const STEPS: [f32; 6] = [1.1, 1.22, 1.4, 1.65, 2.0, 2.5];
/// So many steps in a row may be worse than the one before them; then there is no other peak.
const STEPS_DOWN: u32 = 2;
/// From this quality on no other scale is tried: nothing is left to win.
const PERFECT: f64 = 0.999;
/// The first step around the best of them, halved (as a factor) [`HALVINGS`] times.
const FIRST_STEP: f32 = 1.05;
const HALVINGS: u32 = 2;
/// Smallest and largest factor on length that is tried.
const GROWTHS: (f32, f32) = (0.5, 40.0);

impl Table {
    /// Measures a table.
    ///
    /// # Errors
    /// As [`Stage::new`]; [`LodError::Order`], [`LodError::Length`] or [`LodError::Foliage`] when the
    /// parts of the subject do not belong together; [`LodError::Parameter`] or [`LodError::Table`].
    ///
    /// # Complexity
    /// See the module.
    pub fn measure(subject: &Subject<'_>, params: &TableParams, control: &Control) -> Result<Self> {
        params.validate()?;
        let schedule = subject.schedule()?;
        let stage = subject.stage(&params.around, control)?;
        let fixed = matches!(params.scale, Scale::Fixed(_));
        let mut growth = 1.0;
        let mut rows = Vec::with_capacity(params.lambdas.len());
        for (number, &lambda) in params.lambdas.iter().rev().enumerate() {
            control.report("table", number as f32 / params.lambdas.len() as f32)?;
            let cut = schedule.at(lambda)?;
            let at = |growth: f32| subject.scores(&stage, &cut, growth);
            growth = match params.scale {
                // The full model covers its own pixels.
                _ if lambda == 1.0 && subject.is_full() && !fixed => {
                    rows.push(Row {
                        lambda,
                        scale: 1.0,
                        precision: 1.0,
                        recall: 1.0,
                        quality: 1.0,
                    });
                    continue;
                }
                Scale::Best => best(growth, |growth| Ok(mean_quality(&at(growth))), control)?,
                Scale::Cook => cook_scale(lambda).sqrt(),
                Scale::Kept => 1.0,
                Scale::Fixed(scale) => scale.sqrt(),
            };
            let scores = at(growth);
            let sum: Score = scores.iter().copied().sum();
            rows.push(Row {
                lambda,
                scale: growth * growth,
                precision: sum.precision() as f32,
                recall: sum.recall() as f32,
                quality: mean_quality(&scores) as f32,
            });
        }
        rows.reverse();
        Self::new(rows)
    }
}

/// Scores of a subject at each λ and scale (on area) of `at`, one for each camera. The full model is drawn once.
///
/// # Errors
/// As [`Table::measure`].
///
/// # Complexity
/// O(views × triangles) for the full model, O(views × λ · triangles) for each of `at`, in parallel over views.
pub fn scores_at(
    subject: &Subject<'_>,
    at: &[(f32, f32)],
    around: &Around,
    control: &Control,
) -> Result<Vec<Vec<Score>>> {
    around.validate()?;
    let schedule = subject.schedule()?;
    let mut cuts = Vec::with_capacity(at.len());
    for &(lambda, scale) in at {
        check_range("scale", scale.into(), 0.01, 1e4)?;
        cuts.push((schedule.at(lambda)?, scale.sqrt()));
    }
    let stage = subject.stage(around, control)?;
    cuts.iter()
        .map(|(cut, growth)| {
            control.check()?;
            Ok(subject.scores(&stage, cut, *growth))
        })
        .collect()
}

/// Mean of the qualities of several views.
#[must_use]
pub fn mean_quality(scores: &[Score]) -> f64 {
    scores.iter().map(Score::quality).sum::<f64>() / scores.len().max(1) as f64
}

impl Subject<'_> {
    /// Checks that the parts belong together, and how they are dropped.
    fn schedule(&self) -> Result<Schedule> {
        self.elements.check(self.mesh)?;
        self.tiers.iter().try_for_each(|tier| tier.check(self.mesh, self.elements))?;
        let (found, expected) = (self.ranking.pivots.len(), self.elements.len());
        if found != expected {
            return Err(LodError::Length { what: "pivots", found, expected });
        }
        if !self.ranking.pivots.iter().all(|pivot| pivot.is_finite()) {
            return Err(LodError::Foliage("a pivot is not finite"));
        }
        Schedule::new(self.tiers, &self.ranking.order, self.kept)
    }

    /// Whether the first tier is the model as it is.
    fn is_full(&self) -> bool {
        let first = self.tiers.first().map_or(0, |tier| tier.triangles.len());
        first == self.elements.n_triangles()
    }

    fn stage(&self, around: &Around, control: &Control) -> Result<Stage<'_>> {
        Stage::new(self.mesh, &around.cameras(), around.size, &self.elements.surfaces, control)
    }

    /// A score for each view of a stage.
    fn scores(&self, stage: &Stage<'_>, cut: &Cut, growth: f32) -> Vec<Score> {
        let (fine, coarse) = (cut.tier as usize, (cut.tier as usize + 1).min(self.tiers.len() - 1));
        let score = |shot: &crate::cover::Shot| {
            let mut bits: Bits = shot.kept.clone();
            for (rank, &element) in self.ranking.order[..cut.end as usize].iter().enumerate() {
                let tier = if rank < cut.fine as usize { fine } else { coarse };
                let element = element as usize;
                let piece = Piece {
                    surface: self.elements.surface[element],
                    triangles: self.tiers[tier].of(element),
                    center: self.ranking.pivots[element],
                    growth,
                };
                stage.draw(shot, piece, &mut bits);
            }
            bits.score(&shot.full)
        };
        stage.shots().par_iter().map(score).collect()
    }
}

/// The scale (on length) of best quality, from that of the λ above on.
fn best(from: f32, mut quality: impl FnMut(f32) -> Result<f64>, control: &Control) -> Result<f32> {
    let mut look = |growth: f32, best: &mut (f64, f32)| -> Result<f64> {
        control.check()?;
        let growth = growth.clamp(GROWTHS.0, GROWTHS.1);
        let found = quality(growth)?;
        if found > best.0 {
            *best = (found, growth);
        }
        Ok(found)
    };
    let mut best = (f64::NEG_INFINITY, from);
    let mut last = look(from, &mut best)?;
    let mut down = 0;
    for step in STEPS {
        if best.0 >= PERFECT || down == STEPS_DOWN {
            break;
        }
        let found = look(from * step, &mut best)?;
        down = if found < last { down + 1 } else { 0 };
        last = found;
    }
    let mut step = FIRST_STEP;
    for _ in 0..HALVINGS {
        if best.0 >= PERFECT {
            break;
        }
        let middle = best.1;
        look(middle * step, &mut best)?;
        if best.1 == middle {
            look(middle / step, &mut best)?;
        }
        step = step.sqrt();
    }
    Ok(best.1)
}
