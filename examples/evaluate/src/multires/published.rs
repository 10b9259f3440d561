//! Derived words against printed ones: strings, counts and constants of the paper, the thesis and the book.

use super::Outcome;
use crate::table::{Aim, Row, Table};
use tree_core::{Control, Limits, Seed};
use tree_model::lsystem::word::Word;
use tree_model::lsystem::{Grammar, Preset};

/// Grammar (1) of Lluch et al. with a chance to stop, and chain (2), which is one of its specimens: rewriting all modules
/// at once without chance gives both B(0.5) their children.
const SPECIES: &str = "axiom: A(1)\n\
    A(l) : itNum < maxIt -> B(l)[A(l/2)A(l/2)] : .7\n\
    A(l) : itNum < maxIt -> B(l) : .3\n\
    A(l) : itNum = maxIt -> B(l)";
const CHAIN_2: &str = "B(1)[B(0.5)[B(0.25)B(0.25)]B(0.5)]";
/// Seeds among which it must be.
const SPECIMENS: u64 = 100;

/// A grammar, and its words from the axiom on, as printed.
struct Words {
    case: &'static str,
    grammar: &'static str,
    words: &'static [&'static str],
}

const WORDS: [Words; 3] = [
    Words {
        case: "algae (ABOP 1.1)",
        grammar: "axiom: b\nb -> a\na -> ab",
        words: &["b", "a", "ab", "aba", "abaab", "abaababa"],
    },
    Words {
        case: "Anabaena catenula (ABOP p. 5)",
        grammar: "#symbols ar al br bl\naxiom: ar\nar -> al br\nal -> bl ar\nbr -> ar\nbl -> al",
        words: &["ar", "albr", "blarar", "alalbralbr", "blarblararblarar"],
    },
    Words {
        case: "parametric example (ABOP Fig. 1.37)",
        grammar: "axiom: B(2)A(4,4)\nA(x,y) : y<=3 -> A(x*2,x+y)\nA(x,y) : y>3 -> B(x)A(x/y,0)\n\
            B(x) : x<1 -> C\nB(x) : x>=1 -> B(x-1)",
        words: &["B(2)A(4,4)", "B(1)B(4)A(1,0)", "B(0)B(3)A(2,1)", "CB(2)A(4,3)", "CB(1)A(8,7)"],
    },
];

/// Presets after one derivation, as their printed productions give it by hand. W is ten times the width ratio of .707.
const FIRST: [(&str, &str); 6] = [
    ("thesis-a", "F[+F]F[-F]F"),
    ("thesis-b", "F[+X][-X]FX"),
    ("thesis-c", "F[[X]-X]F[+FX]"),
    ("honda-a", "!(10)F(1)[&(45)B(0.6,W)]/(137.5)A(0.9,W)"),
    ("aono-kunii-a", "!(10)F(1)[&(5)B(0.9,W)]/(180)[&(65)B(0.7,W)]"),
    (
        "ternary-a",
        "!(1.732)F(221.8)/(45)!(1.732)F(50)[&(18.95)F(50)A]/(94.74)[&(18.95)F(50)A]/(132.63)[&(18.95)F(50)A]",
    ),
];

/// Presets, derivations, parameters of F, and the number of F that the recurrences of their productions give: five of
/// one; k(3ⁿ − 2ⁿ) where each X makes k of F and three of X, and each F two; an internode an apex for Honda's and
/// Aono's, of which there are 2ⁿ; four an apex, of which there are 3ⁿ, for the ternary trees.
const COUNTS: [(&str, u32, usize, usize); 6] = [
    ("thesis-a", 5, 0, 3125),
    ("thesis-b", 5, 0, 2 * (243 - 32)),
    ("thesis-c", 7, 0, 3 * (2187 - 128)),
    ("honda-a", 10, 1, 1023),
    ("aono-kunii-a", 10, 1, 1023),
    ("ternary-a", 6, 1, 1 + 2 * (729 - 1)),
];

/// Tables 2.1 to 2.3 of ABOP, as other people's programs have them too (J. Leech's lsys, J. Heck's Lindenmayer): a preset
/// with its constants.
const TABLES: [(&str, &[&str], &[f64]); 12] = [
    ("honda-a", &MONOPODIAL, &[0.9, 0.6, 45.0, 45.0, 137.5, 0.707]),
    ("honda-b", &MONOPODIAL, &[0.9, 0.9, 45.0, 45.0, 137.5, 0.707]),
    ("honda-c", &MONOPODIAL, &[0.9, 0.8, 45.0, 45.0, 137.5, 0.707]),
    ("honda-d", &MONOPODIAL, &[0.9, 0.7, 30.0, -30.0, 137.5, 0.707]),
    ("aono-kunii-a", &SYMPODIAL, &[0.9, 0.7, 5.0, 65.0, 0.707]),
    ("aono-kunii-b", &SYMPODIAL, &[0.9, 0.7, 10.0, 60.0, 0.707]),
    ("aono-kunii-c", &SYMPODIAL, &[0.9, 0.8, 20.0, 50.0, 0.707]),
    ("aono-kunii-d", &SYMPODIAL, &[0.9, 0.8, 35.0, 35.0, 0.707]),
    ("ternary-a", &TERNARY, &[94.74, 132.63, 18.95, 1.109, 1.732, 0.0, -1.0, 0.0, 0.22, 6.0]),
    ("ternary-b", &TERNARY, &[137.5, 137.5, 18.95, 1.109, 1.732, 0.0, -1.0, 0.0, 0.14, 8.0]),
    ("ternary-c", &TERNARY, &[112.5, 157.5, 22.5, 1.79, 1.732, -0.02, -1.0, 0.0, 0.27, 8.0]),
    ("ternary-d", &TERNARY, &[180.0, 252.0, 36.0, 1.07, 1.732, -0.61, 0.77, -0.19, 0.4, 6.0]),
];
const MONOPODIAL: [&str; 6] = ["r1", "r2", "a0", "a2", "d", "wr"];
const SYMPODIAL: [&str; 5] = ["r1", "r2", "a1", "a2", "wr"];
const TERNARY: [&str; 10] =
    ["d1", "d2", "a", "lr", "vr", "tropism_x", "tropism_y", "tropism_z", "elasticity", "steps"];

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    let species = parse(SPECIES)?;
    let found = (0..SPECIMENS).map(|seed| derived(&species, 3, Seed(seed)));
    let found = found.collect::<Outcome<Vec<_>>>()?;
    let n = found.iter().filter(|word| word.text(species.symbols()) == CHAIN_2).count();
    all(table, "chain (2) of the paper", "is a specimen of its species", n.min(1), 1);
    for Words { case, grammar, words } in &WORDS {
        let grammar = parse(grammar)?;
        let mut n = 0;
        for (steps, printed) in (0..).zip(*words) {
            n +=
                usize::from(derived(&grammar, steps, Seed(1))?.text(grammar.symbols()) == *printed);
        }
        all(table, case, "words as printed", n, words.len());
    }
    for (name, printed) in FIRST {
        let grammar = Preset::find(name)?.system()?.grammar;
        let text = derived(&grammar, 1, Seed(1))?.text(grammar.symbols());
        // As numbers of 64 bits have it.
        let printed = printed.replace('W', &(10.0 * 0.707).to_string());
        all(table, name, "first word as by hand", usize::from(text == printed), 1);
    }
    for (name, steps, n_params, expected) in COUNTS {
        let grammar = Preset::find(name)?.system()?.grammar;
        let word = derived(&grammar, steps, Seed(1))?;
        let kind = grammar.symbols().find("F", n_params).ok_or("a grammar without F")?;
        let n = word.kinds().iter().filter(|&&k| k == kind).count();
        let case = format!("{name}, {steps} derivations");
        let (ours, paper) = (n as f64, Some(expected as f64));
        let metric = "F off the textbook's count";
        let off = (ours - expected as f64).abs();
        let peer = Some(ours);
        table.row(&Row {
            case: &case,
            metric,
            paper,
            peer,
            ours: off,
            unit: "",
            aim: Aim::AtMost(0.0),
        });
    }
    constants(table)
}

/// Constants of the presets that are those of the tables.
fn constants(table: &mut Table) -> Outcome {
    let (mut n, mut n_all) = (0, 0);
    for (name, names, values) in TABLES {
        let grammar = Preset::find(name)?.system()?.grammar;
        for (constant, value) in names.iter().zip(values) {
            n_all += 1;
            let ours = match *constant {
                "steps" => Some(f64::from(grammar.steps())),
                constant => grammar.constants().find(|c| c.0 == constant).map(|c| c.1),
            };
            if ours == Some(*value) {
                n += 1;
            } else {
                eprintln!("{name}: {constant} is {ours:?}, in the table {value}");
            }
        }
    }
    all(table, "twelve trees of ABOP, tables 2.1 to 2.3", "constants as printed", n, n_all);
    Ok(())
}

fn parse(text: &str) -> Outcome<Grammar> {
    Ok(Grammar::parse(text, &Limits::default())?)
}

fn derived(grammar: &Grammar, steps: u32, seed: Seed) -> Outcome<Word> {
    Ok(grammar.derive(Some(steps), seed, &Control::default())?.word)
}

/// A row for so many of so many.
fn all(table: &mut Table, case: &str, metric: &str, n: usize, of: usize) {
    let (ours, of) = (n as f64, of as f64);
    let (paper, aim) = (Some(of), Aim::AtLeast(of));
    table.row(&Row { case, metric, paper, peer: None, ours, unit: "", aim });
}
