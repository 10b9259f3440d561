//! Trees of least-cost paths in a rough volume (Xu & Mould 2012).

mod graph;
mod grow;
mod level;
mod nodes;
mod params;
mod preset;
mod profile;
mod report;
mod terrain;

pub use graph::*;
pub use grow::*;
pub use level::*;
pub use nodes::*;
pub use params::*;
pub use preset::*;
pub use profile::*;
pub use report::*;
pub use terrain::*;
