//! What a scene holds.

use super::analysis::tree_plastic;
use super::pose::tree_pose;
use super::scene::{Held, lock, tree_plastic_scene};
use super::sky::{tree_plastic_response, tree_plastic_sky};
use crate::border::{Result, call, out, out_value, tree_status, write};
use crate::mesh::column;
use tree_model::plastic::TreeId;

/// The sky. Set `sky->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_get_sky(
    scene: *const tree_plastic_scene,
    sky: *mut tree_plastic_sky,
) -> tree_status {
    call(|| {
        let found = tree_plastic_sky::of(unsafe { lock(scene) }?.scene.sky());
        unsafe { write(sky, "sky", &found) }
    })
}

/// How much trees react. Set `response->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_get_response(
    scene: *const tree_plastic_scene,
    response: *mut tree_plastic_response,
) -> tree_status {
    call(|| {
        let found = tree_plastic_response::of(unsafe { lock(scene) }?.scene.response());
        unsafe { write(response, "response", &found) }
    })
}

unsafe fn view_ids(
    scene: *const tree_plastic_scene,
    list: impl FnOnce(&Held) -> &Vec<u64>,
    ids: *mut *const u64,
    n_ids: *mut usize,
) -> Result<()> {
    let held = unsafe { lock(scene) }?;
    let list = list(&held);
    unsafe { out_value(ids, column(list), "ids") }?;
    unsafe { out_value(n_ids, list.len(), "n_ids") }
}

/// The trees' ids, in the order they were planted. Valid until the next edit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_trees(
    scene: *const tree_plastic_scene,
    ids: *mut *const u64,
    n_ids: *mut usize,
) -> tree_status {
    call(|| unsafe { view_ids(scene, |held| &held.trees, ids, n_ids) })
}

/// The obstacles' ids, in the order they were put there. Valid until the next edit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_obstacles(
    scene: *const tree_plastic_scene,
    ids: *mut *const u64,
    n_ids: *mut usize,
) -> tree_status {
    call(|| unsafe { view_ids(scene, |held| &held.obstacles, ids, n_ids) })
}

/// Ids of the trees that the last update changed. Valid until the next update.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_changed(
    scene: *const tree_plastic_scene,
    ids: *mut *const u64,
    n_ids: *mut usize,
) -> tree_status {
    call(|| unsafe { view_ids(scene, |held| &held.changed, ids, n_ids) })
}

/// Where a tree stands. `TREE_ERROR_INVALID` for an id that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_pose(
    scene: *const tree_plastic_scene,
    id: u64,
    pose: *mut tree_pose,
) -> tree_status {
    call(|| {
        let found = unsafe { lock(scene) }?.scene.pose(TreeId(id))?;
        unsafe { out_value(pose, tree_pose::of(found), "pose") }
    })
}

/// The analysis that a tree was planted from, not copied. Free it with `tree_plastic_free`. `TREE_ERROR_INVALID` for an id
/// that is not there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_model(
    scene: *const tree_plastic_scene,
    id: u64,
    plastic: *mut *mut tree_plastic,
) -> tree_status {
    call(|| {
        let place = unsafe { out(plastic, "plastic") }?;
        let model = unsafe { lock(scene) }?.scene.model(TreeId(id))?.clone();
        place.put(tree_plastic::new(model));
        Ok(())
    })
}
