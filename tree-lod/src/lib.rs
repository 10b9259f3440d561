#![forbid(unsafe_code)]
#![doc = "Level of detail, and previews, of botanical trees."]

mod error;
pub mod preview;

pub use error::LodError;
pub use tree_core;
pub use tree_core::glam;
pub use tree_mesh;
