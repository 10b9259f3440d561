//! What every reader, and the C ABI, promises of any bytes: one function for each fuzz target in the folder above. It panics where a promise
//! is broken. This crate's tests call them with files of the corpus, changed at random; the fuzz targets, guided by coverage.

// A panic is what a target is there to find.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

pub mod c_abi;
pub mod drawings;
pub mod meshes;
pub mod pictures;
pub mod plants;
mod script;
pub mod stream;

use tree_core::{Control, Limits};

/// Limits small enough that an input within them is quick.
fn control() -> Control {
    Control::default().with_limits(limits())
}

/// See [`control`].
fn limits() -> Limits {
    Limits {
        nodes: 10_000,
        triangles: 20_000,
        pixels: 1 << 16,
        input_bytes: 1 << 20,
        ..Limits::default()
    }
}
