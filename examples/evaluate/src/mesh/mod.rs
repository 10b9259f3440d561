//! Meshes: speed and memory of bark and leaves, whether bark is closed, what crosses at junctions, and
//! triangles needed for a silhouette. Peers' figures are those published in shared/PEERS.md.

mod outline;
mod plain;
mod shape;
#[path = "../../../../tests/common/skeletons.rs"]
pub(crate) mod skeletons;
mod speed;
mod tools;

use crate::table::Table;
use std::error::Error;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

pub(crate) use speed::build_case;

/// All of it; see the rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    speed::evaluate(table)?;
    tools::evaluate(table)?;
    shape::evaluate(table)?;
    outline::evaluate(table)
}
