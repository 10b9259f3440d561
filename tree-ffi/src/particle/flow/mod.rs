//! Particles and their traces.

mod params;
mod traces;
mod way;

pub use params::*;
pub use traces::*;
pub use way::*;
