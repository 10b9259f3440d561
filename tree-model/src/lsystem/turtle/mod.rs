//! The turtle: a word becomes a tree.
//!
//! A turtle with a position and three axes reads the word from left to right and draws (ABOP, sections 1.5,
//! 1.6 and 2.3; its appendix C lists the symbols):
//!
//! | Symbol | Meaning |
//! |---|---|
//! | `F(l)` | draws wood of length l; between braces it sets a corner at its end instead |
//! | `f(l)` | moves by l without drawing; between braces it sets a corner at its end |
//! | `G(l)` | draws as `F` does; between braces it moves without setting a corner |
//! | `+(a)` `-(a)` | turns left, right by a degrees about U |
//! | `&(a)` `^(a)` | pitches down, up about L |
//! | `\(a)` `/(a)` | rolls about H, left over up and back |
//! | `\|` | turns round |
//! | `$` | rolls until L is horizontal |
//! | `!(w)` `#(w)` | sets the diameter; without w it falls, or rises, by the width ratio |
//! | `_(e)` | sets the elasticity of tropism (as in the program cpfg) |
//! | `'` `'(n)` | next colour, colour n |
//! | `[` `]` | a branch: saves and restores all of the above |
//! | `%` | cuts off the rest of the branch |
//! | `{` `.` `}` | a polygon, a corner of it where the turtle stands, its end; polygons nest |
//! | `~(s, k)` | a leaf of size s and kind k (default 0): its midrib along H, its upper face towards U |
//!
//! Steps: one pass with a stack of states (`walk`) makes columns of nodes, leaves and polygons in f64 units
//! (`wood`); these are scaled to metres, and widths become radii.
//!
//! Departures: `+ & \` are right-handed rotations about U, L and H, which is what their names say; two of the
//! three matrices printed in ABOP turn the other way. Symbols that the table lacks do nothing and are counted
//! in the report. A gap made by `f` is bridged, because a skeleton hangs together. Wood between braces is not
//! drawn. Widths become tapered internodes instead of cylinders, see [`Taper`].
//!
//! Cost: O(modules), 8 to 20 ns each (the more different angles, the more), and the radius rule where the word sets no
//! width; 36 bytes a node, 80 a leaf, and 136 for each open bracket.

mod action;
pub(crate) mod frame;
mod lines;
mod params;
mod polygon;
mod report;
#[cfg(test)]
mod tests;
mod walk;
mod wood;

pub use lines::lines;
pub use params::{Taper, Thickness, TurtleParams};
pub use polygon::Polygon;
pub use report::TurtleReport;

use super::{Symbols, Word};
use crate::error::Result;
use tree_core::{Control, Species, Tree};

/// What a word drew.
#[derive(Clone, Debug, PartialEq)]
pub struct Interpretation {
    /// Wood and leaves; the base is at the origin.
    pub tree: Tree,
    /// What was drawn between braces, leaf or not, in the order of its ends.
    pub polygons: Vec<Polygon>,
    /// What the turtle met.
    pub report: TurtleReport,
}

/// Draws a word.
///
/// ```
/// use tree_core::{Control, Species};
/// use tree_model::lsystem::turtle::{TurtleParams, interpret};
/// use tree_model::lsystem::{Symbols, Word};
/// let mut symbols = Symbols::default();
/// let word = Word::parse("F(1)[+(30)F(0.5)]F(1)", &mut symbols)?;
/// let drawn = interpret(&word, &symbols, &Species::default(), &TurtleParams::default(), &Control::default())?;
/// assert_eq!(drawn.tree.skeleton().parents()[2..], [1, 1]);
/// # Ok::<(), tree_model::ModelError>(())
/// ```
///
/// # Errors
/// [`ModelError::Word`](crate::ModelError::Word) that names the module: a bracket or brace without its partner,
/// a coordinate beyond 1e12 units, a width or size below 0, a leaf kind that the species lacks.
/// [`ModelError::Parameter`](crate::ModelError::Parameter) for a field out of its range, or a tree of more than
/// 1000 km. A limit on nodes or leaves, and cancellation.
///
/// # Complexity
/// O(modules) time, one pass, no recursion.
pub fn interpret(
    word: &Word,
    symbols: &Symbols,
    species: &Species,
    params: &TurtleParams,
    control: &Control,
) -> Result<Interpretation> {
    let mut wood = wood::Wood::new(params, species.leaf_kinds.len(), control);
    let mut report = walk::walk(word, symbols, params, control, &mut wood)?;
    let (skeleton, foliage, polygons) = wood.finish(params, &mut report)?;
    let tree = Tree::new(skeleton, foliage, species.clone())?;
    Ok(Interpretation { tree, polygons, report })
}
