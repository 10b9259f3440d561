//! Time and memory of a piece of work.

use std::fs;
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

/// Runs `work` and returns by how many bytes the resident memory of this process peaked above what
/// it was before; `None` where the system does not tell (it takes Linux's `/proc`).
pub(crate) fn peak_bytes<T>(work: impl FnOnce() -> T) -> (T, Option<u64>) {
    // Writing 5 resets the peak.
    let reset = fs::write("/proc/self/clear_refs", "5").is_ok();
    let before = status_bytes("VmRSS:");
    let value = work();
    let peak = status_bytes("VmHWM:");
    let grown = match (before, peak) {
        (Some(before), Some(peak)) if reset => Some(peak.saturating_sub(before)),
        _ => None,
    };
    (value, grown)
}

fn status_bytes(field: &str) -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with(field))?;
    let kilobytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024 * kilobytes)
}
