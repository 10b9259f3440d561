//! Impostors: leaves, or whole trees, as pictures (Lluch et al. 2010, §4.2).
//!
//! * [`texel`]: pieces of a mesh as small images; what the others are made of.
//! * [`boxes`]: the hierarchy of boxes along the branches, and an order in which the leaves of each are one
//!   range.
//! * [`cards`]: six diagonal planes for each box, with pictures of its leaves, and their blending.
//! * [`choose`]: which boxes, and which leaves, are drawn at a distance.
//! * [`octahedral`]: pictures of a whole tree from all sides, the modern alternative from afar.
//!
//! Pictures hold the colour of the surface without light, and normals: the engine lights them as it does the
//! mesh.

pub mod boxes;
pub mod cards;
pub mod choose;
pub mod octahedral;
pub mod texel;

#[cfg(test)]
mod shader_tests;
#[cfg(test)]
pub(crate) mod tests;
