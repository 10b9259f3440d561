//! How thick branches are, and at which angles they part.

mod angles;
mod radii;
mod rule;

pub use angles::*;
pub use radii::*;
pub use rule::*;
