//! Productions at work.

use super::{tree_grammar, tree_word};
use crate::border::{Failure, Result, TREE_ERROR_PARAMETER, call, get, out, tree_status};
use crate::control::{run, tree_control};
use tree_model::tree_core::Seed;

/// As many derivations as the text of the grammar asks for.
pub const TREE_STEPS_OF_TEXT: u32 = 0xFFFF_FFFF;

/// More derivations are refused, as in a text.
const MOST_STEPS: u32 = 1_000_000;

/// The caller's number of derivations; `None` for the text's.
pub(super) fn steps(steps: u32) -> Result<Option<u32>> {
    match steps {
        TREE_STEPS_OF_TEXT => Ok(None),
        0..=MOST_STEPS => Ok(Some(steps)),
        _ => {
            let text =
                format!("steps is {steps}, allowed is 0 to {MOST_STEPS}, or TREE_STEPS_OF_TEXT");
            Err(Failure::new(TREE_ERROR_PARAMETER, text))
        }
    }
}

/// Applies a grammar's productions to all modules at once, `steps` times (0 to 1,000,000), beginning with the
/// axiom; `TREE_STEPS_OF_TEXT` takes the number from the text. The same `seed` gives the same word for any number
/// of threads. `control` may be NULL. `TREE_ERROR_INVALID` names module and production where an expression has no
/// finite value; `TREE_ERROR_LIMIT` comes before the word grows beyond `tree_limits.modules`. `tree_word_past`
/// tells how it grew. Free the word with `tree_word_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_derive(
    grammar: *const tree_grammar,
    steps: u32,
    seed: u64,
    control: *const tree_control,
    word: *mut *mut tree_word,
) -> tree_status {
    call(|| {
        let place = unsafe { out(word, "word") }?;
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        let steps = self::steps(steps)?;
        let derived =
            unsafe { run(control, |control| Ok(grammar.derive(steps, Seed(seed), control)?)) }?;
        place.put(tree_word::derived(derived.word, grammar, derived.report.modules));
        Ok(())
    })
}

/// Applies a grammar's productions to a word once: step `step`, counted from 0, of `of` steps, which conditions
/// see as `itNum` and `maxIt`. Steps one by one from `tree_grammar_axiom` give the word of `tree_grammar_derive`
/// (where the axiom is not random and not decomposed). `control` may be NULL. Errors are those of
/// `tree_grammar_derive`, and `TREE_ERROR_INVALID` for a word of another alphabet. Free the new word with
/// `tree_word_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_step(
    grammar: *const tree_grammar,
    word: *const tree_word,
    step: u32,
    of: u32,
    seed: u64,
    control: *const tree_control,
    next: *mut *mut tree_word,
) -> tree_status {
    call(|| {
        let place = unsafe { out(next, "next") }?;
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        let word = unsafe { get(word, "word") }?.of(grammar)?;
        let body = |control: &_| Ok(grammar.step(word, step, of, Seed(seed), control)?);
        place.put(tree_word::of_grammar(unsafe { run(control, body) }?, grammar));
        Ok(())
    })
}

/// The word as a turtle is to see it: the grammar's rules of interpretation applied, again to what they give,
/// down to their `maximum depth`. Without such rules it is a copy. Otherwise as `tree_grammar_step`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_interpretation(
    grammar: *const tree_grammar,
    word: *const tree_word,
    seed: u64,
    control: *const tree_control,
    seen: *mut *mut tree_word,
) -> tree_status {
    call(|| {
        let place = unsafe { out(seen, "seen") }?;
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        let word = unsafe { get(word, "word") }?.of(grammar)?;
        let body = |control: &_| Ok(grammar.interpretation(word, Seed(seed), control)?);
        place.put(tree_word::of_grammar(unsafe { run(control, body) }?, grammar));
        Ok(())
    })
}
