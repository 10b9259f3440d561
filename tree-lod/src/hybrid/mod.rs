//! One model for all distances: branches by prefix, leaves by geometry or by images (Lluch et al. 2010,
//! section 4.3).
//!
//! 1. [`Hybrid::make`]: the wood as a [`MultiMesh`](crate::multires::MultiMesh), the leaves in boxes along the
//!    branches with pictures on their diagonal planes ([`impostor`](crate::impostor)).
//! 2. [`Hybrid::update`]: what a viewer sees of one instance: a fractional level of wood, boxes, and ranges of
//!    leaves. No allocation.
//! 3. An engine draws a prefix of the wood, windows of the leaves, and the planes of the boxes with
//!    the shaders of [`impostor::cards`](crate::impostor::cards); or [`Hybrid::mesh_of`] makes a plain mesh of it,
//!    for previews and for the levels of a glTF file.
//!
//! # Where we depart from the paper
//!
//! * It does not tell how a level of branches is found for a distance. Here paths are drawn as
//!   long as they cover a given number of pixels, seen from the side; in between they grow ([`multires::grow`](crate::multires::grow)).

mod choose;
#[cfg(feature = "gltf")]
mod gltf;
mod make;
mod mesh;

#[cfg(test)]
mod tests;

pub use choose::HybridChoice;
pub use make::{Hybrid, HybridParams};
