//! Freehand sketches: drawings cleaned and joined, crowns closed, templates chosen, and trees inferred from them.

mod branches;
mod clean;
mod crown;
mod drawing;
mod finish;
mod infer;
mod infer_graph;
mod omega;
mod plan;
mod propagate;
mod select;
mod session;
mod template;

pub use branches::*;
pub use clean::*;
pub use crown::*;
pub use drawing::*;
pub use finish::*;
pub use infer::*;
pub use infer_graph::*;
pub use omega::*;
pub use plan::*;
pub use propagate::*;
pub use select::*;
pub use session::*;

use crate::border::{Failure, Result, TREE_ERROR_FORMAT, TREE_ERROR_TEXT, bytes};
use crate::memory;
use std::ffi::c_char;
use tree_model::ModelError;
use tree_model::tree_core::Limits;

/// A caller's document.
///
/// # Safety
/// As [`bytes`].
unsafe fn document<'a>(
    data: *const c_char,
    len: usize,
    limits: &Limits,
    argument: &str,
) -> Result<&'a str> {
    let bytes = unsafe { bytes(data.cast(), len, limits, argument) }?;
    std::str::from_utf8(bytes).map_err(|error| {
        let at = error.valid_up_to();
        Failure::new(TREE_ERROR_TEXT, format!("{argument} is not UTF-8 from byte {at} on"))
    })
}

/// Bytes that a parsed document takes for each of its own.
const PARSED: u64 = 30;

/// Asks the memory budget for parsing `text`, which cannot be stopped on the way.
fn ask_to_parse(text: &str) -> Result<()> {
    memory::ask((text.len() as u64).saturating_mul(PARSED))
}

/// What is wrong with a document is wrong with its format.
fn in_document(error: ModelError) -> Failure {
    match error {
        ModelError::Sketch { .. } | ModelError::Stroke { .. } | ModelError::Template { .. } => {
            Failure::new(TREE_ERROR_FORMAT, error.to_string())
        }
        other => other.into(),
    }
}
