//! Trees as they are compared.

use super::params::tree_edit_params;
use crate::border::{
    Handle, Versioned, call, free, get, out, read, read_or_default, slice, tree_status, write,
};
use crate::control::{limits, tree_control};
use crate::mesh::column;
use crate::skeleton::tree_skeleton;
use tree_core::distance::EditTree;
use tree_model::tree_core::Resource;

/// A rooted tree with a weight for every node, to be compared with many others: a skeleton, perhaps with runs or axes
/// as one node each, or any tree of your own.
pub struct tree_edit_tree(EditTree);

impl Handle for tree_edit_tree {
    const NAME: &'static str = "tree_edit_tree";
}

impl tree_edit_tree {
    pub(super) fn rust(&self) -> &EditTree {
        &self.0
    }
}

/// A tree that is compared, in columns: as input, or as a view.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_edit_columns {
    /// `sizeof(tree_edit_columns)`.
    pub struct_size: usize,
    /// Number of nodes, at least 1.
    pub n_nodes: usize,
    /// One for each node: its parent, which comes before it; `TREE_NO_PARENT` for node 0 alone.
    pub parents: *const u32,
    /// One for each node: its weight, finite and 0 or more.
    pub weights: *const f64,
    /// One for each node: the uppermost of the skeleton's nodes that it stands for; of a tree of columns, the node itself.
    /// Not looked at as input.
    pub nodes: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_edit_columns {
    const NAME: &'static str = "tree_edit_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_nodes: 0,
            parents: std::ptr::null(),
            weights: std::ptr::null(),
            nodes: std::ptr::null(),
        }
    }
}

/// Reduces and weighs a skeleton, which is not kept. `params` may be NULL. Free the tree with `tree_edit_tree_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_edit_tree_of_skeleton(
    skeleton: *const tree_skeleton,
    params: *const tree_edit_params,
    tree: *mut *mut tree_edit_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust(false)?;
        place.put(tree_edit_tree(EditTree::of(skeleton, &params)));
        Ok(())
    })
}

/// Makes a tree of columns, which are copied. `control` may be NULL; only its limits matter. `TREE_ERROR_INVALID` for a
/// second root or parents that do not come first, `TREE_ERROR_PARAMETER` for weights below 0 or not finite. Free the
/// tree with `tree_edit_tree_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_edit_tree_from_columns(
    columns: *const tree_edit_columns,
    control: *const tree_control,
    tree: *mut *mut tree_edit_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        let columns = unsafe { read(columns, "columns") }?;
        let limits = unsafe { limits(control) }?;
        let (n, nodes) = (columns.n_nodes, Resource::Nodes);
        let parents = unsafe { slice(columns.parents, n, &limits, nodes, "columns.parents") }?;
        let weights = unsafe { slice(columns.weights, n, &limits, nodes, "columns.weights") }?;
        place.put(tree_edit_tree(EditTree::new(parents.to_vec(), weights.to_vec())?));
        Ok(())
    })
}

/// Views the tree. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_edit_tree_view(
    tree: *const tree_edit_tree,
    columns: *mut tree_edit_columns,
) -> tree_status {
    call(|| {
        let tree = unsafe { get(tree, "tree") }?.rust();
        let value = tree_edit_columns {
            n_nodes: tree.len(),
            parents: column(tree.parents()),
            weights: column(tree.weights()),
            nodes: column(tree.nodes()),
            ..tree_edit_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// Frees a tree that is compared.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_edit_tree_free(tree: *mut tree_edit_tree) -> tree_status {
    call(|| unsafe { free(tree, "tree") })
}
