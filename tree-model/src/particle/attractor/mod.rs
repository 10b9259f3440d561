//! The main branches in one image: the graph that attracts particles (Neubert 2012, section 3.2.2).

mod cost;
mod graph;
mod livewire;
mod plane;
mod ridge;
mod search;
mod seeds;
mod tidy;
mod trunk;
mod working;

pub use graph::AttractorGraph;
pub use livewire::{LivewireParams, LivewireReport, livewire};
pub use seeds::{SeedParams, silhouette_seeds};
