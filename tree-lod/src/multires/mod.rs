//! Trees whose levels of detail are prefixes (Lluch et al. 2010, section 4.1).
//!
//! A tree is cut into *paths*, sorted such that the first few show its structure best and each one stems
//! from a path before it. So every prefix is a tree, the last is the whole tree, and a level is no more
//! than a number.
//!
//! 1. [`Adt`]: the tree of branches (the paper's t-ADT), of a bracketed chain of modules or of a skeleton.
//! 2. [`Metric`]: what a branch is worth: by default the area shown for each branch drawn; the paper's four, and orders to
//!    compare with.
//! 3. [`paths`]: from the root or a fork to a tip along the branches of most worth, again and again.
//! 4. [`MultiChain`]: the modules in that order, with `SAVE` and `RESTORE` for the turtle.
//! 5. [`Multires`]: a tree with its nodes and leaves in that order; a level is a slice of its columns.
//! 6. [`MultiMesh`]: tubes and leaves, of which a level is a prefix of each index buffer, with what a
//!    shader needs to let branches grow in continuously.
//! 7. [`stream`]: bytes of which every prefix is a coarser tree.
//!
//! # Where we depart from the paper
//!
//! * It saves the turtle at the end of a branch, which is right where all children stem from there. We save
//!   at the brackets, and a path goes on into a child only where the branch itself ends; chains whose
//!   children stem from the ends of branches give the paper's form.
//! * Skeletons need no turtle: the branches are the runs between forks, and a level is a prefix of the nodes.
//! * It sorts by branching length. On ten trees, and on ten others, [`Metric::Density`] shows more of the silhouette with as
//!   many branches (`evaluate -- multires`), so that is the default.
//! * Its levels pop. Ours have fractions: the path that comes next grows out of its fork.

mod adt;
mod chain;
mod density;
#[cfg(feature = "gltf")]
mod gltf;
pub mod grow;
mod mesh;
mod metric;
mod model;
mod order;
mod shown;
pub mod stream;
mod tube;

pub use adt::{Adt, Token};
pub use chain::{Item, MultiChain};
pub use mesh::{Draw, MultiMesh};
pub use metric::Metric;
pub use model::{Level, Multires, Rows};
pub use order::{Paths, paths};

#[cfg(test)]
mod mesh_tests;
#[cfg(test)]
mod tests;
