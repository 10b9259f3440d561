//! Quality and its spread over a turn around the tree, against billboard clouds at equal mean quality
//! (Fig. 7.16).

use super::billboard::{bake, behrendt, decoret};
use super::pruned::Pruned;
use super::{Outcome, Prepared, SEED, mean, spread};
use crate::table::{Aim, Row, Table};
use tree_core::Control;
use tree_lod::cover::{self, Around};
use tree_lod::quality::Score;

/// Billboards: those of Fig. 7.16, and fewer.
const BILLBOARDS: [usize; 2] = [209, 60];
/// Texels along the longer side of a billboard.
const TEXELS: u32 = 128;
/// A view every five degrees.
const VIEWS: u32 = 72;
/// Views in which the λ of the same quality is sought.
const FEW: u32 = 18;
/// Pixels along the sides of the masks.
const SIZE: u32 = 256;
/// Halvings of the interval of λ in which the same quality is sought.
const HALVINGS: u32 = 9;

pub(super) fn evaluate(table: &mut Table, models: &[&Prepared<'_>]) -> Outcome {
    for prepared in models {
        let (mesh, elements) = (&prepared.model.mesh, &prepared.model.elements);
        for n in BILLBOARDS {
            let planes = decoret(mesh, elements, n);
            let clusters = behrendt(mesh, elements, n, SEED);
            for (name, billboards) in [("Décoret", planes), ("Behrendt", clusters)] {
                let baked = bake(mesh, elements, &billboards, TEXELS)?;
                let scores =
                    cover::score(&baked, mesh, &around().cameras(), SIZE, &Control::default())?;
                let theirs = qualities(&scores);
                let case = format!("{}, {n} billboards of {name}", prepared.model.name);
                against(table, &case, prepared, &theirs)?;
            }
        }
    }
    Ok(())
}

fn around() -> Around {
    Around { azimuths: VIEWS, size: SIZE, turn: 0.01, ..Around::default() }
}

fn qualities(scores: &[Score]) -> Vec<f64> {
    scores.iter().map(Score::quality).collect()
}

/// Rows of ours, and of leaves at random, at the λ at which they are as good on average.
fn against(table: &mut Table, case: &str, prepared: &Prepared<'_>, theirs: &[f64]) -> Outcome {
    let aimed = mean(theirs);
    let (lambda, found) = as_good(&prepared.ours, aimed)?;
    let (_, random) = as_good(&prepared.random, aimed)?;
    let range = |values: &[f64]| {
        let most = values.iter().copied().fold(f64::MIN, f64::max);
        most - values.iter().copied().fold(f64::MAX, f64::min)
    };
    let mut row = |metric, peer: Option<f64>, ours, aim| {
        table.row(&Row { case, metric, paper: None, peer, ours, unit: "", aim });
    };
    row("λ of the same mean Q", None, lambda.into(), Aim::None);
    row("mean Q over 360°", Some(aimed), mean(&found), Aim::None);
    let (peer, least) = (spread(theirs), range(theirs));
    row("standard deviation of Q", Some(peer), spread(&found), Aim::AtMost(peer));
    row("most less least Q", Some(least), range(&found), Aim::AtMost(least));
    row("standard deviation of random leaves", Some(peer), spread(&random), Aim::None);
    Ok(())
}

/// The λ of this mean quality, and the qualities there.
fn as_good(pruned: &Pruned<'_>, aimed: f64) -> Outcome<(f32, Vec<f64>)> {
    // A few views find it, all of them tell the spread.
    let few = Around { azimuths: FEW, ..around() };
    let (mut low, mut high) = (pruned.schedule()?.least_lambda(), 1.0_f32);
    for _ in 0..HALVINGS {
        let middle = (low * high).sqrt();
        if pruned.quality(middle, &few)? < aimed { low = middle } else { high = middle }
    }
    Ok((high, qualities(&pruned.scores(high, &around())?)))
}
