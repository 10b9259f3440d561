//! One pass over a word: every module is replaced or stays.

use super::choose::Scratch;
use super::context::Neighbours;
use crate::error::{ModelError, Result};
use crate::lsystem::expr::{Env, Fault};
use crate::lsystem::grammar::{Action, Row, Rules};
use crate::lsystem::{Grammar, Kind, Symbols, Word};
use rayon::prelude::*;
use std::ops::Range;
use tree_core::{Control, Resource, Seed};

/// Modules of a chunk: small enough that its decisions stay in the nearest cache, large enough that starting
/// one costs nothing.
const CHUNK: usize = 8192;
/// Parameters that one module of the budget stands for.
const PARAMS_OF_A_MODULE: u64 = 2;
/// The decision that a module stays.
pub(super) const STAYS: u16 = u16::MAX;

/// A pass, ready to run.
pub(super) struct Pass<'a> {
    pub(super) rules: &'a Rules,
    pub(super) symbols: &'a Symbols,
    pub(super) word: &'a Word,
    pub(super) neighbours: Option<Neighbours>,
    env: Env,
    control: &'a Control,
}

/// Modules of a chunk, and its part of the column of parameters.
#[derive(Clone)]
struct Chunk {
    modules: Range<usize>,
    params: Range<usize>,
}

/// What the first reading of a chunk finds.
struct Plan {
    /// The rule of each module that has a choice.
    choices: Vec<u16>,
    n_modules: u64,
    n_params: u64,
    changes: bool,
}

impl<'a> Pass<'a> {
    pub(super) fn new(
        grammar: &'a Grammar,
        rules: &'a Rules,
        word: &'a Word,
        stream: Seed,
        [step, steps]: [u32; 2],
        control: &'a Control,
    ) -> Result<Self> {
        let neighbours = if rules.have_contexts() {
            Some(Neighbours::new(word, grammar.symbols(), grammar.considered())?)
        } else {
            None
        };
        let env = Env { step: step.into(), steps: steps.into(), stream, module: 0 };
        Ok(Self { rules, symbols: grammar.symbols(), word, neighbours, env, control })
    }

    /// The new word; nothing when all modules stay.
    pub(super) fn run(&self) -> Result<Option<Word>> {
        let chunks = self.chunks();
        let parallel = chunks.len() > 1 && rayon::current_num_threads() > 1;
        // All results are gathered before the first error is looked for: which one that is must not
        // depend on threads.
        let plans: Vec<Result<Plan>> = if parallel {
            chunks.par_iter().map(|chunk| self.plan(chunk)).collect()
        } else {
            chunks.iter().map(|chunk| self.plan(chunk)).collect()
        };
        let plans: Vec<Plan> = plans.into_iter().collect::<Result<_>>()?;
        if !plans.iter().any(|plan| plan.changes) {
            return Ok(None);
        }
        let add = |of: fn(&Plan) -> u64| plans.iter().map(of).fold(0, u64::saturating_add);
        let (n_modules, n_params) = (add(|plan| plan.n_modules), add(|plan| plan.n_params));
        let n_budget = n_modules.max(n_params / PARAMS_OF_A_MODULE);
        self.control.limits.check(Resource::Modules, n_budget)?;
        let mut word = with_capacity(n_modules, n_params);
        if parallel {
            let parts: Vec<Result<Word>> = chunks
                .par_iter()
                .zip(&plans)
                .map(|(chunk, plan)| {
                    let mut part = with_capacity(plan.n_modules, plan.n_params);
                    self.write(chunk, plan, &mut part).map(|()| part)
                })
                .collect();
            let (kinds, params) = word.columns_mut();
            for part in parts {
                let part = part?;
                kinds.extend_from_slice(part.kinds());
                params.extend_from_slice(part.params());
            }
        } else {
            for (chunk, plan) in chunks.iter().zip(&plans) {
                self.write(chunk, plan, &mut word)?;
            }
        }
        Ok(Some(word))
    }

    fn chunks(&self) -> Vec<Chunk> {
        let mut from = 0;
        let chunks = self.word.kinds().chunks(CHUNK).enumerate().map(|(i, kinds)| {
            let n: usize = kinds.iter().map(|&kind| self.rules.row(kind).arity()).sum();
            let params = from..from + n;
            from += n;
            Chunk { modules: i * CHUNK..i * CHUNK + kinds.len(), params }
        });
        chunks.collect()
    }

    /// First reading: decisions and sizes.
    fn plan(&self, chunk: &Chunk) -> Result<Plan> {
        self.control.check()?;
        let mut plan = Plan { choices: Vec::new(), n_modules: 0, n_params: 0, changes: false };
        let mut scratch = Scratch::default();
        let mut at = chunk.params.start;
        for (i, &kind) in self.kinds(chunk).iter().enumerate() {
            let mut row = self.rules.row(kind);
            let end = at + row.arity();
            if let Action::Choose(from, to) = row.action {
                let module = chunk.modules.start + i;
                let own = self.params(at..end);
                let choice = self.choose(module, own, from..to, &mut scratch)?;
                plan.choices.push(choice);
                row = self.rules.row_of_choice(choice, row);
            }
            plan.changes |= row.action != Action::Keep;
            plan.n_modules = plan.n_modules.saturating_add(row.n_modules.into());
            plan.n_params = plan.n_params.saturating_add(row.n_params.into());
            at = end;
        }
        Ok(plan)
    }

    /// Second reading: the new modules.
    fn write(&self, chunk: &Chunk, plan: &Plan, word: &mut Word) -> Result<()> {
        self.control.check()?;
        let (out_kinds, out_params) = word.columns_mut();
        let kinds = self.kinds(chunk);
        let mut choices = plan.choices.iter();
        let (mut scratch, mut stack) = (Scratch::default(), Vec::new());
        let mut env = self.env;
        // Modules and parameters from here on stay, and are not copied yet.
        let (mut run, mut run_params) = (0, chunk.params.start);
        let mut at = chunk.params.start;
        for (i, &kind) in kinds.iter().enumerate() {
            let row = self.rules.row(kind);
            let (begin, end) = (at, at + row.arity());
            at = end;
            let rule = match row.action {
                Action::Keep => continue,
                Action::Always(rule) => rule,
                Action::Choose(..) => match choices.next() {
                    Some(&STAYS) | None => continue,
                    Some(&rule) => rule,
                },
            };
            let Some(rule) = self.rules.rule(rule) else { continue };
            out_kinds.extend_from_slice(kinds.get(run..i).unwrap_or_default());
            out_params.extend_from_slice(self.params(run_params..begin));
            (run, run_params) = (i + 1, end);
            out_kinds.extend_from_slice(&rule.successor.kinds);
            if rule.successor.values.is_empty() {
                continue;
            }
            let module = chunk.modules.start + i;
            env.module = module as u64;
            let own = self.params(begin..end);
            let frame =
                if rule.gathers { self.gather(rule, module, own, &mut scratch) } else { own };
            let written = rule.successor.write_params(frame, &env, &mut stack, out_params);
            written.map_err(|fault| self.fault(module, own, rule, &fault))?;
        }
        out_kinds.extend_from_slice(kinds.get(run..).unwrap_or_default());
        out_params.extend_from_slice(self.params(run_params..at));
        Ok(())
    }

    fn kinds(&self, chunk: &Chunk) -> &'a [Kind] {
        self.word.kinds().get(chunk.modules.clone()).unwrap_or_default()
    }

    #[inline]
    pub(super) fn params(&self, range: Range<usize>) -> &'a [f64] {
        self.word.params().get(range).unwrap_or_default()
    }

    pub(super) fn env(&self, module: usize) -> Env {
        Env { module: module as u64, ..self.env }
    }

    #[cold]
    pub(super) fn fault(
        &self,
        module: usize,
        own: &[f64],
        rule: &crate::lsystem::grammar::Rule,
        fault: &Fault,
    ) -> ModelError {
        let name = self.symbols.get(rule.kind).map_or("?", |(name, _)| name);
        let params: Vec<String> = own.iter().map(ToString::to_string).collect();
        let params =
            if params.is_empty() { String::new() } else { format!("({})", params.join(",")) };
        let (label, line, fault) = (&rule.name, rule.line, &fault.0);
        let problem = format!("{fault} in {label} (line {line}) of {name}{params}");
        ModelError::Word { module, problem }
    }
}

impl Row {
    #[inline]
    fn arity(&self) -> usize {
        usize::from(self.arity)
    }
}

fn with_capacity(n_modules: u64, n_params: u64) -> Word {
    let mut word = Word::default();
    let (kinds, params) = word.columns_mut();
    kinds.reserve_exact(n_modules as usize);
    params.reserve_exact(n_params as usize);
    word
}
