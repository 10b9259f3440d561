//! A freehand drawing becomes a tree: branches from strokes by a Markov random field (Neubert 2012, chapter 4;
//! Chen, Neubert, Xu, Deussen & Kang 2008).

mod branches;
mod crown;
pub mod finish;
mod footprint;
mod midline;
mod omega;
mod plan;
pub mod propagate;
mod stroke;

pub use branches::{Branches, Label};
pub use crown::{Crown, CrownParams, CrownRepair, CrownReport, OutlineParams, outline_of};
pub use footprint::{DIRECTIONS, Footprint, convex_hull};
pub use midline::{FillRule, Midline, MidlineParams, midlines, midlines_of};
pub use omega::{Habit, Normal, Omega};
pub use plan::Plan;
pub use stroke::{Drawing, Role, Stroke};
