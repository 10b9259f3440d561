//! How thick branches are.

mod rule;

pub use rule::*;
