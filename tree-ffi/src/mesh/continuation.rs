//! Which branch goes on. Until `skeleton/axes.rs` is merged: then delete this file and its two lines in
//! `mesh/mod.rs`.

use crate::border::{Failure, Result};
use tree_model::tree_core::Continuation;

/// Which child goes on an axis at a fork.
pub type tree_continuation = u32;
/// The child with the largest radius, by length to the tip where radii are equal.
pub const TREE_CONTINUATION_THICKEST: u32 = 0;
/// The child with the longest path to a tip.
pub const TREE_CONTINUATION_LONGEST: u32 = 1;
/// The child that bends least from the segment below; at the root, the longest.
pub const TREE_CONTINUATION_STRAIGHTEST: u32 = 2;

/// The kind of continuation that the number says; `name` is what it is called by.
pub(crate) fn continuation(found: tree_continuation, name: &str) -> Result<Continuation> {
    match found {
        TREE_CONTINUATION_THICKEST => Ok(Continuation::Thickest),
        TREE_CONTINUATION_LONGEST => Ok(Continuation::Longest),
        TREE_CONTINUATION_STRAIGHTEST => Ok(Continuation::Straightest),
        other => Err(Failure::not_one_of(name, other, "TREE_CONTINUATION_")),
    }
}

/// The number of a kind of continuation.
pub(crate) fn continuation_number(continuation: Continuation) -> tree_continuation {
    match continuation {
        Continuation::Thickest => TREE_CONTINUATION_THICKEST,
        Continuation::Longest => TREE_CONTINUATION_LONGEST,
        Continuation::Straightest => TREE_CONTINUATION_STRAIGHTEST,
    }
}
