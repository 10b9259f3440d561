//! Scenes, and what a view of one remembers.

use super::select_model::{tree_scene_instance, tree_scene_model};
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_ORDER, Versioned, call, free, get, out, out_value,
    read_rows, slice, tree_status, write,
};
use crate::control::{limits, run, tree_control};
use bytemuck::{Pod, Zeroable};
use std::ptr::null;
use std::sync::{Mutex, MutexGuard, RwLock, RwLockReadGuard, RwLockWriteGuard, TryLockError};
use tree_lod::select::{Instance, Scene, State};
use tree_lod::tree_core::Resource;

/// Most models of a scene.
const MODELS_MAX: usize = 1 << 16;

/// Tree models, and where they stand (Neubert 2012, 7.2.5 and 7.4). Make one `tree_scene_state` for each view of it.
/// In each frame `tree_scene_state_select` finds what is drawn and how finely, and `tree_scene_state_draws` or
/// `tree_scene_state_batches` write it into your own buffers; neither takes memory.
///
/// It is an object that changes, in `tree_scene_set_instances` alone: a call that comes while that one is at
/// work, or the other way round, is `TREE_ERROR_ORDER`. Any number of threads may select in it at once, each
/// with a state of its own.
pub struct tree_scene(RwLock<Scene>);

impl Handle for tree_scene {
    const NAME: &'static str = "tree_scene";
}

fn busy(argument: &str) -> Failure {
    let text = format!("{argument} is at work in another call: one call at a time");
    Failure::new(TREE_ERROR_ORDER, text)
}

/// The scene of a handle, to look at.
pub(super) unsafe fn scene<'a>(scene: *const tree_scene) -> Result<RwLockReadGuard<'a, Scene>> {
    match unsafe { get(scene, "scene") }?.0.try_read() {
        Ok(held) => Ok(held),
        Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
        Err(TryLockError::WouldBlock) => Err(busy("scene")),
    }
}

unsafe fn scene_mut<'a>(scene: *mut tree_scene) -> Result<RwLockWriteGuard<'a, Scene>> {
    match unsafe { get(scene.cast_const(), "scene") }?.0.try_write() {
        Ok(held) => Ok(held),
        Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
        Err(TryLockError::WouldBlock) => Err(busy("scene")),
    }
}

/// What is needed to draw a scene.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_scene_needs {
    /// `sizeof(tree_scene_needs)`.
    pub struct_size: usize,
    /// Number of instances: rows of `tree_instance_lod` that always suffice.
    pub n_instances: usize,
    /// Rows of `tree_draw_indexed` that always suffice: the parts of all instances.
    pub most_draws: usize,
    /// Indices of all instances at their finest level: what is drawn without selection.
    pub most_indices: u64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_scene_needs {
    const NAME: &'static str = "tree_scene_needs";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), n_instances: 0, most_draws: 0, most_indices: 0 }
    }
}

/// Makes a scene of `n_models` models and `n_instances` instances, which are copied and numbered as they come.
/// `control` may be NULL; `nodes` of its limits caps the instances. Free the scene with `tree_scene_free`. The text
/// of an error names the first model or instance that is not right: `TREE_ERROR_INVALID`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_new(
    models: *const tree_scene_model,
    n_models: usize,
    instances: *const tree_scene_instance,
    n_instances: usize,
    control: *const tree_control,
    scene: *mut *mut tree_scene,
) -> tree_status {
    call(|| {
        let place = unsafe { out(scene, "scene") }?;
        let limits = unsafe { limits(control) }?;
        let rows = unsafe { read_rows(models, n_models, MODELS_MAX, "models") }?;
        let model =
            |(i, row): (usize, &tree_scene_model)| unsafe { row.rust(&format!("models[{i}]")) };
        let models = rows.iter().enumerate().map(model).collect::<Result<Vec<_>>>()?;
        let nodes = Resource::Nodes;
        let rows = unsafe { slice(instances, n_instances, &limits, nodes, "instances") }?;
        let body = |control: &_| {
            let instances: Vec<Instance> = rows.iter().map(tree_scene_instance::rust).collect();
            Ok(Scene::new(&models, &instances, control)?)
        };
        place.put(tree_scene(RwLock::new(unsafe { run(control, body) }?)));
        Ok(())
    })
}

/// Moves instances, or gives them other models: those from number `first` on become the `n_instances` given, all of
/// them, or on an error none. Between frames: what was selected before holds the old ones. They keep their
/// place in the order of drawing; when most move far, a new scene is faster to look through.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_set_instances(
    scene: *mut tree_scene,
    first: usize,
    instances: *const tree_scene_instance,
    n_instances: usize,
) -> tree_status {
    call(|| {
        let limits = unsafe { limits(null()) }?;
        let mut scene = unsafe { scene_mut(scene) }?;
        let nodes = Resource::Nodes;
        let rows = unsafe { slice(instances, n_instances, &limits, nodes, "instances") }?;
        if let [one] = rows {
            return Ok(scene.set_instance(first, &one.rust())?);
        }
        let instances: Vec<Instance> = rows.iter().map(tree_scene_instance::rust).collect();
        Ok(scene.set_instances(first, &instances)?)
    })
}

/// Tells how large a scene is, and how large the buffers for it must be. Set `needs->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_measure(
    scene: *const tree_scene,
    needs: *mut tree_scene_needs,
) -> tree_status {
    call(|| {
        let scene = unsafe { self::scene(scene) }?;
        let found = tree_scene_needs {
            n_instances: scene.len(),
            most_draws: scene.most_draws(),
            most_indices: scene.most_indices(),
            ..tree_scene_needs::default_value()
        };
        unsafe { write(needs, "needs", &found) }
    })
}

/// Frees a scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_free(scene: *mut tree_scene) -> tree_status {
    call(|| unsafe { free(scene, "scene") })
}

/// What one view of a scene (a camera, or a cascade of a shadow map) remembers from frame to frame, and all the
/// room that a frame needs.
///
/// It is an object that changes: do not use it from two threads at once. A call that comes while another is at work
/// on it is `TREE_ERROR_ORDER`.
pub struct tree_scene_state(Mutex<State>);

impl Handle for tree_scene_state {
    const NAME: &'static str = "tree_scene_state";
}

/// The state of a handle, for this call alone.
pub(super) unsafe fn state<'a>(state: *const tree_scene_state) -> Result<MutexGuard<'a, State>> {
    match unsafe { get(state, "state") }?.0.try_lock() {
        Ok(held) => Ok(held),
        Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
        Err(TryLockError::WouldBlock) => Err(busy("state")),
    }
}

/// How an instance was drawn in the last frame.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_scene_shown {
    /// Whether it was in view, 1 or 0; if not, all else is 0.
    pub in_view: u32,
    /// Level of its model.
    pub level: u32,
    /// Share of the foliage's triangles.
    pub lambda: f32,
    /// Share of the sample points that are seen, 0 to 1.
    pub visible: f32,
}

/// Makes a state for one view of `scene`, or of another scene with as many instances and the same models: 32 bytes for
/// each instance, and 144 KiB. `control` may be NULL; `nodes` of its limits caps the instances. It does not keep the
/// scene alive. Free it with `tree_scene_state_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_state_new(
    scene: *const tree_scene,
    control: *const tree_control,
    state: *mut *mut tree_scene_state,
) -> tree_status {
    call(|| {
        let place = unsafe { out(state, "state") }?;
        let scene = unsafe { self::scene(scene) }?;
        let scene: &Scene = &scene;
        let made = unsafe { run(control, |control| Ok(State::new(scene, control)?)) }?;
        place.put(tree_scene_state(Mutex::new(made)));
        Ok(())
    })
}

/// Number of the instances that were in view in the last frame: rows of `tree_instance_lod` that it needs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_state_count_drawn(
    state: *const tree_scene_state,
    n_drawn: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { self::state(state) }?.n_drawn();
        unsafe { out_value(n_drawn, n, "n_drawn") }
    })
}

/// How an instance of `scene` was drawn in the last frame; not in view when there is no such instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_state_shown(
    state: *const tree_scene_state,
    scene: *const tree_scene,
    instance: usize,
    shown: *mut tree_scene_shown,
) -> tree_status {
    call(|| {
        let state = unsafe { self::state(state) }?;
        let scene = unsafe { self::scene(scene) }?;
        let found = state.shown(&scene, instance).map(|shown| tree_scene_shown {
            in_view: 1,
            level: shown.level as u32,
            lambda: shown.lambda,
            visible: shown.visible,
        });
        unsafe { out_value(shown, found.unwrap_or_default(), "shown") }
    })
}

/// Frees a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_state_free(state: *mut tree_scene_state) -> tree_status {
    call(|| unsafe { free(state, "state") })
}
