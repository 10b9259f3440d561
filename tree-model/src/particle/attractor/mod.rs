//! The main branches in one image: the graph that attracts particles (Neubert 2012, section 3.2.2).

mod builder;
mod cost;
#[cfg(feature = "svg")]
mod drawing;
mod edit;
mod graph;
mod livewire;
mod plane;
mod ridge;
mod search;
mod seeds;
mod strokes;
#[cfg(test)]
mod tests;
mod tidy;
mod trunk;
mod working;

#[cfg(feature = "svg")]
pub use drawing::strokes_from_svg;
pub use edit::{CutOff, EraseReport};
pub use graph::{AttractorGraph, Nearest};
pub use livewire::{LivewireParams, LivewireReport, livewire};
pub use seeds::{SeedParams, silhouette_seeds};
pub use strokes::{StrokeParams, StrokeReport, from_strokes};
