//! Chances.

use super::{count, parse};
use tree_core::{Control, Seed};

/// χ² above which a right distribution lies once in a thousand, for 1, 2 and 3 degrees of freedom.
const ONE_IN_A_THOUSAND: [f64; 3] = [10.828, 13.816, 16.266];

/// χ² of the symbols B, C and so on in one step from 30,000 times A.
fn chi_square(rules: &str, weights: &[f64]) -> f64 {
    let n = 30_000;
    let grammar = parse(&format!("axiom: {}\n{rules}", "A".repeat(n)));
    let word = grammar.derive(Some(1), Seed(7), &Control::default()).unwrap().word;
    let total: f64 = weights.iter().sum();
    let terms = weights.iter().zip(["B", "C", "D", "E"]).map(|(weight, name)| {
        let expected = n as f64 * weight / total;
        let off = count(&grammar, &word, name) as f64 - expected;
        off * off / expected
    });
    terms.sum()
}

#[test]
fn frequencies_follow_the_weights() {
    for (rules, weights) in [
        ("A -(.33)-> B\nA -(.33)-> C\nA -(.34)-> D", &[0.33, 0.33, 0.34][..]),
        ("A -> B : 1\nA -> C : 5\nA -> D : 2\nA -> E : .1", &[1.0, 5.0, 2.0, 0.1]),
        ("p = .2\nA -> B : p\nA -> C : 1-p\nA -> D : 0", &[0.2, 0.8]),
    ] {
        let found = chi_square(rules, weights);
        assert!(found < ONE_IN_A_THOUSAND[weights.len() - 2], "{rules}: {found}");
    }
}

#[test]
fn only_productions_that_match_share_the_chance() {
    let rules = "A : 1 > 2 -> D : 100\nA -> B : 3\nA -> C : 1";
    assert!(chi_square(rules, &[3.0, 1.0]) < ONE_IN_A_THOUSAND[0]);
}

#[test]
fn weights_may_depend_on_parameters() {
    let grammar = parse("axiom: A(0)A(1)A(0)\nA(x) -> B : x\nA(x) -> C : 1-x");
    let word = grammar.derive(Some(1), Seed(3), &Control::default()).unwrap().word;
    assert_eq!(word.text(grammar.symbols()), "CBC");
}

#[test]
fn seeds_differ_and_the_same_seed_does_not() {
    let grammar = parse("axiom: F\nF -> F[+F]F : 1\nF -> F[-F]F : 1");
    let derive = |seed| grammar.derive(Some(6), Seed(seed), &Control::default()).unwrap().word;
    assert_eq!(derive(1), derive(1));
    assert_ne!(derive(1), derive(2));
}

#[test]
fn random_parameters_differ_by_module_step_and_draw() {
    let grammar = parse("axiom: A(0)A(0)\nA(x) -> A(rand)B(rand)");
    let word = grammar.derive(Some(2), Seed(1), &Control::default()).unwrap().word;
    let mut values = word.params().to_vec();
    values.sort_by(f64::total_cmp);
    values.dedup();
    assert_eq!(values.len(), 6);
    assert!(values.iter().all(|x| (0.0..1.0).contains(x)));
}

#[test]
fn a_random_axiom_follows_the_seed() {
    let grammar = parse("axiom: F(ran(1))");
    let derive = |seed| grammar.derive(None, Seed(seed), &Control::default()).unwrap().word;
    assert_ne!(derive(1), derive(2));
    assert_eq!(&derive(0), grammar.axiom());
}
