//! L-systems: a grammar becomes a tree (Lindenmayer 1968; Prusinkiewicz & Lindenmayer, *The Algorithmic
//! Beauty of Plants*, 1990, "ABOP" below; Lluch et al. 2010, section 3).

pub mod of_skeleton;
pub mod turtle;
pub mod word;

pub use word::{Kind, Module, Symbols, Word};
