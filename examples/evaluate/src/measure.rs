//! Time and memory of a piece of work.

use rayon::prelude::*;
use std::error::Error;
use std::fs;
use std::process::Command;
use std::time::Instant;

/// Seconds of the fastest of `runs` runs, and the last result. The fastest is the least disturbed by
/// whatever else the machine does.
pub(crate) fn fastest<T, E>(
    runs: u32,
    mut work: impl FnMut() -> Result<T, E>,
) -> Result<(f64, T), E> {
    let mut best = f64::INFINITY;
    let mut result = None;
    for _ in 0..runs.max(1) {
        drop(result.take());
        let start = Instant::now();
        let value = work()?;
        best = best.min(start.elapsed().as_secs_f64());
        result = Some(value);
    }
    match result {
        Some(value) => Ok((best, value)),
        None => work().map(|value| (best, value)),
    }
}

/// As [`fastest`], of as many runs as begin within so many seconds: at least one, at most [`RUNS_MAX`].
pub(crate) fn fastest_within<T, E>(
    seconds: f64,
    mut work: impl FnMut() -> Result<T, E>,
) -> Result<(f64, T), E> {
    let started = Instant::now();
    let (mut best, mut result) = fastest(1, &mut work)?;
    for _ in 1..RUNS_MAX {
        if started.elapsed().as_secs_f64() >= seconds {
            break;
        }
        drop(result);
        let (again, value) = fastest(1, &mut work)?;
        best = best.min(again);
        result = value;
    }
    Ok((best, result))
}

/// Makes something of each item, on all cores, and hands it out in their order.
pub(crate) fn of_each<A: Sync, T: Send>(
    items: &[A],
    make: impl Fn(&A) -> Result<T, Box<dyn Error>> + Sync,
) -> Result<Vec<T>, Box<dyn Error>> {
    let made: Result<Vec<T>, String> =
        items.par_iter().map(|item| make(item).map_err(|error| error.to_string())).collect();
    Ok(made?)
}

/// More runs than this find nothing faster.
const RUNS_MAX: u32 = 100;

/// The flag under which [`peak_bytes`] calls this program again.
pub(crate) const MEMORY_FLAG: &str = "--memory-of";

/// Peak resident memory of a piece of work above that of a program that does nothing: `case` is run
/// by a fresh process of this program, because a used one hides what its allocator has kept. `None`
/// where the system does not tell (it takes Linux's `/proc`).
pub(crate) fn peak_bytes(case: &str) -> Option<u64> {
    let measure = |case: &str| -> Option<u64> {
        let program = std::env::current_exe().ok()?;
        let output = Command::new(program).args([MEMORY_FLAG, case]).output().ok()?;
        String::from_utf8(output.stdout).ok()?.trim().parse().ok()
    };
    Some(measure(case)?.saturating_sub(measure("nothing")?))
}

/// Prints the peak resident memory of this process in bytes.
pub(crate) fn print_peak() {
    let peak = fs::read_to_string("/proc/self/status").ok().and_then(|status| {
        let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
        line.split_whitespace().nth(1)?.parse::<u64>().ok()
    });
    if let Some(kilobytes) = peak {
        println!("{}", 1024 * kilobytes);
    }
}
