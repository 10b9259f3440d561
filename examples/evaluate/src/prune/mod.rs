//! Pruning: level of detail by measured quality (Neubert 2012, chapters 6 and 7).

mod anova;
mod billboard;
mod colour;
mod large;
mod modelled;
mod models;
mod nearest;
mod parity;
mod peers;
mod pictures;
mod popping;
mod pruned;
mod scene;
mod simplify;
mod steady;
mod turning;

use crate::table::{Aim, Row, Table};
use models::Model;
use pruned::Pruned;
use std::error::Error;
use tree_core::Seed;
use tree_lod::order::stochastic;
use tree_lod::quality::Scale;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// Least distance of trees in metres.
const SPACING: f32 = 5.0;
/// All orders, scenes and clusters come from this seed.
const SEED: Seed = Seed(1);

/// A model with what every part of the evaluation needs of it.
struct Prepared<'a> {
    model: &'a Model,
    ours: Pruned<'a>,
    /// Whole leaves at random, with the best scale.
    random: Pruned<'a>,
}

impl<'a> Prepared<'a> {
    fn new(model: &'a Model) -> Outcome<Self> {
        let ours = Pruned::ours(model)?;
        let random = Pruned::ordered(model, stochastic(&model.elements, SEED), Scale::Best)?;
        Ok(Self { model, ours, random })
    }
}

/// All of it; see the rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    let start = std::time::Instant::now();
    let clock = |what: &str| eprintln!("{:7.1} s  {what}", start.elapsed().as_secs_f64());
    if std::env::var("PRUNE_ONLY").is_ok_and(|o| o == "large") {
        return large::evaluate(table);
    }
    let of_peers = models::of_peers()?;
    let modelled: Vec<Model> =
        of_peers.iter().map(models::with_modelled_leaves).collect::<Outcome<_>>()?;
    let (imported, ours) = (models::imported()?, models::ours()?);
    clock("models");
    // DEV
    let only = std::env::var("PRUNE_ONLY").unwrap_or_default();
    let names = std::env::var("PRUNE_MODELS").unwrap_or_default();
    let part = |name: &str| only.is_empty() || only.split(',').any(|o| o == name);
    let wanted = |m: &&Model| names.is_empty() || names.split(';').any(|o| o == m.name);
    fn prepare(model: &Model) -> Outcome<Prepared<'_>> {
        let s = std::time::Instant::now();
        let found = Prepared::new(model);
        eprintln!("{} {:.1}", model.name, s.elapsed().as_secs_f64());
        found
    }
    if only == "large" {
        return large::evaluate(table);
    }
    let forest: Vec<Prepared<'_>> = imported.iter().chain(&ours).filter(wanted).map(prepare).collect::<Outcome<_>>()?;
    let modelled: Vec<Prepared<'_>> = modelled.iter().filter(wanted).map(prepare).collect::<Outcome<_>>()?;
    if part("popping") {
    popping::evaluate(table, forest.iter().chain(&modelled))?;
    clock("popping");}
    if part("turning") {
    turning::evaluate(table, &some(&forest, &["eztree_oak_medium", "apple, modelled"]))?;
    clock("turning");}
    if part("colour") {
    let coloured = ["eztree_oak_medium", "oak, cards", "apple, modelled"];
    colour::evaluate(table, &some(&forest, &coloured))?;
    clock("colour");}
    if part("steady") {
    let steady = ["eztree_oak_medium", "eztree_pine_small", "apple, modelled"];
    steady::evaluate(table, &some(&forest, &steady))?;
    clock("steady");}
    if part("peers") {
    peers::evaluate(table, forest.iter().chain(&modelled))?;
    clock("peers");}
    if part("parity") {
    let cook = parity::evaluate(table, &forest)?;
    clock("parity");
    if part("pictures") {
    pictures::evaluate(table, &forest, &cook)?;
    clock("pictures");}}
    if part("large") {
    large::evaluate(table)?;
    clock("large");}
    Ok(())
}

/// The models of these names that are there.
fn some<'a, 'b>(all: &'b [Prepared<'a>], names: &[&str]) -> Vec<&'b Prepared<'a>> {
    all.iter().filter(|prepared| names.contains(&prepared.model.name.as_str())).collect()
}

fn information(table: &mut Table, case: &str, metric: &str, ours: f64, unit: &str) {
    table.row(&Row { case, metric, paper: None, peer: None, ours, unit, aim: Aim::None });
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

/// Standard deviation.
fn spread(values: &[f64]) -> f64 {
    let middle = mean(values);
    mean(&values.iter().map(|x| (x - middle) * (x - middle)).collect::<Vec<_>>()).sqrt()
}
