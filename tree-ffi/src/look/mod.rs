//! Textures, materials, and what a species looks like.

use crate::border::{Handle, Result, call, free, get, out, read, tree_status};
use crate::tree::{tree_species, tree_tree};
use ::tree_mesh::Look;
use tree_model::tree_core::Species;

/// What a species looks like: a material for the bark, and a leaf look for each leaf kind.
pub struct tree_look(Look);

impl Handle for tree_look {
    const NAME: &'static str = "tree_look";
}

impl tree_look {
    pub(crate) fn rust(&self) -> &Look {
        &self.0
    }
}

/// The caller's species; NULL is an oak.
unsafe fn species_or_oak(species: *const tree_species) -> Result<Species> {
    if species.is_null() {
        return Ok(Species::default());
    }
    unsafe { read(species, "species")?.rust("species") }
}

/// Makes a look of the built-in bark and leaf textures that the species names; NULL is an oak.
/// `TREE_ERROR_UNKNOWN_NAME` for a name that is not built in: dress such species with `tree_look_plain`
/// or textures of your own. Free the look with `tree_look_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_built_in(
    species: *const tree_species,
    look: *mut *mut tree_look,
) -> tree_status {
    call(|| {
        let place = unsafe { out(look, "look") }?;
        let species = unsafe { species_or_oak(species) }?;
        place.put(tree_look(Look::built_in(&species)?));
        Ok(())
    })
}

/// Makes a look of plain colours without textures, for a species; NULL is an oak. For previews, tests and
/// engines that bring their own materials. Leaf cards show as whole rectangles. Free the look with
/// `tree_look_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_plain(
    species: *const tree_species,
    look: *mut *mut tree_look,
) -> tree_status {
    call(|| {
        let place = unsafe { out(look, "look") }?;
        let species = unsafe { species_or_oak(species) }?;
        place.put(tree_look(Look::plain(&species)));
        Ok(())
    })
}

/// As `tree_look_built_in`, for the species of a tree; with `plain` as `tree_look_plain`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_of_tree(
    tree: *const tree_tree,
    plain: u32,
    look: *mut *mut tree_look,
) -> tree_status {
    call(|| {
        let place = unsafe { out(look, "look") }?;
        let species = unsafe { get(tree, "tree") }?.rust().species();
        let made = if plain != 0 { Look::plain(species) } else { Look::built_in(species)? };
        place.put(tree_look(made));
        Ok(())
    })
}

/// Checks that a look has one leaf look for each leaf kind of the species (NULL is an oak).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_check(
    look: *const tree_look,
    species: *const tree_species,
) -> tree_status {
    call(|| {
        let look = unsafe { get(look, "look") }?;
        let species = unsafe { species_or_oak(species) }?;
        Ok(look.rust().check(&species)?)
    })
}

/// Ends a look. Meshes that were built with it keep their textures.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_free(look: *mut tree_look) -> tree_status {
    call(|| unsafe { free(look, "look") })
}
