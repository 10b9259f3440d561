//! One tree and its world; one tree of several.

use super::habit::tree_growth_habit;
use super::world::tree_growth_world;
use crate::border::{Result, Versioned, call, init, read, read_or_default, read_rows, tree_status};
use glam::Vec3;
use tree_model::growth::{GrowthParams, Habit, MAX_PLANTS, Plant, World};

/// Everything that shapes a tree that grows alone. Begin with `tree_growth_params_init`, or with `tree_growth_preset`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_growth_params {
    /// `sizeof(tree_growth_params)`.
    pub struct_size: usize,
    /// Where it grows. Default NULL: as `tree_growth_world_init` has it.
    pub world: *const tree_growth_world,
    /// What kind of tree it is. Default NULL: as `tree_growth_habit_init` has it.
    pub habit: *const tree_growth_habit,
    /// Where it stands, in metres. Default the origin.
    pub base: [f32; 3],
    /// Iterations, usually years, 0 to 10,000; after 0 there is the seedling's one internode. Default 18.
    pub iterations: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_growth_params {
    const NAME: &'static str = "tree_growth_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let params = GrowthParams::default();
        Self {
            struct_size: size_of::<Self>(),
            world: std::ptr::null(),
            habit: std::ptr::null(),
            base: params.base.to_array(),
            iterations: params.iterations,
        }
    }
}

impl tree_growth_params {
    /// The parameters in Rust's form, not yet checked against their ranges.
    pub(super) unsafe fn rust(&self) -> Result<GrowthParams> {
        Ok(GrowthParams {
            iterations: self.iterations,
            world: unsafe { world(self.world, "params.world") }?,
            habit: unsafe { habit(self.habit, "params.habit") }?,
            base: Vec3::from(self.base),
        })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_params_init(
    params: *mut tree_growth_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether all fields, those of world and habit too, are in order: `TREE_OK`, or the error that their use would give.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_params_check(
    params: *const tree_growth_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params")?.rust() }?.validate()?))
}

/// A tree to be, and where it stands. Begin with `tree_growth_plant_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_growth_plant {
    /// `sizeof(tree_growth_plant)`.
    pub struct_size: usize,
    /// Its kind. Default NULL: as `tree_growth_habit_init` has it.
    pub habit: *const tree_growth_habit,
    /// Where it stands, in metres, at most 1,000 km from the origin. Default the origin.
    pub base: [f32; 3],
    /// Direction of its first internode; any length but 0. Default 0, 1, 0.
    pub direction: [f32; 3],
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_growth_plant {
    const NAME: &'static str = "tree_growth_plant";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            habit: std::ptr::null(),
            base: [0.0; 3],
            direction: Vec3::Y.to_array(),
        }
    }
}

/// Makes `plant`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_plant_init(
    plant: *mut tree_growth_plant,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(plant, size) })
}

/// NULL is the default.
pub(super) unsafe fn world(given: *const tree_growth_world, name: &str) -> Result<World> {
    unsafe { read_or_default(given, name)?.rust(name) }
}

unsafe fn habit(given: *const tree_growth_habit, name: &str) -> Result<Habit> {
    unsafe { read_or_default(given, name)?.rust(name) }
}

/// The caller's plants.
pub(super) unsafe fn plants(first: *const tree_growth_plant, n: usize) -> Result<Vec<Plant>> {
    unsafe { read_rows(first, n, MAX_PLANTS, "plants") }?
        .iter()
        .enumerate()
        .map(|(i, plant)| {
            Ok(Plant {
                habit: unsafe { habit(plant.habit, &format!("plants[{i}].habit")) }?,
                base: Vec3::from(plant.base),
                direction: Vec3::from(plant.direction),
            })
        })
        .collect()
}
