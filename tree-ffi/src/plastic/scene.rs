//! Trees, obstacles and a sky that can be moved.

use super::sky::{tree_plastic_response, tree_plastic_sky};
use crate::border::{
    Handle, Result, Versioned, call, free, get, lock_now, out, read, read_or_default, tree_status,
    view,
};
use crate::control::{run, tree_control};
use std::sync::{Mutex, MutexGuard};
use tree_model::plastic::{Scene, Update};
use tree_model::tree_core::Control;

/// Trees, obstacles and a sky. Edits are checked at once, and leave the scene as it was where they are refused;
/// `tree_plastic_scene_update` works out what all edits since the last one mean, and no more than that.
///
/// What the trees look like depends on the scene alone, not on how it came about: an obstacle that is moved away leaves
/// no trace. Trees and obstacles are named by ids, which are not used again after they are removed.
///
/// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work on it,
/// from a progress callback too, is `TREE_ERROR_ORDER`. What it hands out is copied, does not change with it, and outlives
/// it; ids that are viewed stay until the next edit or update.
pub struct tree_plastic_scene(Mutex<Held>);

/// A scene, and lists of ids as they are viewed.
#[derive(Clone, Default)]
pub(super) struct Held {
    pub(super) scene: Scene,
    pub(super) trees: Vec<u64>,
    pub(super) obstacles: Vec<u64>,
    pub(super) changed: Vec<u64>,
}

impl Handle for tree_plastic_scene {
    const NAME: &'static str = "tree_plastic_scene";
}

/// The scene of a handle, for this call alone.
pub(super) unsafe fn lock<'a>(scene: *const tree_plastic_scene) -> Result<MutexGuard<'a, Held>> {
    lock_now(&unsafe { get(scene, "scene") }?.0, "scene")
}

/// What an update did.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_plastic_update {
    /// `sizeof(tree_plastic_update)`.
    pub struct_size: usize,
    /// Trees that are not what they were, or get another light: `tree_plastic_scene_changed` tells which.
    pub n_changed: u64,
    /// Trees that were looked at.
    pub n_touched: u64,
    /// Seasons of trees whose light was worked out anew.
    pub n_seasons: u64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_plastic_update {
    const NAME: &'static str = "tree_plastic_update";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Update::default())
    }
}

impl tree_plastic_update {
    fn of(update: &Update) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_changed: update.changed.len() as u64,
            n_touched: update.touched.into(),
            n_seasons: update.seasons.into(),
        }
    }
}

/// Makes an empty scene. `sky` and `response` may be NULL for the defaults. Free it with `tree_plastic_scene_free`.
/// `TREE_ERROR_PARAMETER` names what is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_new(
    sky: *const tree_plastic_sky,
    response: *const tree_plastic_response,
    scene: *mut *mut tree_plastic_scene,
) -> tree_status {
    call(|| {
        let place = unsafe { out(scene, "scene") }?;
        let sky = unsafe { read_or_default(sky, "sky") }?.rust();
        let response = unsafe { read_or_default(response, "response") }?.rust();
        let held = Held { scene: Scene::new(sky, response)?, ..Held::default() };
        place.put(tree_plastic_scene(Mutex::new(held)));
        Ok(())
    })
}

/// A second one in the state of the first. Free it too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_copy(
    scene: *const tree_plastic_scene,
    copy: *mut *mut tree_plastic_scene,
) -> tree_status {
    call(|| {
        let place = unsafe { out(copy, "copy") }?;
        let held = unsafe { lock(scene) }?.clone();
        place.put(tree_plastic_scene(Mutex::new(held)));
        Ok(())
    })
}

/// Changes the sky. It is as it was where it is refused.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_set_sky(
    scene: *mut tree_plastic_scene,
    sky: *const tree_plastic_sky,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(scene) }?;
        Ok(held.scene.set_sky(unsafe { read(sky, "sky") }?.rust())?)
    })
}

/// Changes how much trees react. It is as it was where it is refused.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_set_response(
    scene: *mut tree_plastic_scene,
    response: *const tree_plastic_response,
) -> tree_status {
    call(|| {
        let mut held = unsafe { lock(scene) }?;
        Ok(held.scene.set_response(unsafe { read(response, "response") }?.rust())?)
    })
}

/// Works out what the edits since the last update mean. `control` and `update` may be NULL. Where it is cancelled trees
/// are half way, and the next update works all of them out anew. For each tree that is touched it takes time in proportion to
/// its nodes and seasons, and to the clusters and obstacles around each of its clusters.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_update(
    scene: *mut tree_plastic_scene,
    control: *const tree_control,
    update: *mut tree_plastic_update,
) -> tree_status {
    call(|| {
        unsafe { crate::border::foresee(update, "update") }?;
        let mut held = unsafe { lock(scene) }?;
        let held = &mut *held;
        let body = |control: &Control| {
            held.changed.clear();
            let done = held.scene.update(control)?;
            held.changed.extend(done.changed.iter().map(|id| id.0));
            Ok(done)
        };
        let done = unsafe { run(control, body) }?;
        unsafe { view(update, "update", &tree_plastic_update::of(&done)) }
    })
}

/// Frees a scene. What it handed out lives on. `TREE_ERROR_ORDER` while a call is at work on it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plastic_scene_free(scene: *mut tree_plastic_scene) -> tree_status {
    call(|| {
        if !scene.is_null() {
            // Waits for no one: who holds it would go on with what is freed.
            drop(unsafe { lock(scene) }?);
        }
        unsafe { free(scene, "scene") }
    })
}
