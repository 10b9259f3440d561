//! Drawn outlines become a tree, from coarse to fine: structure from silhouettes (Wither, Boudon, Cani & Godin 2009).
//!
//! A person draws the outline of the crown, then of one branch's foliage, then of a leaf. Branches are inferred, what is
//! drawn once spreads to the siblings, and the tree in space fits the outlines.

pub mod branch;
pub mod bump;
pub mod grow;
mod line;
pub mod outline;
pub mod place;
pub mod plan;
pub mod read;
pub mod session;
pub mod stand;
pub mod sub;

pub use line::Line;
pub use outline::{LeafOutline, Outline, OutlineParams, OutlineRepair};
