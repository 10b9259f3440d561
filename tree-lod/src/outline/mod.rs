//! Triangles that elements are drawn with: all of them, or fewer with nearly the same outline.
//!
//! A [`Tier`] has triangles for every element. The first is the model itself; in every next one each
//! element has fewer triangles. Tiers use the model's own vertices.

mod tier;

pub use tier::Tier;
