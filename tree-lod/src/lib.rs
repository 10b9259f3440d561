#![forbid(unsafe_code)]
#![doc = "Level of detail, and previews, of botanical trees."]

pub mod cover;
pub mod element;
mod error;
pub mod hybrid;
pub mod implicit;
pub mod impostor;
pub mod multires;
pub mod order;
pub mod outline;
pub mod preview;
pub mod prune;
pub mod quality;
pub mod select;

pub use element::{Elements, Foliage, Grain};
pub use error::LodError;
pub use tree_core;
pub use tree_core::glam;
pub use tree_mesh;
