//! Ready-made habits, as structs that belong to the library.

use super::habit::tree_growth_habit;
use super::params::tree_growth_params;
use super::world::tree_growth_world;
use crate::border::{
    Failure, TREE_ERROR_PARAMETER, Versioned, call, init, out_value, text, tree_status, tree_str,
    write,
};
use crate::foliage::tree_leaf_params;
use crate::path::{keep_one, keep_species};
use std::ffi::c_char;
use std::ptr::null;
use std::sync::OnceLock;
use tree_model::growth::{GrowthParams, Habit, PRESETS, Preset};

/// The presets in C's form, in the order of [`PRESETS`], and the default habit.
struct Built {
    presets: Vec<tree_growth_params>,
    habit: tree_growth_habit,
}
// SAFETY: points at what nothing ever changes or frees.
unsafe impl Send for Built {}
// SAFETY: as above.
unsafe impl Sync for Built {}

static BUILT: OnceLock<Built> = OnceLock::new();

fn built() -> &'static Built {
    BUILT.get_or_init(|| Built {
        presets: PRESETS.iter().map(|preset| keep(&preset.params())).collect(),
        habit: keep_habit(&Habit::default()),
    })
}

/// The default of `tree_growth_habit`.
pub(super) fn default_habit() -> tree_growth_habit {
    built().habit
}

/// Parameters in C's form, whose parts live for ever. Presets have no volumes.
fn keep(params: &GrowthParams) -> tree_growth_params {
    tree_growth_params {
        struct_size: size_of::<tree_growth_params>(),
        world: keep_one(tree_growth_world::of(&params.world)),
        habit: keep_one(keep_habit(&params.habit)),
        base: params.base.to_array(),
        iterations: params.iterations,
    }
}

fn keep_habit(habit: &Habit) -> tree_growth_habit {
    tree_growth_habit {
        leaves: habit.leaves.as_ref().map_or(null(), |own| keep_one(tree_leaf_params::of(own))),
        species: keep_species(&habit.species),
        ..tree_growth_habit::of(habit)
    }
}

/// Number of presets of growing trees.
#[unsafe(no_mangle)]
pub extern "C" fn tree_growth_preset_count() -> usize {
    PRESETS.len()
}

/// Name of a preset, such as `oak`; valid for ever. `index` is below `tree_growth_preset_count`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_preset_name(index: usize, name: *mut tree_str) -> tree_status {
    call(|| {
        let preset = PRESETS.get(index).ok_or_else(|| {
            let text = format!("index is {index}, but there are {} presets", PRESETS.len());
            Failure::new(TREE_ERROR_PARAMETER, text)
        })?;
        unsafe { out_value(name, tree_str::of(preset.name()), "name") }
    })
}

/// Makes `params`, of `size` bytes, the preset called `name` (`len` bytes, or `TREE_NUL_TERMINATED`). World and habit, and
/// what they point at, belong to the library and live for ever: to alter one, copy it and point at the copy. The habit is
/// for `tree_growth_plant` too. `TREE_ERROR_UNKNOWN_NAME` lists the names there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_preset(
    name: *const c_char,
    len: usize,
    params: *mut tree_growth_params,
    size: usize,
) -> tree_status {
    call(|| {
        let name = Preset::find(unsafe { text(name, len, "name") }?)?.name();
        let mut all = PRESETS.iter().zip(&built().presets);
        let found = all.find(|(preset, _)| preset.name() == name);
        unsafe { init(params, size) }?;
        let value = found.map_or_else(tree_growth_params::default_value, |(_, own)| *own);
        unsafe { write(params, "params", &value) }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn presets_come_back_from_c_as_they_went() {
        for (preset, built) in PRESETS.iter().zip(&built().presets) {
            let there = preset.params();
            let back = unsafe { built.rust() }.unwrap();
            back.validate().unwrap();
            assert_eq!(format!("{back:?}"), format!("{there:?}"), "{}", preset.name());
        }
    }

    #[test]
    fn defaults_come_back_from_c_as_they_went() {
        let back = unsafe { tree_growth_params::default_value().rust() }.unwrap();
        assert_eq!(format!("{back:?}"), format!("{:?}", GrowthParams::default()));
    }
}
