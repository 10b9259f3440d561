//! What the tests of the C side share.
#![allow(dead_code, reason = "each test uses its part")]

pub(crate) mod compile;
pub(crate) mod header;
