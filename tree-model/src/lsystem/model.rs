//! A grammar with all that it takes to grow a tree of it.

use super::derive::DeriveReport;
use super::presets::Preset;
use super::turtle::{Polygon, TurtleParams, TurtleReport, interpret};
use super::{Grammar, Word};
use crate::Modeler;
use crate::error::{ModelError, Result};
use tree_core::{Control, Limits, Seed, Species, Tree};

/// An L-system: from a seed it grows a tree.
///
/// Constants of the text may set the turtle, so that a file says all there is to say: `step`, `width`,
/// `width_ratio`, `leaf_size`, `elasticity`, `tropism_x`, `tropism_y`, `tropism_z`, `unit`, `height` and
/// `trunk_radius` are the fields of [`TurtleParams`].
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
    /// Derivations, 0 to 1,000,000; `None` takes what the text asks for.
    pub steps: Option<u32>,
    /// How the word is drawn.
    pub turtle: TurtleParams,
    /// What it grows.
    pub species: Species,
}

/// A grown tree, and how it grew.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Grown {
    /// Wood and leaves.
    pub tree: Tree,
    /// What was drawn between braces.
    pub polygons: Vec<Polygon>,
    /// The word that was drawn; its kinds are the grammar's.
    pub word: Word,
    /// What was done.
    pub report: LSystemReport,
}

/// What growing a tree took.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LSystemReport {
    /// The derivation.
    pub derivation: DeriveReport,
    /// The drawing.
    pub turtle: TurtleReport,
}

/// Shares of the progress at which the word is derived, and rewritten to be drawn.
const DERIVED: f32 = 0.7;
const REWRITTEN: f32 = 0.8;

impl LSystem {
    /// Grows what a grammar says: the angle and the turtle come from its constants, the species is the default
    /// one.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] for a constant that names a field of the turtle and is out of its range.
    pub fn new(grammar: Grammar) -> Result<Self> {
        let mut turtle = TurtleParams { angle: grammar.angle(), ..TurtleParams::default() };
        for (name, value) in grammar.constants() {
            set(&mut turtle, name, value);
        }
        turtle.validate()?;
        Ok(Self { grammar, steps: None, turtle, species: Species::default() })
    }

    /// Reads a grammar.
    ///
    /// # Errors
    /// As [`Grammar::parse`] and [`new`](Self::new).
    pub fn parse(text: &str, limits: &Limits) -> Result<Self> {
        Self::new(Grammar::parse(text, limits)?)
    }

    /// The preset of this name.
    ///
    /// # Errors
    /// [`ModelError::UnknownPreset`] that lists the names there are.
    pub fn preset(name: &str) -> Result<Self> {
        Preset::find(name)?.system()
    }

    /// Derives the word and draws it. The same seed gives the same bits on every platform, for any number of
    /// threads.
    ///
    /// # Errors
    /// [`ModelError::Word`] that names the module of the derived word, [`ModelError::Parameter`] for a field of
    /// the turtle, a limit on modules, nodes or leaves, and cancellation.
    ///
    /// # Complexity
    /// O(modules of all steps together).
    pub fn grow(&self, seed: Seed, control: &Control) -> Result<Grown> {
        self.turtle.validate()?;
        let grammar = &self.grammar;
        let derived = grammar.derive(self.steps, seed, &control.part(0.0, DERIVED))?;
        let word =
            grammar.interpretation(&derived.word, seed, &control.part(DERIVED, REWRITTEN))?;
        control.report("turtle", REWRITTEN)?;
        let drawn = interpret(&word, grammar.symbols(), &self.species, &self.turtle, control)?;
        control.report("turtle", 1.0)?;
        let report = LSystemReport { derivation: derived.report, turtle: drawn.report };
        Ok(Grown { tree: drawn.tree, polygons: drawn.polygons, word, report })
    }
}

impl Modeler for LSystem {
    fn model(&self, seed: Seed, control: &Control) -> Result<Tree, ModelError> {
        Ok(self.grow(seed, control)?.tree)
    }
}

/// Sets the turtle's field of this name, if it has one.
fn set(turtle: &mut TurtleParams, name: &str, value: f64) {
    match name {
        "step" => turtle.step = value,
        "width" => turtle.width = value,
        "width_ratio" => turtle.width_ratio = value,
        "leaf_size" => turtle.leaf_size = value,
        "elasticity" => turtle.elasticity = value,
        "tropism_x" => turtle.tropism.x = value as f32,
        "tropism_y" => turtle.tropism.y = value as f32,
        "tropism_z" => turtle.tropism.z = value as f32,
        "unit" => turtle.unit = value,
        "height" => turtle.height = Some(value as f32),
        "trunk_radius" => turtle.trunk_radius = Some(value as f32),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_of_the_text_set_the_turtle() {
        let text =
            "angle: 30\nelasticity = 0.2\ntropism_y = 1\ntrunk_radius = 0.3\nstep = 2\naxiom: FF";
        let system = LSystem::parse(text, &Limits::default()).unwrap();
        let turtle = &system.turtle;
        assert_eq!((turtle.angle, turtle.elasticity, turtle.tropism.y), (30.0, 0.2, 1.0));
        let tree = system.model(Seed(1), &Control::default()).unwrap();
        assert_eq!(tree.skeleton().bounds().max.y, 4.0);
        assert!((tree.skeleton().radii()[0] - 0.3).abs() < 1e-6);
    }

    #[test]
    fn a_constant_out_of_the_range_of_its_field_is_named() {
        let text = "elasticity = 1e9\naxiom: F";
        let error = LSystem::parse(text, &Limits::default()).unwrap_err().to_string();
        assert!(error.contains("turtle.elasticity"), "{error}");
    }

    #[test]
    fn cancelled_work_stops() {
        let flag = tree_core::CancelFlag::default();
        flag.cancel();
        let control = Control::default().with_cancel(flag);
        let grown = LSystem::preset("honda-a").unwrap().grow(Seed(1), &control);
        assert!(matches!(grown, Err(ModelError::Cancelled(_))));
    }
}
