//! PLY: all surfaces as one list of vertices and one of triangles, in binary or as text.
//!
//! **Written**: `x y z`, `nx ny nz`, `s t` (v upwards, 1 − v), `red green blue` (the material's colour
//! times the mean of its texture, sRGB), then `vertex_indices`. PLY knows neither materials nor
//! textures.
//!
//! **Read**: [`read`] and [`from_slice`].
//!
//! Source: Turk, *The PLY Polygon File Format*, 1994. The reader has two layers, so that others than
//! meshes can be read: the header, which lists elements and their properties, and the body, which
//! hands out their numbers.

mod body;
mod header;
mod points;
mod read;
mod srgb;
mod write;

pub(super) use points::points;
pub use read::{from_slice, read};
pub use write::{PlyOptions, to_bytes, write_ply};

use crate::error::MeshError;

fn malformed(place: impl Into<String>, problem: impl Into<String>) -> MeshError {
    MeshError::Malformed { format: "PLY", place: place.into(), problem: problem.into() }
}
