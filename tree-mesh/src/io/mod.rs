//! Meshes to files, pictures from and to files. A file is whole or absent, never a part.
//!
//! * [`obj`]: OBJ with MTL, and PNG textures with the feature `image`.
//! * `gltf` (feature `gltf`): GLB, glTF 2.0 in one binary file.
//! * With the feature `image`, [`Texture`](crate::Texture) reads PNG and JPEG and writes PNG.

#[cfg(feature = "gltf")]
pub mod gltf;
mod names;
pub mod obj;
#[cfg(feature = "image")]
mod picture;
