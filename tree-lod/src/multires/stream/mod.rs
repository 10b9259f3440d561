//! A tree as bytes of which every prefix is a coarser tree (section 4.1: progressive transmission).
//!
//! | part | bytes |
//! |---|---|
//! | head | `TREM`, version 1, precision in metres (`f32`, 0: exact), name of the species, of its bark, number and names of its leaf kinds, numbers of levels, nodes and leaves, CRC-32 of all that |
//! | each level | length of the rest, fork, number of nodes, nodes, number of leaves, leaves; then the lower half of the CRC-32 of all bytes so far |
//! | end | CRC-32 of all bytes before |
//!
//! Numbers without a type are LEB128 (7 bits a byte, the lowest first), checks and floats little-endian, texts are
//! their length and UTF-8. The fork is counted back from the last node that is there. Coordinates are
//! differences to a prediction, as signed LEB128: a node is expected straight on from its parent and as
//! thick, a leaf at its node and as large as the one before. An exact stream codes the bits of floats
//! in their order, one of a precision codes steps of it; both are the same code.
//!
//! A level more is bytes more at the end: the stream of `k` levels begins that of `k + 1`.

mod code;
mod read;
mod write;

#[cfg(test)]
mod tests;

pub use read::{Reader, Received, decode, read_file};
pub use write::{StreamParams, encode, encode_chain, write_file};
