//! Direction fields: where particles go, seen in one image (Neubert 2012, section 3.5).

mod direction;

pub use direction::DirectionField;
