//! The main branches in one image: the graph that attracts particles (Neubert 2012, section 3.2.2).
//!
//! * [`livewire`] finds them in a photograph, from seeds on the silhouette ([`silhouette_seeds`]) or given.
//! * [`from_strokes`] makes them of what a person drew, in an SVG file (`strokes_from_svg`) or elsewhere.
//! * [`AttractorGraph::add_stroke`], [`erase`](AttractorGraph::erase) and
//!   [`move_near`](AttractorGraph::move_near) change them by hand.

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
