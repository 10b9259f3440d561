//! Meshes to and from files, on disk and in memory; clouds of points from files.

mod bytes;
mod cloud;
mod gltf;
mod gltf_instanced;
mod gltf_moving;
mod gltf_rows;
mod gltf_wind;
mod note;
mod obj;
mod ply;
mod read;
mod report;

pub use bytes::*;
pub use cloud::*;
pub use gltf::*;
pub use gltf_instanced::*;
pub use gltf_moving::*;
pub use gltf_rows::*;
pub use gltf_wind::*;
pub use note::*;
pub use obj::*;
pub use ply::*;
pub use read::*;
pub use report::*;

use tree_model::tree_core::Limits;

/// Limits for arrays with `per_vertex` values for each vertex: a mesh has up to three vertices for each
/// triangle.
pub(crate) fn per_vertex(limits: &Limits, per_vertex: u64) -> Limits {
    Limits { triangles: limits.triangles.saturating_mul(3 * per_vertex), ..*limits }
}
