//! Photographs of trees: mattes, cameras and the branches seen in them.

mod attractor;
mod camera;
mod lines;
mod matte;
mod picture;

pub use attractor::*;
pub use camera::*;
pub use lines::*;
pub use matte::*;
pub use picture::*;

use crate::border::{Failure, tree_status};
use tree_model::ModelError;

/// As `status` what says that a picture or a graph cannot be used: which code is right depends on where it
/// came from.
fn blamed(status: tree_status) -> impl Fn(ModelError) -> Failure {
    move |error| match error {
        ModelError::Picture { .. } | ModelError::Attractor { .. } => {
            Failure::new(status, error.to_string())
        }
        other => other.into(),
    }
}
