//! From branches to a tree: wood as thick as the pipe model has it, twigs and leaves (Neubert 2012, sections 4.7
//! and 5.4).
//!
//! 1. [`grow_wood`]: segments become a skeleton. Every point stays where it is: seen from the front, sketched branches
//!    are the strokes.
//! 2. [`grow_crown`]: twigs and leaves of a species, as sprays. There are as many leaves as cover the crown as those
//!    of a tree in full leaf do, spread over it so that dense parts get less than their share of shoots; and as many
//!    twigs as leaves need places beyond those that branches have. With a crown drawn, both stay in it.
//!
//! Departure: the thesis does not say how many leaves there are.
//!
//! Cost: O(nodes + leaves).

mod crown;
mod params;
mod spread;
#[cfg(test)]
mod tests;
mod wood;

pub use crown::{FinishReport, grow_crown};
pub use params::FinishParams;
pub use wood::grow_wood;
