//! A number that changes when a tree would.

use crate::manifest::Line;
use std::path::Path;
use tree_core::{CoreError, Limits, file};

/// FNV-1a in 64 bits, as hexadecimal digits: of the program's version, the line, and the files it names.
pub(crate) fn of_line(line: &Line, folder: &Path, limits: &Limits) -> Result<String, CoreError> {
    let mut hash = add(0xcbf2_9ce4_8422_2325, env!("CARGO_PKG_VERSION").as_bytes());
    hash = add(hash, line.text.as_bytes());
    for path in line.inputs() {
        hash = add(hash, &file::read_bytes(&folder.join(path), limits)?);
    }
    Ok(format!("{hash:016x}"))
}

/// A length goes first, so that no byte can move from one part into the next.
fn add(hash: u64, bytes: &[u8]) -> u64 {
    let length = (bytes.len() as u64).to_le_bytes();
    let step = |hash: u64, &byte: &u8| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
    bytes.iter().fold(length.iter().fold(hash, step), step)
}
