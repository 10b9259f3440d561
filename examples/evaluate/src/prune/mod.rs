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
pub(crate) mod simplify;
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

/// Models of which more is shown: cards imported and of ours, and modelled leaves.
const EZ_OAK: &str = "eztree_oak_medium";
const EZ_PINE: &str = "eztree_pine_small";
const OAK: &str = "oak, cards";
const APPLE: &str = "apple, modelled";

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

/// All of it; see the rows. The longest parts are the orders of thirteen models and the tables of five orders
/// of ten of them: some minutes on two cores.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    let of_peers = models::of_peers()?;
    let modelled: Vec<Model> =
        of_peers.iter().map(models::with_modelled_leaves).collect::<Outcome<_>>()?;
    let (imported, ours) = (models::imported()?, models::ours()?);
    let forest = prepared(imported.iter().chain(&ours))?;
    let modelled = prepared(modelled.iter())?;
    let cook = parity::evaluate(table, &forest)?;
    peers::evaluate(table, forest.iter().chain(&modelled))?;
    turning::evaluate(table, &some(&forest, &[EZ_OAK, APPLE]))?;
    popping::evaluate(table, forest.iter().chain(&modelled))?;
    colour::evaluate(table, &some(&forest, &[EZ_OAK, OAK, APPLE]))?;
    steady::evaluate(table, &some(&forest, &[EZ_OAK, EZ_PINE, APPLE]))?;
    pictures::evaluate(table, &forest, &cook)?;
    large::evaluate(table)
}

fn prepared<'a>(models: impl Iterator<Item = &'a Model>) -> Outcome<Vec<Prepared<'a>>> {
    models.map(Prepared::new).collect()
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
