//! What can go wrong in this crate.

use tree_core::{Cancelled, CoreError, LimitError, ParameterError};
use tree_mesh::MeshError;

/// Shorthand for results of this crate.
pub(crate) type Result<T, E = LodError> = std::result::Result<T, E>;

/// Every error of tree-lod. Each says what was wrong, where, and what would be right.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LodError {
    /// A parameter lies outside its range, or is not finite.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// A camera that does not look anywhere.
    #[error("{field}: {problem}")]
    Camera {
        /// The field at fault.
        field: &'static str,
        /// What is wrong with it and what would be right.
        problem: &'static str,
    },
    /// A picture's pixels do not fill its width and height.
    #[error("picture: {found} bytes, {expected} are needed for {width} × {height} RGBA")]
    Picture {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// Bytes it holds.
        found: usize,
        /// Bytes it needs.
        expected: usize,
    },
    /// A table of levels that is not one.
    #[error("table, row {row}: {problem}")]
    Table {
        /// The row at fault.
        row: usize,
        /// What is wrong with it and what would be right.
        problem: &'static str,
    },
    /// Columns that belong together have different lengths.
    #[error("{what}: {found} rows, {expected} are needed")]
    Length {
        /// The column at fault.
        what: &'static str,
        /// Rows it has.
        found: usize,
        /// Rows it should have.
        expected: usize,
    },
    /// There is nothing that could be pruned.
    #[error("foliage: {0}")]
    Foliage(&'static str),
    /// An order of elements that leaves some out or has one twice.
    #[error("order, row {row}: {problem}")]
    Order {
        /// The row at fault.
        row: usize,
        /// What is wrong with it and what would be right.
        problem: &'static str,
    },
    /// A scene that cannot be drawn: instances, models, cameras, depth buffers.
    #[error("scene: {what} {row}: {problem}")]
    Scene {
        /// What is at fault: "instance", "model", "camera", "depth buffer", "state", "output".
        what: &'static str,
        /// Its number.
        row: usize,
        /// What is wrong with it and what would be right.
        problem: &'static str,
    },
    /// A bracketed chain of modules that is not one.
    #[error("chain, module {module}: {problem}")]
    Chain {
        /// The module at fault.
        module: usize,
        /// What is wrong with it and what would be right.
        problem: &'static str,
    },
    /// A progressive stream that is cut off before its first level, or damaged.
    #[error("stream, byte {byte}: {problem}")]
    Stream {
        /// Where reading stopped.
        byte: u64,
        /// What is wrong there.
        problem: String,
    },
    /// An impostor that cannot be made or read.
    #[error("impostor: {0}")]
    Impostor(&'static str),
    /// An image could not be encoded.
    #[cfg(feature = "image")]
    #[error("image: {0}")]
    Image(#[from] image::ImageError),
    /// The mesh cannot be used.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Something from the layer below.
    #[error(transparent)]
    Core(#[from] CoreError),
    /// More was asked for than the limits allow.
    #[error(transparent)]
    Limit(#[from] LimitError),
    /// The caller cancelled the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Checks that `found` is finite and within `min..=max`.
///
/// # Errors
/// [`LodError::Parameter`], naming `field`.
pub(crate) fn check_range(field: &'static str, found: f64, min: f64, max: f64) -> Result<()> {
    Ok(tree_core::check_parameter(field, found, min, max)?)
}
