//! Trees from photographs (Neubert 2012, chapter 3): silhouettes, branches, density, matting and times.

mod accuracy;
mod cases;
mod hints;
mod photos;
mod pictures;
mod score;
mod scribbles;
mod speed;
mod synthetic;

use crate::table::Table;
use std::error::Error;

pub(crate) use accuracy::{Known, known_pictures};
pub(crate) use photos::tree;

pub(crate) fn evaluate(table: &mut Table) -> Result<(), Box<dyn Error>> {
    // First, before the machine is warm and its memory taken.
    speed::rows(table)?;
    accuracy::rows(table)?;
    synthetic::rows(table)?;
    photos::rows(table)
}
