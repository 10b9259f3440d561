//! Reading grammars: notation, mistakes, hostile text.

mod mistakes;
mod notation;
mod robust;

use super::*;

fn parse(text: &str) -> Grammar {
    Grammar::parse(text, &Limits::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The word after so many steps as text.
fn derived(grammar: &Grammar, steps: u32) -> String {
    let derived = grammar.derive(Some(steps), Seed(1), &Control::default()).unwrap();
    derived.word.text(grammar.symbols())
}
