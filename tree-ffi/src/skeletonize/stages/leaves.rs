//! Leaves found in a mesh.

use super::separation::tree_separation;
use crate::border::{Handle, Versioned, call, free, get, out, tree_status, tree_str, write};
use crate::control::{run, tree_control};
use crate::mesh::column;
use crate::skeleton::tree_skeleton;
use crate::tree::tree_foliage;
use tree_model::skeletonize::stages::Leaves;

/// Leaves found in a mesh, and their kinds.
pub struct tree_found_leaves {
    leaves: Leaves,
    names: Names,
}

/// Views of the kinds' names.
struct Names(Vec<tree_str>);
// SAFETY: point into the leaves that the same object holds and nothing changes.
unsafe impl Send for Names {}
// SAFETY: as above.
unsafe impl Sync for Names {}

impl Handle for tree_found_leaves {
    const NAME: &'static str = "tree_found_leaves";
}

/// A view of the kinds of leaves that were found.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_leaf_kinds {
    /// `sizeof(tree_leaf_kinds)`.
    pub struct_size: usize,
    /// Number of kinds.
    pub n_kinds: usize,
    /// Names of the kinds: those of the parts they come from.
    pub names: *const tree_str,
    /// Mean width of each kind as a share of its length.
    pub widths: *const f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_leaf_kinds {
    const NAME: &'static str = "tree_leaf_kinds";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_kinds: 0,
            names: std::ptr::null(),
            widths: std::ptr::null(),
        }
    }
}

/// The fourth stage: makes a leaf of each leaf component, on the nearest wood of a skeleton as
/// `tree_pieces_link` returns it. Positions and sizes are in the units of the mesh already. `control` may
/// be NULL. Free the leaves with `tree_found_leaves_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_separation_leaves(
    separation: *const tree_separation,
    skeleton: *const tree_skeleton,
    control: *const tree_control,
    leaves: *mut *mut tree_found_leaves,
) -> tree_status {
    call(|| {
        let place = unsafe { out(leaves, "leaves") }?;
        let separation = unsafe { get(separation, "separation") }?.rust();
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let leaves = unsafe { run(control, |control| Ok(separation.leaves(skeleton, control)?)) }?;
        let names = Names(leaves.kinds.iter().map(|kind| tree_str::of(kind)).collect());
        place.put(tree_found_leaves { leaves, names });
        Ok(())
    })
}

/// Views the leaves, in the form that `tree_tree_new` takes. Set `foliage->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_found_leaves_foliage(
    leaves: *const tree_found_leaves,
    foliage: *mut tree_foliage,
) -> tree_status {
    call(|| {
        let leaves = unsafe { get(leaves, "leaves") }?;
        unsafe { write(foliage, "foliage", &tree_foliage::of(&leaves.leaves.foliage)) }
    })
}

/// Views the kinds of leaves. Set `kinds->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_found_leaves_view(
    leaves: *const tree_found_leaves,
    kinds: *mut tree_leaf_kinds,
) -> tree_status {
    call(|| {
        let leaves = unsafe { get(leaves, "leaves") }?;
        let value = tree_leaf_kinds {
            n_kinds: leaves.names.0.len(),
            names: column(&leaves.names.0),
            widths: column(&leaves.leaves.widths),
            ..tree_leaf_kinds::default_value()
        };
        unsafe { write(kinds, "kinds", &value) }
    })
}

/// Frees leaves found in a mesh.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_found_leaves_free(leaves: *mut tree_found_leaves) -> tree_status {
    call(|| unsafe { free(leaves, "leaves") })
}
