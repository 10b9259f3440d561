//! Axes: the unbroken shoots a tree consists of.

use super::tree_skeleton;
use crate::border::{Failure, Handle, Result, Versioned, call, free, get, out, tree_status, write};
use crate::mesh::column;
use tree_model::tree_core::{Axes, Continuation};

/// Which child continues the axis at a fork: one of the `TREE_CONTINUATION_` constants. Ties go to the
/// child with the lower number.
pub type tree_continuation = u32;
/// The child with the largest radius, by length to the tip where radii are equal. The default.
pub const TREE_CONTINUATION_THICKEST: u32 = 0;
/// The child with the longest path to a tip.
pub const TREE_CONTINUATION_LONGEST: u32 = 1;
/// The child that bends least from the segment below; at the root, the longest.
pub const TREE_CONTINUATION_STRAIGHTEST: u32 = 2;

/// The constant in Rust's form; `name` is what the caller calls it.
pub(crate) fn continuation(found: tree_continuation, name: &str) -> Result<Continuation> {
    match found {
        TREE_CONTINUATION_THICKEST => Ok(Continuation::Thickest),
        TREE_CONTINUATION_LONGEST => Ok(Continuation::Longest),
        TREE_CONTINUATION_STRAIGHTEST => Ok(Continuation::Straightest),
        other => Err(Failure::not_one_of(name, other, "TREE_CONTINUATION_")),
    }
}

/// The constant of a rule.
pub(crate) const fn continuation_of(rule: Continuation) -> tree_continuation {
    match rule {
        Continuation::Thickest => TREE_CONTINUATION_THICKEST,
        Continuation::Longest => TREE_CONTINUATION_LONGEST,
        Continuation::Straightest => TREE_CONTINUATION_STRAIGHTEST,
    }
}

/// All axes of a skeleton. An axis starts where it leaves another and runs to a tip.
pub struct tree_axes(Axes);

impl Handle for tree_axes {
    const NAME: &'static str = "tree_axes";
}

/// The axes in columns. Parent axes come first; axis 0 is the trunk.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_axis_columns {
    /// `sizeof(tree_axis_columns)`.
    pub struct_size: usize,
    /// Number of axes, at least 1.
    pub n_axes: usize,
    /// Number of nodes of the skeleton.
    pub n_nodes: usize,
    /// One for each axis: its order after Gravelius, 0 for the trunk, one more than the parent axis for
    /// a lateral.
    pub orders: *const u32,
    /// One more than there are axes: the nodes of axis `i` are `nodes[starts[i]]` up to, but not
    /// including, `nodes[starts[i + 1]]`.
    pub starts: *const u32,
    /// `n_nodes` numbers: the nodes, axis after axis, each from base to tip. A lateral's first node is
    /// the first one above the fork; the fork itself belongs to the parent axis.
    pub nodes: *const u32,
    /// One for each node: the axis it lies on.
    pub axis_of: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_axis_columns {
    const NAME: &'static str = "tree_axis_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_axes: 0,
            n_nodes: 0,
            orders: std::ptr::null(),
            starts: std::ptr::null(),
            nodes: std::ptr::null(),
            axis_of: std::ptr::null(),
        }
    }
}

impl tree_axis_columns {
    fn of(axes: &Axes) -> Self {
        Self {
            n_axes: axes.len(),
            n_nodes: axes.axis_of().len(),
            orders: column(axes.orders()),
            starts: column(axes.starts()),
            nodes: column(axes.nodes()),
            axis_of: column(axes.axis_of()),
            ..Self::default_value()
        }
    }
}

/// Splits a skeleton into axes. Free them with `tree_axes_free`; they do not need the skeleton any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_axes(
    skeleton: *const tree_skeleton,
    rule: tree_continuation,
    axes: *mut *mut tree_axes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(axes, "axes") }?;
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        place.put(tree_axes(skeleton.axes(continuation(rule, "rule")?)));
        Ok(())
    })
}

/// Views the axes. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_axes_view(
    axes: *const tree_axes,
    columns: *mut tree_axis_columns,
) -> tree_status {
    call(|| {
        let axes = &unsafe { get(axes, "axes") }?.0;
        unsafe { write(columns, "columns", &tree_axis_columns::of(axes)) }
    })
}

/// Frees the axes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_axes_free(axes: *mut tree_axes) -> tree_status {
    call(|| unsafe { free(axes, "axes") })
}
