//! Trees from photographs (Neubert 2012, chapter 3): silhouettes, branches, density, matting and times.

mod cases;
mod score;
mod synthetic;

use crate::table::Table;
use std::error::Error;

pub(crate) fn evaluate(table: &mut Table) -> Result<(), Box<dyn Error>> {
    synthetic::rows(table)
}
