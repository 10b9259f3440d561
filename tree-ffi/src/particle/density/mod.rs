//! The density of a tree in space.

mod carve;
mod equations;
mod look;
mod paint;
mod params;
mod report;

pub use carve::*;
pub use equations::*;
pub use look::*;
pub use paint::*;
pub use params::*;
pub use report::*;

pub(super) use paint::{brushes, strokes};
pub(super) use report::rows;
