//! One model for all distances: branches by prefix, leaves by geometry or by images (Lluch et al. 2010, 4.3).

mod choice;
mod files;
mod model;
mod params;

pub use choice::*;
pub use files::*;
pub use model::*;
pub use params::*;
