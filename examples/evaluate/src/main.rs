//! Reproduces the papers' tables: one row per case with the paper's figure, ours, the aim and
//! whether it holds.
//!
//! `cargo run --release -p evaluate -- SYSTEM [--json]`; `all` runs every system and writes EVALUATION.md.

mod all;
mod ffi;
mod measure;
mod mesh;
mod multires;
mod particle;
mod path;
mod peers;
mod plastic;
mod prune;
mod realism;
mod references;
mod silhouette;
mod sketch;
mod soak;
mod statistics;
mod table;

use std::process::ExitCode;
use table::Table;

type Evaluation = fn(&mut Table) -> Result<(), Box<dyn std::error::Error>>;

/// Every system, by the name of its module.
const SYSTEMS: [(&str, Evaluation); 12] = [
    ("path", path::evaluate),
    ("particle", particle::evaluate),
    ("sketch", sketch::evaluate),
    ("silhouette", silhouette::evaluate),
    ("mesh", mesh::evaluate),
    ("prune", prune::evaluate),
    ("multires", multires::evaluate),
    ("plastic", plastic::evaluate),
    ("realism", realism::evaluate),
    ("peers", peers::evaluate),
    ("ffi", ffi::evaluate),
    ("soak", soak::evaluate),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [flag, case] = arguments.as_slice()
        && flag == measure::MEMORY_FLAG
    {
        let done = path::grow_case(case)
            .and_then(|()| mesh::build_case(case))
            .and_then(|()| peers::build_case(case));
        measure::print_peak();
        return if done.is_ok() { ExitCode::SUCCESS } else { ExitCode::FAILURE };
    }
    if arguments.iter().eq([ffi::RUST_FLAG]) {
        return if ffi::answer_in_rust().is_ok() { ExitCode::SUCCESS } else { ExitCode::FAILURE };
    }
    let json = arguments.iter().any(|argument| argument == "--json");
    let wanted: Vec<&String> = arguments.iter().filter(|a| !a.starts_with("--")).collect();
    let known = || SYSTEMS.map(|(name, _)| name).join(", ");
    let [wanted] = wanted.as_slice() else {
        eprintln!("usage: evaluate SYSTEM [--json]\nsystems: {}, or all of them: all", known());
        return ExitCode::from(2);
    };
    if *wanted == "all" {
        return all::evaluate(json).unwrap_or_else(|error| {
            eprintln!("all: {error}");
            ExitCode::from(table::BROKEN)
        });
    }
    let Some((name, evaluation)) = SYSTEMS.iter().find(|(name, _)| name == wanted) else {
        eprintln!("no system named '{wanted}'; there are {}", known());
        return ExitCode::from(2);
    };
    let mut table = Table::new(name, json);
    if let Err(error) = evaluation(&mut table) {
        eprintln!("{name}: {error}");
        return ExitCode::from(table::BROKEN);
    }
    table.finish()
}
