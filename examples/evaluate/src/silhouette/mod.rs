//! Trees from outlines (Wither et al. 2009).

mod branches;
mod bumps;
mod cases;
mod fit;
mod gibbs;
mod kinds;
mod lobes;
mod paint;
mod speed;
mod view;

use crate::table::Table;
use std::error::Error;

pub(crate) use cases::tree;

pub(crate) fn evaluate(table: &mut Table) -> Result<(), Box<dyn Error>> {
    // First, before the machine is warm.
    speed::rows(table)?;
    gibbs::rows(table)?;
    bumps::rows(table)?;
    branches::rows(table)?;
    fit::rows(table)?;
    kinds::rows(table)
}
