//! A grammar with all that it takes to grow a tree of it.

use super::derive::DeriveReport;
use super::presets::Preset;
use super::turtle::{Polygon, TurtleParams, TurtleReport, interpret};
use super::{Grammar, Word};
use crate::error::{ModelError, Result};
use crate::{Modeler, turtle_settings};
use tree_core::{Control, Limits, Seed, Species, Tree};

/// An L-system: from a seed it grows a tree.
///
/// ```
/// use tree_model::lsystem::LSystem;
/// use tree_model::tree_core::{Control, Limits, Seed};
/// let text = "steps: 4\nangle: 30\nheight = 3\naxiom: X\nX -> F[+X][-X]FX\nF -> FF";
/// let system = LSystem::parse(text, &Limits::default())?;
/// let grown = system.grow(Seed(1), &Control::default())?;
/// assert!((grown.tree.skeleton().bounds().max.y - 3.0).abs() < 1e-4);
/// # Ok::<(), tree_model::ModelError>(())
/// ```
#[derive(Clone, Debug)]
pub struct LSystem {
    /// The productions.
    pub grammar: Grammar,
    /// Derivations; `None` takes what the text asks for.
    pub steps: Option<u32>,
    /// How the word is drawn.
    pub turtle: TurtleParams,
    /// What it grows.
    pub species: Species,
}
