//! Strings and counts of the books.

use super::*;

fn parse(text: &str) -> Grammar {
    Grammar::parse(text, &Limits::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn derived(grammar: &Grammar, steps: u32) -> String {
    let derived = grammar.derive(Some(steps), Seed(1), &Control::default()).unwrap();
    derived.word.text(grammar.symbols())
}

#[test]
fn algae_grow_as_lindenmayer_said() {
    let grammar = parse("axiom: b\nb -> a\na -> ab");
    let words: Vec<String> = (0..6).map(|n| derived(&grammar, n)).collect();
    assert_eq!(words, ["b", "a", "ab", "aba", "abaab", "abaababa"]);
}
