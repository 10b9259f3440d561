//! A polygon tree becomes a skeleton and leaves; a laser scan a skeleton.

mod params;
mod part;
mod report;
mod scan;
mod stages;
mod whole;

pub use params::*;
pub use part::*;
pub use report::*;
pub use scan::*;
pub use stages::*;
pub use whole::*;
