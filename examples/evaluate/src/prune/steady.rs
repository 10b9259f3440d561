//! How steady the best scale is: between two directions (§7.2.4), and with the size on the screen.
//!
//! The thesis compares what 19 users chose in two views. Here the best scale is measured in 19 views
//! around either direction, which are 90° apart.

use super::anova::{anova, critical, exceedance};
use super::pruned::Pruned;
use super::{Outcome, Prepared, information, mean, spread};
use crate::table::{Aim, Row, Table};
use rayon::prelude::*;
use std::f32::consts::TAU;
use tree_core::Control;
use tree_lod::cover::Around;
use tree_lod::quality::{Scale, Table as Measured, TableParams};

const LAMBDAS: [f32; 2] = [0.2, 0.6];
/// Views around each of the two directions, as many as the thesis had users.
const VIEWS: u32 = 19;
/// Turn from one of them to the next: all 19 lie within 90°.
const STEP: f32 = TAU / 4.0 / VIEWS as f32;
/// Pixels along the sides of the masks.
const SIZE: u32 = 256;
/// Sizes on the screen that are compared.
const SIZES: [u32; 4] = [64, 128, 256, 512];
/// Level of significance, as in the thesis.
const ALPHA: f64 = 0.05;

pub(super) fn evaluate(table: &mut Table, models: &[&Prepared<'_>]) -> Outcome {
    for prepared in models {
        for (order, pruned) in [("stochastic", &prepared.random), ("ours", &prepared.ours)] {
            for lambda in LAMBDAS {
                let case = format!("{}, {order}, λ = {lambda}", prepared.model.name);
                directions(table, &case, pruned, lambda)?;
                sizes(table, &case, pruned, lambda)?;
            }
        }
    }
    Ok(())
}

/// The best scale in some views, and the quality it has there.
fn best(pruned: &Pruned<'_>, lambda: f32, around: Around) -> Result<[f64; 2], String> {
    let params = TableParams { around, lambdas: vec![lambda, 1.0], scale: Scale::Best };
    let measured = Measured::measure(&pruned.subject(), &params, &Control::default())
        .map_err(|error| error.to_string())?;
    let row = measured.at(lambda);
    Ok([row.scale.into(), row.quality.into()])
}

fn directions(table: &mut Table, case: &str, pruned: &Pruned<'_>, lambda: f32) -> Outcome {
    let mut lost = Vec::new();
    let mut group = |first: f32| -> Result<Vec<f64>, String> {
        let views: Vec<u32> = (0..VIEWS).collect();
        let one = |&i: &u32| -> Result<[f64; 2], String> {
            let turn = first + i as f32 * STEP;
            let around = Around { azimuths: 1, turn, size: SIZE, ..Around::default() };
            let of_table = pruned.quality(lambda, &around).map_err(|error| error.to_string())?;
            let [scale, quality] = best(pruned, lambda, around)?;
            Ok([scale, quality - of_table])
        };
        let found = views.par_iter().map(one).collect::<Result<Vec<_>, _>>()?;
        lost.extend(found.iter().map(|one| one[1]));
        Ok(found.iter().map(|one| one[0]).collect())
    };
    let (a, b) = (group(0.0)?, group(TAU / 4.0)?);
    information(table, case, "Q lost by one scale for all views", mean(&lost), "");
    let found = anova(&a, &b).ok_or("too few measurements")?;
    let limit = critical(ALPHA, 1, found.within);
    information(table, case, "s_opt, first direction", mean(&a), "");
    information(table, case, "s_opt, second direction", mean(&b), "");
    let apart = 200.0 * (mean(&a) - mean(&b)).abs() / (mean(&a) + mean(&b));
    information(table, case, "s_opt, difference of directions", apart, "%");
    information(table, case, "chance of such an F", exceedance(found.f, 1, found.within), "");
    table.row(&Row {
        case,
        metric: "F of two directions",
        paper: None,
        peer: None,
        ours: found.f,
        unit: "",
        aim: Aim::AtMost(limit),
    });
    Ok(())
}

fn sizes(table: &mut Table, case: &str, pruned: &Pruned<'_>, lambda: f32) -> Outcome {
    let one = |size| best(pruned, lambda, Around { turn: 0.25, size, ..Around::default() });
    let found = SIZES.into_iter().map(one).collect::<Result<Vec<_>, _>>()?;
    let found: Vec<f64> = found.into_iter().map(|[scale, _]| scale).collect();
    let relative = 100.0 * spread(&found) / mean(&found);
    information(table, case, "s_opt from 64 to 512 px, spread", relative, "%");
    Ok(())
}
