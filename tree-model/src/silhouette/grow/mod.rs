//! From the plane to space: a plan becomes a tree (Wither et al. 2009, sections 4.2 and 5).
//!
//! 1. `style`: of every system that was drawn, what others may copy: where it branches, how far apart, at what
//!    angles, and the shapes of its branches.
//! 2. `pattern`: the branches of a system round its axis. Sketched ones keep what the drawing shows of them and find
//!    their azimuth in their domain; added ones fill the rest, as long as the pseudo-surface of revolution lets them be. Systems that
//!    were not drawn are made of the style of the nearest that was.
//! 3. `expand`: patterns are set down level by level, and become columns of nodes and leaves.
//!
//! 4. `fence`, `fill`: leaves and twigs that would be seen outside the outlines are left out, and cells of
//!    the outlines that stayed empty get twigs and leaves from what is nearest. The paper does neither; its trees match their
//!    outlines at high density only, as it says.
//!
//! A pattern knows no size: what two branches of the same shape and number of branches share is made once, in a few variants.
//! That is what makes a million leaves affordable. A tree of fifty thousand leaves takes some tens of milliseconds.

mod expand;
mod explicit;
mod fence;
mod fill;
mod frame;
mod params;
mod pattern;
mod report;
mod shapes;
mod style;

pub use expand::grow;
pub use params::{GrowParams, Leaves, LevelParams};
pub use report::{GrowReport, Grown};

#[cfg(test)]
mod tests;
