//! Derivation: productions applied to all modules of a word at once, again and again.
//!
//! 1. One pass (`pass`) rewrites a word in two readings of chunks of it. The first decides which rule
//!    applies to each module and adds up the size of the result, so that the budget is asked before memory
//!    is taken and no column ever grows; the second writes. Chunks are independent: they run in parallel,
//!    and are joined in order.
//! 2. Modules whose kind has one unconditional rule need no decision (`choose` makes the others), and runs of
//!    modules that stay are copied at once.
//! 3. Neighbours across branches are found in one reading of the whole word (`context`), only where a
//!    rule has a context.
//! 4. After each step come the passes of decomposition, down to their depth.
//!
//! Random numbers belong to (seed, step, index of the module, number of the draw in the grammar), so
//! neither threads nor chunks change them.

mod choose;
mod context;
mod pass;

#[cfg(test)]
mod tests;

use super::expr::Env;
use super::grammar::Rules;
use super::{Grammar, Word};
use crate::error::{ModelError, Result};
use pass::Pass;
use tree_core::{Control, Seed};

/// What a derivation gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Derived {
    /// The word after the last step.
    pub word: Word,
    /// What was done.
    pub report: DeriveReport,
}

/// What a derivation did.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct DeriveReport {
    /// Modules of the axiom, and then of the word after each step.
    pub modules: Vec<u64>,
}

impl DeriveReport {
    /// Modules that all steps wrote together.
    #[must_use]
    pub fn n_produced(&self) -> u64 {
        self.modules.iter().skip(1).sum()
    }
}

/// The axiom with the random numbers of this seed.
pub(super) fn axiom(grammar: &Grammar, seed: Seed) -> Result<Word> {
    let start = grammar.start();
    let mut word = Word::default();
    let (kinds, params) = word.columns_mut();
    kinds.extend_from_slice(&start.kinds);
    let steps = f64::from(grammar.steps());
    let env = Env { step: 0.0, steps, stream: seed.stream("axiom"), module: 0 };
    start
        .write_params(&[], &env, &mut Vec::new(), params)
        .map_err(|fault| ModelError::Word { module: 0, problem: format!("axiom: {}", fault.0) })?;
    Ok(word)
}

/// See [`Grammar::derive`].
pub(super) fn derive(
    grammar: &Grammar,
    steps: u32,
    seed: Seed,
    control: &Control,
) -> Result<Derived> {
    let word = axiom(grammar, seed)?;
    let mut word = decompose(grammar, word, 0, steps, seed, control)?;
    let mut modules = vec![word.len() as u64];
    for step in 0..steps {
        control.report("derivation", step as f32 / steps as f32)?;
        if let Some(next) = rewrite(grammar, &word, step, steps, seed, control)? {
            word = next;
        }
        word = decompose(grammar, word, step + 1, steps, seed, control)?;
        modules.push(word.len() as u64);
    }
    control.report("derivation", 1.0)?;
    Ok(Derived { word, report: DeriveReport { modules } })
}

/// See [`Grammar::step`].
pub(super) fn step(
    grammar: &Grammar,
    word: &Word,
    step: u32,
    of: u32,
    seed: Seed,
    control: &Control,
) -> Result<Word> {
    let next = rewrite(grammar, word, step, of, seed, control)?.unwrap_or_else(|| word.clone());
    decompose(grammar, next, step.saturating_add(1), of, seed, control)
}

/// See [`Grammar::interpretation`].
pub(super) fn interpretation(
    grammar: &Grammar,
    word: &Word,
    seed: Seed,
    control: &Control,
) -> Result<Word> {
    let (rules, stream) = (grammar.interpretation_rules(), seed.stream("interpretation"));
    let steps = grammar.steps();
    let seen = to_depth(grammar, rules, word, stream, [steps, steps], control)?;
    Ok(seen.unwrap_or_else(|| word.clone()))
}

fn rewrite(
    grammar: &Grammar,
    word: &Word,
    step: u32,
    of: u32,
    seed: Seed,
    control: &Control,
) -> Result<Option<Word>> {
    let stream = seed.stream("lsystem").child(step.into());
    // The paper's conditions name the step at work, counted from 1.
    let counts = [step.saturating_add(1), of];
    Pass::new(grammar, grammar.productions(), word, stream, counts, control)?.run()
}

/// Decomposes the axiom (`after` = 0) or the word after so many steps.
fn decompose(
    grammar: &Grammar,
    word: Word,
    after: u32,
    of: u32,
    seed: Seed,
    control: &Control,
) -> Result<Word> {
    let (rules, stream) =
        (grammar.decomposition(), seed.stream("decomposition").child(after.into()));
    let decomposed = to_depth(grammar, rules, &word, stream, [after, of], control)?;
    Ok(decomposed.unwrap_or(word))
}

/// Applies rules without context to what they give, until none applies or their depth is reached. As they
/// see no neighbours, a pass over the whole word for each depth is the same as recursion in each module.
fn to_depth(
    grammar: &Grammar,
    rules: &Rules,
    word: &Word,
    stream: Seed,
    counts: [u32; 2],
    control: &Control,
) -> Result<Option<Word>> {
    let mut last = None;
    if rules.rules().is_empty() {
        return Ok(last);
    }
    for depth in 0..rules.depth() {
        let stream = stream.child(depth.into());
        let from = last.as_ref().unwrap_or(word);
        match Pass::new(grammar, rules, from, stream, counts, control)?.run()? {
            Some(next) => last = Some(next),
            None => break,
        }
    }
    Ok(last)
}
