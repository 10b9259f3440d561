//! A laser scan becomes a skeleton.

mod params;
mod report;
mod whole;

pub use params::*;
pub use report::*;
pub use whole::*;
