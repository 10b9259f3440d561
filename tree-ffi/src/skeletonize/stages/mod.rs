//! The stages of skeletonizing, one by one: to look at what lies between them, to change it, or to stop
//! there.

mod leaves;
mod pieces;
mod separation;

pub use leaves::*;
pub use pieces::*;
pub use separation::*;
