//! A freehand drawing becomes a tree: branches from strokes by a Markov random field (Neubert 2012, chapter 4;
//! Chen, Neubert, Xu, Deussen & Kang 2008).

mod branches;
pub mod clean;
pub mod crown;
pub mod finish;
mod footprint;
mod frame;
pub mod infer;
mod midline;
mod omega;
mod plan;
pub mod propagate;
pub mod read;
mod relation;
pub mod session;
mod stroke;
pub mod template;

pub use branches::{Branches, Label};
pub use footprint::{DIRECTIONS, Footprint, convex_hull};
pub use midline::{FillRule, Midline, MidlineParams, midlines, midlines_of};
pub use omega::{Habit, Normal, Omega};
pub use plan::Plan;
pub use relation::Relation;
pub use stroke::{Drawing, Role, Stroke};
