//! Modules per second on one core, beside the crate `symbios`.

use super::{Outcome, information};
use crate::measure::fastest;
use crate::table::{Aim, Row, Table};
use tree_core::{Control, Limits, Seed, Species};
use tree_model::lsystem::Grammar;
use tree_model::lsystem::turtle::{TurtleParams, interpret};

/// Million modules per second that the issue asks for.
const WANTED: f64 = 20.0;
/// Runs, of which the fastest counts.
const RUNS: u32 = 5;
/// Modules that the peer may make.
const ROOM: usize = 100_000_000;

struct Case {
    name: &'static str,
    axiom: &'static str,
    rules: &'static [&'static str],
    steps: u32,
    /// Whether the peer knows it.
    peer: bool,
}

const CASES: [Case; 7] = [
    Case { name: "algae", axiom: "A", rules: &["A -> A B", "B -> A"], steps: 28, peer: true },
    Case {
        name: "ternary tree, 2 parameters",
        axiom: "A(1,1)",
        rules: &[
            "A(l,w) -> !(w) F(l) [&(45) A(l*0.7,w*0.6)] /(120) [&(45) A(l*0.7,w*0.6)] /(120) [&(45) A(l*0.7,w*0.6)]",
        ],
        steps: 10,
        peer: true,
    },
    Case {
        name: "Honda's tree",
        axiom: "A(1,10)",
        rules: &[
            "A(l,w) -> !(w) F(l) [&(45) B(l*0.6, w*0.707)] /(137.5) A(l*0.9, w*0.707)",
            "B(l,w) -> !(w) F(l) [-(45) $ C(l*0.6, w*0.707)] C(l*0.9, w*0.707)",
            "C(l,w) -> !(w) F(l) [+(45) $ B(l*0.6, w*0.707)] B(l*0.9, w*0.707)",
        ],
        steps: 16,
        peer: true,
    },
    Case {
        name: "conditions",
        axiom: "A(1,1)",
        rules: &[
            "A(l,w) : l > 0.0001 -> !(w) F(l) [&(45) A(l*0.7,w*0.6)] /(120) [&(45) A(l*0.7,w*0.6)] /(120) [&(45) A(l*0.7,w*0.6)]",
            "A(l,w) : l <= 0.0001 -> F(l)",
        ],
        steps: 10,
        peer: true,
    },
    Case {
        name: "growing internodes",
        axiom: "A(1,1)",
        rules: &[
            "A(l,w) -> F(l) [&(45) A(l*0.7,w*0.6)] [&(45) A(l*0.7,w*0.6)]",
            "F(l) -> F(l*1.1)",
        ],
        steps: 15,
        peer: true,
    },
    Case {
        name: "stochastic",
        axiom: "A(1)",
        rules: &[
            "A(l) -> F(l)[+(30)A(l*.7)][-(30)A(l*.7)] : 1",
            "A(l) -> F(l)[+(30)A(l*.7)]A(l*.8) : 2",
        ],
        steps: 17,
        peer: false,
    },
    Case {
        name: "context",
        axiom: "A(1)",
        rules: &["A(l) -> F(l)[+(30)A(l*.7)][-(30)A(l*.7)]", "F(a) < F(b) -> F(a+b)"],
        steps: 17,
        peer: false,
    },
];

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    for case in &CASES {
        let rows = one.install(|| measure(case).map_err(|error| error.to_string()))?;
        let title = format!("derivation, {}: {} modules", case.name, rows.n);
        table.row(&Row {
            case: &title,
            metric: "modules made, one core",
            paper: None,
            peer: rows.peer,
            ours: rows.made,
            unit: "M/s",
            aim: Aim::AtLeast(WANTED),
        });
        if let Some(turtle) = rows.turtle {
            information(table, &title, "turtle, one core", turtle, "M/s");
        }
    }
    Ok(())
}

struct Rates {
    n: usize,
    made: f64,
    peer: Option<f64>,
    turtle: Option<f64>,
}

/// Million modules per second. Modules of all steps count, since all are made; the peer makes the same.
fn measure(case: &Case) -> Outcome<Rates> {
    let text = format!("axiom: {}\n{}", case.axiom, case.rules.join("\n"));
    let control = Control::default();
    let grammar = Grammar::parse(&text, &Limits::default())?;
    let (seconds, derived) = fastest(RUNS, || grammar.derive(Some(case.steps), Seed(1), &control))?;
    let made = derived.report.n_produced() as f64 * 1e-6;
    let n = derived.word.len();
    let peer = if case.peer { Some(made / by_peer(case, n)?) } else { None };
    let turtle = if case.name.contains("tree") {
        let draw = || {
            let species = Species::default();
            interpret(
                &derived.word,
                grammar.symbols(),
                &species,
                &TurtleParams::default(),
                &control,
            )
        };
        Some(n as f64 * 1e-6 / fastest(3, draw)?.0)
    } else {
        None
    };
    Ok(Rates { n, made: made / seconds, peer, turtle })
}

/// Seconds that `symbios` takes, its grammar read.
fn by_peer(case: &Case, n: usize) -> Outcome<f64> {
    let (seconds, found) = fastest(RUNS, || -> Outcome<usize> {
        let mut system = symbios::System::new();
        for rule in case.rules {
            system.add_rule(rule)?;
        }
        system.state.max_capacity = ROOM;
        system.set_axiom(case.axiom)?;
        system.derive(case.steps as usize)?;
        Ok(system.state.len())
    })?;
    if found != n {
        return Err(format!("symbios makes {found} modules of {}, not {n}", case.name).into());
    }
    Ok(seconds)
}
