//! Mistakes are reported with line, column and a hint.

use super::super::Grammar;
use crate::ModelError;
use tree_core::Limits;

fn mistake(text: &str) -> (usize, usize, String) {
    match Grammar::parse(text, &Limits::default()) {
        Err(ModelError::Grammar { line, column, problem, hint }) => {
            (line, column, format!("{problem}; {hint}"))
        }
        other => panic!("{text}: {other:?}"),
    }
}

#[track_caller]
fn is(text: &str, line: usize, column: usize, says: &str) {
    let (l, c, problem) = mistake(text);
    assert_eq!((l, c), (line, column), "{text}: {problem}");
    assert!(problem.contains(says), "{text}: {problem}");
}

#[test]
fn unknown_names_get_a_proposal() {
    is("#define length 2\naxiom: F(lenght)", 2, 10, "did you mean 'length'?");
    is("axiom: F(x)\n", 1, 10, "nothing is named 'x'");
    is("axiom: A(1)\nA(l) -> F(I)", 2, 11, "known are l");
    is("axiom: A(1)\nA(l) -> F(sinn(l))", 2, 11, "did you mean 'sin'?");
    is("axiom: F\n#defin a 3", 2, 1, "did you mean 'define'?");
    is("axioma: F", 1, 1, "did you mean 'axiom'?");
}

#[test]
fn wrong_numbers_of_parameters_name_the_production() {
    let text = "axiom: A(1)\np1: A(l) -> F(l)A(l,\n 2)";
    is(text, 2, 17, "'A' takes 1 parameter in p1, here it has 2");
    is("axiom: A\nA(l) -> F", 1, 8, "'A' takes 1 parameter in production 1, here it has 0");
    // Symbols without productions may have any number, and productions for several numbers are fine.
    assert!(Grammar::parse("axiom: A(1)AF\nA(l) -> F(l)\nA -> F", &Limits::default()).is_ok());
}

#[test]
fn unclosed_brackets_are_named_where_they_open() {
    is("axiom: A\nA -> F[+A\nB -> C", 2, 7, "'[' is never closed");
    is("axiom: F(1\n", 1, 9, "'(' is never closed");
    is("axiom: F]", 1, 9, "']' without a '[' before it");
    is("axiom: F[(1])", 1, 12, "']' does not fit");
    is("axiom: F /* and\nmore", 1, 10, "the comment is never closed");
}

#[test]
fn wrong_predecessors_are_explained() {
    is("axiom: F\np1: A(x,\n x) -> F", 3, 2, "'x' stands here twice");
    is("axiom: F\nB(x) < A(x) -> F", 2, 10, "'x' stands here twice");
    is("axiom: F\nAB -> F", 2, 2, "a production replaces one module");
    is("axiom: F\nA(1) -> F", 2, 3, "a number in a predecessor");
    is("axiom: F\n -> F", 2, 3, "'>' where a symbol was expected");
    is("axiom: F\n\n: A -> F", 3, 1, "no predecessor");
    is("axiom: F\np: > A -> B", 2, 4, "no predecessor");
    is("axiom: F\n] -> F", 2, 1, "']' without a '['");
    is("axiom: F\nA[B] < C -> F", 2, 2, "a bracket in a left context");
    is("axiom: F\na : b : c : d -> F", 2, 11, "a third ':'");
    is("#ignore F\naxiom: F\nF < A -> F", 3, 1, "contexts ignore 'F'");
    is("axiom: F\ndecomposition\nF < A -> F", 3, 1, "a context outside the productions");
}

#[test]
fn wrong_successors_are_explained() {
    is("axiom: F\nF -> F*2", 2, 7, "'*' where a symbol was expected");
    is("axiom: F\nF -> F = 2", 2, 8, "'=' where a symbol was expected");
    is("axiom: F\nF -> F() F", 2, 8, "')' where a number, a name or '('");
    is("axiom: F\nF -> F,F", 2, 7, "',' where a symbol was expected");
    is("axiom: F\nF -(.5)-> F : 2", 2, 13, "a second probability");
    is("axiom: F\nF -> F : 2 3", 2, 12, "'3' where the end of the statement");
    is("axiom: F\nF -> F\u{1}", 2, 7, "'\\u{1}' where a symbol");
}

#[test]
fn wrong_settings_are_explained() {
    is("F -> FF", 1, 8, "the grammar has no axiom");
    is("axiom:\nF -> F", 1, 7, "the axiom is empty");
    is("axiom: F\naxiom: G", 2, 7, "a second axiom");
    is("axiom: F\nsteps: 2.5", 2, 7, "a whole number");
    is("axiom: F\nsteps: -1", 2, 8, "allowed is 0 to");
    is("axiom: F\nsteps: 1e9", 2, 8, "allowed is 0 to 1000000");
    is("axiom: F\na = 1/0", 2, 5, "division by zero");
    is("axiom: F\na = ran(2)", 2, 5, "a constant cannot be random");
    is(&format!("#symbols A {}\naxiom: F", "A".repeat(65)), 1, 12, "more than 64 bytes");
    is("#symbols A(\naxiom: F", 1, 10, "'(' cannot be part of a symbol");
    is("axiom: F\n#define f(x) x", 2, 9, "has parameters");
    is("axiom: F\nmaximum depth: 3", 2, 15, "write it after 'decomposition'");
    is("axiom: F\n#ignore F\n#consider G", 3, 11, "both 'ignore' and 'consider'");
    is("axiom: F\nhello world", 2, 1, "neither a production nor a setting");
}

#[test]
fn columns_count_characters() {
    is("axiom: F\nF → ε[αβ(z)]", 2, 10, "nothing is named 'z'");
}

#[test]
fn long_texts_are_refused_before_they_are_read() {
    let limits = Limits { input_bytes: 10, ..Limits::default() };
    assert!(matches!(Grammar::parse("axiom: FFFFFF", &limits), Err(ModelError::Limit(_))));
}
