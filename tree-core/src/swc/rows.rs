//! From text to columns: one pass over the lines, no row checked against another yet.

use super::{SwcOptions, SwcProblem};
use crate::error::{CoreError, Result};
use crate::limits::{Limits, Resource};

/// Fields of a row.
const N_FIELDS: usize = 7;

/// How much of a bad field an error repeats, in characters.
const QUOTE_CHARS: usize = 32;

/// Largest whole number that a field may hold when it is written as a decimal (`3.0`): beyond
/// 2⁵³ an f64 does not hold every one.
const MAX_DECIMAL: f64 = 9_007_199_254_740_992.0;

/// The rows of a file in columns, in the order, axes and units of the file.
#[derive(Debug, Default)]
pub(super) struct Rows {
    pub(super) ids: Vec<i64>,
    pub(super) types: Vec<i32>,
    pub(super) positions: Vec<[f64; 3]>,
    pub(super) radii: Vec<f32>,
    pub(super) parents: Vec<i64>,
    /// Line of each row, from 1.
    pub(super) lines: Vec<usize>,
    pub(super) n_lines: usize,
    pub(super) comments: String,
    pub(super) n_rows_with_more_fields: usize,
}

impl Rows {
    pub(super) fn parse(text: &str, options: &SwcOptions, limits: &Limits) -> Result<Self> {
        let mut rows = Self::default();
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        // `lines` knows \n and \r\n; what \r is left ends a line of an old Macintosh file.
        for line in text.lines().flat_map(|line| line.split('\r')) {
            rows.n_lines += 1;
            let content = match line.split_once('#') {
                Some((content, comment)) => {
                    rows.comments.push_str(comment.trim());
                    rows.comments.push('\n');
                    content
                }
                None => line,
            };
            let mut fields = content.split_whitespace();
            if let Some(first) = fields.next() {
                limits.check(Resource::Nodes, rows.ids.len() as u64 + 1)?;
                rows.push(first, fields, options.scale)
                    .map_err(|problem| CoreError::Swc { line: rows.n_lines, problem })?;
            }
        }
        Ok(rows)
    }

    fn push<'a>(
        &mut self,
        first: &'a str,
        rest: impl Iterator<Item = &'a str>,
        scale: f64,
    ) -> Result<(), SwcProblem> {
        let mut fields = [first; N_FIELDS];
        let mut found = 1;
        for field in rest {
            if let Some(slot) = fields.get_mut(found) {
                *slot = field;
            }
            found += 1;
        }
        if found < N_FIELDS {
            return Err(SwcProblem::Fields { found });
        }
        let [id, kind, x, y, z, radius, parent] = fields;
        let id = whole("id", id)?;
        if id < 0 {
            return Err(SwcProblem::NegativeId { found: id });
        }
        let type_of_row = whole("type", kind)?;
        let type_of_row = i32::try_from(type_of_row).map_err(|_| not_a_number("type", kind))?;
        let position = [number("x", x)?, number("y", y)?, number("z", z)?];
        let radius = number("radius", radius)?;
        if radius < 0.0 {
            return Err(SwcProblem::NegativeRadius { found: radius });
        }
        let radius = (radius * scale) as f32;
        if !radius.is_finite() {
            return Err(SwcProblem::NotFinite { field: "radius" });
        }
        let parent = whole("parent", parent)?;
        self.ids.push(id);
        self.types.push(type_of_row);
        self.positions.push(position);
        self.radii.push(radius);
        self.parents.push(parent);
        self.lines.push(self.n_lines);
        self.n_rows_with_more_fields += usize::from(found > N_FIELDS);
        Ok(())
    }
}

/// A whole number, as `3` or as the `3.0` and `3e0` that table writers make of it.
fn whole(field: &'static str, text: &str) -> Result<i64, SwcProblem> {
    if let Ok(value) = text.parse::<i64>() {
        return Ok(value);
    }
    match text.parse::<f64>() {
        Ok(value) if value.abs() <= MAX_DECIMAL && value.trunc() == value => Ok(value as i64),
        _ => Err(not_a_number(field, text)),
    }
}

/// A finite f64 that rounds to the f32 nearest to the decimal number.
fn number(field: &'static str, text: &str) -> Result<f64, SwcProblem> {
    let value: f64 = text.parse().map_err(|_| not_a_number(field, text))?;
    if !value.is_finite() {
        return Err(SwcProblem::NotFinite { field });
    }
    // Rounding twice, to f64 and then to f32, may miss the nearest f32 where the f64 falls on the
    // middle between two. One step to the right side mends it; so what we write is read back to
    // the bit.
    let nearest = match text.parse::<f32>() {
        Ok(nearest) => f64::from(nearest),
        Err(_) => return Ok(value),
    };
    let rounded = f64::from(value as f32);
    Ok(if nearest > rounded {
        value.next_up()
    } else if nearest < rounded {
        value.next_down()
    } else {
        value
    })
}

fn not_a_number(field: &'static str, text: &str) -> SwcProblem {
    SwcProblem::NotANumber { field, found: text.chars().take(QUOTE_CHARS).collect() }
}
