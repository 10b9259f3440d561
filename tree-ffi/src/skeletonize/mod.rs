//! A polygon tree becomes a skeleton and leaves.

mod params;
mod part;
mod report;
mod stages;
mod whole;

pub use params::*;
pub use part::*;
pub use report::*;
pub use stages::*;
pub use whole::*;
