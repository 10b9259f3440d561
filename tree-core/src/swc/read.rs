//! Reading: rows, then who is whose parent, then a skeleton in metres with +Y up.

use super::fill::interpolate;
use super::rows::Rows;
use super::{SwcOptions, SwcProblem, UnknownRadius};
use crate::error::{CoreError, Result};
use crate::limits::Limits;
use crate::skeleton::{NO_PARENT, Reordered, Skeleton};
use glam::Vec3;
use std::path::Path;

/// Parent of the root in a file.
const ROOT_MARK: i64 = -1;

/// A skeleton from an SWC file, with what a skeleton has no column for.
#[derive(Clone, Debug, PartialEq)]
pub struct SwcImport {
    /// The skeleton: metres, +Y up. Rows keep their order where parents come first; otherwise
    /// nodes come breadth-first.
    pub skeleton: Skeleton,
    /// The type of each node as in the file; 3 continues its parent's axis, 4 starts a lateral.
    pub types: Vec<i32>,
    /// The id of each node as in the file.
    pub ids: Vec<i64>,
    /// What was found on the way.
    pub report: SwcReport,
}

/// What was noted while reading.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SwcReport {
    /// All comments without their `#`, a line each.
    pub comments: String,
    /// Rows without a known radius (0).
    pub n_unknown_radii: usize,
    /// How many of these [`SwcOptions::unknown_radius`] gave a radius.
    pub n_filled_radii: usize,
    /// Rows with more than seven fields; the further ones were passed over.
    pub n_rows_with_more_fields: usize,
    /// Whether rows came before their parents, so that nodes have another order than rows.
    pub reordered: bool,
    /// What was added to every position to bring the root to the origin, in metres and our axes;
    /// zeros if nothing was moved. In f64, as it may be a place on a map grid.
    pub moved_by: [f64; 3],
}

/// Reads the text of an SWC file.
///
/// # Errors
/// [`CoreError::Swc`] with the line and what is wrong there, [`CoreError::Limit`] when there are
/// more rows than [`Limits::nodes`], or as [`SwcOptions::validate`].
///
/// # Complexity
/// O(n log n) for n rows, O(n) apart from looking up ids; about 120 bytes a row while reading.
pub fn read(text: &str, options: &SwcOptions, limits: &Limits) -> Result<SwcImport> {
    options.validate()?;
    let mut rows = Rows::parse(text, options, limits)?;
    let (parents, root) = resolve(&rows)?;
    let (positions, moved_by) = place(&rows, root, options)?;
    let radii = std::mem::take(&mut rows.radii);
    let Reordered { mut skeleton, rows: row_of } =
        Skeleton::from_unordered(positions, radii, parents).map_err(|error| match error {
            CoreError::Cycle { node } => {
                problem(&rows, node, SwcProblem::Cycle { id: rows.ids[node] })
            }
            other => other,
        })?;
    let n_unknown = |skeleton: &Skeleton| skeleton.radii().iter().filter(|&&r| r == 0.0).count();
    let n_unknown_radii = n_unknown(&skeleton);
    match options.unknown_radius {
        UnknownRadius::Keep => {}
        UnknownRadius::Interpolate => interpolate(&mut skeleton)?,
    }
    let report = SwcReport {
        comments: std::mem::take(&mut rows.comments),
        n_unknown_radii,
        n_filled_radii: n_unknown_radii - n_unknown(&skeleton),
        n_rows_with_more_fields: rows.n_rows_with_more_fields,
        reordered: row_of.iter().enumerate().any(|(i, &row)| i != row as usize),
        moved_by,
    };
    Ok(SwcImport {
        skeleton,
        types: row_of.iter().map(|&row| rows.types[row as usize]).collect(),
        ids: row_of.iter().map(|&row| rows.ids[row as usize]).collect(),
        report,
    })
}

/// Reads an SWC file, which must be UTF-8 text (ASCII is).
///
/// # Errors
/// As [`read`]; [`CoreError::Io`] with the path; [`CoreError::Limit`] when the file is larger than
/// [`Limits::input_bytes`].
pub fn read_file(path: &Path, options: &SwcOptions, limits: &Limits) -> Result<SwcImport> {
    read(&crate::file::read_text(path, limits)?, options, limits)
}

fn problem(rows: &Rows, row: usize, problem: SwcProblem) -> CoreError {
    CoreError::Swc { line: rows.lines.get(row).copied().unwrap_or(rows.n_lines.max(1)), problem }
}

/// The row of each row's parent, and the row of the root.
fn resolve(rows: &Rows) -> Result<(Vec<u32>, usize)> {
    if rows.ids.is_empty() {
        return Err(problem(rows, 0, SwcProblem::NoRows));
    }
    if rows.ids.len() >= NO_PARENT as usize {
        return Err(CoreError::OutOfRange {
            field: "nodes",
            index: 0,
            found: rows.ids.len() as f64,
            min: 1.0,
            max: f64::from(NO_PARENT - 1),
        });
    }
    let row_of_id = index_ids(rows)?;
    let mut root = None;
    let mut parents = Vec::with_capacity(rows.ids.len());
    for (row, &parent) in rows.parents.iter().enumerate() {
        if parent == ROOT_MARK {
            if let Some(first) = root.replace(row) {
                let first_line = rows.lines[first];
                return Err(problem(rows, row, SwcProblem::SecondRoot { first_line }));
            }
            parents.push(NO_PARENT);
            continue;
        }
        match row_of_id.binary_search_by_key(&parent, |&(id, _)| id) {
            Ok(found) => parents.push(row_of_id[found].1),
            Err(_) => {
                let id = rows.ids[row];
                return Err(problem(rows, row, SwcProblem::UnknownParent { id, parent }));
            }
        }
    }
    match root {
        Some(root) => Ok((parents, root)),
        None => Err(problem(rows, 0, SwcProblem::NoRoot)),
    }
}

/// Ids with their rows, sorted by id; of several duplicates the one that comes first in the file
/// is reported.
fn index_ids(rows: &Rows) -> Result<Vec<(i64, u32)>> {
    let mut row_of_id: Vec<(i64, u32)> = rows.ids.iter().copied().zip(0..).collect();
    row_of_id.sort_unstable();
    let duplicate = row_of_id
        .windows(2)
        .filter_map(|pair| match *pair {
            [(a, first), (b, second)] if a == b => Some((second, first, a)),
            _ => None,
        })
        .min();
    match duplicate {
        Some((second, first, id)) => {
            let first_line = rows.lines[first as usize];
            let duplicate = SwcProblem::DuplicateId { id, first_line };
            Err(problem(rows, second as usize, duplicate))
        }
        None => Ok(row_of_id),
    }
}

/// Positions in metres with +Y up, and what was added to them.
fn place(rows: &Rows, root: usize, options: &SwcOptions) -> Result<(Vec<Vec3>, [f64; 3])> {
    let base = if options.base_at_origin { rows.positions[root] } else { [0.0; 3] };
    // Not subtracting a zero keeps the sign of a negative zero.
    let offset = |value: f64, base: f64| if base == 0.0 { value } else { value - base };
    let mut positions = Vec::with_capacity(rows.positions.len());
    for (row, &[x, y, z]) in rows.positions.iter().enumerate() {
        let [x, y, z] = [(x, base[0], "x"), (y, base[1], "y"), (z, base[2], "z")].map(
            |(value, base, field)| {
                let metres = (offset(value, base) * options.scale) as f32;
                if metres.is_finite() {
                    Ok(metres)
                } else {
                    Err(problem(rows, row, SwcProblem::NotFinite { field }))
                }
            },
        );
        positions.push(Vec3::from(options.up.to_y_up([x?, y?, z?])));
    }
    // 0 − x rather than −x: a root that was at the origin is reported as moved by 0, not by −0.
    let moved_by = options.up.to_y_up(base).map(|metres| 0.0 - metres * options.scale);
    Ok((positions, moved_by))
}
