//! What engines want besides triangles: wind, packed vertices, capsules, other axes.

mod branch;
mod collide;
mod convention;
mod convert;
mod pack;
mod packed;
mod pivots;
mod unpacked;
mod vertex;
mod wind;

pub use branch::*;
pub use collide::*;
pub use convention::*;
pub use convert::*;
pub use pack::*;
pub use packed::*;
pub use pivots::*;
pub use unpacked::*;
pub use vertex::*;
pub use wind::*;
