//! Which pixels a mesh covers: triangles to bit masks, fast enough to be called thousands of times.
//!
//! There is no depth and no colour: a bit is set where a triangle covers the middle of a pixel (and
//! the texture's alpha there is drawn). Alpha-tested textures are read from mip levels that keep
//! their covered share, as the preview does it.
//!
//! 1. [`Around`] says from where to look; [`Camera`](crate::preview::Camera) does as well.
//! 2. [`Stage`] prepares a mesh for these views: masks of all of it, and of what is never pruned.
//! 3. Elements are drawn into [`Bits`], scaled about their centres, and compared ([`Bits::score`]).
//!
//! Cost of drawing: some 20 ns per triangle and 0.1 ns (opaque) or 3 ns (alpha-tested) per pixel.

mod around;
mod bits;
mod stage;
mod triangle;

pub use around::Around;
pub use bits::Bits;
pub(crate) use stage::{Piece, Shot};
pub use stage::{Stage, mask, score};

#[cfg(test)]
mod tests;
