//! A pruned model as a scene draws it.

use super::distance::tree_lod_distance;
use super::pruned::tree_pruned;
use super::select_model::{tree_scene_draw, tree_scene_model};
use crate::border::{Handle, Versioned, call, free, get, out, tree_status, write};
use crate::mesh::column;
use tree_lod::quality::Distance;
use tree_lod::select::Model;

/// Levels of a pruned model, for a `tree_scene_model`.
pub struct tree_scene_levels {
    center: [f32; 3],
    radius: f32,
    distance: tree_lod_distance,
    lambdas: Vec<f32>,
    scales: Vec<f32>,
    fades: Vec<f32>,
    draws: Vec<tree_scene_draw>,
}

impl Handle for tree_scene_levels {
    const NAME: &'static str = "tree_scene_levels";
}

impl tree_scene_levels {
    fn of(model: &Model) -> Self {
        let levels = &model.levels;
        let draw = |draw: &tree_lod::select::Draw| tree_scene_draw {
            first_index: draw.first_index,
            index_count: draw.index_count,
            base_vertex: draw.base_vertex,
        };
        Self {
            center: model.center.to_array(),
            radius: model.radius,
            distance: tree_lod_distance::of(&model.distance),
            lambdas: levels.iter().map(|level| level.lambda).collect(),
            scales: levels.iter().map(|level| level.scale).collect(),
            fades: levels.iter().map(|level| level.fade).collect(),
            draws: levels.iter().flat_map(|level| &level.draws).map(draw).collect(),
        }
    }
}

/// The model for a scene, with `n` levels, 2 to 1024, as `tree_pruned_levels` makes them: a draw for every surface,
/// wood included, all surfaces one after another in one vertex buffer and one index buffer. `distance` says how lambda
/// falls, NULL for that of `tree_lod_distance_cook`. Free the levels with `tree_scene_levels_free`.
///
/// `TREE_ERROR_INVALID` when the model has more than 64 surfaces, or one buffer cannot hold them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_scene_levels(
    pruned: *const tree_pruned,
    n: usize,
    distance: *const tree_lod_distance,
    levels: *mut *mut tree_scene_levels,
) -> tree_status {
    call(|| {
        let place = unsafe { out(levels, "levels") }?;
        let model = unsafe { get(pruned, "pruned") }?.rust();
        let distance = match distance.is_null() {
            true => Distance::cook(),
            false => unsafe { tree_lod_distance::read(distance, "distance") }?,
        };
        place.put(tree_scene_levels::of(&model.to_select_model(n, distance)?));
        Ok(())
    })
}

/// Makes `model` one of these levels, with sphere and distance; points for occlusion, occluders, `near` and `far` are
/// left at their defaults, for you to set. Set `model->struct_size` first. It borrows from the levels: make the scene
/// before they are freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_levels_model(
    levels: *const tree_scene_levels,
    model: *mut tree_scene_model,
) -> tree_status {
    call(|| {
        let levels = unsafe { get(levels, "levels") }?;
        let n_levels = levels.lambdas.len();
        let found = tree_scene_model {
            distance: &levels.distance,
            lambdas: column(&levels.lambdas),
            scales: column(&levels.scales),
            fades: column(&levels.fades),
            n_levels,
            draws: column(&levels.draws),
            n_parts: levels.draws.len().checked_div(n_levels).unwrap_or(0),
            center: levels.center,
            radius: levels.radius,
            ..tree_scene_model::default_value()
        };
        unsafe { write(model, "model", &found) }
    })
}

/// Frees levels; no model may point at them any more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_levels_free(levels: *mut tree_scene_levels) -> tree_status {
    call(|| unsafe { free(levels, "levels") })
}
