//! Ready-made trees, as structs that belong to the library.

use super::level::{placing_of, tree_path_level};
use super::params::{TREE_PATH_LIFESPAN_FULL, TREE_PATH_LIFESPAN_RANDOM, tree_path_params};
use super::terrain::tree_paint;
use crate::allometry::tree_radius_rule;
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, Versioned, call, init, out_value, register_for_ever,
    text, tree_status, tree_str, write,
};
use crate::foliage::tree_leaf_params;
use crate::tree::tree_species;
use crate::volume::tree_volume;
use std::ptr::null;
use std::sync::OnceLock;
use tree_model::path::{Lifespan, LinkParams, PRESETS, PathParams, Preset};
use tree_model::tree_core::{Species, Volume};

/// The presets in C's form, in the order of [`PRESETS`].
struct Built(Vec<tree_path_params>);
// SAFETY: points at what nothing ever changes or frees.
unsafe impl Send for Built {}
// SAFETY: as above.
unsafe impl Sync for Built {}

static BUILT: OnceLock<Built> = OnceLock::new();

fn built() -> &'static [tree_path_params] {
    let build = || {
        // A preset that could not be built would show as one without a volume.
        let of = |preset: &Preset| preset.params().map_or(EMPTY, |params| keep(&params));
        Built(PRESETS.iter().map(of).collect())
    };
    &BUILT.get_or_init(build).0
}

/// The first preset: the default of `tree_path_params`.
pub(super) fn oak() -> tree_path_params {
    built().first().copied().unwrap_or(EMPTY)
}

/// No tree.
const EMPTY: tree_path_params = tree_path_params {
    struct_size: size_of::<tree_path_params>(),
    volume: null(),
    root: [0.0; 3],
    graph_nodes: 0,
    endpoints_random: 0,
    endpoints_placing: 0,
    endpoints_candidates: 0,
    endpoints_above: 0.0,
    placed: null(),
    n_placed: 0,
    size: 0.0,
    shrink: 0.0,
    levels: null(),
    n_levels: 0,
    lifespan: TREE_PATH_LIFESPAN_FULL,
    lifespan_stop: 0.0,
    linking_reach: 0.0,
    linking_low: 0.0,
    linking_bias: 0.0,
    smoothing: 0,
    paints: null(),
    n_paints: 0,
    cost: None,
    cost_user: std::ptr::null_mut(),
    obstacle: null(),
    radii: null(),
    leaves: null(),
    species: null(),
    roots: null(),
    clearance: 0.0,
    reserved: 0,
};

/// Parameters in C's form, whose parts live for ever. Cost functions cannot be kept: presets have none.
fn keep(params: &PathParams) -> tree_path_params {
    let (lifespan, lifespan_stop) = match params.lifespan {
        Lifespan::Full => (TREE_PATH_LIFESPAN_FULL, 0.0),
        Lifespan::Random { stop } => (TREE_PATH_LIFESPAN_RANDOM, stop),
    };
    let paints = params.paint.iter().map(|paint| tree_paint {
        volume: keep_volume(&paint.volume),
        factor: paint.factor,
        ..tree_paint::default_value()
    });
    let placed = params.endpoints.placed.iter().map(|point| point.to_array());
    let obstacle = params.obstacle.as_ref();
    let LinkParams { reach, low, bias } = params.linking;
    tree_path_params {
        volume: keep_volume(&params.volume),
        root: params.root.to_array(),
        graph_nodes: params.graph_nodes,
        endpoints_random: params.endpoints.random,
        endpoints_placing: placing_of(params.endpoints.placing),
        endpoints_candidates: params.endpoints.candidates,
        endpoints_above: params.endpoints.above,
        placed: keep_all(placed).cast(),
        n_placed: params.endpoints.placed.len(),
        size: params.size,
        shrink: params.shrink,
        levels: keep_all(params.levels.iter().map(tree_path_level::of)),
        n_levels: params.levels.len(),
        lifespan,
        lifespan_stop,
        linking_reach: reach,
        linking_low: low,
        linking_bias: bias,
        smoothing: params.smoothing,
        paints: keep_all(paints),
        n_paints: params.paint.len(),
        obstacle: obstacle.map_or(null(), |obstacle| keep_volume(&obstacle.volume)),
        radii: keep_one(tree_radius_rule::of(&params.radii)),
        leaves: params.leaves.as_ref().map_or(null(), |own| keep_one(tree_leaf_params::of(own))),
        species: keep_species(&params.species),
        roots: params.roots.as_ref().map_or(null(), |roots| keep_one(keep(roots))),
        clearance: obstacle.map_or(0.0, |obstacle| obstacle.clearance),
        ..EMPTY
    }
}

fn keep_volume(volume: &Volume) -> *const tree_volume {
    register_for_ever(tree_volume::new(volume.clone()))
}

/// A value that lives for ever.
pub(crate) fn keep_one<T>(value: T) -> *const T {
    Box::leak(Box::new(value))
}

/// NULL for none.
fn keep_all<T>(values: impl Iterator<Item = T>) -> *const T {
    let values: Vec<T> = values.collect();
    if values.is_empty() { null() } else { Box::leak(values.into_boxed_slice()).as_ptr() }
}

/// Names that live for ever.
pub(crate) fn keep_species(species: &Species) -> *const tree_species {
    let keep = |name: &String| tree_str::of(Box::leak(name.clone().into_boxed_str()));
    keep_one(tree_species {
        name: keep(&species.name),
        bark: keep(&species.bark),
        leaf_kinds: keep_all(species.leaf_kinds.iter().map(keep)),
        n_leaf_kinds: species.leaf_kinds.len(),
        ..tree_species::default_value()
    })
}

/// Number of presets: an oak, the twelve trees of Xu and Mould (2012), and two root systems.
#[unsafe(no_mangle)]
pub extern "C" fn tree_path_preset_count() -> usize {
    PRESETS.len()
}

fn at(index: usize) -> Result<&'static Preset> {
    PRESETS.get(index).ok_or_else(|| {
        let text = format!("index is {index}, but there are {} presets", PRESETS.len());
        Failure::new(TREE_ERROR_PARAMETER, text)
    })
}

/// Name of a preset, such as `oak`, and what the tree looks like, in a few words. `index` is below
/// `tree_path_preset_count`; `title` may be NULL. Both texts are valid for ever.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_path_preset_name(
    index: usize,
    name: *mut tree_str,
    title: *mut tree_str,
) -> tree_status {
    call(|| {
        let preset = at(index)?;
        unsafe { out_value(name, tree_str::of(preset.name()), "name") }?;
        if title.is_null() {
            return Ok(());
        }
        unsafe { out_value(title, tree_str::of(preset.title()), "title") }
    })
}

/// Seconds that the tree took the authors of the method, in 2012; 0 where it is none of theirs. `index` is
/// below `tree_path_preset_count`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_path_preset_paper_seconds(
    index: usize,
    seconds: *mut f32,
) -> tree_status {
    call(|| {
        let found = at(index)?.paper_seconds().unwrap_or(0.0);
        unsafe { out_value(seconds, found, "seconds") }
    })
}

/// Makes `params`, of `size` bytes, the preset called `name` (`len` bytes, or `TREE_NUL_TERMINATED`). What
/// it points at belongs to the library and lives for ever. `TREE_ERROR_UNKNOWN_NAME` lists the names there
/// are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_path_preset(
    name: *const std::ffi::c_char,
    len: usize,
    params: *mut tree_path_params,
    size: usize,
) -> tree_status {
    call(|| {
        let name = Preset::find(unsafe { text(name, len, "name") }?)?.name();
        let found = PRESETS.iter().zip(built()).find(|(preset, _)| preset.name() == name);
        unsafe { init(params, size) }?;
        unsafe { write(params, "params", &found.map_or(EMPTY, |(_, params)| *params)) }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use tree_model::tree_core::Limits;

    #[test]
    fn presets_come_back_from_c_as_they_went() {
        for (preset, built) in PRESETS.iter().zip(built()) {
            let there = preset.params().unwrap();
            let back = unsafe { built.rust(&Limits::default(), "params") }.unwrap();
            back.validate().unwrap();
            assert_eq!(back.volume, there.volume);
            assert_eq!(back.endpoints, there.endpoints);
            assert_eq!(format!("{:?}", back.levels), format!("{:?}", there.levels));
            assert_eq!(format!("{:?}", back.paint), format!("{:?}", there.paint));
            assert_eq!(back.leaves, there.leaves);
            assert_eq!(format!("{:?}", back.radii), format!("{:?}", there.radii));
            assert_eq!(back.species, there.species);
            assert_eq!(back.lifespan, there.lifespan);
            assert_eq!(back.linking, there.linking);
            assert_eq!((back.size, back.shrink), (there.size, there.shrink));
            assert_eq!(back.smoothing, there.smoothing);
            assert_eq!(back.roots.is_some(), there.roots.is_some());
        }
    }
}
