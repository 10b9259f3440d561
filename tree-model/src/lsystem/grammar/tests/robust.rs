//! Hostile text gives an error or a grammar, and nothing else.

use super::super::Grammar;
use proptest::prelude::*;
use tree_core::{Control, Limits, Seed};

/// Pieces of which texts are made that are nearly right.
const PIECES: [&str; 44] = [
    "axiom: ",
    "A(1)",
    "F",
    "[",
    "]",
    "+",
    "-",
    "->",
    "-->",
    "→",
    "\n",
    ":",
    "A(x)",
    "(x*2)",
    "x",
    ">",
    "<",
    "1/x",
    "#define a 3\n",
    "#ignore +-\n",
    "steps: 3\n",
    " : ",
    ".5",
    "-(.5)->",
    "decomposition\n",
    "homomorphism\n",
    "*",
    "ε",
    "\\",
    "/",
    "//",
    "/*",
    "*/",
    "(",
    ")",
    ",",
    "=",
    "ran(2)",
    "if(x,1,2)",
    "B < A(x) > [C]D",
    "itNum",
    "sin(",
    "#symbols AB\n",
    "maximum depth: 3\n",
];

fn try_all(text: &str) {
    let limits = Limits { modules: 2_000, ..Limits::default() };
    let control = Control::default().with_limits(limits);
    if let Ok(grammar) = Grammar::parse(text, &limits)
        && let Ok(derived) = grammar.derive(Some(3), Seed(1), &control)
    {
        derived.word.check(grammar.symbols()).unwrap();
        assert!(derived.word.params().iter().all(|x| x.is_finite()));
        let again = grammar.word(&derived.word.text(grammar.symbols()));
        if let Ok(word) = again {
            assert_eq!(word, derived.word);
        }
        let _ = grammar.interpretation(&derived.word, Seed(1), &control);
    }
}

proptest! {
    #[test]
    fn any_text_is_read_without_panic(text in "\\PC{0,200}") {
        try_all(&text);
    }

    #[test]
    fn any_pieces_of_grammars_are_read_without_panic(
        pieces in prop::collection::vec(prop::sample::select(&PIECES[..]), 0..40),
    ) {
        try_all(&format!("axiom: A(1)F[B]\n{}", pieces.concat()));
        try_all(&pieces.concat());
    }
}

#[test]
fn a_hundred_thousand_brackets_are_no_danger() {
    let n = 100_000;
    let deep = format!("axiom: {}F{}\nF -> [F]", "[".repeat(n), "]".repeat(n));
    let grammar = Grammar::parse(&deep, &Limits::default()).unwrap();
    let word = grammar.derive(Some(2), Seed(1), &Control::default()).unwrap().word;
    assert_eq!(word.len(), 2 * n + 5);
    for text in [
        format!("axiom: {}", "[".repeat(n)),
        format!("axiom: F({}", "(".repeat(n)),
        format!("axiom: F({}1{})", "(".repeat(n), ")".repeat(n)),
        format!("axiom: F({}1{})", "sin(".repeat(n), ")".repeat(n)),
        format!("axiom: F\nF > {}F{} -> F", "[".repeat(n), "]".repeat(n)),
        format!("axiom: F\nF : {}1 -> F", "!".repeat(n)),
    ] {
        let error = Grammar::parse(&text, &Limits::default()).unwrap_err();
        assert!(matches!(error, crate::ModelError::Grammar { .. }), "{error}");
    }
}

#[test]
fn deep_branches_keep_their_contexts() {
    let n = 50_000;
    let text = format!("axiom: A{}B{}\nA < B -> C\nA > [B] -> D", "[".repeat(n), "]".repeat(n));
    let grammar = Grammar::parse(&text, &Limits::default()).unwrap();
    let word = grammar.derive(Some(1), Seed(1), &Control::default()).unwrap().word;
    let text = word.text(grammar.symbols());
    // B sits on A through all the brackets; the first of them begins with a branch and not with B.
    assert!(text.starts_with("A[") && text.contains("[C]"));
}
