//! Trees from sketches (Neubert 2012, chapter 4).

mod exhaustive;
mod fidelity;
mod round_trip;
mod shared;
mod speed;

use crate::table::Table;
use std::error::Error;
use tree_model::sketch::convex_hull;
use tree_model::sketch::template::crown_points;
use tree_model::tree_core::Tree;
use tree_model::tree_core::glam::Vec2;

pub(crate) fn evaluate(table: &mut Table) -> Result<(), Box<dyn Error>> {
    // First, before the machine is warm.
    speed::rows(table)?;
    fidelity::rows(table)?;
    exhaustive::rows(table)?;
    round_trip::rows(table)?;
    shared::rows(table)
}

/// The crown that a person would draw round a leafy tree seen from `yaw`.
pub(crate) fn crown_of(tree: &Tree, yaw: f32) -> Vec<Vec<Vec2>> {
    vec![convex_hull(&crown_points(tree, yaw))]
}
