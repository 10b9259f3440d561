//! Ten thousand trees of all modelers, of parameters right and wrong: no panic, nothing invalid, no memory that stays, the same bits on
//! one thread as on all.
//!
//! Each case has its own chance, named by its number: `TREE_SOAK_CASE=1234 evaluate soak` does that one alone and says what came of it.
//! Limits are small, so that a case takes milliseconds. Panics are caught and counted.

mod dice;
mod drawn;
mod judge;
mod modelers;

use crate::table::{Aim, Row, Table};
use dice::Dice;
use modelers::MODELERS;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};
use tree_core::{Control, Limits, Seed};
use tree_model::ModelError;

/// Cases in all.
const CASES: u64 = 10_000;
/// Cases after which memory is looked at.
const PART: u64 = 2000;
/// A case that takes longer is stopped, which is an error with a type like others.
const PATIENCE: Duration = Duration::from_millis(1500);
/// Memory at the end, of that after the first part: what stays behind would be there five times.
const GROWTH: f64 = 1.2;
/// Names one case to be done alone.
const ALONE: &str = "TREE_SOAK_CASE";

/// What came of a case.
#[derive(Clone, Debug, PartialEq)]
enum Fate {
    /// Trees and meshes that are right: a number that differs where bits do.
    Sound(u64),
    /// An error with a type, by its name.
    Refused(String),
    /// It was taking too long.
    Stopped,
    /// Something that must not come out.
    Invalid(String),
    Panicked(String),
}

/// All of it; see the rows.
pub(crate) fn evaluate(table: &mut Table) -> Result<(), Box<dyn Error>> {
    if let Some(case) = std::env::var(ALONE).ok().and_then(|text| text.parse().ok()) {
        let started = Instant::now();
        let fate = fate(case);
        eprintln!("case {case} ({}): {fate:?} in {:?}", MODELERS[kind(case)].0, started.elapsed());
        return Ok(());
    }
    // What panics say is told with the case.
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| ()));
    let outcome = run(table);
    std::panic::set_hook(hook);
    outcome
}

fn run(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let started = Instant::now();
    let fates: Vec<Fate> = (0..CASES).into_par_iter().map(fate).collect();
    let seconds = started.elapsed().as_secs_f64();
    // On one thread, so that it tells whether bits depend on threads, and whether memory grows: with more threads the
    // allocator's pools do, by which thread happens to do what.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let mut memory = Vec::new();
    let again: Vec<Fate> = pool.install(|| {
        let alone = |case| {
            if case % PART == 0 {
                memory.push(resident());
            }
            fate(case)
        };
        (0..CASES).map(alone).collect()
    });
    memory.push(resident());
    modelers(table, &fates);
    let mut row = |metric: &str, ours: f64, unit: &str, aim| {
        table.row(&Row { case: "all", metric, paper: None, peer: None, ours, unit, aim });
    };
    row("panics", count(&fates, |fate| matches!(fate, Fate::Panicked(_))), "", Aim::AtMost(0.0));
    row("invalid", count(&fates, |fate| matches!(fate, Fate::Invalid(_))), "", Aim::AtMost(0.0));
    row("stopped for time", count(&fates, |fate| *fate == Fate::Stopped), "", Aim::None);
    row(
        "refused with a typed error",
        count(&fates, |fate| matches!(fate, Fate::Refused(_))),
        "",
        Aim::None,
    );
    row("sound trees", count(&fates, |fate| matches!(fate, Fate::Sound(_))), "", Aim::None);
    row("seconds", seconds, "s", Aim::None);
    for (part, bytes) in (0..).zip(&memory).skip(1) {
        let metric = format!("resident memory after {} cases", part * PART);
        row(&metric, bytes.map_or(f64::NAN, |bytes| bytes as f64 / 1e6), "MB", Aim::None);
    }
    if let [_, Some(first), .., Some(last)] = memory.as_slice() {
        let growth = *last as f64 / *first as f64;
        row("memory after 10,000 cases over that after 2,000", growth, "", Aim::AtMost(GROWTH));
    }
    let differing = differing(&fates, &again) as f64;
    row("other bits on one thread", differing, "of 10,000", Aim::AtMost(0.0));
    flaws(&fates);
    Ok(())
}

/// Rows of each modeler, and the errors it gave, which are told for information.
fn modelers(table: &mut Table, fates: &[Fate]) {
    for (number, (name, ..)) in MODELERS.iter().enumerate() {
        let own: Vec<Fate> = (0..CASES)
            .zip(fates)
            .filter(|(case, _)| kind(*case) == number)
            .map(|(_, fate)| fate.clone())
            .collect();
        let mut row = |metric, ours: f64, aim| {
            table.row(&Row { case: name, metric, paper: None, peer: None, ours, unit: "", aim });
        };
        row("cases", own.len() as f64, Aim::None);
        row("sound", count(&own, |fate| matches!(fate, Fate::Sound(_))), Aim::None);
        let bad = |fate: &Fate| matches!(fate, Fate::Panicked(_) | Fate::Invalid(_));
        row("panics and invalid output", count(&own, bad), Aim::AtMost(0.0));
    }
}

fn count(fates: &[Fate], which: impl Fn(&Fate) -> bool) -> f64 {
    fates.iter().filter(|fate| which(fate)).count() as f64
}

/// The modeler of a case: each has its share in every thousand, mixed.
fn kind(case: u64) -> usize {
    let mut left = (case * 617 % 1000) as usize;
    for (number, (_, share, _)) in MODELERS.iter().enumerate() {
        match left.checked_sub(*share) {
            Some(rest) => left = rest,
            None => return number,
        }
    }
    MODELERS.len() - 1
}

/// Small enough that nothing takes long, large enough that most trees fit.
fn limits() -> Limits {
    Limits {
        nodes: 20_000,
        graph_nodes: 20_000,
        graph_arcs: 300_000,
        leaves: 20_000,
        voxels: 60_000,
        pixels: 100_000,
        triangles: 400_000,
        input_bytes: 1 << 20,
        modules: 6000,
        pairs: 100_000,
    }
}

fn fate(case: u64) -> Fate {
    let late = Instant::now() + PATIENCE;
    let control = Control::default().with_limits(limits()).with_stop(move || Instant::now() > late);
    let (_, _, make) = MODELERS[kind(case)];
    let work = AssertUnwindSafe(|| {
        let mut dice = Dice::new(Seed(case).stream("soak"));
        match make(&mut dice, &control) {
            Ok(trees) => {
                let mut all = trees.len() as u64;
                for tree in &trees {
                    match judge::judge(tree, &mut dice, &control) {
                        Ok(print) => all = all.rotate_left(7) ^ print,
                        Err(flaw) => return Fate::Invalid(flaw),
                    }
                }
                Fate::Sound(all)
            }
            Err(ModelError::Cancelled(_)) => Fate::Stopped,
            Err(error) => refused(&error),
        }
    });
    catch_unwind(work).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
        Fate::Panicked(text.unwrap_or("no message").into())
    })
}

/// An error's type, and whether its words are words.
fn refused(error: &ModelError) -> Fate {
    let (name, words) = (format!("{error:?}"), error.to_string());
    if words.len() < 8 {
        return Fate::Invalid(format!("an error without words: {name}"));
    }
    let name = name.split([' ', '(', '{']).next().unwrap_or_default();
    Fate::Refused(match error {
        ModelError::Limit(limit) => format!("{name} {}", limit.resource.field()),
        _ => name.into(),
    })
}

/// How many come out otherwise the second time. Time is no part of a tree, so those that were stopped do not count.
fn differing(fates: &[Fate], again: &[Fate]) -> usize {
    let mut differing = 0;
    for ((case, first), second) in (0..CASES).zip(fates).zip(again) {
        if ![first, second].contains(&&Fate::Stopped) && first != second {
            eprintln!(
                "case {case} ({}): {first:?}, on one thread {second:?}",
                MODELERS[kind(case)].0
            );
            differing += 1;
        }
    }
    differing
}

/// What is wrong, and what was refused how often, for people.
fn flaws(fates: &[Fate]) {
    let mut refused: BTreeMap<(usize, &str), u32> = BTreeMap::new();
    for (case, fate) in (0..CASES).zip(fates) {
        match fate {
            Fate::Panicked(said) => {
                eprintln!("case {case} ({}) panics: {said}", MODELERS[kind(case)].0);
            }
            Fate::Invalid(what) => eprintln!("case {case} ({}): {what}", MODELERS[kind(case)].0),
            Fate::Refused(name) => *refused.entry((kind(case), name)).or_default() += 1,
            Fate::Stopped => *refused.entry((kind(case), "stopped for time")).or_default() += 1,
            Fate::Sound(_) => {}
        }
    }
    for ((kind, name), n) in refused {
        eprintln!("{}: {n} × {name}", MODELERS[kind].0);
    }
}

/// Resident memory of this process in bytes; none where the system does not tell (it takes Linux's `/proc`).
fn resident() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmRSS:"))?;
    Some(1024 * line.split_whitespace().nth(1)?.parse::<u64>().ok()?)
}
