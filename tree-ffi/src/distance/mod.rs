//! How different two trees are: the constrained edit distance (Zhang 1996).

mod costs;
mod measure;
mod params;
mod tree;

pub use costs::*;
pub use measure::*;
pub use params::*;
pub use tree::*;
