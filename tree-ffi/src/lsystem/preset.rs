//! Ready-made L-systems.

use super::tree_grammar;
use super::turtle::tree_turtle_params;
use crate::allometry::tree_radius_rule;
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, Versioned, call, init, out, out_value, text,
    tree_status, tree_str, write,
};
use crate::tree::{SpeciesNames, tree_species};
use std::ffi::c_char;
use std::sync::OnceLock;
use tree_model::lsystem::{LSystem, Preset, Thickness, presets};
use tree_model::tree_core::Species;

/// What the turtle of a preset points at.
struct Kept {
    radii: tree_radius_rule,
    species: tree_species,
    _names: (SpeciesNames, Species),
}

// SAFETY: points into the species that it holds, whose texts nothing changes or moves.
unsafe impl Send for Kept {}
// SAFETY: as above.
unsafe impl Sync for Kept {}

static KEPT: OnceLock<Vec<Kept>> = OnceLock::new();

/// Radii and species of all presets, in their order.
fn kept() -> &'static [Kept] {
    KEPT.get_or_init(|| presets().filter_map(|preset| preset.system().ok()).map(keep).collect())
}

fn keep(system: LSystem) -> Kept {
    let radii = match system.turtle.thickness {
        Thickness::Auto(rule) | Thickness::Rule(rule) => tree_radius_rule::of(&rule),
        Thickness::Word => tree_radius_rule::default_value(),
    };
    let species = system.species;
    let names = SpeciesNames::of(&species);
    Kept { radii, species: names.view(&species), _names: (names, species) }
}

/// What is known of a preset. All texts are valid for ever.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_lsystem_preset_info {
    /// `sizeof(tree_lsystem_preset_info)`.
    pub struct_size: usize,
    /// Its name: `oak`, `honda-a`, `abop-1.24f`.
    pub name: tree_str,
    /// What it looks like, in a few words.
    pub title: tree_str,
    /// Where it was published; empty for those of this library.
    pub source: tree_str,
    /// The text of its grammar, before its constants are changed.
    pub text: tree_str,
    /// Number of constants of the text that it changes: `tree_lsystem_preset_constant`.
    pub n_constants: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_lsystem_preset_info {
    const NAME: &'static str = "tree_lsystem_preset_info";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            name: tree_str::EMPTY,
            title: tree_str::EMPTY,
            source: tree_str::EMPTY,
            text: tree_str::EMPTY,
            n_constants: 0,
        }
    }
}

fn at(index: usize) -> Result<Preset> {
    presets().nth(index).ok_or_else(|| {
        let text = format!("index is {index}, but there are {} presets", presets().count());
        Failure::new(TREE_ERROR_PARAMETER, text)
    })
}

/// Number of ready-made L-systems: leafy species of this library first, then those of the books.
#[unsafe(no_mangle)]
pub extern "C" fn tree_lsystem_preset_count() -> usize {
    presets().count()
}

/// Tells name, title, source and text of a preset. `index` is below `tree_lsystem_preset_count`. Set
/// `info->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lsystem_preset_view(
    index: usize,
    info: *mut tree_lsystem_preset_info,
) -> tree_status {
    call(|| {
        let preset = at(index)?;
        let value = tree_lsystem_preset_info {
            name: tree_str::of(preset.name()),
            title: tree_str::of(preset.title()),
            source: tree_str::of(preset.source()),
            text: tree_str::of(preset.text()),
            n_constants: preset.constants().len(),
            ..tree_lsystem_preset_info::default_value()
        };
        unsafe { write(info, "info", &value) }
    })
}

/// Name and value of a constant of the text that a preset changes: presets of one figure share a text. `constant`
/// is below `tree_lsystem_preset_info.n_constants`. The name is valid for ever.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lsystem_preset_constant(
    index: usize,
    constant: usize,
    name: *mut tree_str,
    value: *mut f64,
) -> tree_status {
    call(|| {
        let constants = at(index)?.constants();
        let Some(&(found, number)) = constants.get(constant) else {
            let n = constants.len();
            let text = format!("constant is {constant}, but the preset changes {n}");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        };
        unsafe { out_value(name, tree_str::of(found), "name") }?;
        unsafe { out_value(value, number, "value") }
    })
}

/// The preset called `name` (`len` bytes, or `TREE_NUL_TERMINATED`): `turtle`, of `size` bytes, becomes how it is
/// drawn, what that points at belongs to the library and lives for ever; `grammar` what it derives. Give both to
/// `tree_lsystem_grow`. Free the grammar with `tree_grammar_free`. `TREE_ERROR_UNKNOWN_NAME` lists the names there
/// are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lsystem_preset(
    name: *const c_char,
    len: usize,
    turtle: *mut tree_turtle_params,
    size: usize,
    grammar: *mut *mut tree_grammar,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grammar, "grammar") }?;
        let preset = Preset::find(unsafe { text(name, len, "name") }?)?;
        let system = preset.system()?;
        unsafe { init(turtle, size) }?;
        let kept = presets().zip(kept()).find(|(other, _)| other.name() == preset.name());
        let kept = kept.map(|(_, kept)| kept);
        let value = tree_turtle_params {
            radii: kept.map_or(std::ptr::null(), |kept| &raw const kept.radii),
            species: kept.map_or(std::ptr::null(), |kept| &raw const kept.species),
            ..tree_turtle_params::of(&system.turtle)
        };
        unsafe { write(turtle, "turtle", &value) }?;
        place.put(tree_grammar::new(system.grammar));
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn presets_come_back_from_c_as_they_went() {
        assert_eq!(kept().len(), presets().count());
        for (preset, kept) in presets().zip(kept()) {
            let there = preset.system().unwrap();
            let turtle = tree_turtle_params {
                radii: &raw const kept.radii,
                species: &raw const kept.species,
                ..tree_turtle_params::of(&there.turtle)
            };
            let back = unsafe { turtle.rust("turtle") }.unwrap();
            back.validate().unwrap();
            assert_eq!(back, there.turtle, "{}", preset.name());
            assert_eq!(unsafe { turtle.species("turtle") }.unwrap(), there.species);
        }
    }
}
