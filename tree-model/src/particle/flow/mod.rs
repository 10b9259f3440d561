//! The particles and their traces (Neubert 2012, section 3.4).
//!
//! Particles start where the tree is dense and flow to its base:
//!
//! 1. [`Way`]: the way to the base through the density, by fast marching.
//! 2. [`Forces`]: the images' direction fields, the way to the base and the nearest neighbour make one
//!    direction.
//! 3. [`run`]: Newton's law with drag by an adaptive Runge-Kutta method (Eq. 3.4, 3.6), joins of particles
//!    that come close, until all have arrived (Algorithm 1). A join adds up masses; heavy particles turn
//!    more slowly.
//! 4. [`Traces`] become a skeleton.
//!
//! Where we depart from the thesis, and why:
//! * The pull to the base follows the cheapest way through the density, not a straight line: a crown on a
//!   bare trunk, and one that leans, are not left. It can prefer a stem, which gives branching angles where
//!   no image shows any.
//! * The views' vectors are joined by least squares, not averaged, and where they vanish or contradict each
//!   other the way to the base takes over.
//! * A particle also joins a trace nearby whose particle has gone on. Starts at different distances reach
//!   one branch at different times; joining only what meets at one time would lay traces side by side.
//! * The thesis leaves open what keeps particles from gaining speed without end. Here it is drag: all move
//!   about as fast, and forces decide where to. The error of a step is known (Bogacki and Shampine 1989) and
//!   bounded, which the fourth-order method of Eq. 3.6 does not tell.
//! * Particles that have not arrived after all steps are steered home and reported; none is dropped.
//!
//! Cost: neighbours and traces come from uniform grids, so a step is linear in the particles still apart; they
//! join as they go.

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
