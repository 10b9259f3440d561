//! What an edit changed.

use crate::border::{Handle, Versioned, call, free, get, tree_status, tree_str, write};
use crate::mesh::column;
use std::ptr::null;
use tree_model::silhouette::session::Change;

/// What an edit of a `tree_silhouette_session` changed.
pub struct tree_silhouette_change {
    change: Change,
    repairs: Vec<tree_str>,
}

// SAFETY: the views point into the texts, which never change.
unsafe impl Send for tree_silhouette_change {}
// SAFETY: as above.
unsafe impl Sync for tree_silhouette_change {}

impl Handle for tree_silhouette_change {
    const NAME: &'static str = "tree_silhouette_change";
}

impl tree_silhouette_change {
    pub(super) fn new(change: Change) -> Self {
        let repairs = change.repairs.iter().map(|text| tree_str::of(text)).collect();
        Self { change, repairs }
    }
}

/// A view of a `tree_silhouette_change`: ids of branches, in rising order. Set `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_silhouette_change_columns {
    /// `sizeof(tree_silhouette_change_columns)`.
    pub struct_size: usize,
    /// Number of branches that are new.
    pub n_added: usize,
    /// Their ids.
    pub added: *const u32,
    /// Number of branches that are gone.
    pub n_removed: usize,
    /// Their ids.
    pub removed: *const u32,
    /// Number of branches whose line, outline or place is another.
    pub n_reshaped: usize,
    /// Their ids.
    pub reshaped: *const u32,
    /// Number of branches that bear a drawn system which they did not, or another one, or take their style from
    /// elsewhere.
    pub n_restyled: usize,
    /// Their ids.
    pub restyled: *const u32,
    /// Number of repairs of the stroke.
    pub n_repairs: usize,
    /// What was repaired in the stroke, in sentences.
    pub repairs: *const tree_str,
    /// 1 where the trunk or the crown is another.
    pub trunk: u32,
    /// 1 where the leaf is another.
    pub leaf: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_silhouette_change_columns {
    const NAME: &'static str = "tree_silhouette_change_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_added: 0,
            added: null(),
            n_removed: 0,
            removed: null(),
            n_reshaped: 0,
            reshaped: null(),
            n_restyled: 0,
            restyled: null(),
            n_repairs: 0,
            repairs: null(),
            trunk: 0,
            leaf: 0,
        }
    }
}

/// Views a change. Valid until `tree_silhouette_change_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_change_view(
    change: *const tree_silhouette_change,
    columns: *mut tree_silhouette_change_columns,
) -> tree_status {
    call(|| {
        let tree_silhouette_change { change, repairs } = unsafe { get(change, "change") }?;
        let value = tree_silhouette_change_columns {
            n_added: change.added.len(),
            added: column(&change.added),
            n_removed: change.removed.len(),
            removed: column(&change.removed),
            n_reshaped: change.reshaped.len(),
            reshaped: column(&change.reshaped),
            n_restyled: change.restyled.len(),
            restyled: column(&change.restyled),
            n_repairs: repairs.len(),
            repairs: column(repairs),
            trunk: change.trunk.into(),
            leaf: change.leaf.into(),
            ..tree_silhouette_change_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// Frees a change.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_change_free(
    change: *mut tree_silhouette_change,
) -> tree_status {
    call(|| unsafe { free(change, "change") })
}
