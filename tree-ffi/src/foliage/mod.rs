//! Twigs and leaves on any skeleton.

mod arrangement;
mod leaf_params;

pub use arrangement::*;
pub use leaf_params::*;
