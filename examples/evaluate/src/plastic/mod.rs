//! Pirk et al. 2012: laser scans as input.

mod scans;

use crate::table::Table;
use std::error::Error;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// All of it; see the rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    scans::evaluate(table)
}
