//! Where a text or a word is wrong, as numbers.

use crate::border::{Result, Versioned, view};
use tree_model::ModelError;

/// What kind of place a mistake has: one of the `TREE_GRAMMAR_PLACE_` constants.
pub type tree_grammar_place = u32;
/// None: there is no mistake, or it has no place.
pub const TREE_GRAMMAR_PLACE_NONE: u32 = 0;
/// A line and a column of the text.
pub const TREE_GRAMMAR_PLACE_TEXT: u32 = 1;
/// A module of the word.
pub const TREE_GRAMMAR_PLACE_MODULE: u32 = 2;

/// Where a text or a word is wrong, for an editor that marks the place; what is wrong is in
/// `tree_error_text`. Written when the call fails, too.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_grammar_report {
    /// `sizeof(tree_grammar_report)`.
    pub struct_size: usize,
    /// `TREE_GRAMMAR_PLACE_TEXT`: line of the text, from 1; else 0.
    pub line: u64,
    /// `TREE_GRAMMAR_PLACE_TEXT`: column in characters, from 1; else 0.
    pub column: u64,
    /// `TREE_GRAMMAR_PLACE_MODULE`: index of the module in the word, from 0; else 0.
    pub module: u64,
    /// Which of these hold.
    pub place: tree_grammar_place,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_grammar_report {
    const NAME: &'static str = "tree_grammar_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            line: 0,
            column: 0,
            module: 0,
            place: TREE_GRAMMAR_PLACE_NONE,
            reserved: 0,
        }
    }
}

impl tree_grammar_report {
    fn of(error: &ModelError) -> Self {
        let none = Self::default_value();
        match *error {
            ModelError::Grammar { line, column, .. } => Self {
                line: line as u64,
                column: column as u64,
                place: TREE_GRAMMAR_PLACE_TEXT,
                ..none
            },
            ModelError::Word { module, .. } => {
                Self { module: module as u64, place: TREE_GRAMMAR_PLACE_MODULE, ..none }
            }
            _ => none,
        }
    }
}

/// Clears a caller's report: what fails before anything is read has no place.
///
/// # Safety
/// `report` is NULL or points at a struct of the size it states, which may be written.
pub(super) unsafe fn clear(report: *mut tree_grammar_report) -> Result<()> {
    unsafe { view(report, "report", &tree_grammar_report::default_value()) }
}

/// The result; a failure is noted in the caller's report.
///
/// # Safety
/// As [`clear`].
pub(super) unsafe fn noted<T>(
    result: std::result::Result<T, ModelError>,
    report: *mut tree_grammar_report,
) -> Result<T> {
    if let Err(error) = &result {
        unsafe { view(report, "report", &tree_grammar_report::of(error)) }?;
    }
    Ok(result?)
}
