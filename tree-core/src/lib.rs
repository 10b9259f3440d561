#![forbid(unsafe_code)]
#![doc = "The vocabulary of the tree family: what a tree is, before it has a single triangle."]
//!
//! * [`Skeleton`]: branches as a rooted tree of nodes with radii, in columns; views on it
//!   ([children](Skeleton::children), [axes](Skeleton::axes), lengths and counts).
//! * [`Foliage`] and [`Tree`]: leaves in columns, and both with a [`Species`].
//! * [`Volume`]: solids and their combinations; crowns, search graphs and obstacles use them.
//! * [`allometry`]: how thick branches are and at which angles they part.
//! * [`branching`]: how a tree branches, measured: Horton-Strahler orders, pipe exponent, angles.
//! * [`distance`]: how different two trees are, by the edits that turn one into the other.
//! * [`assignment`]: who is matched with whom at least cost.
//! * [`Part`]: borrowed triangles of one material, for modelers that read meshes.
//! * [`swc`]: skeletons from and to the plain-text exchange format; [`file`](mod@file): files within limits, whole or absent.
//! * [`Seed`], [`Control`], [`Limits`]: the same bits for the same seed, progress and cancellation,
//!   and caps on memory.
//!
//! ```
//! use tree_core::glam::Vec3;
//! use tree_core::branching::Strahler;
//! use tree_core::{Foliage, Skeleton, Species, Tree};
//!
//! let mut builder = Skeleton::builder(Vec3::ZERO, 0.2)?; // base, radius
//! let fork = builder.add(0, Vec3::Y * 2.0, 0.15)?;
//! builder.add(fork, Vec3::new(-1.0, 3.5, 0.0), 0.1)?;
//! builder.add(fork, Vec3::new(1.0, 3.5, 0.0), 0.1)?;
//! let tree = Tree::new(builder.finish(), Foliage::default(), Species::default())?;
//! assert_eq!(Strahler::of(tree.skeleton()).highest(), 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Conventions: right-handed, +Y up, metres, radians, the base of the tree at the origin.

pub mod allometry;
pub mod assignment;
mod bounds;
pub mod branching;
mod control;
pub mod distance;
pub mod error;
pub mod file;
mod foliage;
mod limits;
mod parameter;
mod part;
pub mod seed;
mod skeleton;
pub mod swc;
mod tree;
pub mod volume;

pub use bounds::Aabb;
pub use control::{CancelFlag, Cancelled, Control, Progress};
pub use error::CoreError;
pub use foliage::{Foliage, Leaf};
pub use glam;
pub use limits::{LimitError, Limits, Resource};
pub use parameter::{ParameterError, check_parameter};
pub use part::{Hint, Part};
pub use seed::{Rng, Seed};
pub use skeleton::{
    Axes, Axis, Children, Continuation, NO_PARENT, Reordered, Skeleton, SkeletonBuilder,
    SkeletonColumns,
};
pub use swc::UpAxis;
pub use tree::{Species, Tree, TreeParts};
pub use volume::{Solid, Volume};
