//! Nodes for long segments.

use crate::border::{Handle, call, free, get, out, out_opt, out_value, tree_status};
use crate::control::{run, tree_control};
use crate::mesh::column;
use crate::skeleton::tree_skeleton;
use tree_model::foliage::refine;

/// Numbers of rows: for each node of a skeleton that was made of another the node there that it comes from,
/// or the tips of a graph; for each row of a tree with levels the row of the tree it was made of.
pub struct tree_rows(Vec<u32>);

impl Handle for tree_rows {
    const NAME: &'static str = "tree_rows";
}

impl tree_rows {
    pub(crate) fn new(rows: Vec<u32>) -> Self {
        Self(rows)
    }
}

/// Views the numbers: where they begin and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_rows_view(
    rows: *const tree_rows,
    first: *mut *const u32,
    n: *mut usize,
) -> tree_status {
    call(|| {
        let rows = &unsafe { get(rows, "rows") }?.0;
        unsafe { out_value(first, column(rows), "first") }?;
        unsafe { out_value(n, rows.len(), "n") }
    })
}

/// Frees the numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_rows_free(rows: *mut tree_rows) -> tree_status {
    call(|| unsafe { free(rows, "rows") })
}

/// A new skeleton, the same but with nodes at most `spacing` metres apart (1e-5 to 1e6) on all segments
/// that lie within `bearing` metres (0 to 1e6) of a tip, so that twigs find a node near their place. Old
/// nodes keep their order but get other numbers; positions and radii between them are linear.
///
/// `rows`, which may be NULL, gets for each node the old node at its segment's upper end; free it with
/// `tree_rows_free`, and the skeleton with `tree_skeleton_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_refine(
    skeleton: *const tree_skeleton,
    bearing: f32,
    spacing: f32,
    control: *const tree_control,
    rows: *mut *mut tree_rows,
    refined: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let rows = unsafe { out_opt(rows, "rows") }?;
        let place = unsafe { out(refined, "refined") }?;
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let made =
            unsafe { run(control, |control| Ok(refine(skeleton, bearing, spacing, control)?)) }?;
        if let Some(rows) = rows {
            rows.put(tree_rows::new(made.rows));
        }
        place.put(tree_skeleton::own(made.skeleton));
        Ok(())
    })
}
