//! L-systems: a grammar becomes a tree (Lindenmayer 1968; Prusinkiewicz & Lindenmayer, *The Algorithmic
//! Beauty of Plants*, 1990, "ABOP" below; Lluch et al. 2010, section 3).
//!
//! 1. [`Grammar::parse`] reads a text in the notation of ABOP and of the programs cpfg and L-studio.
//! 2. [`Grammar::derive`] replaces all modules of a [`Word`] at once, step by step.
//! 3. [`Grammar::interpretation`] makes of the word what a turtle is to see.
//!
//! `docs/LSYSTEMS.md` in the repository tells how to write a grammar, with pictures of all presets.
//!
//! ```
//! use tree_model::lsystem::Grammar;
//! use tree_model::tree_core::{Control, Limits, Seed};
//! let text = "
//!     #define r 0.5            // a constant
//!     steps: 2
//!     axiom: A(1)
//!     p1: A(l) : l > 0.1 -> F(l)[+(30)A(l*r)]A(l*r)
//! ";
//! let grammar = Grammar::parse(text, &Limits::default())?;
//! let derived = grammar.derive(None, Seed(1), &Control::default())?;
//! let word = derived.word.text(grammar.symbols());
//! assert_eq!(word, "F(1)[+(30)F(0.5)[+(30)A(0.25)]A(0.25)]F(0.5)[+(30)A(0.25)]A(0.25)");
//! # Ok::<(), tree_model::ModelError>(())
//! ```
//!
//! # Notation
//!
//! One text is one grammar, one line a statement. Lines are joined where a bracket is open, behind a `\`
//! at the end, before a line that begins with an arrow, and between an arrow at the end of a line and an
//! indented line without one.
//!
//! | text | meaning |
//! |---|---|
//! | `/* ... */`, `// ...` | comments; `//` begins one at the start of a line, or behind white space if no third `/` follows: `]////F` are four rolls |
//! | `#define a 30`, `a = 30` | a constant; its value is an expression of those before |
//! | `#symbols Apex Fl` | symbols of more than one character; the longest that fits is read. All others are one character |
//! | `#ignore +-F`, `ignore: +-F` | symbols that contexts do not see |
//! | `#consider AB`, `consider: AB` | the only symbols that contexts see |
//! | `steps: 7`, `derivation length: 7`, `n: 7` | number of derivations; default 0 |
//! | `angle: 25.7`, `δ: 25.7` | turn without a parameter in degrees; default 90 |
//! | `seed: 3` | the seed that the text proposes; default 0 |
//! | `axiom: A(1)`, `ω: A(1)`, `w: A(1)` | the word to begin with |
//! | `p1: A(x) : x > 1 -> B(x/2)` | a production; label and condition may be left out, or the condition be `*` |
//! | `->`, `-->`, `→` | arrows; a symbol `-` before one needs a space between |
//! | `A ->`, `A -> ε` | a module that vanishes |
//! | `B(y) < A(x) > C[D(z)]` | left and right context; `*` is an empty one |
//! | `A -(.3)-> B`, `A -.3-> B`, `A -> B : .3` | a production with a weight, an expression |
//! | `decomposition`, `homomorphism` or `interpretation`, `productions` | what follows are rules of that section |
//! | `maximum depth: 5` | how often the rules of the section are applied to what they give; default 1 |
//! | `endlsystem` | the end; what follows is not read |
//!
//! Symbols are any characters but `( ) , : < > = * ; ε`. Brackets `[ ]` are symbols that must pair in
//! every word. A symbol with one number of parameters is another *kind* than with two, and productions match
//! kinds; but a symbol that has productions for some numbers of parameters and stands in a word with another
//! number is a mistake.
//!
//! Expressions know, from the weakest: `||` (`|`, `or`), `&&` (`&`, `and`), `not`, `==` (`=`) `!=`,
//! `< <= > >=`, `+ -`, `* / %`, prefix `-` and `!`, `^`; the functions `sin cos tan asin acos atan atan2`
//! (degrees), `exp log sqrt abs floor ceil round sign min max pow mod`, `if(c,a,b)`; the random numbers
//! `rand` (uniform, 0 to 1), `ran(x)` (0 to x) and `nran(mean, deviation)`; and `itNum`, the step at work,
//! with `maxIt`, the number of steps. Truth is 1 or 0. A result that is not finite is an error.
//!
//! # Which production applies
//!
//! Productions with a context are tried first, else they are tried in the order of the text. The first that
//! matches applies, if it has no weight. If it has one, all productions with a weight that match (among
//! those with a context, or among those without) share the chance by their weights, which need not add up to 1.
//! A module that nothing matches stays.
//!
//! # The paper's `itNum`
//!
//! Lluch et al. call it the number of derivations "applied so far", and stop with `itNum = maxIt`. It must
//! count the derivation at work, from 1: counted from 0 that condition would hold in no step. Their grammar (1)
//! then gives `B(1)[B(.5)[B(.25)B(.25)]B(.5)[B(.25)B(.25)]]` for three steps. The printed chain (2) lacks the
//! last branch; no rewriting of all modules at once can treat two equal `A(.5)` differently, so it is a
//! specimen of the same species with a chance to stop (a test has that grammar).
//!
//! # What differs from cpfg
//!
//! * Names of several characters must be declared; cpfg takes one character or `@` with letters.
//! * There are no blocks of C, arrays, files, sub-L-systems or environment (`?E`), and macros have no parameters.
//! * `//` is no comment inside a run of rolls, see above.
//! * Weights of the productions that match are normalised; cpfg lets the rest of 1 keep the module.
//! * Decomposition is applied to the axiom and after each step.
//! * A bracket in a right context finds its branch behind other branches at the same place (4096 at most).
//! * `-2^2` is -4, `%` takes the sign of its left side, and no logarithm, root or division fails silently.
//!
//! The same seed gives the same word on every platform and for any number of threads.

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
