#![forbid(unsafe_code)]
#![doc = "From a tree to triangles an engine can upload."]

mod error;
mod mesh;
pub mod texture;

pub use error::MeshError;
pub use mesh::{Alpha, Material, Mesh, Surface, Texture};
pub use tree_core;
pub use tree_core::glam;
