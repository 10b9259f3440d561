//! How the nodes of a tree stand, for skins that follow them.

use super::scene::{lock, tree_plastic_scene};
use crate::border::{Failure, TREE_ERROR_INVALID, call, fill, tree_status};
use tree_model::plastic::TreeId;

/// How each node of the input of tree `id` stands as of the last update: what belonged to a node at p is at p + moved +
/// (rotation (p - node) - (p - node)), in the tree's own frame. Branchlets follow their main branch. `moved` has room for 3 floats
/// a node, `rotations` for 4 (x, y, z, w), `alive` for one byte (1 where the branch lives, else 0); each may be NULL when it is not wanted.
/// `n_nodes` is the number of nodes of the input, or nothing is written and `TREE_ERROR_INVALID` says how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_motions(
    scene: *const tree_plastic_scene,
    id: u64,
    moved: *mut f32,
    rotations: *mut f32,
    alive: *mut u8,
    n_nodes: usize,
) -> tree_status {
    call(|| {
        let motions = unsafe { lock(scene) }?.scene.motions(TreeId(id))?;
        if motions.len() != n_nodes {
            let text = format!("n_nodes: {n_nodes}, the tree has {} nodes", motions.len());
            return Err(Failure::new(TREE_ERROR_INVALID, text));
        }
        if !moved.is_null() {
            let rows: Vec<f32> =
                motions.iter().flat_map(|motion| motion.moved.to_array()).collect();
            unsafe { fill(moved, rows.len(), &rows, "moved") }?;
        }
        if !rotations.is_null() {
            let rows: Vec<f32> =
                motions.iter().flat_map(|motion| motion.rotation.to_array()).collect();
            unsafe { fill(rotations, rows.len(), &rows, "rotations") }?;
        }
        if !alive.is_null() {
            let rows: Vec<u8> = motions.iter().map(|motion| motion.alive.into()).collect();
            unsafe { fill(alive, rows.len(), &rows, "alive") }?;
        }
        Ok(())
    })
}
