//! Strings and counts of "The Algorithmic Beauty of Plants" and of Lluch et al. 2010.

use super::{count, derived, parse, word};
use tree_core::{Control, Seed};

#[test]
fn algae_grow_by_fibonacci_numbers() {
    let grammar = parse("axiom: b\nb -> a\na -> ab");
    let words: Vec<String> = (0..6).map(|n| derived(&grammar, n)).collect();
    assert_eq!(words, ["b", "a", "ab", "aba", "abaab", "abaababa"]);
    let derived = grammar.derive(Some(20), Seed(1), &Control::default()).unwrap();
    let lengths = &derived.report.modules;
    assert!(
        lengths.windows(3).all(|n| n[2] == n[0] + n[1]) && lengths[20] == 10_946,
        "{lengths:?}"
    );
    assert_eq!(derived.report.n_produced(), lengths[1..].iter().sum::<u64>());
}

#[test]
fn anabaena_divides_as_in_the_book() {
    // ABOP p. 5: a and b are sizes, l and r the polarities.
    let text = "#symbols ar al br bl\naxiom: ar\nar -> al br\nal -> bl ar\nbr -> ar\nbl -> al";
    let words: Vec<String> = (0..5).map(|n| derived(&parse(text), n)).collect();
    assert_eq!(words, ["ar", "albr", "blarar", "alalbralbr", "blarblararblarar"]);
}

#[test]
fn koch_curves_have_their_counts() {
    // ABOP Fig. 1.6, Fig. 1.9 a, Fig. 1.10 a (dragon), and the islands and lakes of Fig. 1.8.
    for (axiom, rules, steps, symbol, n) in [
        ("F-F-F-F", "F -> F-F+F+FF-F-F+F", 3, "F", 4 * 512),
        ("F-F-F-F", "F -> FF-F-F-F-F-F+F", 4, "F", 4 * 4096),
        ("l", "l -> l+r+\nr -> -l-r", 10, "l", 512),
        ("F+F+F+F", "F -> F+f-FF+F+FF+Ff+FF-f+FF-F-FF-Ff-FFF\nf -> ffffff", 2, "F", 4 * 18 * 18),
    ] {
        let grammar = parse(&format!("axiom: {axiom}\n{rules}"));
        assert_eq!(count(&grammar, &word(&grammar, steps), symbol), n, "{rules}");
    }
}

#[test]
fn bracketed_plants_have_their_counts() {
    // ABOP Fig. 1.24 a to f; for d, e and f the recurrences F' = 2 F + m X, X' = k X.
    for (steps, rules, n) in [
        (5, "axiom: F\nF -> F[+F]F[-F]F", 3125),
        (5, "axiom: F\nF -> F[+F]F[-F][F]", 3125),
        (4, "axiom: F\nF -> FF-[-F+F+F]+[+F-F-F]", 4096),
        (7, "axiom: X\nX -> F[+X]F[-X]+X\nF -> FF", 2 * (2187 - 128)),
        (7, "axiom: X\nX -> F[+X][-X]FX\nF -> FF", 2 * (2187 - 128)),
        (5, "axiom: X\nX -> F-[[X]+X]+F[+FX]-X\nF -> FF", 3 * (1024 - 32) / 2),
    ] {
        let grammar = parse(rules);
        assert_eq!(count(&grammar, &word(&grammar, steps), "F"), n, "{rules}");
    }
}

#[test]
fn the_parametric_example_gives_the_strings_of_the_book() {
    // ABOP (1.4) and Fig. 1.37.
    let grammar = parse(
        "ω : B(2)A(4,4)\np1 : A(x,y) : y<=3 -> A(x*2,x+y)\np2 : A(x,y) : y>3 -> B(x)A(x/y,0)\np3 : B(x) : x<1 -> C\np4 : B(x) : x>=1 -> B(x-1)",
    );
    let words: Vec<String> = (0..5).map(|n| derived(&grammar, n)).collect();
    let book = ["B(2)A(4,4)", "B(1)B(4)A(1,0)", "B(0)B(3)A(2,1)", "CB(2)A(4,3)", "CB(1)A(8,7)"];
    assert_eq!(words, book);
    assert_eq!(derived(&grammar, 5), format!("CB(0)B(8)A({},0)", 8.0 / 7.0));
}

/// Grammar (1) of Lluch et al. 2010.
const LLUCH: &str = "Axiom : A(1)\n\
    Rule1 : A(l) : itNum < maxIt -> B(l)[A(l/2)A(l/2)]\n\
    Rule2 : A(l) : itNum = maxIt -> B(l)";

#[test]
fn the_papers_grammar_gives_only_terminal_symbols() {
    // Derivations count from 1, so that Rule2 applies in the last of maxIt. Printed (2) lacks the children of
    // the second B(.5): no rewriting of all modules at once can give it (see the next test).
    assert_eq!(derived(&parse(LLUCH), 1), "B(1)");
    assert_eq!(derived(&parse(LLUCH), 2), "B(1)[B(0.5)B(0.5)]");
    assert_eq!(derived(&parse(LLUCH), 3), "B(1)[B(0.5)[B(0.25)B(0.25)]B(0.5)[B(0.25)B(0.25)]]");
}

#[test]
fn the_papers_chain_2_is_a_specimen_of_its_species() {
    // The same species with a chance to stop has printed chain (2) among its specimens.
    let text = "Axiom : A(1)\n\
        A(l) : itNum < maxIt -> B(l)[A(l/2)A(l/2)] : .7\n\
        A(l) : itNum < maxIt -> B(l) : .3\n\
        A(l) : itNum = maxIt -> B(l)";
    let grammar = parse(text);
    let printed = "B(1)[B(0.5)[B(0.25)B(0.25)]B(0.5)]";
    let specimen = |seed| {
        let derived = grammar.derive(Some(3), Seed(seed), &Control::default()).unwrap();
        derived.word.text(grammar.symbols())
    };
    assert!((0..100).any(|seed| specimen(seed) == printed));
}
