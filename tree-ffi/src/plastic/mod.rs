//! Trees that react: light, obstacles and neighbours bend, prune and fill them (Pirk et al. 2012).

mod adapted;
mod analysis;
mod clusters;
mod edit;
mod motions;
mod params;
mod pose;
mod read;
mod regrowth;
mod scene;
mod seasons;
mod sky;

pub use adapted::*;
pub use analysis::*;
pub use clusters::*;
pub use edit::*;
pub use motions::*;
pub use params::*;
pub use pose::*;
pub use read::*;
pub use regrowth::*;
pub use scene::*;
pub use seasons::*;
pub use sky::*;
