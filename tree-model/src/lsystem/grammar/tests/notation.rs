//! The notation of the books and programs, and what it means.

use super::{derived, parse};
use tree_core::Seed;

#[test]
fn settings_are_read_in_all_their_spellings() {
    for text in [
        "steps: 7\nangle: 25.7\nseed: 3\naxiom: F",
        "derivation length: 7\nAngle : 25.7°\nSeed = 3\nAxiom : F",
        "n: 7\nδ: 25.7\nseed: 1+2\nω : F",
        "Lsystem: 1\nseed: 3\n#define N 6\nderivation   length: N+1\ndelta: 25.7\nw: F\nendlsystem\nnothing -> of this (counts",
    ] {
        // The last text has an open bracket behind its end, which is a mistake wherever it stands.
        let text = text.replace("(counts", "counts");
        let grammar = parse(&text);
        assert_eq!(grammar.steps(), 7, "{text}");
        assert_eq!(grammar.angle(), 25.7, "{text}");
        assert_eq!(grammar.seed().0, 3, "{text}");
        assert_eq!(grammar.axiom().text(grammar.symbols()), "F", "{text}");
    }
}

#[test]
fn comments_are_no_part_of_the_text() {
    let grammar = parse(
        "/* a tree\n of comments */ axiom: F // begins\n// alone\nF -> F /* a\nb */ F // both\n",
    );
    assert_eq!(derived(&grammar, 1), "FF");
}

#[test]
fn several_strokes_behind_a_module_are_rolls() {
    // ABOP p. 26.
    let grammar = parse("axiom: A\nA -> [&FL!A]/////'[&FL!A]///////'[&FL!A]");
    assert_eq!(derived(&grammar, 1).matches('/').count(), 12);
}

#[test]
fn statements_continue_behind_open_brackets_backslashes_and_arrows() {
    let grammar = parse(
        "axiom: A(\n 1)\nA(x) : x > 0\n  --> B(x,\n 2)[\n C]\\\nG\nD -->\n E\nB(x,y) -->\n\n F\nC -->",
    );
    assert_eq!(grammar.n_productions(), 4);
    assert_eq!(derived(&parse("axiom: D\nD ->\n E\nF ->\nF -> F"), 1), "E");
    assert_eq!(derived(&grammar, 0), "A(1)");
}

#[test]
fn a_backslash_at_the_end_of_a_line_is_no_roll() {
    let grammar = parse("axiom: A\nA -> B\\C\\\nD\n");
    assert_eq!(derived(&grammar, 1), "B\\CD");
}

#[test]
fn constants_are_expressions_of_those_before() {
    let grammar = parse("#define a 30\nb = a/2 + 1\naxiom: F(b)\nangle = b");
    assert_eq!(derived(&grammar, 0), "F(16)");
    assert_eq!(
        grammar.constants().collect::<Vec<_>>(),
        [("a", 30.0), ("angle", 16.0), ("b", 16.0)]
    );
}

#[test]
fn a_constant_set_later_changes_all_that_depends_on_it() {
    let mut grammar = parse("#define a 30\nb = a/2\nsteps: b\naxiom: F(a)\nF(x) -> F(x+b)");
    grammar.set_constant("a", 4.0).unwrap();
    assert_eq!((grammar.steps(), derived(&grammar, 1)), (2, "F(6)".into()));
    grammar.set_constant("b", 1.0).unwrap();
    grammar.set_constant("angle", 12.5).unwrap();
    assert_eq!((grammar.steps(), derived(&grammar, 1)), (1, "F(5)".into()));
    assert_eq!(grammar.angle(), 12.5);
    let error = grammar.set_constant("c", 1.0).unwrap_err().to_string();
    assert!(error.contains("no constant 'c'"), "{error}");
    assert!(grammar.set_constant("a", f64::NAN).is_err());
    assert!(grammar.set_constant("steps", -1.0).is_err());
    grammar.set_constant("steps", 3.5).unwrap();
    assert_eq!(grammar.steps(), 3);
    assert_eq!(derived(&grammar, 0), "F(4)");
}

#[test]
fn declared_names_may_have_several_characters() {
    let grammar = parse("axiom: Apex(1)AF\nApex(x) -> Fl[Fl Apex(x/2)]\n#symbols Apex, Fl");
    assert_eq!(derived(&grammar, 1), "Fl[FlApex(0.5)]AF");
    assert_eq!(grammar.axiom().len(), 3);
}

#[test]
fn labels_and_conditions_are_told_apart() {
    let grammar = parse(
        "#define big 2\naxiom: ABCDE(1)\np1: A -> a\nB : * -> b\nC : big > 1 -> c\nx : D : big < 1 -> d\nE(x) : x == 1 -> e",
    );
    assert_eq!(derived(&grammar, 1), "abcDe");
}

#[test]
fn successors_may_be_empty() {
    let grammar = parse("axiom: ABCD\nA -> ε\nB ->\nC -> \nD → d");
    assert_eq!(derived(&grammar, 1), "d");
}

#[test]
fn probabilities_stand_at_the_arrow_or_at_the_end() {
    for text in [
        "F -(1/3)-> A\nF -(0)-> B",
        "F -.33-> A\nF --.0--> B",
        "F --(.33)--> A\nF -(p)-> B",
        "F -> A : .33\nF -> B : p",
        "q: F : * -(1)-> A\nF : p == 0 -> B : p",
        "F -> B : 0\nF : 1 - (p) -> A",
    ] {
        let grammar = parse(&format!("p = 0\naxiom: F\n{text}"));
        assert_eq!(derived(&grammar, 1), "A", "{text}");
    }
}

#[test]
fn sections_hold_rules_of_their_own() {
    let grammar = parse(
        "axiom: A\nA -> BA\ndecomposition\nmaximum depth: 2\nB -> CB\nhomomorphism\nmaximum depth: 5\nC -> F[+D]\nD -> FE\nE -> f\nproductions\nC -> c",
    );
    // B becomes CB, and CCB at depth 2, after every step; C becomes c in the next step.
    assert_eq!(derived(&grammar, 1), "CCBA");
    assert_eq!(derived(&grammar, 2), "ccCCBCCBA");
    let word = grammar.word("CC").unwrap();
    let seen = grammar.interpretation(&word, Seed(1), &Default::default()).unwrap();
    assert_eq!(seen.text(grammar.symbols()), "F[+Ff]F[+Ff]");
}

#[test]
fn signs_of_typeset_books_are_those_of_a_keyboard() {
    let grammar = parse("axiom: F−F\nF → F∧F−’G(2−1)");
    assert_eq!(derived(&grammar, 1), "F^F-'G(1)-F^F-'G(1)");
}

#[test]
fn words_of_the_grammar_are_read() {
    let grammar = parse("axiom: F(1)[+F(2)]");
    assert_eq!(grammar.word("F(3)[F(4)]").unwrap().len(), 4);
    assert!(
        grammar.word("F(3)G").unwrap_err().to_string().contains("no module 'G' with 0 parameters")
    );
    assert!(grammar.word("F(3)[").unwrap_err().to_string().contains("without a ']'"));
}

#[test]
fn the_text_of_a_grammar_gives_the_same_grammar() {
    let text =
        "#define r .7\naxiom: A(1)\nA(l) : l > .1 -> F(l)[+A(l*r)]A(l*r) : 2\nA(l) -> F(l) : 1";
    let grammar = parse(text);
    assert_eq!(derived(&parse(grammar.text()), 5), derived(&grammar, 5));
}
