#![no_main]

use tree_core::{Control, Limits, Seed};
use tree_model::lsystem::Grammar;

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    let text = String::from_utf8_lossy(data);
    let limits = Limits { modules: 5_000, ..tree_fuzz::limits() };
    let control = Control::default().with_limits(limits);
    let Ok(grammar) = Grammar::parse(&text, &limits) else { return };
    // Words that do not grow could be derived for ever.
    let steps = grammar.steps().clamp(3, 8);
    let Ok(derived) = grammar.derive(Some(steps), grammar.seed(), &control) else { return };
    let word = derived.word;
    word.check(grammar.symbols()).expect("pairs of brackets and known kinds");
    assert!(word.params().iter().all(|x| x.is_finite()));
    if let Ok(seen) = grammar.interpretation(&word, Seed(1), &control) {
        seen.check(grammar.symbols()).expect("pairs of brackets and known kinds");
    }
    let again = Grammar::parse(grammar.text(), &limits).expect("what was read");
    assert_eq!(again.derive(Some(steps), grammar.seed(), &control).expect("the same").word, word);
});
