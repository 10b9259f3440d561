//! Skeletons from and to SWC files.

/// What is wrong with a line of an SWC file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SwcProblem {
    /// A line has fewer than seven fields, as the last line of a truncated file does.
    #[error("{found} of 7 fields (id type x y z radius parent); is the file truncated?")]
    Fields {
        /// How many there are.
        found: usize,
    },
}
