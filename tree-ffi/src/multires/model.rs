//! Trees whose levels are prefixes of their columns.

use super::paths::{metric, tree_metric_params, tree_multi_paths};
use crate::border::{
    Failure, Handle, Result, Shared, TREE_ERROR_INVALID, Versioned, call, foresee, free, get, out,
    out_opt, out_value, tree_status, view,
};
use crate::control::{limits, run, tree_control};
use crate::foliage::tree_rows;
use crate::memory::ask;
use crate::mesh::column;
use crate::skeleton::tree_skeleton_columns;
use crate::tree::{tree_foliage, tree_tree};
use tree_lod::multires::{Adt, Multires};
use tree_model::tree_core::Tree;

/// About how many bytes a node or a leaf takes in a copy, with what is needed to sort it.
const BYTES_A_ROW: u64 = 64;

/// A tree with its nodes and leaves sorted path by path: its first levels are its coarser forms, and a level is no more
/// than a number. It is as large as the tree, and 8 bytes a level more.
pub struct tree_multires(Shared<Multires>);

impl Handle for tree_multires {
    const NAME: &'static str = "tree_multires";
}

impl tree_multires {
    pub(super) fn new(multires: Multires) -> Self {
        Self(Shared::new(multires))
    }

    /// A tree with levels that is part of something.
    pub(crate) fn part(held: Shared<Multires>) -> Self {
        Self(held)
    }

    pub(super) fn rust(&self) -> &Multires {
        self.0.get()
    }
}

/// Asks the memory budget for so many copies of a tree.
pub(super) fn ask_for_trees(tree: &Tree, times: u64) -> Result<()> {
    let rows = (tree.skeleton().len() + tree.foliage().len()) as u64;
    ask(times.saturating_mul(BYTES_A_ROW).saturating_mul(rows))
}

/// Sorts a tree, which is copied, by a metric, NULL for the default; its branches are those of `tree_adt_of_skeleton`.
/// `seed` matters to `TREE_METRIC_RANDOM` alone. `control` may be NULL. Free what is made with `tree_multires_free`.
///
/// `TREE_ERROR_INVALID` when there are not as many worths as branches, `TREE_ERROR_PARAMETER` when one is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_new(
    tree: *const tree_tree,
    params: *const tree_metric_params,
    seed: u64,
    control: *const tree_control,
    multires: *mut *mut tree_multires,
) -> tree_status {
    call(|| {
        let place = unsafe { out(multires, "multires") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let metric = unsafe { metric(params, seed, &limits(control)?) }?;
        let made = unsafe {
            run(control, |control| {
                ask_for_trees(tree, 2)?;
                Ok(Multires::new(tree, &metric, control)?)
            })
        }?;
        place.put(tree_multires::new(made));
        Ok(())
    })
}

/// Sorts a tree, which is copied, by paths of its own branches, and tells where rows went: `nodes` and `leaves`, each
/// of which may be NULL, get for each node and leaf its number in the tree that came in. Free them with
/// `tree_rows_free`, and what is made with `tree_multires_free`. `control` may be NULL; of it only a cancellation before
/// the work begins matters. `TREE_ERROR_INVALID` when the paths are those of another tree, or of a chain.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_of_paths(
    tree: *const tree_tree,
    paths: *const tree_multi_paths,
    control: *const tree_control,
    nodes: *mut *mut tree_rows,
    leaves: *mut *mut tree_rows,
    multires: *mut *mut tree_multires,
) -> tree_status {
    call(|| {
        let places = unsafe { (out_opt(nodes, "nodes"), out_opt(leaves, "leaves")) };
        let place = unsafe { out(multires, "multires") }?;
        let (nodes, leaves) = (places.0?, places.1?);
        let tree = unsafe { get(tree, "tree") }?.rust();
        let (adt, paths) = unsafe { get(paths, "paths") }?.rust();
        let (made, rows) = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_trees(tree, 3)?;
                is_of(adt, tree)?;
                Ok(Multires::of_paths(tree, adt, paths)?)
            })
        }?;
        if let Some(nodes) = nodes {
            nodes.put(tree_rows::new(rows.nodes));
        }
        if let Some(leaves) = leaves {
            leaves.put(tree_rows::new(rows.leaves));
        }
        place.put(tree_multires::new(made));
        Ok(())
    })
}

/// Paths of another tree with as many nodes would pass for this one's, and its levels would be no trees.
fn is_of(adt: &Adt, tree: &Tree) -> Result<()> {
    let own = Adt::of_skeleton(tree.skeleton());
    let same = |branch| adt.modules(branch) == own.modules(branch);
    if adt.parents() == own.parents() && (0..own.len() as u32).all(same) {
        return Ok(());
    }
    let text = "paths are not those of this tree's skeleton: make them with tree_adt_of_skeleton";
    Err(Failure::new(TREE_ERROR_INVALID, text))
}

/// Number of levels: of tips, at least 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_count(
    multires: *const tree_multires,
    n_levels: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(multires, "multires") }?.rust().n_levels();
        unsafe { out_value(n_levels, n, "n_levels") }
    })
}

/// Nodes and leaves of the first `n_levels` levels, at least one level, at most all.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_level_counts(
    multires: *const tree_multires,
    n_levels: usize,
    n_nodes: *mut usize,
    n_leaves: *mut usize,
) -> tree_status {
    call(|| {
        let counts = unsafe { get(multires, "multires") }?.rust().counts(n_levels);
        unsafe { out_value(n_nodes, counts.0, "n_nodes") }?;
        unsafe { out_value(n_leaves, counts.1, "n_leaves") }
    })
}

/// Views the first `n_levels` levels, at least one, at most all: their nodes are a skeleton, and their leaves stand on
/// these. Nothing is copied, and all levels begin at the same places. Each of `columns` and `foliage` may be NULL; set
/// its `struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_level(
    multires: *const tree_multires,
    n_levels: usize,
    columns: *mut tree_skeleton_columns,
    foliage: *mut tree_foliage,
) -> tree_status {
    call(|| {
        unsafe { foresee(columns.cast_const(), "columns") }?;
        unsafe { foresee(foliage.cast_const(), "foliage") }?;
        let level = unsafe { get(multires, "multires") }?.rust().level(n_levels);
        let nodes = tree_skeleton_columns {
            n_nodes: level.positions.len(),
            positions: column(level.positions).cast(),
            radii: column(level.radii),
            parents: column(level.parents),
            ..tree_skeleton_columns::default_value()
        };
        let leaves = tree_foliage {
            n_leaves: level.leaf_nodes.len(),
            nodes: column(level.leaf_nodes),
            positions: column(level.leaf_positions).cast(),
            rotations: column(level.leaf_rotations).cast(),
            sizes: column(level.leaf_sizes),
            kinds: column(level.leaf_kinds),
            ..tree_foliage::default_value()
        };
        unsafe { view(columns, "columns", &nodes) }?;
        unsafe { view(foliage, "foliage", &leaves) }
    })
}

/// A copy of the first `n_levels` levels, at least one, at most all, as a tree of its own, with its species. `control`
/// may be NULL; of it only a cancellation before the work begins matters. Free the tree with `tree_tree_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_tree_at(
    multires: *const tree_multires,
    n_levels: usize,
    control: *const tree_control,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        let multires = unsafe { get(multires, "multires") }?.rust();
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_trees(multires.tree(), 1)?;
                Ok(multires.tree_at(n_levels)?)
            })
        }?;
        place.put(tree_tree::new(made));
        Ok(())
    })
}

/// How many levels have at most `n_nodes` nodes together; one if none has so few.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_level_of_nodes(
    multires: *const tree_multires,
    n_nodes: usize,
    n_levels: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(multires, "multires") }?.rust().level_of_nodes(n_nodes);
        unsafe { out_value(n_levels, n, "n_levels") }
    })
}

/// Frees a multiresolution tree, and with it all views of its levels.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multires_free(multires: *mut tree_multires) -> tree_status {
    call(|| unsafe { free(multires, "multires") })
}
