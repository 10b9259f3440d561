//! How traces become a tree.

use crate::allometry::tree_radius_rule;
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, TREE_ERROR_UNKNOWN_NAME, Versioned, call, init, read,
    text, tree_status, write,
};
use crate::foliage::{tree_leaf_params, tree_twig_params};
use crate::particle::keep::Kept;
use crate::tree::tree_species;
use std::ffi::c_char;
use std::ptr::null;
use std::sync::OnceLock;
use tree_model::foliage::{SPECIES, SpeciesPreset};
use tree_model::particle::finish::FinishParams;
use tree_model::tree_core::allometry::{PipeModel, RadiusRule};

/// How traces become a tree. Begin with `tree_finish_params_init`, which makes it an oak, or with
/// `tree_finish_params_find`. What it points at then belongs to the library, lives for ever and is not to be
/// written: to alter twigs or leaves, copy them to a struct of your own and point at that.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_finish_params {
    /// `sizeof(tree_finish_params)`.
    pub struct_size: usize,
    /// How thick branches are: a rule of the kind `TREE_RADII_PIPE`. Without a `trunk_radius` that seen in
    /// the pictures is taken, and where they show no bare trunk, `slenderness`. NULL for the default: an
    /// exponent of 2.49.
    pub radii: *const tree_radius_rule,
    /// Twigs on the ends of the traces; NULL for none. Default those of an oak.
    pub twigs: *const tree_twig_params,
    /// Leaves; NULL for a bare tree. Default sprays of an oak's leaves.
    pub leaves: *const tree_leaf_params,
    /// Names of species, bark and leaves; NULL for an oak's. With leaves it must have the kind that they
    /// name.
    pub species: *const tree_species,
    /// Passes of smoothing along branches, 0 to 100. Default 4.
    pub smoothing: u32,
    /// Nodes nearer to the one below than this share of the tree's height are left out, 0 to 0.1. Default
    /// 0.005.
    pub spacing: f32,
    /// Radius of the trunk as a share of the height where nothing tells it, 1e-4 to 0.2. Default 0.017.
    pub slenderness: f32,
    /// Area of a blade as a share of its length squared, 1e-3 to 2: how much a leaf covers, and so how many
    /// it takes. Default 0.333, an oak's spray; an oak leaf has 0.28, a needle 0.04.
    pub blade: f32,
    /// Leaves against what the pictures ask for, 0 to 10. Default 1.
    pub fullness: f32,
    /// Times the leaves are counted in the pictures and their density put right, 0 to 10. Default 3.
    pub corrections: u32,
    /// Leaves and twigs where a picture's matte is below this are discarded, 0 (none) to 1. Default 0.5.
    pub empty: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_finish_params {
    const NAME: &'static str = "tree_finish_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        built().oak
    }
}

impl tree_finish_params {
    /// The parameters in C's form; what they point at is kept in `kept`.
    pub(in crate::particle) fn of(params: &FinishParams, kept: &mut Kept) -> Self {
        let leaves = params.leaves.as_ref().map(tree_leaf_params::of);
        let twigs = params.twigs.as_ref().map(tree_twig_params::of);
        Self {
            struct_size: size_of::<Self>(),
            radii: kept.one(tree_radius_rule::of(&RadiusRule::Pipe(params.radii))),
            twigs: twigs.map_or(null(), |twigs| kept.one(twigs)),
            leaves: leaves.map_or(null(), |leaves| kept.one(leaves)),
            species: kept.species(&params.species),
            smoothing: params.smoothing,
            spacing: params.spacing,
            slenderness: params.slenderness,
            blade: params.blade,
            fullness: params.fullness,
            corrections: params.corrections,
            empty: params.empty,
            reserved: 0,
        }
    }

    /// The parameters in Rust's form, not yet checked against their ranges; `name` is what they are called
    /// by.
    pub(in crate::particle) unsafe fn rust(&self, name: &str) -> Result<FinishParams> {
        let part = |field: &str| format!("{name}.{field}");
        let default = FinishParams::default();
        let twigs = match self.twigs.is_null() {
            true => None,
            false => Some(unsafe { read(self.twigs, &part("twigs")) }?.rust()?),
        };
        let leaves = match self.leaves.is_null() {
            true => None,
            false => Some(unsafe { read(self.leaves, &part("leaves")) }?.rust()?),
        };
        let species = match self.species.is_null() {
            true => default.species,
            false => unsafe { read(self.species, &part("species"))?.rust(&part("species")) }?,
        };
        Ok(FinishParams {
            smoothing: self.smoothing,
            spacing: self.spacing,
            radii: unsafe { self.pipe(default.radii, &part("radii")) }?,
            slenderness: self.slenderness,
            twigs,
            leaves,
            blade: self.blade,
            fullness: self.fullness,
            corrections: self.corrections,
            empty: self.empty,
            species,
        })
    }

    unsafe fn pipe(&self, default: PipeModel, name: &str) -> Result<PipeModel> {
        if self.radii.is_null() {
            return Ok(default);
        }
        match unsafe { read(self.radii, name) }?.rust()? {
            RadiusRule::Pipe(pipe) => Ok(pipe),
            _ => {
                let text = format!("{name}.kind must be TREE_RADII_PIPE");
                Err(Failure::new(TREE_ERROR_PARAMETER, text))
            }
        }
    }
}

/// The parameters for all species by name, which live for ever.
struct Built {
    oak: tree_finish_params,
    /// For each species what `find` gives, and what `of` does.
    species: Vec<(&'static str, [tree_finish_params; 2])>,
    _kept: Kept,
}

// SAFETY: points at what it keeps, which nothing changes.
unsafe impl Send for Built {}
// SAFETY: as above.
unsafe impl Sync for Built {}

fn built() -> &'static Built {
    static BUILT: OnceLock<Built> = OnceLock::new();
    BUILT.get_or_init(|| {
        let mut kept = Kept::default();
        let oak = tree_finish_params::of(&FinishParams::default(), &mut kept);
        let species = SPECIES
            .iter()
            .filter_map(|preset| {
                let both = [FinishParams::find(preset.name).ok()?, FinishParams::of(preset)];
                Some((preset.name, both.map(|params| tree_finish_params::of(&params, &mut kept))))
            })
            .collect();
        Built { oak, species, _kept: kept }
    })
}

/// Makes `params`, of `size` bytes, an oak.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_finish_params_init(
    params: *mut tree_finish_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Makes `params`, of `size` bytes, those of a species by its name, of `len` bytes or
/// `TREE_NUL_TERMINATED`: the defaults with its twigs, and sprays of its leaves or needles. Names are
/// those of `tree_foliage_preset_name`; `TREE_ERROR_UNKNOWN_NAME` lists them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_finish_params_find(
    name: *const c_char,
    len: usize,
    params: *mut tree_finish_params,
    size: usize,
) -> tree_status {
    call(|| {
        let [sprays, _] = unsafe { species(name, len) }?;
        unsafe { init(params, size) }?;
        unsafe { write(params, "params", sprays) }
    })
}

/// As `tree_finish_params_find`, with single leaves and needles instead of sprays: far more of them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_finish_params_of(
    name: *const c_char,
    len: usize,
    params: *mut tree_finish_params,
    size: usize,
) -> tree_status {
    call(|| {
        let [_, single] = unsafe { species(name, len) }?;
        unsafe { init(params, size) }?;
        unsafe { write(params, "params", single) }
    })
}

unsafe fn species(name: *const c_char, len: usize) -> Result<&'static [tree_finish_params; 2]> {
    let name = SpeciesPreset::find(unsafe { text(name, len, "name") }?)?.name;
    let found = built().species.iter().find(|(known, _)| *known == name);
    let none = || Failure::new(TREE_ERROR_UNKNOWN_NAME, format!("{name} has no parameters"));
    Ok(&found.ok_or_else(none)?.1)
}

/// Whether all fields are in order: `TREE_OK`, or the error that their use would give.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_finish_params_check(
    params: *const tree_finish_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params")?.rust("params") }?.validate()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn species_come_back_from_c_as_they_went() {
        assert_eq!(built().species.len(), SPECIES.len());
        for (preset, (name, [sprays, single])) in SPECIES.iter().zip(&built().species) {
            let back = |params: &tree_finish_params| unsafe { params.rust("params") }.unwrap();
            assert_eq!(back(sprays), FinishParams::find(name).unwrap());
            assert_eq!(back(single), FinishParams::of(preset));
        }
        let oak = tree_finish_params::default_value();
        assert_eq!(unsafe { oak.rust("params") }.unwrap(), FinishParams::default());
    }
}
