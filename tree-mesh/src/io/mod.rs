//! Meshes to and from files, pictures from and to files. A file is written whole or not at all; what
//! is read is checked before memory is taken for it, and never trusted.
//!
//! * [`obj`]: OBJ with MTL, and PNG textures with the feature `image`.
//! * [`ply`]: PLY, binary and text.
//! * [`points`]: clouds of points from PLY and text.
//! * `gltf` (feature `gltf`): glTF 2.0, in one file (GLB) or several.
//! * With the feature `image`, [`Texture`](crate::Texture) reads PNG and JPEG and writes PNG.
//!
//! [`read`] picks the reader.

#[cfg(feature = "gltf")]
pub mod gltf;
mod import;
mod names;
mod normals;
pub mod obj;
#[cfg(feature = "image")]
mod picture;
pub mod ply;
pub mod points;
mod polygon;
#[cfg(test)]
mod samples;

pub use import::{ImportOptions, ImportReport, Imported, Note};

use crate::error::{MeshError, Result};
use std::path::Path;
use tree_core::Control;

/// Reads a mesh from a file with the extension `glb`, `gltf`, `obj` or `ply`, in letters of any case.
///
/// # Errors
/// [`MeshError::Unsupported`] for other extensions, and without the feature `gltf` for glTF; else as
/// `gltf::read`, [`obj::read`] and [`ply::read`].
pub fn read(
    path: impl AsRef<Path>,
    options: &ImportOptions,
    control: &Control,
) -> Result<Imported> {
    let path = path.as_ref();
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    match extension.as_str() {
        "obj" => obj::read(path, options, control),
        "ply" => ply::read(path, control),
        #[cfg(feature = "gltf")]
        "glb" | "gltf" => gltf::read(path, options, control),
        _ => Err(MeshError::Unsupported {
            format: "file",
            what: format!("the extension '{extension}' of {}", path.display()),
        }),
    }
}
