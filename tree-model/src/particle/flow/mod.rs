//! The particles and their traces (Neubert 2012, section 3.4).
//!
//! Particles start where the tree is dense and flow to its base:
//!
//! 1. [`Way`]: the way to the base through the density, by fast marching.
//! 2. [`Forces`]: the images' direction fields, the way to the base and the nearest neighbour make one
//!    direction.
//! 3. [`run`]: Newton's law with drag by an adaptive Runge-Kutta method (Eq. 3.4, 3.6), joins of particles
//!    that come close, until all have arrived (Algorithm 1).
//! 4. [`Traces`] become a skeleton.
//!
//! Where we depart from the thesis, and why:
//! * The pull to the base follows the cheapest way through the density, not a straight line: a crown on a
//!   bare trunk, and one that leans, are not left. It can prefer a stem, which gives branching angles where
//!   no image shows any.
//! * The views' vectors are joined by least squares, not averaged, and where they vanish or contradict each
//!   other the way to the base takes over.
//! * Particles that have not arrived after all steps are steered home and reported; none is dropped.
//!
//! Cost: neighbours come from a uniform grid, so a step is linear in the particles still apart.

mod force;
mod integrate;
mod march;
mod near;
mod params;
mod run;
mod trace;
mod way;

pub use force::Forces;
pub use params::FlowParams;
pub use run::{Flow, FlowReport, run};
pub use trace::Traces;
pub use way::Way;

#[cfg(test)]
mod tests;
