//! Trees of least-cost paths in iterated random graphs, after Ling Xu and David Mould, *Synthetic
//! Tree Models from Iterated Discrete Graphs* (2012).
//!
//! A rough volume is filled with random nodes, near nodes are linked by edges of random cost, and
//! the cheapest paths from a few endpoints to the root become the main branches: they run together
//! near the root and wander apart like real ones. Then a smaller volume is put round each
//! endpoint and everything is done again, for as many levels as wanted.
//!
//! 1. [`nodes`]: nodes strewn in the volume, none closer than a separation (steps 1A to 1F).
//! 2. [`graph`]: links between near nodes, with random costs, painted costs and obstacles (1G, 1H).
//! 3. [`search`]: one search from the root finds the cheapest path to every node (3A).
//! 4. Endpoints are chosen, and the union of their paths kept (2, 3B).
//! 5. Every endpoint becomes the root of a smaller graph (4), up to the last level.
//! 6. The paths are smoothed, get radii ([`allometry`](tree_core::allometry)) and leaves
//!    ([`foliage`](crate::foliage)).
//!
//! Where we depart from the paper, and why:
//! * Two lengths keep nodes apart and link them; the paper's single one would leave no edge.
//! * One search per graph serves all endpoints, and it is linear in nodes and arcs.
//! * Subgraphs point from the root before *through* the endpoint, outwards, as the pseudocode and all
//!   figures have it; the text has the opposite sign.
//! * Random endpoints are graph nodes, so that none is out of reach.
//! * Each subgraph's paths end at its own root, which is the endpoint it grows from; the paper
//!   speaks of connecting them to "the structure obtained before", which is the same tree.
//! * Beyond the paper: obstacles, painted costs, surface and hand-placed endpoints, endpoints spread
//!   by best candidates, smoothing, the pipe model for radii, leaves.
//! * Parts of a volume thinner than the separation (trunks) get nodes by their length, or graphs would
//!   fall apart there.
//! * The presets `e`, `f`, `g`, `j`, `l` have a cheap way up the middle, and the conifers among them
//!   placed endpoints near the top: by plain paths in a cone every branch would start at the ground.
//!
//! Cost: linear in the nodes of all graphs together, and the graphs of a level run in parallel.

mod draft;
mod endpoints;
pub mod graph;
mod grid;
mod iterate;
pub mod nodes;
mod nursery;
mod obstacle;
mod params;
mod presets;
#[cfg(feature = "svg")]
mod profile;
pub mod search;
mod shoot;
pub(crate) mod smooth;

pub use graph::{CostField, LinkParams, Paint};
pub use iterate::{LevelReport, PathReport, PathTree};
pub use obstacle::Obstacle;
pub use params::{
    Endpoints, Level, LevelAxis, Lifespan, MAX_ENDPOINTS, MAX_LEVELS, MIN_ANGLE, PathParams,
    Placing, SubShape,
};
pub use presets::{PRESETS, Preset};
#[cfg(feature = "svg")]
pub use profile::{Profile, ProfileOptions};
pub use shoot::GraphStats;

use crate::{ModelError, Modeler};
use tree_core::{Control, Seed, Tree};

impl Modeler for PathParams {
    fn model(&self, seed: Seed, control: &Control) -> Result<Tree, ModelError> {
        self.grow(seed, control).map(|grown| grown.tree)
    }
}

#[cfg(test)]
mod tests;
