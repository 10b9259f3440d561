//! L-systems: a grammar becomes a tree (Lindenmayer 1968; Prusinkiewicz & Lindenmayer, *The Algorithmic
//! Beauty of Plants*, 1990, "ABOP" below; Lluch et al. 2010, section 3).

mod derive;
mod expr;
mod grammar;
mod model;
pub mod of_skeleton;
mod presets;
mod text;
pub mod turtle;
pub mod word;

pub use derive::{DeriveReport, Derived};
pub use grammar::Grammar;
pub use model::{Grown, LSystem, LSystemReport};
pub use presets::{Preset, presets};
pub use turtle::{Interpretation, Polygon, Taper, Thickness, TurtleParams, TurtleReport};
pub use word::{Kind, Module, Symbols, Word};
