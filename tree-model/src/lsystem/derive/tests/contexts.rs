//! Contexts across branches, as in the book.

use super::{derived, parse};

#[test]
fn the_context_of_the_book_is_found_across_branches() {
    // ABOP p. 32: BC < S > G[H]M applies to S in ABC[DE][SG[HI[JK]L]MNO].
    let grammar = parse("axiom: ABC[DE][SG[HI[JK]L]MNO]\nBC < S > G[H]M -> X");
    assert_eq!(derived(&grammar, 1), "ABC[DE][XG[HI[JK]L]MNO]");
}

#[test]
fn near_misses_of_that_context_do_not_match() {
    for (axiom, context) in [
        ("ABC[DE][SG[HI[JK]L]MNO]", "BC < S > G[I]M"),
        ("ABC[DE][SG[HI[JK]L]MNO]", "C < S > G[HJ]"),
        ("ABC[DE][SG[HI[JK]L]MNO]", "E < S"),
        ("ABC[DE][SG[HI[JK]L]MNO]", "S > GH"),
        ("ABC[DE][SG[HI[JK]L]MNO]", "S > G[H][M]"),
        ("ABC[DE][SG[HI[JK]L]MNO]", "S > GMNOP"),
        ("AS[B]", "S > B"),
        ("S]".trim_end_matches(']'), "S > B"),
    ] {
        let grammar = parse(&format!("axiom: {axiom}\n{context} -> X"));
        assert_eq!(derived(&grammar, 1), axiom, "{context}");
    }
}

#[test]
fn branches_of_a_context_are_found_behind_others() {
    for context in ["S > [B]", "S > [A][C]D", "S > [B[E]]D", "S > D", "S > [[X]C]", "S > [BF]"] {
        let grammar = parse(&format!("axiom: S[A][B[E]F][[X]C]D\n{context} -> Y"));
        assert!(derived(&grammar, 1).starts_with('Y'), "{context}");
    }
}

#[test]
fn contexts_go_before_productions_without_them() {
    let grammar = parse("axiom: ABA\nA -> x\nB < A -> y");
    assert_eq!(derived(&grammar, 1), "xBy");
}

#[test]
fn a_signal_runs_up_and_another_down() {
    // ABOP p. 30, and the acropetal and basipetal signals of Fig. 1.30.
    let grammar = parse("axiom: baaaaaaaa\nb < a -> b\nb -> a");
    let words: Vec<String> = (0..3).map(|n| derived(&grammar, n)).collect();
    assert_eq!(words, ["baaaaaaaa", "abaaaaaaa", "aabaaaaaa"]);
    let up = parse("#ignore: +-\naxiom: J[+I]I[-I]I[+I]I\nJ < I -> J");
    let words: Vec<String> = (1..5).map(|n| derived(&up, n)).collect();
    assert_eq!(
        words,
        ["J[+J]J[-I]I[+I]I", "J[+J]J[-J]J[+I]I", "J[+J]J[-J]J[+J]J", "J[+J]J[-J]J[+J]J"]
    );
    let down = parse("ignore: +-\naxiom: I[+I]I[-I]I[+I]J\nI > J -> J");
    let words: Vec<String> = (1..5).map(|n| derived(&down, n)).collect();
    assert_eq!(
        words,
        ["I[+I]I[-I]J[+I]J", "I[+I]J[-I]J[+I]J", "J[+I]J[-I]J[+I]J", "J[+I]J[-I]J[+I]J"]
    );
}

#[test]
fn considered_symbols_are_the_only_neighbours() {
    let grammar = parse("#consider JI\naxiom: J+FI[-I]\nJ < I -> J");
    assert_eq!(derived(&grammar, 1), "J+FJ[-I]");
}

#[test]
fn hogewegs_and_hespers_plant_a_grows_as_computed_apart() {
    // ABOP Fig. 1.31 a. The strings and lengths are of a separate program that follows the definition.
    let grammar = parse(
        "#ignore: +-F\nω : F1F1F1\n\
         p1 : 0 < 0 > 0 -> 0\np2 : 0 < 0 > 1 -> 1[+F1F1]\np3 : 0 < 1 > 0 -> 1\np4 : 0 < 1 > 1 -> 1\n\
         p5 : 1 < 0 > 0 -> 0\np6 : 1 < 0 > 1 -> 1F1\np7 : 1 < 1 > 0 -> 0\np8 : 1 < 1 > 1 -> 0\n\
         p9 : * < + > * -> -\np10 : * < - > * -> +",
    );
    let words: Vec<String> = (0..6).map(|n| derived(&grammar, n)).collect();
    assert_eq!(
        words,
        ["F1F1F1", "F1F0F1", "F1F1F1F1", "F1F0F0F1", "F1F0F1[+F1F1]F1", "F1F1F1F1[-F0F1]F1"]
    );
    let long = derived(&grammar, 30);
    assert_eq!((long.len(), long.matches('F').count()), (6910, 2501));
}

#[test]
fn parameters_of_contexts_reach_conditions_and_successors() {
    // A substance spreads along the axis and into branches.
    let grammar = parse(
        "axiom: A(8)B(0)[B(1)]B(3)\nA(x) < B(y) > B(z) : z > y -> B(x+10*y+100*z)\nB(x) < B(y) -> B(y+x/2)",
    );
    assert_eq!(derived(&grammar, 1), "A(8)B(308)[B(1)]B(3)");
    let grammar = parse("axiom: S(1)[T(2)U(3)]V(4)W(5)\nS(a) > [T(b)U(c)]V(d) -> X(a,b,c,d)");
    assert_eq!(derived(&grammar, 1), "X(1,2,3,4)[T(2)U(3)]V(4)W(5)");
    let grammar = parse("axiom: S(1)T(2)U(3)\nS(a)T(b) < U(c) -> X(a,b,c)");
    assert_eq!(derived(&grammar, 1), "S(1)T(2)X(1,2,3)");
}
