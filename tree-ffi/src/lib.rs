#![doc = "The C ABI of the tree family: `include/tree.h`."]
//!
//! This crate converts, owns and reports; it computes nothing. A C program needs no Rust: it includes
//! `tree.h` (or `tree.hpp`) and links `libtree_ffi`.
//!
//! # Conventions
//!
//! * **Status.** Functions that can fail return a [`tree_status`], `TREE_OK` or a code. What was wrong,
//!   where, and what would be right is in [`tree_error_text`], thread by thread. Nothing unwinds into the
//!   caller and nothing aborts: a defect is `TREE_ERROR_PANIC`.
//! * **Handles** (`tree_mesh *` and so on) are made by the library, never change after that, may be read
//!   by any number of threads at once, and end by their `_free`, which accepts NULL. A handle that was
//!   freed, or is of another kind, is `TREE_ERROR_HANDLE`. Freeing in one thread what another is using
//!   is the one thing that cannot be caught. Handles keep alive what they are made of.
//! * **Out parameters** come last. A handle's place is set to NULL first, so after an error it is NULL.
//! * **Views** (`tree_surface` and so on) point into the object they were asked of: tightly packed,
//!   nothing copied, valid until that object is freed.
//! * **Structs** of parameters and views begin with `struct_size`. Parameters: call `tree_X_init(&x,
//!   sizeof x)`, which fills in the defaults, and change what should differ; NULL instead of parameters
//!   means the defaults. Views and reports: set `struct_size` to `sizeof x`; NULL where a report is not
//!   wanted. So programs built with an older header go on with a newer library.
//! * **Texts** are UTF-8, a pointer and a number of bytes; `TREE_NUL_TERMINATED` as number for C strings.
//! * **Constants** of one kind share a `typedef` and a prefix. A number that is none of them is
//!   `TREE_ERROR_ENUM`. A yes or no is a `uint32_t`, 0 is no and anything else yes.
//! * **Control** ([`tree_control`]) is taken by all that can run long: progress, cancellation, limits,
//!   threads. NULL means: no progress, no cancellation, default limits, all cores.
//! * **Axes:** right-handed, +Y up, metres, radians, triangles counter-clockwise from outside, texture v
//!   downwards, quaternions as x, y, z, w; [`tree_convention`] lists others.

#![allow(non_camel_case_types, reason = "these are C's names")]
#![allow(
    clippy::missing_safety_doc,
    reason = "one contract for all functions, above: pointers are NULL or point at what the text says"
)]

mod allometry;
mod border;
mod control;
mod engine;
mod foliage;
mod instance;
mod io;
mod look;
mod memory;
mod mesh;
mod path;
mod pool;
mod preview;
mod skeleton;
mod skeletonize;
mod tree;
mod version;
mod volume;

pub use allometry::*;
pub use border::*;
pub use control::*;
pub use engine::*;
pub use foliage::*;
pub use instance::*;
pub use io::*;
pub use look::*;
pub use memory::*;
pub use mesh::*;
pub use path::*;
pub use pool::*;
pub use preview::*;
pub use skeleton::*;
pub use skeletonize::*;
pub use tree::*;
pub use version::*;
pub use volume::*;
