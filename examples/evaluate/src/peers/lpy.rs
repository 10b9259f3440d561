//! L-Py (openalea.lpy, from conda): a ternary tree, derived and drawn by the turtle.
//!
//! Beside the crate `symbios`, which `multires` compares with, it is what people derive plants with. Both are given the
//! same system. L-Py makes triangles of what it draws, ours a skeleton, so the aim is on the derivation alone.

use super::program::{Language, Peer};
use super::{CASE, Outcome, SECONDS, beside, fastest, memory, or_note};
use crate::measure::peak_bytes;
use crate::table::{Aim, Table};
use serde::Deserialize;
use std::hint::black_box;
use tree_core::{Control, Limits, Seed, Species};
use tree_model::lsystem::Grammar;
use tree_model::lsystem::turtle::{TurtleParams, interpret};

const PEER: Peer = Peer {
    name: "L-Py",
    install: "conda install -c openalea3 -c conda-forge openalea.lpy, and TREE_PEERS_PYTHON",
    language: Language::Python,
    script: "lpy.py",
};
/// Steps of the derivation: a hundred thousand modules.
const STEPS: u32 = 8;
/// The same as in `lpy.py`, where the width is set by `_`.
const SYSTEM: &str = "axiom: A(1,1)
A(l,w) -> !(w) F(l) [&(45) A(l*0.7,w*0.6)] /(120) [&(45) A(l*0.7,w*0.6)] /(120) [&(45) A(l*0.7,w*0.6)]";

/// The case of memory.
const DRAWN: &str = "L-system drawn";

#[derive(Deserialize)]
struct More {
    derive_seconds: f64,
    modules: f64,
}

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    let (steps, within) = (STEPS.to_string(), SECONDS.to_string());
    let told = PEER.ask::<More>(&[steps.as_ref(), within.as_ref()]);
    let Some(told) = or_note(told) else { return Ok(()) };
    let control = Control::default();
    let grammar = Grammar::parse(SYSTEM, &Limits::default())?;
    let (derive_seconds, derived) =
        fastest(|| Ok(grammar.derive(Some(STEPS), Seed(1), &control)?))?;
    let (seconds, ()) = fastest(draw)?;
    let case = format!("L-Py, ternary tree, {STEPS} steps");
    let mut row = |metric, figures, unit, aim| beside(table, &case, metric, figures, unit, aim);
    row("modules", [told.more.modules, derived.word.len() as f64], "", Aim::None);
    let peer = 1e3 * told.more.derive_seconds;
    row("time to derive", [peer, 1e3 * derive_seconds], "ms", Aim::AtMost(peer));
    row("time to derive and draw", [1e3 * told.seconds, 1e3 * seconds], "ms", Aim::None);
    memory(table, &case, told.peak_bytes, peak_bytes(&format!("{CASE}{DRAWN}")));
    Ok(())
}

fn draw() -> Outcome {
    let control = Control::default();
    let grammar = Grammar::parse(SYSTEM, &Limits::default())?;
    let word = grammar.derive(Some(STEPS), Seed(1), &control)?.word;
    let turtle = TurtleParams::default();
    black_box(interpret(&word, grammar.symbols(), &Species::default(), &turtle, &control)?);
    Ok(())
}

/// Does what a case of [`peak_bytes`] names, if it is this one.
pub(super) fn build_case(case: &str) -> Outcome<bool> {
    let drawn = case == DRAWN;
    if drawn {
        draw()?;
    }
    Ok(drawn)
}
