//! Which node of a skeleton carries each leaf.

use crate::border::{call, get, tree_status};
use crate::control::{run, tree_control};
use crate::lod::take::{fill_some, room_for};
use crate::lod::tree_elements;
use crate::mesh::tree_mesh;
use crate::skeleton::tree_skeleton;
use crate::tree::tree_tree;
use tree_lod::impostor::boxes::Bearers;

/// Writes the node of the tree's skeleton that carries each element, leaf by leaf, exactly: for a mesh that was built
/// of this tree. `elements` must be whole leaves (`TREE_GRAIN_LEAF`). `bearers` has room for `capacity` numbers, at least
/// one for each element. `TREE_ERROR_INVALID` when mesh and tree have different numbers of leaves.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_bearers_of_tree(
    tree: *const tree_tree,
    mesh: *const tree_mesh,
    elements: *const tree_elements,
    bearers: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let tree = unsafe { get(tree, "tree") }?.rust();
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let elements = unsafe { get(elements, "elements") }?.rust();
        room_for(elements.len(), capacity, "bearers")?;
        elements.check(mesh)?;
        let found = Bearers::of_tree(tree, mesh, elements)?;
        unsafe { fill_some(bearers, capacity, &found.0, "bearers") }
    })
}

/// Writes the nearest node of the skeleton to the middle of each element: for meshes whose leaves are not known to a
/// tree. `bearers` has room for `capacity` numbers, at least one for each element. `control` may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_bearers_nearest(
    skeleton: *const tree_skeleton,
    elements: *const tree_elements,
    control: *const tree_control,
    bearers: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let elements = unsafe { get(elements, "elements") }?.rust();
        room_for(elements.len(), capacity, "bearers")?;
        let found = unsafe {
            run(control, |control| {
                control.check()?;
                Ok(Bearers::nearest(skeleton, elements))
            })
        }?;
        unsafe { fill_some(bearers, capacity, &found.0, "bearers") }
    })
}
