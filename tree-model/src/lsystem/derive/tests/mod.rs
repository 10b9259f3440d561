//! Derived words: those of the books, chances, contexts, and the same bits on any number of threads.

mod books;
mod chance;
mod contexts;
mod robust;

use super::*;
use tree_core::Limits;

fn parse(text: &str) -> Grammar {
    Grammar::parse(text, &Limits::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn word(grammar: &Grammar, steps: u32) -> Word {
    grammar.derive(Some(steps), Seed(1), &Control::default()).unwrap().word
}

/// The word after so many steps as text.
fn derived(grammar: &Grammar, steps: u32) -> String {
    word(grammar, steps).text(grammar.symbols())
}

/// How often a symbol without parameters stands in the word.
fn count(grammar: &Grammar, word: &Word, name: &str) -> usize {
    let kind = grammar.symbols().find(name, 0).unwrap();
    word.kinds().iter().filter(|&&k| k == kind).count()
}
