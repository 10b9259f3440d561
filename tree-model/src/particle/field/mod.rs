//! Direction fields: where particles go, seen in one image (Neubert 2012, section 3.5).

mod build;
mod direction;
mod params;
mod picture;
#[cfg(test)]
mod tests;

pub use build::{direction_field, direction_field_with};
pub use direction::DirectionField;
pub use params::{Blend, FieldParams};
