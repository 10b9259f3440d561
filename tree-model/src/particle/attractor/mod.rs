//! The main branches in one image: the graph that attracts particles (Neubert 2012, section 3.2.2).

mod graph;

pub use graph::AttractorGraph;
