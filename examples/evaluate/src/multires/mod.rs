//! L-systems and the hybrid multiresolution tree (Lluch et al. 2010): printed words, derivation, chains, orders of branches,
//! times, sizes, triangles, impostors.

mod chain;
mod chance;
mod derivation;
mod drawn;
mod frames;
mod hybrids;
mod impostors;
mod levels;
mod metrics;
mod model;
mod orders;
mod parts;
mod pictures;
mod published;
mod scene;
mod size;
mod trees;

use crate::table::{Aim, Row, Table};
use std::error::Error;
use tree_core::Seed;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// All that is random comes from this seed.
const SEED: Seed = Seed(2010);

/// All of it; see the rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    published::evaluate(table)?;
    chance::evaluate(table)?;
    derivation::evaluate(table)?;
    let trees = trees::ten()?;
    chain::evaluate(table, &trees)?;
    levels::evaluate(table, &trees)?;
    scene::evaluate(table)?;
    size::evaluate(table)?;
    frames::evaluate(table)?;
    metrics::evaluate(table, &trees)?;
    impostors::evaluate(table)?;
    hybrids::evaluate(table)?;
    pictures::evaluate(table, &trees)
}

fn information(table: &mut Table, case: &str, metric: &str, ours: f64, unit: &str) {
    table.row(&Row { case, metric, paper: None, peer: None, ours, unit, aim: Aim::None });
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}
