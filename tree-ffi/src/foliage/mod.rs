//! Twigs and leaves on any skeleton.

mod arrangement;
mod grow;
mod leaf_params;
mod presets;
mod refine;
mod report;
mod twig_params;

pub use arrangement::*;
pub use grow::*;
pub use leaf_params::*;
pub use presets::*;
pub use refine::*;
pub use report::*;
pub use twig_params::*;
