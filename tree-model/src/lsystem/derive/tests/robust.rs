//! Threads, budgets, faults and cancellation.

use super::{derived, parse, word};
use crate::ModelError;
use crate::lsystem::Grammar;
use proptest::prelude::*;
use tree_core::{CancelFlag, Control, LimitError, Limits, Resource, Seed};

fn on_threads(n: usize, grammar: &Grammar, steps: u32, seed: u64) -> crate::lsystem::Word {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
    pool.install(|| grammar.derive(Some(steps), Seed(seed), &Control::default())).unwrap().word
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    for text in [
        "axiom: A(1,1)\nA(l,w) -> !(w)F(l)[&(45)A(l*.7,w*.6)]/(120)[&(45)A(l*.7,w*.6)]/(120)A(l*.7,w*.6)",
        "axiom: A(1)\nA(l) -> F(l)[+(ran(30))A(l*.7)]A(l*nran(.8,.1)) : 2\nA(l) -> F(l)[-A(l)]A(l*.9) : 1",
        "axiom: A(1)\nA(l) -> F(l)[+A(l)][-A(l)]\nF(a) < F(b) > [+F(c)] -> F(a+b*c)\nF(a) < F(b) -> F(a+b)",
        "axiom: A\nA -> [B]A[B]A\ndecomposition\nmaximum depth: 3\nB -> C(rand)B\n",
    ] {
        let grammar = parse(text);
        let steps = (1..).find(|&n| word(&grammar, n).len() > 40_000).unwrap();
        let one = on_threads(1, &grammar, steps, 5);
        assert!(one.len() > 40_000);
        assert_eq!(one, on_threads(3, &grammar, steps, 5), "{text}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn words_survive_their_text(seed in any::<u64>(), steps in 0_u32..7) {
        let grammar = parse("axiom: A(1)\nA(l) -> F(l)[+(ran(30))A(l*.7)]A(l*nran(.8,.1)) : 2\nA(l) -> F(l/3)A(l*.9) : 1");
        let word = grammar.derive(Some(steps), Seed(seed), &Control::default()).unwrap().word;
        word.check(grammar.symbols()).unwrap();
        prop_assert_eq!(grammar.word(&word.text(grammar.symbols())).unwrap(), word);
    }

    #[test]
    fn steps_one_by_one_are_the_derivation(seed in any::<u64>(), steps in 1_u32..7) {
        let grammar = parse("axiom: A(1)\nA(l) : itNum < maxIt -> F(rand)[A(l/2)]A(l/2) : 2\nA(l) -> B(l) : 1\ndecomposition\nB(l) -> CB(l)");
        let control = Control::default();
        let mut word = grammar.axiom().clone();
        for step in 0..steps {
            word = grammar.step(&word, step, steps, Seed(seed), &control).unwrap();
        }
        prop_assert_eq!(grammar.derive(Some(steps), Seed(seed), &control).unwrap().word, word);
    }
}

#[test]
fn runaway_growth_stops_at_the_budget_with_the_exact_number() {
    let grammar = parse("axiom: F\nF -> FFFFFFFFFF");
    let limits = Limits { modules: 5_000, ..Limits::default() };
    let control = Control::default().with_limits(limits);
    match grammar.derive(Some(1000), Seed(1), &control) {
        Err(ModelError::Limit(LimitError { resource, requested, cap })) => {
            assert_eq!((resource, requested, cap), (Resource::Modules, 10_000, 5_000));
        }
        other => panic!("{other:?}"),
    }
    // Parameters weigh as well.
    let grammar = parse(
        "axiom: F(1)\nF(x) -> F(x,x,x,x,x,x,x,x)\nF(a,b,c,d,e,f,g,h) -> F(a)F(a)F(a)F(a)F(a)F(a)F(a)F(a)",
    );
    assert!(matches!(grammar.derive(Some(20), Seed(1), &control), Err(ModelError::Limit(_))));
}

#[test]
fn faults_name_module_and_production() {
    let fault =
        |text: &str, steps| match parse(text).derive(Some(steps), Seed(1), &Control::default()) {
            Err(ModelError::Word { module, problem }) => (module, problem),
            other => panic!("{text}: {other:?}"),
        };
    let (module, problem) = fault("axiom: FA(2)\np1: A(x) -> A(x-1)B(1/x)", 3);
    assert_eq!((module, problem.as_str()), (1, "division by zero in p1 (line 2) of A(0)"));
    let (module, problem) = fault("axiom: F(1e200)\nF(x) -> F(x*x)", 2);
    assert_eq!(module, 0);
    assert!(
        problem.ends_with("is inf in production 1 (line 2) of F(1".to_owned().as_str())
            || problem.contains("is inf in production 1 (line 2)"),
        "{problem}"
    );
    let (_, problem) = fault("axiom: F(1)\nF(x) : log(x-2) > 0 -> F(x)", 1);
    assert!(problem.contains("log(-1) is NaN"), "{problem}");
    let (_, problem) = fault("axiom: F(1)\nF(x) -> F(x) : -x", 1);
    assert!(problem.contains("the probability -1"), "{problem}");
}

#[test]
fn the_first_fault_is_reported_on_any_number_of_threads() {
    let grammar = parse("axiom: A(40000)\nA(x) -> A(x/2)A(x/2)\nA(x) : x < 0 -> B(1/0)\n");
    let bad = parse(&format!("axiom: {}A(1)A(0)A(0)\nA(x) -> B(1/x)", "A(1)".repeat(30_000)));
    assert_eq!(word(&grammar, 3).len(), 8);
    for n in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
        let error = pool.install(|| bad.derive(Some(1), Seed(1), &Control::default())).unwrap_err();
        assert!(matches!(error, ModelError::Word { module: 30_001, .. }), "{error}");
    }
}

#[test]
fn cancelled_work_stops() {
    let flag = CancelFlag::default();
    flag.cancel();
    let control = Control::default().with_cancel(flag);
    let grammar = parse("axiom: F\nF -> FF");
    assert!(matches!(grammar.derive(Some(9), Seed(1), &control), Err(ModelError::Cancelled(_))));
}

#[test]
fn words_of_another_grammar_are_refused() {
    let grammar = parse("axiom: F\nF -> FF");
    let other = parse("axiom: [A(1)B(2)C(3)D(4)]").axiom().clone();
    assert!(grammar.step(&other, 0, 1, Seed(1), &Control::default()).is_err());
    assert!(grammar.interpretation(&other, Seed(1), &Control::default()).is_err());
}

#[test]
fn words_that_no_production_matches_stay() {
    assert_eq!(derived(&parse("axiom: A(1)B[C]\nA(x) : x > 1 -> D\nX -> Y"), 50), "A(1)B[C]");
}
