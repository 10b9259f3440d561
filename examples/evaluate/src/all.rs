//! Every system in turn, each in a process of its own, and the page of all they told.

use crate::SYSTEMS;
use crate::table::MISSED;
use crate::table::page::{Chapter, markdown};
use crate::table::{Line, Table};
use std::error::Error;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;
use tree_core::CoreError;
use tree_core::file::write_atomic;

/// Where the page is written: the folder the command is given in.
const PAGE: &str = "EVALUATION.md";

/// Runs all of them; fails where an aim is missed or one does not come to its end.
pub(crate) fn evaluate(json: bool) -> Result<ExitCode, Box<dyn Error>> {
    let mut chapters = Vec::new();
    let (mut held, mut aims, mut broken) = (0, 0, false);
    for (system, _) in SYSTEMS {
        eprintln!("== {system}");
        let mut table = Table::new(system, json);
        let (chapter, ended) = run(system, &mut table)?;
        eprintln!("== {system}: {} s", chapter.seconds.round());
        let (of_it, in_all) = table.held();
        (held, aims, broken) = (held + of_it, aims + in_all, broken | !ended);
        chapters.push(chapter);
    }
    let page = markdown(&chapters, &machine());
    write_atomic(Path::new(PAGE), |file| {
        file.write_all(page.as_bytes()).map_err(|error| CoreError::io(PAGE, error))
    })?;
    eprintln!("{held} of {aims} aims hold; written to {PAGE}");
    Ok(if held == aims && !broken { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// One system, in a fresh process of this program: memory and threads of one do not matter to the next. Tells whether it came
/// to its end.
fn run(system: &str, table: &mut Table) -> Result<(Chapter, bool), Box<dyn Error>> {
    let started = Instant::now();
    let mut child = Command::new(std::env::current_exe()?)
        .args([system, "--json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()?;
    let told = child.stderr.take();
    // Both pipes are read at once, so that neither fills up.
    let notes = std::thread::spawn(move || {
        let mut text = String::new();
        told.map(|mut told| told.read_to_string(&mut text));
        text
    });
    let mut lines = Vec::new();
    let rows = child.stdout.take().ok_or("no output")?;
    for text in BufReader::new(rows).lines() {
        if let Ok(line) = serde_json::from_str::<Line>(&text?) {
            table.line(&line);
            lines.push(line);
        }
    }
    let status = child.wait()?;
    let mut notes: Vec<String> = notes
        .join()
        .unwrap_or_default()
        .lines()
        .filter(|line| !line.is_empty())
        .map(String::from)
        .collect();
    notes.iter().for_each(|note| eprintln!("{note}"));
    let ended = status.success() || status.code() == Some(i32::from(MISSED));
    if !ended {
        notes.push(format!("It did not come to its end: {status}."));
    }
    let seconds = started.elapsed().as_secs_f64();
    Ok((Chapter { system: system.into(), lines, seconds, notes }, ended))
}

/// Processor and threads.
fn machine() -> String {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let model = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    });
    let model = model.unwrap_or_else(|| std::env::consts::ARCH.into());
    format!("{threads} threads of {model}")
}
