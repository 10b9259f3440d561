//! From traces to a tree.

mod grow;
mod params;

pub use grow::*;
pub use params::*;
