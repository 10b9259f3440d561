//! How the nodes of a tree stand, for skins that follow them.

use super::scene::{lock, tree_plastic_scene};
use crate::border::{call, fill, tree_status};
use tree_model::plastic::{NodeMotion, TreeId};

/// How a node of the input stands: what belonged to it at p is at p + moved + (rotation (p - node) - (p - node)), in the tree's
/// own frame.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_plastic_motion {
    /// How far it moved, in metres.
    pub moved: [f32; 3],
    /// How far its segment turned: a unit quaternion, x, y, z, w.
    pub rotation: [f32; 4],
    /// 1 where the branch that carries it lives, else 0.
    pub alive: u32,
}

impl tree_plastic_motion {
    fn of(motion: &NodeMotion) -> Self {
        Self {
            moved: motion.moved.to_array(),
            rotation: motion.rotation.to_array(),
            alive: motion.alive.into(),
        }
    }
}

/// Writes for each node of the input of tree `id` how it stands as of the last update: the skin of a mesh of the input follows it.
/// Branchlets follow their main branch. `motions` has room for `capacity` rows, at least one for each node.
/// `TREE_ERROR_INVALID` for an id that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_motions(
    scene: *const tree_plastic_scene,
    id: u64,
    motions: *mut tree_plastic_motion,
    capacity: usize,
) -> tree_status {
    call(|| {
        let found = unsafe { lock(scene) }?.scene.motions(TreeId(id))?;
        let rows: Vec<_> = found.iter().map(tree_plastic_motion::of).collect();
        unsafe { fill(motions, capacity, &rows, "motions") }
    })
}
