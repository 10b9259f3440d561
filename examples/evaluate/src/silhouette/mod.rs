//! Trees from outlines (Wither et al. 2009).

mod cases;
mod fit;
mod paint;
mod view;

use crate::table::Table;
use std::error::Error;

pub(crate) fn evaluate(table: &mut Table) -> Result<(), Box<dyn Error>> {
    fit::rows(table)
}
