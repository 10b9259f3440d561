#![doc = "The C ABI of the tree family: `include/tree.h`."]
//!
//! This crate converts, owns and reports; it computes nothing. A C program needs no Rust: it includes
//! `tree.h` (or `tree.hpp`) and links `libtree_ffi`.
//!
//! # Conventions
//!
#![doc = include_str!("../CONVENTIONS.md")]
#![allow(non_camel_case_types, reason = "these are C's names")]
#![allow(
    clippy::missing_safety_doc,
    reason = "one contract for all functions, above: pointers are NULL or point at what the text says"
)]

mod allometry;
mod border;
mod control;
mod distance;
mod engine;
mod foliage;
mod growth;
mod hybrid;
mod impostor;
mod instance;
mod io;
mod lod;
mod look;
mod lsystem;
mod memory;
mod mesh;
mod multires;
mod particle;
mod path;
mod photo;
mod plastic;
mod pool;
mod preview;
mod silhouette;
mod skeleton;
mod skeletonize;
mod sketch;
mod tree;
mod version;
mod volume;

pub use allometry::*;
pub use border::*;
pub use control::*;
pub use distance::*;
pub use engine::*;
pub use foliage::*;
pub use growth::*;
pub use hybrid::*;
pub use impostor::*;
pub use instance::*;
pub use io::*;
pub use lod::*;
pub use look::*;
pub use lsystem::*;
pub use memory::*;
pub use mesh::*;
pub use multires::*;
pub use particle::*;
pub use path::*;
pub use photo::*;
pub use plastic::*;
pub use pool::*;
pub use preview::*;
pub use silhouette::*;
pub use skeleton::*;
pub use skeletonize::*;
pub use sketch::*;
pub use tree::*;
pub use version::*;
pub use volume::*;
