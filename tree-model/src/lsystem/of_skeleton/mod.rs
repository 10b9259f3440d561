//! From a skeleton back to a word: every tree of the family becomes a chain of modules.
//!
//! Steps: the skeleton is cut into axes; one pass without recursion writes each axis as a run of internodes,
//! with its laterals and leaves as brackets at the nodes where they stand. An internode is at most four
//! modules: `+(a)` and `&(b)` turn the heading onto it, `!(w)` sets the diameter of its upper end, `F(l)`
//! draws it; what does not change is not written. A leaf is
//! `[` turns, `f(l)` for its petiole, turns, a roll `\(r)`, `~(size,kind)` `]`.
//!
//! The writer leads a turtle along: each internode starts where the turtle *is*, not where the skeleton has
//! the node. So numbers may be rounded ([`ChainParams::tolerance`]), and what was rounded off does not add up
//! along an axis.
//!
//! The word reads in metres from the base of the tree, and is drawn with [`chain_turtle`]. Two nodes at one
//! place become one.
//!
//! Cost: O(nodes + leaves), about 8 modules a leaf and 3 a node.

mod aim;
#[cfg(test)]
mod tests;
mod write;

use super::turtle::{Taper, Thickness, TurtleParams};
use super::{Symbols, Word};
use crate::error::{Result, check};
use tree_core::{Continuation, Control, Foliage, Skeleton};

/// How a skeleton becomes a word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainParams {
    /// Which child goes on at a fork; the others are in brackets. Default the thickest.
    pub continuation: Continuation,
    /// How far a node may be from its place, as a share of the tree's extent, 0 to 0.01: numbers are rounded to
    /// as few decimals as this allows. 0 writes all digits. Default 1e-5.
    pub tolerance: f64,
}

impl Default for ChainParams {
    fn default() -> Self {
        Self { continuation: Continuation::Thickest, tolerance: 1e-5 }
    }
}

impl ChainParams {
    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter).
    pub fn validate(&self) -> Result<()> {
        check("chain.tolerance", self.tolerance, 0.0, 0.01)
    }
}

/// A skeleton as a word.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// The modules.
    pub word: Word,
    /// Their kinds.
    pub symbols: Symbols,
    /// For each node that the word draws, in its order, the node of the skeleton it stands for. The first is 0.
    pub nodes: Vec<u32>,
    /// For each leaf that the word draws, in its order, the leaf of the foliage.
    pub leaves: Vec<u32>,
}

/// Writes a skeleton and its leaves as a word.
///
/// ```
/// use tree_core::{Control, Foliage, Skeleton, glam::Vec3};
/// use tree_model::lsystem::of_skeleton::{ChainParams, chain};
/// let mut builder = Skeleton::builder(Vec3::ZERO, 0.1)?;
/// let fork = builder.add(0, Vec3::Y, 0.1)?;
/// builder.add(fork, 2.0 * Vec3::Y, 0.1)?;
/// builder.add(fork, Vec3::new(-1.0, 1.0, 0.0), 0.05)?;
/// let written = chain(&builder.finish(), &Foliage::default(), &ChainParams::default(), &Control::default())?;
/// assert_eq!(written.word.text(&written.symbols), "!(0.2)F(1)[+(90)!(0.1)F(1)]F(1)");
/// # Ok::<(), tree_model::ModelError>(())
/// ```
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter) for the tolerance,
/// [`ModelError::Word`](crate::ModelError::Word) for a leaf on a node that is not there, a limit on modules, and
/// cancellation.
///
/// # Complexity
/// O(nodes + leaves).
pub fn chain(
    skeleton: &Skeleton,
    foliage: &Foliage,
    params: &ChainParams,
    control: &Control,
) -> Result<Chain> {
    params.validate()?;
    write::Writer::new(skeleton, foliage, params, control)?.write()
}

/// The turtle that draws words of [`chain`]: in metres, widths at the upper ends of internodes.
#[must_use]
pub fn chain_turtle() -> TurtleParams {
    TurtleParams {
        width: 0.0,
        taper: Taper::Ends,
        thickness: Thickness::Word,
        ..TurtleParams::default()
    }
}
