//! Skeletons from and to SWC files, the plain-text exchange format of neuron tracing (Cannon et al.
//! 1998), which tree scanning has taken over.
//!
//! A row is `id type x y z radius parent`, separated by blanks; parent −1 marks the root; `#`
//! starts a comment. In botanical files type 3 continues the axis of its parent, type 4 starts a
//! lateral, and radius 0 means that the radius is not known.
//!
//! Files in the wild are read as they are: ids in any order and with gaps, rows before their
//! parents, further columns, blank lines, tabs, any line ending, a byte-order mark, whole numbers
//! written as `3.0`. What cannot be meant is an error with its line: [`SwcProblem`].
//!
//! ```
//! use tree_core::{Limits, swc};
//! let text = "# Z up, metres\n1 3 0 0 0 0.1 -1\n2 3 0 0 1.5 0.05 1\n";
//! let import = swc::read(text, &swc::SwcOptions::default(), &Limits::default())?;
//! assert_eq!(import.skeleton.positions()[1].y, 1.5);
//! # Ok::<(), tree_core::CoreError>(())
//! ```

mod fill;
mod read;
mod rows;
mod write;

pub use read::{SwcImport, SwcReport, read, read_file};
pub use write::{write, write_file, write_to};

use crate::error::Result;
use crate::parameter::check_parameter;

/// Smallest and largest [`SwcOptions::scale`]: beyond them a tree in f32 metres is a slip.
const SCALE: (f64, f64) = (1e-9, 1e9);

/// Which axis of a file points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum UpAxis {
    /// +Y, as in this library.
    Y,
    /// +Z, as laser scanners and foresters have it.
    #[default]
    Z,
}

impl UpAxis {
    /// From the file's axes to +Y up: (x, z, −y) where Z is up. Exact.
    #[must_use]
    pub fn to_y_up<T: std::ops::Neg<Output = T>>(self, [x, y, z]: [T; 3]) -> [T; 3] {
        match self {
            Self::Y => [x, y, z],
            Self::Z => [x, z, -y],
        }
    }

    /// From +Y up to the file's axes: (x, −z, y) where Z is up. Exact.
    #[must_use]
    pub fn from_y_up<T: std::ops::Neg<Output = T>>(self, [x, y, z]: [T; 3]) -> [T; 3] {
        match self {
            Self::Y => [x, y, z],
            Self::Z => [x, -z, y],
        }
    }
}

/// What becomes of radii that a file does not know (radius 0).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum UnknownRadius {
    /// They stay 0, for example to be found by [`allometry`](crate::allometry).
    #[default]
    Keep,
    /// They go from the radius below to the thickest known radius above, in proportion to the path
    /// length. Where nothing is known above, as at twigs, the radius below is taken; where nothing
    /// is known below, the one above; where nothing is known at all, 0 stays.
    Interpolate,
}

/// How coordinates of a file relate to ours.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct SwcOptions {
    /// The file's upward axis. Default Z.
    pub up: UpAxis,
    /// Metres per unit of the file, for positions and radii; from 1e-9 to 1e9. Default 1.
    pub scale: f64,
    /// Whether reading moves the root to the origin. Default true. The move is made in f64, so
    /// that coordinates of a map grid lose nothing. Not used in writing.
    pub base_at_origin: bool,
    /// What becomes of radii that the file does not know. Default: they stay 0. Not used in
    /// writing.
    pub unknown_radius: UnknownRadius,
}

impl Default for SwcOptions {
    fn default() -> Self {
        Self {
            up: UpAxis::Z,
            scale: 1.0,
            base_at_origin: true,
            unknown_radius: UnknownRadius::Keep,
        }
    }
}

impl SwcOptions {
    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`CoreError::Parameter`](crate::CoreError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        let (min, max) = SCALE;
        Ok(check_parameter("scale", self.scale, min, max)?)
    }
}

/// What is wrong with a line of an SWC file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SwcProblem {
    /// A line has fewer than seven fields, as the last line of a truncated file does.
    #[error("{found} of 7 fields (id type x y z radius parent); is the file truncated?")]
    Fields {
        /// How many there are.
        found: usize,
    },
    /// A field is not a number, or not a whole one where that is needed.
    #[error("{field} is {found:?}, which is not {}", wanted(.field))]
    NotANumber {
        /// The field: `id`, `type`, `x`, `y`, `z`, `radius` or `parent`.
        field: &'static str,
        /// How it begins.
        found: String,
    },
    /// A coordinate or radius is NaN or infinite, or does not fit an f32 once it is in metres.
    #[error("{field} is not finite, or not once it is in metres")]
    NotFinite {
        /// The field: `x`, `y`, `z` or `radius`.
        field: &'static str,
    },
    /// A radius is negative.
    #[error("radius is {found}, but must be 0 (unknown) or more")]
    NegativeRadius {
        /// The radius, in the file's unit.
        found: f64,
    },
    /// An id is negative. Ids count from 0 or 1, and −1 as a parent means that there is none.
    #[error("id is {found}, but must be 0 or more")]
    NegativeId {
        /// The id.
        found: i64,
    },
    /// Two rows have the same id.
    #[error("id {id} is taken by line {first_line}")]
    DuplicateId {
        /// The id.
        id: i64,
        /// The line that has it first.
        first_line: usize,
    },
    /// A row names a parent that no row is.
    #[error("node {id} has parent {parent}, but no line has that id (−1 marks the root)")]
    UnknownParent {
        /// The id of the row.
        id: i64,
        /// The parent it names.
        parent: i64,
    },
    /// Following parents from this row never reaches the root.
    #[error("node {id} lies on a cycle: following its parents never reaches the root")]
    Cycle {
        /// The id of one row on the cycle.
        id: i64,
    },
    /// A row has parent −1, but another one before has it too. A file of several trees must be
    /// parted first.
    #[error("a second root: line {first_line} has parent −1 already")]
    SecondRoot {
        /// The line of the first root.
        first_line: usize,
    },
    /// No row has parent −1. The line is that of the first row.
    #[error("no root: one line must have parent −1")]
    NoRoot,
    /// The file has no rows. The line is the last one.
    #[error("no rows: at least one node is needed")]
    NoRows,
}

/// What a field must hold.
fn wanted(field: &str) -> &'static str {
    match field {
        "id" | "parent" => "a whole number of 64 bits",
        "type" => "a whole number of 32 bits",
        _ => "a number",
    }
}

#[cfg(test)]
mod tests;
