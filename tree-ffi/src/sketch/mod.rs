//! Freehand sketches: drawings cleaned and joined, crowns closed, templates chosen, and trees inferred from them.

mod branches;
mod clean;
mod crown;
pub(crate) mod drawing;
mod exemplar;
mod finish;
mod footprint;
mod infer;
mod infer_graph;
mod midline;
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
pub use exemplar::*;
pub use finish::*;
pub use footprint::*;
pub use infer::*;
pub use infer_graph::*;
pub use midline::*;
pub use omega::*;
pub use plan::*;
pub use propagate::*;
pub use select::*;
pub use session::*;
pub use template::*;

use crate::border::{Failure, Result, TREE_ERROR_FORMAT, TREE_ERROR_TEXT, bytes, fill, vec2s};
use crate::control::{limits, run, tree_control};
use crate::memory;
use glam::Vec2;
use rayon::prelude::*;
use std::ffi::c_char;
use tree_model::ModelError;
use tree_model::tree_core::{Control, Limits, Resource};

/// A caller's document.
///
/// # Safety
/// As [`bytes`].
pub(crate) unsafe fn document<'a>(
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
pub(crate) fn ask_to_parse(text: &str) -> Result<()> {
    memory::ask((text.len() as u64).saturating_mul(PARSED))
}

/// What is wrong with a document is wrong with its format.
pub(crate) fn in_document(error: ModelError) -> Failure {
    match error {
        ModelError::Sketch { .. }
        | ModelError::Stroke { .. }
        | ModelError::Template { .. }
        | ModelError::Silhouette { .. } => Failure::new(TREE_ERROR_FORMAT, error.to_string()),
        other => other.into(),
    }
}

/// As [`fill`]; for no values there need be no buffer.
///
/// # Safety
/// As [`fill`].
pub(crate) unsafe fn fill_some<T: Copy>(
    first: *mut T,
    capacity: usize,
    values: &[T],
    argument: &str,
) -> Result<()> {
    if values.is_empty() { Ok(()) } else { unsafe { fill(first, capacity, values, argument) } }
}

/// A caller's points of the plane, as many as the limits of `control` allow nodes.
///
/// # Safety
/// As [`vec2s`].
pub(crate) unsafe fn spots<'a>(
    first: *const f32,
    n: usize,
    control: *const tree_control,
) -> Result<&'a [Vec2]> {
    unsafe { vec2s(first, n, &limits(control)?, Resource::Nodes, "spots") }
}

/// Points between two looks whether to go on.
const CHUNK: usize = 1 << 14;

/// One answer for each row.
///
/// # Safety
/// As [`run`].
pub(crate) unsafe fn answers<P: Sync, T: Send>(
    rows: &[P],
    control: *const tree_control,
    ask: impl Fn(&P) -> T + Sync + Send,
) -> Result<Vec<T>> {
    let body = |control: &Control| {
        control.check()?;
        // A few points are not worth waking other threads.
        if rows.len() <= CHUNK {
            return Ok(rows.iter().map(&ask).collect());
        }
        let chunks: Vec<Vec<T>> = rows
            .par_chunks(CHUNK)
            .map(|rows| {
                control.check()?;
                Ok(rows.iter().map(&ask).collect())
            })
            .collect::<Result<_>>()?;
        Ok(chunks.into_iter().flatten().collect())
    };
    unsafe { run(control, body) }
}
