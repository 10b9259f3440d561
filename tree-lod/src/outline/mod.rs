//! Triangles that elements are drawn with: all of them, or fewer with nearly the same outline.
//!
//! A [`Tier`] has triangles for every element. The first is the model itself; in every next one each
//! element has fewer triangles. Tiers use the model's own vertices, so that they are index buffers over
//! one vertex buffer.
//!
//! Source: Neubert 2012, section 6.3, prunes leaves as they are. The top of PEERS.md shows that on
//! modelled leaves it is better to simplify the outline first; this is that step, and it is ours.
//!
//! 1. `alike`: elements of the same triangles and nearly the same shape share one answer.
//! 2. `shape`: an element falls into connected blades, each in its own frame; `portion` divides
//!    the triangles among them.
//! 3. `disc`: a blade that is a bent or folded disc becomes the best polygon of its own margin
//!    (`polygon`), triangulated close to the folded surface.
//! 4. `collapse`: any blade is also simplified by half-edge collapses (Garland and Heckbert 1997).
//! 5. `choice`: what neither can simplify (tubes) becomes some of its own triangles.
//! 6. `polish` tries small changes to either.
//! 7. `judge` tells the best of these: pixels in which it differs from the blade in thirteen views, after
//!    it has grown about its centre to the same area. A pruned model is scaled as a whole
//!    afterwards, so that lost area costs nothing, while lost shape does.
//!
//! Cost: 5 to 10 ms for each distinct shape of 16 triangles, 0.15 s for one of 44; some 2 µs for each
//! element.

mod alike;
mod blade;
mod choice;
mod collapse;
mod disc;
mod fold;
mod judge;
mod polish;
mod polygon;
mod portion;
mod quadric;
mod shape;
mod tier;
mod work;

pub use tier::Tier;
pub use work::{OutlineParams, tiers};

#[cfg(test)]
mod tests;
