//! Numbers of parameters: a symbol that has productions, but none for the number of parameters with
//! which it stands in a word, is a slip of the pen.

use super::modules::Use;
use super::rules::Rule;
use crate::error::Result;
use crate::lsystem::Symbols;
use crate::lsystem::text::Source;
use std::collections::BTreeMap;

/// Compares the modules used with the predecessors of all rules.
pub(super) fn check<'a>(
    source: &Source<'_>,
    symbols: &Symbols,
    rules: impl Iterator<Item = &'a (crate::lsystem::Kind, String)>,
    uses: &[Use],
) -> Result<()> {
    // By name: the numbers of parameters and the rule that has them.
    let mut known: BTreeMap<&str, BTreeMap<usize, &str>> = BTreeMap::new();
    for (kind, rule) in rules {
        if let Some((name, n)) = symbols.get(*kind) {
            known.entry(name).or_default().entry(n).or_insert(rule);
        }
    }
    for module in uses {
        let Some((name, n)) = symbols.get(module.kind) else { continue };
        let Some(counts) = known.get(name) else { continue };
        if counts.contains_key(&n) {
            continue;
        }
        let takes: Vec<String> = counts
            .iter()
            .map(|(&n, rule)| format!("{n} parameter{} in {rule}", if n == 1 { "" } else { "s" }))
            .collect();
        let problem = format!("'{name}' takes {}, here it has {n}", takes.join(", "));
        return Err(source.error(module.at, problem, "give all of them the same number"));
    }
    Ok(())
}

/// What a rule adds to the comparison.
pub(super) fn entry(rule: &Rule) -> (crate::lsystem::Kind, String) {
    (rule.kind, rule.name.clone())
}
