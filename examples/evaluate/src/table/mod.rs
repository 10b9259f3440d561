//! Rows of an evaluation, printed as they are measured.

pub(crate) mod page;
mod why;

use serde::{Deserialize, Serialize};
use std::io::Write;
use std::process::ExitCode;

/// Prints a line; a reader that has gone away (`| head`) is no reason to panic.
macro_rules! say {
    ($($argument:tt)*) => {{
        let _ = writeln!(std::io::stdout(), $($argument)*);
    }};
}

/// How a system ends that misses an aim.
pub(crate) const MISSED: u8 = 1;
/// How one ends that does not come to its end.
pub(crate) const BROKEN: u8 = 3;

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

/// A row as it is printed and handed on.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Line {
    pub(crate) system: String,
    pub(crate) case: String,
    pub(crate) metric: String,
    pub(crate) paper: Option<f64>,
    pub(crate) peer: Option<f64>,
    /// None where it is not a number.
    pub(crate) ours: Option<f64>,
    pub(crate) unit: String,
    pub(crate) aim: Option<String>,
    pub(crate) holds: Option<bool>,
    /// How far an aim that was missed is off.
    pub(crate) off: Option<String>,
    /// Why it was missed, where that is known.
    pub(crate) why: Option<String>,
}

impl Aim {
    fn holds(self, ours: f64) -> Option<bool> {
        match self {
            Self::AtMost(most) => Some(ours <= most),
            Self::AtLeast(least) => Some(ours >= least),
            Self::Within(least, most) => Some((least..=most).contains(&ours)),
            Self::None => None,
        }
    }

    fn text(self) -> Option<String> {
        match self {
            Self::AtMost(most) => Some(format!("<= {}", figure(most))),
            Self::AtLeast(least) => Some(format!(">= {}", figure(least))),
            Self::Within(least, most) => Some(format!("{} to {}", figure(least), figure(most))),
            Self::None => None,
        }
    }

    /// How far a figure that misses is beyond the bound: in per cent of it, or as it is where the bound is 0.
    fn off(self, ours: f64) -> String {
        let bound = match self {
            Self::AtMost(bound) | Self::AtLeast(bound) => bound,
            Self::Within(least, most) => {
                if ours < least {
                    least
                } else {
                    most
                }
            }
            Self::None => return String::new(),
        };
        let off = (ours - bound).abs();
        if bound == 0.0 {
            format!("by {}", figure(off))
        } else {
            format!("by {} %", figure((1000.0 * off / bound.abs()).round() / 10.0))
        }
    }
}

impl Line {
    fn of(system: &str, row: &Row<'_>) -> Self {
        let holds = row.aim.holds(row.ours);
        Self {
            system: system.into(),
            case: row.case.into(),
            metric: row.metric.into(),
            paper: row.paper,
            peer: row.peer,
            ours: row.ours.is_finite().then_some(row.ours),
            unit: row.unit.into(),
            aim: row.aim.text(),
            holds,
            off: (holds == Some(false)).then(|| row.aim.off(row.ours)),
            why: (holds == Some(false))
                .then(|| why::reason(system, row.case, row.metric).map(str::to_owned))
                .flatten(),
        }
    }

    /// "yes", "NO, by 5 %", or nothing.
    pub(crate) fn verdict(&self) -> String {
        match (self.holds, &self.off) {
            (Some(true), _) => "yes".into(),
            (Some(false), Some(off)) => format!("NO, {off}"),
            (Some(false), None) => "NO".into(),
            (None, _) => String::new(),
        }
    }

    fn print(&self) {
        let optional = |value: Option<f64>| value.map_or(String::new(), figure);
        say!(
            "{:<44} {:<28} {:>12} {:>12} {:>12}  {:<10} {:>14}  {}",
            self.case,
            self.metric,
            optional(self.paper),
            optional(self.peer),
            self.ours.map_or("NaN".into(), figure),
            self.unit,
            self.aim.as_deref().unwrap_or_default(),
            self.verdict()
        );
        if let Some(why) = &self.why {
            say!("    because: {why}");
        }
    }
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
        self.line(&Line::of(&self.system, row));
    }

    /// A row, and why it misses where it does.
    pub(crate) fn row_because(&mut self, row: &Row<'_>, why: &str) {
        let line = Line::of(&self.system, row);
        let why = (line.holds == Some(false)).then(|| why.to_owned());
        self.line(&Line { why, ..line });
    }

    /// Prints and counts a row that was measured elsewhere.
    pub(crate) fn line(&mut self, line: &Line) {
        self.n_aims += usize::from(line.holds.is_some());
        self.n_missed += usize::from(line.holds == Some(false));
        if !self.json {
            line.print();
        } else if let Ok(text) = serde_json::to_string(line) {
            say!("{text}");
        }
    }

    /// Aims that hold, and aims.
    pub(crate) fn held(&self) -> (usize, usize) {
        (self.n_aims - self.n_missed, self.n_aims)
    }

    /// Fails when any aim was missed.
    pub(crate) fn finish(&self) -> ExitCode {
        let (held, aims) = self.held();
        if !self.json {
            say!("{held} of {aims} aims hold");
        }
        if held == aims { ExitCode::SUCCESS } else { ExitCode::from(MISSED) }
    }
}

/// Four significant digits, whole numbers in full.
pub(crate) fn figure(value: f64) -> String {
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
