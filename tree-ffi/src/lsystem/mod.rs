//! L-systems: grammars, the words they derive, the turtle that draws words as trees, and trees written as words
//! (Lindenmayer 1968; Prusinkiewicz & Lindenmayer 1990; Lluch et al. 2010, section 3).

mod alphabet;
mod chain;
mod derive;
mod draw;
mod grammar;
mod place;
mod preset;
mod trace;
mod turtle;
mod word;

pub use alphabet::*;
pub use chain::*;
pub use derive::*;
pub use draw::*;
pub use grammar::*;
pub use place::*;
pub use preset::*;
pub use trace::*;
pub use turtle::*;
pub use word::*;
