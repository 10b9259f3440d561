//! Lengths and counts along a skeleton, into the caller's buffers.

use super::tree_skeleton;
use crate::border::{Result, call, fill, get, tree_status};
use tree_model::tree_core::Skeleton;

unsafe fn measure<T: Copy>(
    skeleton: *const tree_skeleton,
    values: *mut T,
    capacity: usize,
    argument: &str,
    measure: impl Fn(&Skeleton) -> Vec<T>,
) -> Result<()> {
    let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
    unsafe { fill(values, capacity, &measure(skeleton), argument) }
}

/// Length of the segment between each node and its parent, in metres; 0 for the root. `lengths` has room
/// for `capacity` floats, at least one for each node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_segment_lengths(
    skeleton: *const tree_skeleton,
    lengths: *mut f32,
    capacity: usize,
) -> tree_status {
    let of = Skeleton::segment_lengths;
    call(|| unsafe { measure(skeleton, lengths, capacity, "lengths", of) })
}

/// Length of the path from the root to each node, in metres. `distances` has room for `capacity` floats,
/// at least one for each node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_distances_to_root(
    skeleton: *const tree_skeleton,
    distances: *mut f32,
    capacity: usize,
) -> tree_status {
    let of = Skeleton::distances_to_root;
    call(|| unsafe { measure(skeleton, distances, capacity, "distances", of) })
}

/// Length of the longest path from each node up to a tip, in metres; 0 at tips. `distances` has room for
/// `capacity` floats, at least one for each node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_distances_to_tip(
    skeleton: *const tree_skeleton,
    distances: *mut f32,
    capacity: usize,
) -> tree_status {
    let of = Skeleton::distances_to_tip;
    call(|| unsafe { measure(skeleton, distances, capacity, "distances", of) })
}

/// Number of nodes from each node up, itself included. `sizes` has room for `capacity` numbers, at least
/// one for each node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_subtree_sizes(
    skeleton: *const tree_skeleton,
    sizes: *mut u32,
    capacity: usize,
) -> tree_status {
    let of = Skeleton::subtree_sizes;
    call(|| unsafe { measure(skeleton, sizes, capacity, "sizes", of) })
}

/// Number of tips from each node up; 1 for a tip. `counts` has room for `capacity` numbers, at least one
/// for each node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_tip_counts(
    skeleton: *const tree_skeleton,
    counts: *mut u32,
    capacity: usize,
) -> tree_status {
    let of = Skeleton::tip_counts;
    call(|| unsafe { measure(skeleton, counts, capacity, "counts", of) })
}

/// The children of every node: those of node `i` are `nodes[starts[i]]` up to, but not including,
/// `nodes[starts[i + 1]]`, in rising order. `starts` has room for `starts_capacity` numbers, at least one
/// more than there are nodes; `nodes` for `nodes_capacity`, at least one less than there are nodes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_children(
    skeleton: *const tree_skeleton,
    starts: *mut u32,
    starts_capacity: usize,
    nodes: *mut u32,
    nodes_capacity: usize,
) -> tree_status {
    call(|| {
        let children = unsafe { get(skeleton, "skeleton") }?.rust().children();
        // A lone node has no children, and no room for them may be NULL.
        if !children.nodes().is_empty() {
            unsafe { fill(nodes, nodes_capacity, children.nodes(), "nodes") }?;
        }
        unsafe { fill(starts, starts_capacity, children.starts(), "starts") }
    })
}
