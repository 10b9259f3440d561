//! Trees that organise themselves: buds compete for light or space (Palubicki et al. 2009).

mod grow;
mod grown;
mod habit;
mod params;
mod preset;
mod simulation;
mod world;

pub use grow::*;
pub use grown::*;
pub use habit::*;
pub use params::*;
pub use preset::*;
pub use simulation::*;
pub use world::*;
