#![forbid(unsafe_code)]
#![doc = "Modelers: from what a person has to a botanical tree."]
//!
//! One folder per method. Each module opens with what it computes, its source, its steps, and where
//! it departs from the source and why.
//!
//! * [`path`]: a rough volume becomes a tree of least-cost paths (Xu & Mould 2012).
//! * [`particle`]: photographs become a tree by a flow of particles (Neubert 2012).
//! * [`sketch`]: a freehand drawing becomes a tree by a Markov random field (Neubert 2012).
//! * [`silhouette`]: drawn outlines become a tree, level by level (Wither et al. 2009).
//! * [`lsystem`]: a grammar becomes a tree (Prusinkiewicz & Lindenmayer 1990; Lluch et al. 2010).
//! * [`plastic`]: trees that react to light, obstacles and neighbours (Pirk et al. 2012).
//! * [`growth`]: buds that compete for light or space become a tree (Palubicki et al. 2009).
//! * [`foliage`]: leaves on the shoots of any skeleton.
//! * [`skeletonize`]: a polygon tree becomes a skeleton and leaves, a laser scan skeletons.
//!
//! Whatever has a model takes a seed and gives a [`Tree`], by [`Modeler`] or with a report by functions of its own:
//!
//! ```
//! use tree_core::{Control, Seed};
//! use tree_model::path::Preset;
//!
//! let mut params = Preset::find("c")?.params()?;
//! params.graph_nodes = 1000; // coarser than the preset, and quicker
//! let grown = params.grow(Seed(42), &Control::default())?;
//! assert!(grown.tree.skeleton().len() > 100);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
pub mod foliage;
pub mod growth;
pub mod lsystem;
pub mod particle;
pub mod path;
mod plane;
pub mod plastic;
pub mod silhouette;
pub mod skeletonize;
pub mod sketch;
#[cfg(feature = "svg")]
mod svg;

pub use error::ModelError;
pub use tree_core;
pub use tree_core::glam;

use tree_core::{Control, Seed, Tree};

/// Anything that makes a tree of a seed.
pub trait Modeler {
    /// Makes the tree. The same seed gives the same bits on every platform, for any number of
    /// threads.
    ///
    /// # Errors
    /// A [`ModelError`] that names the parameter at fault, or says that a limit was reached or the
    /// caller cancelled.
    fn model(&self, seed: Seed, control: &Control) -> Result<Tree, ModelError>;
}
