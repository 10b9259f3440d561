//! A whole stand from one outline for each tree.
//!
//! The paper names this as an extension (Wither et al. 2009, section 8): one silhouette for each tree of a landscape, details only for
//! those in front. Its fern forest and its stand (figure 10) were drawn tree by tree. Here a drawing of many trees grows at once:
//!
//! 1. `ground`: where each tree stands, and at what scale. Trees drawn higher up and smaller are real trees farther off: sizes
//!    shrink in proportion to the distance of the ground point from the horizon, which is given or estimated. Without clear
//!    perspective all stand on one line.
//! 2. Each tree is a [`Session`](super::session::Session) of its own, drawn as
//!    [`Session::of_drawing`](super::session::Session::of_drawing) does.
//! 3. `lend`: trees without details borrow branches and leaf of the detailed tree with the most similar crown, or of one that
//!    was chosen, scaled as their crowns are.
//! 4. `build`: all grow, in parallel, with the same bits for any number of threads.
//!
//! A tree that cannot be used is left out and reported. Costs what the trees cost.

mod build;
mod ground;
mod lend;
mod params;
mod report;

pub use build::{Stand, StandTree};
pub use ground::StandView;
pub use params::{Lending, Perspective, StandParams};
pub use report::StandNote;

#[cfg(test)]
mod tests;
