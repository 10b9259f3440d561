//! Pirk et al. 2012: light, laws of the adaptation, Table 1 (grown against transformed trees), Table 2 (times), a forest; growth and
//! laser scans.

mod growth;
mod laws;
mod light;
mod scans;
mod table1;
mod table2;

use crate::table::Table;
use std::error::Error;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// All of it; see the rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    light::evaluate(table)?;
    laws::evaluate(table)?;
    table2::evaluate(table)?;
    growth::times(table)?;
    growth::distances(table)?;
    table1::evaluate(table)?;
    scans::evaluate(table)
}
