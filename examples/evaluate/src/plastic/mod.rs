//! Pirk et al. 2012: Table 2 (growth times).

mod growth;

use crate::table::Table;
use std::error::Error;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// All of it; see the rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    growth::times(table)?;
    growth::distances(table)
}
