//! Which of several rules applies to a module.
//!
//! Rules with a context are tried before those without (ABOP p. 30), else in the order of the text. The
//! first that matches applies, if it has no probability. If it has one, all rules with a probability that
//! match are gathered (of those with a context or of those without), and one is drawn by weight.

use super::pass::{Pass, STAYS};
use crate::error::Result;
use crate::lsystem::expr::Fault;
use crate::lsystem::grammar::Rule;
use std::ops::Range;

/// Space that is used again from module to module.
#[derive(Default)]
pub(super) struct Scratch {
    /// Of expressions.
    pub(super) stack: Vec<f64>,
    /// Parameters of a module and its contexts.
    pub(super) frame: Vec<f64>,
    /// Modules that a context matched.
    pub(super) matched: Vec<u32>,
    weights: Vec<(f64, u16)>,
}

impl Pass<'_> {
    /// The rule for a module among a range of candidates, or [`STAYS`].
    pub(super) fn choose(
        &self,
        module: usize,
        own: &[f64],
        range: Range<u32>,
        scratch: &mut Scratch,
    ) -> Result<u16> {
        scratch.weights.clear();
        let mut with_context = false;
        for &number in self.rules.candidates(range.start, range.end) {
            let Some(rule) = self.rules.rule(number) else { continue };
            let drawn = !scratch.weights.is_empty();
            if drawn && rule.has_context() != with_context {
                break;
            }
            if drawn && rule.weight.is_none() {
                continue;
            }
            let weight = self
                .weight(rule, module, own, scratch)
                .map_err(|fault| self.fault(module, own, rule, &fault))?;
            match weight {
                Match::No => {}
                Match::Certain => return Ok(number),
                Match::Weight(weight) => {
                    with_context = rule.has_context();
                    scratch.weights.push((weight, number));
                }
            }
        }
        Ok(match scratch.weights[..] {
            [] => STAYS,
            [(_, only)] => only,
            _ => draw(&scratch.weights, self.env(module).choice()),
        })
    }

    /// Whether a rule matches, and with which weight.
    fn weight(
        &self,
        rule: &Rule,
        module: usize,
        own: &[f64],
        scratch: &mut Scratch,
    ) -> Result<Match, Fault> {
        if rule.has_context() && !self.matches(rule, module, scratch) {
            return Ok(Match::No);
        }
        if rule.condition.is_none() && rule.weight.is_none() {
            return Ok(Match::Certain);
        }
        let mut stack = std::mem::take(&mut scratch.stack);
        let frame = if rule.gathers { self.frame(own, scratch) } else { own };
        let env = self.env(module);
        let found = (|| {
            if let Some(condition) = &rule.condition
                && condition.eval(frame, &env, &mut stack)? == 0.0
            {
                return Ok(Match::No);
            }
            let Some(weight) = &rule.weight else { return Ok(Match::Certain) };
            let weight = weight.eval(frame, &env, &mut stack)?;
            if weight < 0.0 {
                return Err(Fault(format!("the probability {weight}").into()));
            }
            Ok(if weight > 0.0 { Match::Weight(weight) } else { Match::No })
        })();
        scratch.stack = stack;
        found
    }

    /// Parameters of the module and of the contexts that were matched last.
    fn frame<'s>(&self, own: &[f64], scratch: &'s mut Scratch) -> &'s [f64] {
        scratch.frame.clear();
        scratch.frame.extend_from_slice(own);
        for &module in &scratch.matched {
            scratch.frame.extend_from_slice(self.params_of(module));
        }
        &scratch.frame
    }

    /// The same for a rule that is known to match.
    pub(super) fn gather<'s>(
        &self,
        rule: &Rule,
        module: usize,
        own: &[f64],
        scratch: &'s mut Scratch,
    ) -> &'s [f64] {
        self.matches(rule, module, scratch);
        self.frame(own, scratch)
    }
}

enum Match {
    No,
    Certain,
    Weight(f64),
}

/// Draws by weight with a number in [0, 1).
fn draw(weights: &[(f64, u16)], number: f64) -> u16 {
    let total: f64 = weights.iter().map(|&(weight, _)| weight).sum();
    let mut left = number * total;
    for &(weight, rule) in weights {
        left -= weight;
        if left < 0.0 {
            return rule;
        }
    }
    // Rounding may leave a crumb.
    weights.last().map_or(STAYS, |&(_, rule)| rule)
}
