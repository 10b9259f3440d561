//! Meshes to and from files, on disk and in memory.

mod bytes;

pub use bytes::*;
