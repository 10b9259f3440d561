//! No popping: how much what is covered changes from one step of the schedule to the next.

use super::pruned::Pruned;
use super::{Outcome, Prepared, information};
use crate::table::{Aim, Row, Table};
use tree_lod::cover::Around;
use tree_lod::prune::Schedule;
use tree_lod::quality::Score;

/// Pixels along the sides of the masks.
const SIZE: u32 = 64;
/// Steps that are looked at, evenly spread over log λ, besides those around changes of tier.
const STEPS: u32 = 160;
/// Least λ that is looked at, but for the ends of tiers; no table goes further down.
const LEAST: f32 = 0.01;
/// Change between neighbouring steps that is allowed, in percent of what the full model covers.
const CHANGE: f64 = 2.0;

pub(super) fn evaluate<'a: 'b, 'b>(
    table: &mut Table,
    models: impl Iterator<Item = &'b Prepared<'a>>,
) -> Outcome {
    let (mut worst, mut beyond, mut n) = (0.0_f64, 0_usize, 0_usize);
    for prepared in models {
        let changes = changes(&prepared.ours)?;
        let name = &prepared.model.name;
        let most = changes.iter().map(|c| c.mean).fold(0.0, f64::max);
        let tabled = || changes.iter().filter(|c| c.lambda >= LEAST);
        let view = tabled().map(|c| c.most).fold(0.0, f64::max);
        let unfit = tabled().filter(|c| c.most > CHANGE).count();
        let at = tabled().max_by(|a, b| a.most.total_cmp(&b.most)).map_or(0.0, |c| c.lambda);
        let mut row = |metric, ours, aim| {
            table.row(&Row { case: name, metric, paper: None, peer: None, ours, unit: "%", aim });
        };
        row("largest step of coverage, all views", most, Aim::AtMost(CHANGE));
        row("in any view, λ from 0.01", view, Aim::AtMost(CHANGE));
        information(table, name, "its λ", at.into(), "");
        (worst, beyond, n) = (worst.max(view), beyond + unfit, n + tabled().count());
    }
    information(table, "all models", "largest step in any view", worst, "%");
    let share = 100.0 * beyond as f64 / n.max(1) as f64;
    information(table, "all models", "steps above 2 % in any view", share, "%");
    Ok(())
}

/// Change of coverage at one step, in percent of that of the full model.
struct Change {
    lambda: f32,
    /// Of all views together, and in the view where it is largest.
    mean: f64,
    most: f64,
}

fn changes(pruned: &Pruned<'_>) -> Outcome<Vec<Change>> {
    let schedule = pruned.schedule()?;
    let around = Around { azimuths: 8, turn: 0.3, size: SIZE, ..Around::default() };
    let lambda_of = |step: u64| schedule.lambda_of(schedule.cut(step).n_triangles);
    let steps = steps(&schedule);
    let lambdas: Vec<f32> =
        steps.iter().flat_map(|&step| [lambda_of(step), lambda_of(step + 1)]).collect();
    let scores = pruned.scores_of(&lambdas, &around)?;
    let covered = |s: &Score| (s.both + s.wrong) as f64;
    let of_full = |s: &Score| (s.both + s.missed) as f64;
    let change = |(&lambda, pair): (&f32, &[Vec<Score>])| {
        let pairs = || pair[0].iter().zip(&pair[1]);
        let step = |(a, b): (&Score, &Score)| covered(a) - covered(b);
        let most = pairs().map(|(a, b)| step((a, b)).abs() / of_full(a)).fold(0.0, f64::max);
        let moved: f64 = pairs().map(step).sum();
        let full: f64 = pair[0].iter().map(of_full).sum();
        Change { lambda, mean: 100.0 * moved.abs() / full, most: 100.0 * most }
    };
    Ok(lambdas.iter().step_by(2).zip(scores.chunks_exact(2)).map(change).collect())
}

/// Steps spread over log λ, and those around changes of tier, each of which has a next one with fewer
/// triangles.
fn steps(schedule: &Schedule) -> Vec<u64> {
    let step_of = |lambda: f32| {
        let budget = (f64::from(lambda) * schedule.n_triangles() as f64) as u64;
        let (mut low, mut high) = (0, schedule.n_steps() - 1);
        while low < high {
            let middle = low + (high - low) / 2;
            if schedule.cut(middle).n_triangles <= budget {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        low
    };
    let spread = (0..STEPS).map(|i| libm::powf(LEAST, i as f32 / (STEPS - 1) as f32)).map(step_of);
    let changes = schedule.kept().iter().scan(0, |sum, &kept| {
        *sum += u64::from(kept);
        Some(*sum)
    });
    let around = changes.flat_map(|at| at.saturating_sub(2)..at + 2);
    let mut steps: Vec<u64> =
        spread.chain(around).filter(|&s| s + 1 < schedule.n_steps()).collect();
    steps.sort_unstable();
    steps.dedup();
    steps
}
