//! Direction fields: where particles go, seen in one image (Neubert 2012, section 3.5).
//!
//! Far from the attractor graph a field points at its nearest point, near it along it towards the base;
//! [`Blend`] says how one becomes the other (Eq. 3.7). [`direction_field`] makes a [`DirectionField`] of a graph.
//! A graph of the base alone, or none, gives a field that says nothing.

mod build;
mod direction;
mod params;
mod picture;
#[cfg(test)]
mod tests;

pub use build::{direction_field, direction_field_with};
pub use direction::DirectionField;
pub use params::{Blend, FieldParams};
