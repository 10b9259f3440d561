//! Rows of an evaluation, printed as they are measured.

use serde_json::json;
use std::io::Write;
use std::process::ExitCode;

/// Prints a line; a reader that has gone away (`| head`) is no reason to panic.
macro_rules! say {
    ($($argument:tt)*) => {{
        let _ = writeln!(std::io::stdout(), $($argument)*);
    }};
}

/// What a figure is held against.
#[derive(Clone, Copy)]
pub(crate) enum Aim {
    AtMost(f64),
    AtLeast(f64),
    /// From the first to the second.
    Within(f64, f64),
    /// Printed for information.
    None,
}

/// One measured figure.
pub(crate) struct Row<'a> {
    pub(crate) case: &'a str,
    pub(crate) metric: &'a str,
    pub(crate) paper: Option<f64>,
    /// A rival or oracle, measured in the same run.
    pub(crate) peer: Option<f64>,
    pub(crate) ours: f64,
    pub(crate) unit: &'a str,
    pub(crate) aim: Aim,
}

pub(crate) struct Table {
    system: String,
    json: bool,
    n_missed: usize,
    n_aims: usize,
}

impl Table {
    pub(crate) fn new(system: &str, json: bool) -> Self {
        if !json {
            say!(
                "{:<44} {:<28} {:>12} {:>12} {:>12}  {:<10} {:>14}  holds",
                "case",
                "metric",
                "paper",
                "peer",
                "ours",
                "unit",
                "aim"
            );
        }
        Self { system: system.into(), json, n_missed: 0, n_aims: 0 }
    }

    pub(crate) fn row(&mut self, row: &Row<'_>) {
        let holds = match row.aim {
            Aim::AtMost(most) => Some(row.ours <= most),
            Aim::AtLeast(least) => Some(row.ours >= least),
            Aim::Within(least, most) => Some((least..=most).contains(&row.ours)),
            Aim::None => None,
        };
        self.n_aims += usize::from(holds.is_some());
        self.n_missed += usize::from(holds == Some(false));
        let aim = match row.aim {
            Aim::AtMost(most) => format!("<= {}", figure(most)),
            Aim::AtLeast(least) => format!(">= {}", figure(least)),
            Aim::Within(least, most) => format!("{} to {}", figure(least), figure(most)),
            Aim::None => String::new(),
        };
        if self.json {
            let line = json!({
                "system": self.system, "case": row.case, "metric": row.metric, "paper": row.paper,
                "peer": row.peer, "ours": row.ours, "unit": row.unit,
                "aim": (!aim.is_empty()).then_some(aim), "holds": holds,
            });
            say!("{line}");
            return;
        }
        let optional = |value: Option<f64>| value.map_or(String::new(), figure);
        let holds = holds.map_or("", |holds| if holds { "yes" } else { "NO" });
        say!(
            "{:<44} {:<28} {:>12} {:>12} {:>12}  {:<10} {:>14}  {holds}",
            row.case,
            row.metric,
            optional(row.paper),
            optional(row.peer),
            figure(row.ours),
            row.unit,
            aim
        );
    }

    /// Fails when any aim was missed.
    pub(crate) fn finish(&self) -> ExitCode {
        if !self.json {
            say!("{} of {} aims hold", self.n_aims - self.n_missed, self.n_aims);
        }
        if self.n_missed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}

/// Four significant digits, whole numbers in full.
fn figure(value: f64) -> String {
    if value == value.trunc() && value.abs() < 1e12 {
        return format!("{value}");
    }
    let digits = 3 - value.abs().log10_floor();
    format!("{value:.*}", digits.clamp(0, 9) as usize)
}

trait Log10Floor {
    fn log10_floor(self) -> i32;
}

impl Log10Floor for f64 {
    fn log10_floor(mut self) -> i32 {
        // Exact enough for printing, without a platform's logarithm.
        let mut power = 0;
        while self >= 10.0 {
            self /= 10.0;
            power += 1;
        }
        while self > 0.0 && self < 1.0 {
            self *= 10.0;
            power -= 1;
        }
        power
    }
}
