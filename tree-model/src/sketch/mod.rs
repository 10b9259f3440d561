//! A freehand drawing becomes a tree: branches from strokes by a Markov random field (Neubert 2012, chapter 4;
//! Chen, Neubert, Xu, Deussen & Kang 2008).
//!
//! A person draws a few branches, perhaps a crown, in one view. The tree's projection is that drawing.
//!
//! 1. [`read`]: strokes from SVG, JSON or Quick, Draw! lines, or a [`Drawing`] made by hand.
//! 2. [`clean`]: what each stroke shows, middle lines of outlines, overdrawn strokes merged, ends joined, the root found. The
//!    branches are then a tree in the plane, a [`Plan`]; the [`crown`] is closed (Fig. 4.15).
//! 3. [`template`]: of twenty exemplars the one whose views suit the drawing best (Eq. 4.26, 4.27) gives [`Omega`],
//!    the laws of its angles and lengths.
//! 4. [`infer`]: depth and label of each segment, and unless it is kept Ω, by inference in the factor graph (Eq. 4.16
//!    to 4.25). The result is [`Branches`] in space.
//! 5. [`propagate`]: what the drawing leaves out, by its own pattern, inside the crown's surface of local revolution (section 4.7).
//! 6. [`finish`]: radii, twigs and leaves.
//!
//! [`session`] runs all of it, with edits. Each module says where it leaves the thesis and why; ARCHITECTURE.md has the list.
//!
//! What it cannot do: it takes drawings for views from the front without perspective; drawn thickness is not used; outlines
//! of palm fronds do not become fronds.

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
