//! Stochastic productions: frequencies by the χ² test.

use super::{Outcome, information};
use crate::table::{Aim, Row, Table};
use tree_core::{Control, Limits, Seed};
use tree_model::lsystem::{Grammar, Kind};

/// Modules that are rewritten at once.
const MODULES: usize = 30_000;
/// Seeds; their χ² add up.
const SEEDS: u64 = 20;

/// Productions of A with their weights.
struct Case {
    name: &'static str,
    weights: &'static [f64],
    /// χ² that a right distribution exceeds once in a thousand: for one seed, for all of them together, and for
    /// neighbours that do not depend on each other.
    one: f64,
    all: f64,
    pairs: f64,
}

/// Degrees of freedom: 2, 40 and 4; 3, 60 and 9.
const CASES: [Case; 2] = [
    Case {
        name: "weights of ABOP Fig. 1.27: .33, .33, .34",
        weights: &[0.33, 0.33, 0.34],
        one: 13.816,
        all: 73.402,
        pairs: 18.467,
    },
    Case {
        name: "weights 1, 5, 2, .5",
        weights: &[1.0, 5.0, 2.0, 0.5],
        one: 16.266,
        all: 99.607,
        pairs: 27.877,
    },
];

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    for case in &CASES {
        let (mut all, mut worst) = (0.0, 0.0_f64);
        let n = case.weights.len();
        let mut pairs = vec![0.0; n * n];
        let mut counts = vec![0.0; n];
        for seed in 0..SEEDS {
            let chosen = chosen(case.weights, Seed(seed))?;
            let mut of_seed = vec![0.0; n];
            chosen.iter().for_each(|&which| of_seed[which] += 1.0);
            let found = chi_square(&of_seed, &expected(case.weights));
            all += found;
            worst = worst.max(found);
            counts.iter_mut().zip(&of_seed).for_each(|(sum, n)| *sum += n);
            chosen.windows(2).for_each(|pair| pairs[pair[0] * n + pair[1]] += 1.0);
        }
        let total: f64 = counts.iter().sum();
        let n_pairs: f64 = pairs.iter().sum();
        let alone = |at: usize| counts[at] / total;
        let independent: Vec<f64> =
            (0..n * n).map(|i| n_pairs * alone(i / n) * alone(i % n)).collect();
        let title = format!("{}, {SEEDS} x {MODULES} times", case.name);
        let mut row = |metric: &str, ours: f64, most: f64| {
            let aim = Aim::AtMost(most);
            let (paper, peer) = (None, None);
            table.row(&Row { case: &title, metric, paper, peer, ours, unit: "χ²", aim });
        };
        row("frequencies, first seed", first(case)?, case.one);
        row("frequencies, all seeds", all, case.all);
        row("neighbours independent", chi_square(&pairs, &independent), case.pairs);
        information(table, &title, "frequencies, worst seed", worst, "χ²");
    }
    Ok(())
}

fn first(case: &Case) -> Outcome<f64> {
    let mut counts = vec![0.0; case.weights.len()];
    chosen(case.weights, Seed(0))?.iter().for_each(|&which| counts[which] += 1.0);
    Ok(chi_square(&counts, &expected(case.weights)))
}

fn expected(weights: &[f64]) -> Vec<f64> {
    let total: f64 = weights.iter().sum();
    weights.iter().map(|weight| MODULES as f64 * weight / total).collect()
}

fn chi_square(counts: &[f64], expected: &[f64]) -> f64 {
    counts
        .iter()
        .zip(expected)
        .map(|(n, expected)| (n - expected) * (n - expected) / expected)
        .sum()
}

/// Which production each A of the axiom was rewritten by.
fn chosen(weights: &[f64], seed: Seed) -> Outcome<Vec<usize>> {
    let names = ["B", "C", "D", "E"];
    let rules = weights.iter().zip(names).map(|(weight, name)| format!("\nA -> {name} : {weight}"));
    let text = format!("axiom: {}{}", "A".repeat(MODULES), rules.collect::<String>());
    let grammar = Grammar::parse(&text, &Limits::default())?;
    let word = grammar.derive(Some(1), seed, &Control::default())?.word;
    let kinds: Vec<_> = names.map(|name| grammar.symbols().find(name, 0)).into_iter().collect();
    let which = |kind: &Kind| kinds.iter().position(|k| k.as_ref() == Some(kind));
    word.kinds().iter().map(|kind| which(kind).ok_or_else(|| "an A is left".into())).collect()
}
