//! Solids and their combinations.

/// A solid.
#[derive(Clone, Debug)]
pub struct Volume;
