#![forbid(unsafe_code)]
#![doc = "From a tree to triangles an engine can upload."]
//!
//! [`build`] makes a [`Mesh`] of a tree: bark tubes and leaf cards, dressed in a [`Look`]. [`io`]
//! writes meshes to files.
//!
//! ```
//! use tree_core::{Control, Skeleton, Species, Tree, glam::Vec3};
//! use tree_mesh::{Look, MeshParams, build};
//!
//! let mut builder = Skeleton::builder(Vec3::ZERO, 0.2)?;
//! builder.add(0, Vec3::Y * 3.0, 0.1)?;
//! let tree = Tree::bare(builder.finish(), Species::default());
//! let look = Look::plain(tree.species());
//! let built = build(&tree, &look, &MeshParams::default(), &Control::default())?;
//! assert_eq!(built.report.n_tubes, 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Right-handed, +Y up, metres; triangles counter-clockwise seen from outside; texture v downwards.

mod bark;
mod build;
pub mod collide;
mod columns;
pub mod convert;
pub mod displace;
mod error;
pub mod instance;
pub mod io;
mod leaf;
mod lightmap;
mod look;
mod mesh;
pub mod occlusion;
pub mod pack;
mod params;
#[cfg(test)]
mod sample;
pub mod subdivide;
pub mod texture;
pub mod topology;
pub mod wind;

pub use build::{Built, MeshReport, build, build_leaves};
pub use error::MeshError;
pub use leaf::{LeafForm, LeafMesh, LeafModel};
pub use look::{LeafLook, Look};
pub use mesh::{Alpha, Material, Mesh, Surface, Texture};
pub use params::{CurveFit, ErrorBound, MeshParams};
pub use tree_core;
pub use tree_core::glam;
