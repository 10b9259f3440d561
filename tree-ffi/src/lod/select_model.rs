//! What a scene has to know of tree models and of where they stand.

use super::distance::tree_lod_distance;
use super::take::few;
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, Versioned, call, init, read, tree_status,
};
use bytemuck::{Pod, Zeroable};
use glam::{Quat, Vec3};
use std::ptr::null;
use tree_lod::quality::Distance;
use tree_lod::select::{
    Draw, Instance, Level, MAX_LEVELS, MAX_PARTS, MAX_SAMPLES, Model, Occluder,
};

/// A window of an index buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_scene_draw {
    /// First index.
    pub first_index: u32,
    /// Number of indices; 0 for a part that is not drawn.
    pub index_count: u32,
    /// Added to each index.
    pub base_vertex: i32,
}

/// An ellipsoid along the axes of a model that nothing is seen through.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_scene_occluder {
    /// Its centre in metres.
    pub center: [f32; 3],
    /// Half its size along each axis, more than 0.
    pub radii: [f32; 3],
}

/// A tree of a scene.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_scene_instance {
    /// Which model of the scene it is.
    pub model: u32,
    /// Where the model's origin stands, in metres, within 1e7 of the origin.
    pub position: [f32; 3],
    /// How it is turned: a unit quaternion, x, y, z, w. 0, 0, 0, 1 is not at all.
    pub rotation: [f32; 4],
    /// Factor on its size, 0.001 to 1000.
    pub scale: f32,
}

impl tree_scene_instance {
    pub(super) fn rust(&self) -> Instance {
        Instance {
            model: self.model,
            position: self.position.into(),
            rotation: Quat::from_array(self.rotation),
            scale: self.scale,
        }
    }
}

/// A tree model as a scene draws it. Lengths in metres, in the model's own space. Begin with
/// `tree_scene_model_init`. All is copied into the scene.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_scene_model {
    /// `sizeof(tree_scene_model)`.
    pub struct_size: usize,
    /// Points on the crown's surface, evenly spread, three floats each, such as `tree_hull_sample` writes them.
    /// NULL, the default: the model is never taken for occluded.
    pub samples: *const f32,
    /// Number of points, at most 64; 32 do well.
    pub n_samples: usize,
    /// What hides other trees in the built-in occlusion pass: a few ellipsoids that are opaque for certain, such
    /// as the inner crown and the trunk. NULL, the default: the model hides nothing there.
    pub occluders: *const tree_scene_occluder,
    /// Number of occluders, at most 64.
    pub n_occluders: usize,
    /// Lambda for each distance, 0 at `near` and 1 at `far`. NULL, the default: that of `tree_lod_distance_cook`.
    pub distance: *const tree_lod_distance,
    /// For each level the share of the foliage's triangles, rising, more than 0, at most 1. The more levels, the
    /// smoother. No default: NULL, which is refused.
    pub lambdas: *const f32,
    /// For each level the factor on the area of each element, more than 0. NULL, the default: 1.
    pub scales: *const f32,
    /// For each level the width in lambda over which the last elements fade in, 0 (they pop; nothing fades in the full
    /// model) to 1. NULL, the default: 0.
    pub fades: *const f32,
    /// Number of levels, 1 to 1024.
    pub n_levels: usize,
    /// What is drawn of each part of the model (bark, leaves, fruit): the parts of the first level, then those of
    /// the next, `n_levels * n_parts` rows. A part that is always drawn whole has the same draw in every level.
    /// No default: NULL, which is refused.
    pub draws: *const tree_scene_draw,
    /// Number of parts, 1 to 64.
    pub n_parts: usize,
    /// Centre of a sphere around the whole model, at its largest scale. Default 0, 0, 0.
    pub center: [f32; 3],
    /// Radius of that sphere, more than 0, at most 100,000. Default 1: set it.
    pub radius: f32,
    /// Distance up to which the full model is drawn, for an instance of scale 1 in a field of view of 60 degrees
    /// from top to bottom; what counts is the size on the screen. 0 or more. Default 10.
    pub near: f32,
    /// Distance from which on the least is drawn, more than `near`. Default 500.
    pub far: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_scene_model {
    const NAME: &'static str = "tree_scene_model";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let model = Model::default();
        Self {
            struct_size: size_of::<Self>(),
            samples: null(),
            n_samples: 0,
            occluders: null(),
            n_occluders: 0,
            distance: null(),
            lambdas: null(),
            scales: null(),
            fades: null(),
            n_levels: 0,
            draws: null(),
            n_parts: 0,
            center: model.center.to_array(),
            radius: model.radius,
            near: model.near,
            far: model.far,
        }
    }
}

impl tree_scene_model {
    /// `name` is what errors call it.
    pub(super) unsafe fn rust(&self, name: &str) -> Result<Model> {
        let part = |field: &str| format!("{name}.{field}");
        let (samples, n) = (self.samples.cast::<Vec3>(), self.n_samples);
        let samples = unsafe { few(samples, n, MAX_SAMPLES, &part("samples")) }?.to_vec();
        let (occluders, n) = (self.occluders, self.n_occluders);
        let occluders = unsafe { few(occluders, n, MAX_PARTS, &part("occluders")) }?;
        let distance = if self.distance.is_null() {
            Distance::default()
        } else {
            unsafe { tree_lod_distance::read(self.distance, &part("distance")) }?
        };
        let occluder = |one: &tree_scene_occluder| Occluder {
            center: one.center.into(),
            radii: one.radii.into(),
        };
        Ok(Model {
            center: self.center.into(),
            radius: self.radius,
            samples,
            occluders: occluders.iter().map(occluder).collect(),
            distance,
            near: self.near,
            far: self.far,
            levels: unsafe { self.levels(&part) }?,
        })
    }

    unsafe fn levels(&self, part: &impl Fn(&str) -> String) -> Result<Vec<Level>> {
        let n = self.n_levels;
        let lambdas = unsafe { few(self.lambdas, n, MAX_LEVELS, &part("lambdas")) }?;
        let optional = |first: *const f32, name: &str| match first.is_null() {
            true => Ok(&[][..]),
            false => unsafe { few(first, n, MAX_LEVELS, &part(name)) },
        };
        let (scales, fades) = (optional(self.scales, "scales")?, optional(self.fades, "fades")?);
        let parts = self.n_parts;
        if parts > MAX_PARTS {
            let text = format!("{} is {parts}, at most {MAX_PARTS} are allowed", part("n_parts"));
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        // Both are small by now.
        let draws = unsafe { few(self.draws, n * parts, usize::MAX, &part("draws")) }?;
        let draw = |draw: &tree_scene_draw| Draw {
            first_index: draw.first_index,
            index_count: draw.index_count,
            base_vertex: draw.base_vertex,
        };
        let level = |(i, &lambda): (usize, &f32)| Level {
            lambda,
            scale: scales.get(i).copied().unwrap_or(1.0),
            fade: fades.get(i).copied().unwrap_or(0.0),
            draws: draws.iter().skip(i * parts).take(parts).map(draw).collect(),
        };
        Ok(lambdas.iter().enumerate().map(level).collect())
    }
}

/// Makes `model`, of `size` bytes, the default: a sphere of 1 m without levels, which are to be set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_model_init(
    model: *mut tree_scene_model,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(model, size) })
}

/// Checks every number of `model`; the text of an error tells what is at fault and what would be right.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_model_check(model: *const tree_scene_model) -> tree_status {
    call(|| Ok(unsafe { read(model, "model")?.rust("model") }?.validate()?))
}
