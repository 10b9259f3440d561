//! What can go wrong in this crate.

use crate::control::Cancelled;
use crate::limits::LimitError;
use crate::parameter::ParameterError;
use std::path::PathBuf;

/// Shorthand for results of this crate.
pub type Result<T, E = CoreError> = std::result::Result<T, E>;

/// Every error of tree-core. Each says what was wrong, where, and what would be right.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CoreError {
    /// Something that must hold at least one element holds none.
    #[error("{what} is empty: at least one element is needed")]
    Empty {
        /// What was empty, for example `skeleton`.
        what: &'static str,
    },
    /// A coordinate or a length is NaN or infinite.
    #[error("{field}[{index}] is not finite")]
    NotFinite {
        /// The column or parameter.
        field: &'static str,
        /// Row in that column; 0 for a single value.
        index: usize,
    },
    /// A parameter lies outside its range.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// A number in a column lies outside its range.
    #[error("{field}[{index}] is {found}, allowed is {min} to {max}")]
    OutOfRange {
        /// The column.
        field: &'static str,
        /// Row in that column.
        index: usize,
        /// The value that came in.
        found: f64,
        /// Smallest allowed value.
        min: f64,
        /// Largest allowed value.
        max: f64,
    },
    /// Two columns that belong together differ in length.
    #[error("{field} has {found} rows, {expected} are needed")]
    Length {
        /// The column at fault.
        field: &'static str,
        /// Its number of rows.
        found: usize,
        /// The number of rows of its neighbours.
        expected: usize,
    },
    /// Row 0 of a skeleton names a parent, or another row names none.
    #[error("node {node} has no parent, but the one root of a skeleton is node 0")]
    SecondRoot {
        /// The offending node.
        node: usize,
    },
    /// The first row is not a root.
    #[error("node 0 has parent {parent}, but node 0 must be the root")]
    RootHasParent {
        /// The parent that row 0 names.
        parent: u32,
    },
    /// No row is a root.
    #[error("no node is a root: one node must have no parent")]
    NoRoot,
    /// A node comes before its parent, or names one that does not exist.
    #[error("node {node} has parent {parent}, but a parent must come before its children")]
    ParentOrder {
        /// The offending node.
        node: usize,
        /// The parent it names.
        parent: u32,
    },
    /// Following parents from this node never reaches the root.
    #[error("node {node} lies on a cycle: following its parents never reaches the root")]
    Cycle {
        /// One node on the cycle.
        node: usize,
    },
    /// A leaf names something that the tree does not have.
    #[error("leaf {leaf} refers to {what} {found}, but there are only {count}")]
    Dangling {
        /// Row in the foliage.
        leaf: usize,
        /// What it refers to: `node` or `kind`.
        what: &'static str,
        /// The index it holds.
        found: u32,
        /// How many there are.
        count: usize,
    },
    /// A volume that contains nothing or is not well formed.
    #[error("{solid}: {problem}")]
    Volume {
        /// The kind of solid.
        solid: &'static str,
        /// What is wrong with it and what would be right.
        problem: String,
    },
    /// A line of an SWC file cannot be used.
    #[error("SWC line {line}: {problem}")]
    Swc {
        /// Line number, from 1.
        line: usize,
        /// What is wrong with it.
        problem: crate::swc::SwcProblem,
    },
    /// More was asked for than [`Limits`](crate::Limits) allows.
    #[error(transparent)]
    Limit(#[from] LimitError),
    /// The caller cancelled the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A file could not be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        #[source]
        source: std::io::Error,
    },
}

impl CoreError {
    /// Wraps what the system said about `path`.
    pub fn io(path: impl Into<PathBuf>, source: std::io::Error) -> Self {
        Self::Io { path: path.into(), source }
    }
}

/// Checks that `found` is finite and within `min..=max`.
///
/// # Errors
/// [`CoreError::NotFinite`] or [`CoreError::OutOfRange`], naming `field[index]`.
pub fn check_range(
    field: &'static str,
    index: usize,
    found: f32,
    min: f32,
    max: f32,
) -> Result<()> {
    if !found.is_finite() {
        return Err(CoreError::NotFinite { field, index });
    }
    if found < min || found > max {
        return Err(CoreError::OutOfRange {
            field,
            index,
            found: f64::from(found),
            min: f64::from(min),
            max: f64::from(max),
        });
    }
    Ok(())
}

/// Checks that all coordinates are finite.
///
/// # Errors
/// [`CoreError::NotFinite`] that names the first bad row of `field`.
pub fn check_finite(field: &'static str, values: &[glam::Vec3]) -> Result<()> {
    match values.iter().position(|v| !v.is_finite()) {
        Some(index) => Err(CoreError::NotFinite { field, index }),
        None => Ok(()),
    }
}
