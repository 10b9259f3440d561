//! Texels: pieces of a mesh, drawn by parallel projection into small images.
//!
//! 1. `bake`: triangles become a tile: coverage by supersampling, and for what is seen the linear
//!    colour without light, the normal in the space of the tree, and the depth.
//! 2. `dilate`: colours, normals and depths spread outward, so that no dark fringe shows when texels are
//!    filtered (pull-push, after Gortler et al. 1996, "The lumigraph").
//! 3. `atlas`: tiles side by side as RGBA pictures.
//! 4. [`mips`]: smaller levels whose alpha keeps the covered share (Castaño 2010, "Computing alpha
//!    mipmaps").

mod atlas;
mod bake;
mod dilate;
mod mips;

pub(crate) use atlas::{Atlas, Bytes, Grid};
pub(crate) use bake::{Samples, Tile, Window, bake};
pub use mips::mips;
