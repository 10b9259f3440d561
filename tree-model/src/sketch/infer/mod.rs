//! Depths, labels and Ω of a sketch: inference in a Markov tree (Neubert 2012, sections 4.4 to 4.6).
//!
//! A sketch is seen from the front without perspective: x and y of every branch are drawn, its depth z is not.
//!
//! 1. The branches are split into segments from fork to fork. Depth and label (apical, or which lateral) of each
//!    are the variables of a factor graph; its factors say how a segment lies to its parent (Eq. 4.16), by Ω.
//! 2. Bottom-up inference places generation by generation.
//! 3. ICM raises the posterior depth by depth, with competition for space and room where branches cross
//!    (`near`; Eq. 4.22 to 4.24).
//! 4. Ω is estimated anew (Eq. 4.25), and 3 and 4 are repeated. With [`InferParams::keep_omega`] Ω stays.
//!
//! Every step raises the posterior or leaves it: [`Inferred::trace`]. What the pages of each step say on departures is
//! in short: aims of each segment within Ω, parameters by order, sides carried by laterals, a beam, heavy tails,
//! factors for strokes, exact competition.
//!
//! Cost: O(segments · neighbours · sweeps · rounds), some 0.3 ms a segment.

mod aims;
mod bottom_up;
mod climb;
mod densities;
mod depth;
mod factors;
mod graph;
mod icm;
mod labels;
mod near;
mod omega_step;
mod params;
mod posterior;
mod run;
mod segments;
#[cfg(test)]
mod tests;

pub use graph::FactorGraph;
pub use params::InferParams;
pub use posterior::Posterior;
pub use run::{FactorRow, Inferred, Pin, Step, TraceRow, infer, infer_with};
pub use segments::STEEPEST;
