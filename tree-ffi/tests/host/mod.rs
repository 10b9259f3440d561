//! What the tests of other languages share.
#![allow(dead_code, unreachable_pub, reason = "each test takes what it needs")]
#![allow(clippy::unwrap_used, clippy::panic)]

pub mod c_header;
pub mod csharp;
pub mod layout;
pub mod programs;

use std::path::{Path, PathBuf};

/// The root of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// `include/tree.h`, parsed.
pub fn header() -> c_header::Header {
    let path = root().join("include/tree.h");
    let text = std::fs::read_to_string(&path).unwrap_or_default();
    match c_header::parse(&text) {
        Ok(header) => header,
        Err(wrong) => panic!("include/tree.h: {wrong}"),
    }
}
