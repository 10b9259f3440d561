//! Leaves and twigs of species by name.

use super::leaf_params::tree_leaf_params;
use super::twig_params::tree_twig_params;
use crate::border::{
    Failure, TREE_ERROR_PARAMETER, call, out_value, text, tree_status, tree_str, view,
};
use std::ffi::c_char;
use tree_model::foliage::{SPECIES, SpeciesPreset};

/// Number of species whose leaves and twigs are known by name.
#[unsafe(no_mangle)]
pub extern "C" fn tree_foliage_preset_count() -> usize {
    SPECIES.len()
}

/// Name of the species with this number, from 0 up to, but not including, `tree_foliage_preset_count`.
/// Valid for ever.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_foliage_preset_name(
    index: usize,
    name: *mut tree_str,
) -> tree_status {
    call(|| {
        let species = SPECIES.get(index).ok_or_else(|| {
            let text = format!("index is {index}, there are {} species", SPECIES.len());
            Failure::new(TREE_ERROR_PARAMETER, text)
        })?;
        unsafe { out_value(name, tree_str::of(species.name), "name") }
    })
}

/// Leaves and twigs of a species by its name, of `len` bytes. Set `struct_size` of `leaves` and `twigs`
/// first. `leaf_kind` is the name of the leaf kind that goes with them, valid for ever, for the
/// `leaf_kinds` of a `tree_species`; it is kind 0 of the leaves. Each of the three may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_foliage_preset(
    name: *const c_char,
    len: usize,
    leaves: *mut tree_leaf_params,
    twigs: *mut tree_twig_params,
    leaf_kind: *mut tree_str,
) -> tree_status {
    call(|| {
        let species = SpeciesPreset::find(unsafe { text(name, len, "name") }?)?;
        unsafe { view(leaves, "leaves", &tree_leaf_params::of(&species.leaves)) }?;
        unsafe { view(twigs, "twigs", &tree_twig_params::of(&species.twigs)) }?;
        if leaf_kind.is_null() {
            return Ok(());
        }
        unsafe { out_value(leaf_kind, tree_str::of(species.leaf_kind), "leaf_kind") }
    })
}
