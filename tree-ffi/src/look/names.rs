//! Names of the built-in barks and leaves.

use crate::border::{call, out_value, tree_status, tree_str};
use ::tree_mesh::texture::{bark_names, leaf_names};

/// Views of names that are constants.
struct Names<const N: usize>([tree_str; N]);

// SAFETY: points at constants.
unsafe impl<const N: usize> Sync for Names<N> {}

impl<const N: usize> Names<N> {
    const fn of(names: &'static [&'static str]) -> Self {
        let mut views = [tree_str::EMPTY; N];
        let mut i = 0;
        while i < N {
            views[i] = tree_str::of(names[i]);
            i += 1;
        }
        Self(views)
    }
}

static BARKS: Names<{ bark_names().len() }> = Names::of(bark_names());
static LEAVES: Names<{ leaf_names().len() }> = Names::of(leaf_names());

/// Views the names of the built-in barks: where they begin and how many there are. Valid for ever.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bark_names(
    names: *mut *const tree_str,
    n_names: *mut usize,
) -> tree_status {
    call(|| {
        unsafe { out_value(names, BARKS.0.as_ptr(), "names") }?;
        unsafe { out_value(n_names, BARKS.0.len(), "n_names") }
    })
}

/// Views the names of the built-in leaves (single ones, clusters, needles and fronds): where they begin
/// and how many there are. Valid for ever.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_names(
    names: *mut *const tree_str,
    n_names: *mut usize,
) -> tree_status {
    call(|| {
        unsafe { out_value(names, LEAVES.0.as_ptr(), "names") }?;
        unsafe { out_value(n_names, LEAVES.0.len(), "n_names") }
    })
}
