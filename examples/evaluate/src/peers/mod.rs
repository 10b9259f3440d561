//! What a user would pick instead of us, on comparable work: ez-tree, modular-tree, meshoptimizer, L-Py, pymatting.
//!
//! Peers in other languages are run by the scripts in `examples/evaluate/peers`, each case in a process of its own.
//! Times are the fastest of the runs that begin within half a second (at least one) within that process: its start and its
//! imports do not count, nor do textures. Ours are taken on one thread, as theirs are; where all threads work, the
//! module says so. Memory is the peak of the first run above that of the idle process. What is not installed is left
//! out, with a note.
//!
//! Trees of different programs are not the same trees. Rates of triangles grown and meshed have an aim where the work
//! is of one kind: trees that rules expand (ez-tree, modular-tree, our L-systems). Our other modelers do more for a
//! branch: the path modeler searches ways through a volume, the growth model lets buds compete for light. Their rates
//! are told without an aim; the mesher has one on all of them.

mod ez_tree;
mod lpy;
mod matting;
mod meshoptimizer;
mod modular_tree;
mod ours;
mod program;
mod wood;

use crate::measure::fastest_within;
use crate::table::{Aim, Row, Table};
use program::Absence;
use rayon::ThreadPoolBuilder;

type Outcome<T = ()> = Result<T, Box<dyn std::error::Error>>;

pub(crate) use matting::{CLOSED_FORM, ask as ask_for_alpha};
pub(crate) use ours::build_case;

/// Seconds within which runs begin.
const SECONDS: f64 = 0.5;
/// How a case of [`crate::measure::peak_bytes`] that is ours starts.
const CASE: &str = "peers:";

/// All of it; see the rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    let one = ThreadPoolBuilder::new().num_threads(1).build()?;
    for part in [ez_tree::evaluate, modular_tree::evaluate, meshoptimizer::wood, lpy::evaluate] {
        one.install(|| part(table).map_err(|error| error.to_string()))?;
    }
    // On all threads.
    meshoptimizer::leaves(table)?;
    matting::evaluate(table)
}

/// What a peer told, or a note that it is left out.
fn or_note<T>(told: Result<T, Absence>) -> Option<T> {
    told.map_err(|absence| eprintln!("skipped: {absence}")).ok()
}

/// A peer's figure beside ours.
fn beside(table: &mut Table, case: &str, metric: &str, figures: [f64; 2], unit: &str, aim: Aim) {
    let [peer, ours] = figures;
    table.row(&Row { case, metric, paper: None, peer: Some(peer), ours, unit, aim });
}

/// Peak memory of both in megabytes, where the system tells.
fn memory(table: &mut Table, case: &str, peer: Option<f64>, ours: Option<u64>) {
    if let (Some(peer), Some(ours)) = (peer, ours) {
        let metric = "peak memory above idle";
        beside(table, case, metric, [peer / 1e6, ours as f64 / 1e6], "MB", Aim::None);
    }
}

/// The best of a few runs of ours.
fn fastest<T>(work: impl FnMut() -> Outcome<T>) -> Outcome<(f64, T)> {
    fastest_within(SECONDS, work)
}
