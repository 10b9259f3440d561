//! Trees and obstacles: put there, moved, taken away.

use super::analysis::tree_plastic;
use super::pose::tree_pose;
use super::scene::{Held, lock, tree_plastic_scene};
use crate::border::{Failure, Result, call, get, out_value, tree_status};
use crate::volume::tree_volume;
use tree_model::plastic::{ObstacleId, TreeId};

/// Does an edit.
unsafe fn edit<T>(
    scene: *mut tree_plastic_scene,
    work: impl FnOnce(&mut Held) -> Result<T>,
) -> Result<T> {
    work(&mut *unsafe { lock(scene) }?)
}

/// A place for an id, looked at before the edit that gives it.
fn place(id: *const u64) -> Result<()> {
    if id.is_null() { Err(Failure::null("id")) } else { Ok(()) }
}

/// Plants a tree; the analysis is shared, not copied. `pose` may be NULL for the origin, not turned. `TREE_ERROR_INVALID`
/// for a pose that is not finite, and where its base lies in an obstacle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_add_tree(
    scene: *mut tree_plastic_scene,
    plastic: *const tree_plastic,
    pose: *const tree_pose,
    id: *mut u64,
) -> tree_status {
    call(|| {
        place(id)?;
        let model = unsafe { get(plastic, "plastic") }?.rust().clone();
        let pose = unsafe { tree_pose::read(pose) }?;
        let planted = |held: &mut Held| {
            let id = held.scene.add_tree(model, pose)?;
            held.trees.push(id.0);
            Ok(id.0)
        };
        let found = unsafe { edit(scene, planted) }?;
        unsafe { out_value(id, found, "id") }
    })
}

/// Moves a tree. Errors are those of `tree_plastic_scene_add_tree`, and `TREE_ERROR_INVALID` for an id that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_move_tree(
    scene: *mut tree_plastic_scene,
    id: u64,
    pose: *const tree_pose,
) -> tree_status {
    call(|| {
        let pose = unsafe { tree_pose::read(pose) }?;
        unsafe { edit(scene, |held| Ok(held.scene.move_tree(TreeId(id), pose)?)) }
    })
}

/// Takes a tree away. `TREE_ERROR_INVALID` for an id that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_remove_tree(
    scene: *mut tree_plastic_scene,
    id: u64,
) -> tree_status {
    let removed = |held: &mut Held| {
        held.scene.remove_tree(TreeId(id))?;
        held.trees.retain(|&other| other != id);
        Ok(())
    };
    call(|| unsafe { edit(scene, removed) })
}

/// Puts an obstacle into the scene; `volume` may be freed. Spheres, boxes and half-spaces, moved, turned and united, cast
/// their exact shadow; any other volume, closed meshes too, that of boxes a sixteenth of its size. It is prepared once:
/// moving it is cheap. `pose` may be NULL for the origin, not turned. `TREE_ERROR_INVALID` for a pose that is not finite, a
/// volume that has no end and is no half-space (nor a union with them), and where it would hold the base of a tree.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_add_obstacle(
    scene: *mut tree_plastic_scene,
    volume: *const tree_volume,
    pose: *const tree_pose,
    id: *mut u64,
) -> tree_status {
    call(|| {
        place(id)?;
        let volume = unsafe { get(volume, "volume") }?.rust().clone();
        let pose = unsafe { tree_pose::read(pose) }?;
        let placed = |held: &mut Held| {
            let id = held.scene.add_obstacle(volume, pose)?;
            held.obstacles.push(id.0);
            Ok(id.0)
        };
        let found = unsafe { edit(scene, placed) }?;
        unsafe { out_value(id, found, "id") }
    })
}

/// Moves an obstacle. Errors are those of `tree_plastic_scene_add_obstacle`, and `TREE_ERROR_INVALID` for an id that is not
/// there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_move_obstacle(
    scene: *mut tree_plastic_scene,
    id: u64,
    pose: *const tree_pose,
) -> tree_status {
    call(|| {
        let pose = unsafe { tree_pose::read(pose) }?;
        unsafe { edit(scene, |held| Ok(held.scene.move_obstacle(ObstacleId(id), pose)?)) }
    })
}

/// Takes an obstacle away. `TREE_ERROR_INVALID` for an id that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_remove_obstacle(
    scene: *mut tree_plastic_scene,
    id: u64,
) -> tree_status {
    let removed = |held: &mut Held| {
        held.scene.remove_obstacle(ObstacleId(id))?;
        held.obstacles.retain(|&other| other != id);
        Ok(())
    };
    call(|| unsafe { edit(scene, removed) })
}
