//! Lines of text, for people.

use crate::border::{Handle, call, free, get, out_value, tree_status, tree_str};
use crate::mesh::column;

/// Lines of text, for people: warnings, mostly. There may be none.
pub struct tree_lines {
    _texts: Vec<String>,
    views: Vec<tree_str>,
}

// SAFETY: the views point into the texts, which never change.
unsafe impl Send for tree_lines {}
// SAFETY: as above.
unsafe impl Sync for tree_lines {}

impl Handle for tree_lines {
    const NAME: &'static str = "tree_lines";
}

impl tree_lines {
    pub(crate) fn new(texts: Vec<String>) -> Self {
        let views = texts.iter().map(|text| tree_str::of(text)).collect();
        Self { _texts: texts, views }
    }
}

/// Views the lines: where they begin and how many there are. Valid until `tree_lines_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lines_view(
    lines: *const tree_lines,
    texts: *mut *const tree_str,
    n_texts: *mut usize,
) -> tree_status {
    call(|| {
        let lines = &unsafe { get(lines, "lines") }?.views;
        unsafe { out_value(texts, column(lines), "texts") }?;
        unsafe { out_value(n_texts, lines.len(), "n_texts") }
    })
}

/// Frees lines of text.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lines_free(lines: *mut tree_lines) -> tree_status {
    call(|| unsafe { free(lines, "lines") })
}
