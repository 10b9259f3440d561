//! Trees whose levels of detail are prefixes (Lluch et al. 2010): branches, paths, multi-chains, trees,
//! streams, and meshes that grow.

mod adt;
mod chain;
mod gltf;
mod grow;
mod mesh;
mod model;
mod paths;
mod reader;
mod stream;

pub use adt::*;
pub use chain::*;
pub use gltf::*;
pub use grow::*;
pub use mesh::*;
pub use model::*;
pub use paths::*;
pub use reader::*;
pub use stream::*;

use crate::border::{Failure, Result, TREE_ERROR_PARAMETER};

/// Says so when a row that is asked for is not there.
pub(crate) fn there(argument: &str, found: usize, n: usize, what: &str) -> Result<()> {
    if found < n {
        return Ok(());
    }
    let text = format!("{argument} is {found}, but there are {n} {what}");
    Err(Failure::new(TREE_ERROR_PARAMETER, text))
}
