//! Photographs of trees: mattes, cameras and the branches seen in them.

mod align;
mod attractor;
mod automatic;
mod camera;
mod draw;
mod edit;
mod lines;
mod livewire;
mod matte;
mod matting;
mod picture;
mod project;
mod strokes;
mod trimap;

pub use align::*;
pub use attractor::*;
pub use automatic::*;
pub use camera::*;
pub use draw::*;
pub use edit::*;
pub use lines::*;
pub use livewire::*;
pub use matte::*;
pub use matting::*;
pub use picture::*;
pub use project::*;
pub use strokes::*;
pub use trimap::*;

use crate::border::{Failure, Result, fill, floats, tree_status};
use glam::Vec2;
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

/// As [`fill`]; for no values there need be no buffer.
///
/// # Safety
/// As [`fill`].
unsafe fn fill_some<T: Copy>(
    first: *mut T,
    capacity: usize,
    values: &[T],
    argument: &str,
) -> Result<()> {
    if values.is_empty() { Ok(()) } else { unsafe { fill(first, capacity, values, argument) } }
}

/// As [`fill_some`]; nothing is written to NULL.
///
/// # Safety
/// As [`fill`].
unsafe fn fill_opt<T: Copy>(
    first: *mut T,
    capacity: usize,
    values: &[T],
    argument: &str,
) -> Result<()> {
    if first.is_null() { Ok(()) } else { unsafe { fill_some(first, capacity, values, argument) } }
}

/// A point of a picture, two floats.
///
/// # Safety
/// As [`floats`].
unsafe fn vec2(first: *const f32, argument: &str) -> Result<Vec2> {
    unsafe { floats(first, argument) }.map(Vec2::from_array)
}
