#![forbid(unsafe_code)]
#![doc = "Level of detail, and previews, of botanical trees."]
//!
//! * [`prune`]: one index buffer from which every level is drawn (Neubert 2012); made of [`element`] (what is dropped and scaled as
//!   one), [`order`] (who is dropped first), [`outline`] (leaves with fewer triangles) and [`quality`] (how good it is, measured).
//! * [`select`]: what to draw of a forest in a frame.
//! * [`multires`]: trees of which every prefix is a tree, in memory, in the index buffer and in streams (Lluch et al. 2010).
//! * [`impostor`]: leaves, and whole trees, as images. [`hybrid`]: wood by prefix, leaves by geometry or images.
//! * [`cover`]: which pixels are covered. [`implicit`]: metaballs and their iso-surface.
//! * [`preview`]: pictures, masks and silhouettes, on the processor.
//!
//! ```
//! use tree_lod::multires::{Metric, Multires};
//! use tree_lod::tree_core::glam::Vec3;
//! use tree_lod::tree_core::{Control, Foliage, Skeleton, Species, Tree};
//!
//! let mut builder = Skeleton::builder(Vec3::ZERO, 0.2)?;
//! let fork = builder.add(0, Vec3::Y, 0.15)?;
//! builder.add(fork, Vec3::new(-0.5, 2.0, 0.0), 0.1)?;
//! builder.add(fork, Vec3::new(0.5, 2.0, 0.0), 0.1)?;
//! let tree = Tree::new(builder.finish(), Foliage::default(), Species::default())?;
//!
//! let multires = Multires::new(&tree, &Metric::default(), &Control::default())?;
//! let coarsest = multires.tree_at(1)?; // the first path alone: a prefix of the columns
//! assert!(coarsest.skeleton().len() < tree.skeleton().len());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod cover;
pub mod element;
mod error;
pub mod hybrid;
pub mod implicit;
pub mod impostor;
pub mod multires;
pub mod order;
pub mod outline;
pub mod preview;
pub mod prune;
pub mod quality;
pub mod select;

pub use element::{Elements, Grain, LeafSurfaces};
pub use error::LodError;
pub use tree_core;
pub use tree_core::glam;
pub use tree_mesh;
