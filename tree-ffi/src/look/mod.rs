//! Textures, materials, and what a species looks like.
//!
//! * `texture`, `names`: pictures, drawn, decoded or of the caller's; `bark_style`, `leaf_shape`: drawn to
//!   the caller's wishes.
//! * `material`, `leaf`, `leaf_mesh`: what goes on bark and leaves.

mod bark_style;
mod leaf;
mod leaf_mesh;
mod leaf_shape;
mod material;
mod names;
mod texture;

pub use bark_style::*;
pub use leaf::*;
pub use leaf_mesh::*;
pub use leaf_shape::*;
pub use material::*;
pub use names::*;
pub use texture::*;

use crate::border::{
    Failure, Handle, Result, TREE_ERROR_INVALID, call, free, get, out, out_value, read,
    read_or_default, read_rows, tree_status, write,
};
use crate::control::{limits, tree_control};
use crate::tree::{tree_species, tree_tree};
use ::tree_mesh::{Look, Material};
use leaf_mesh::leaf_of;
use material::check_materials;
use std::borrow::Cow;
use tree_model::tree_core::{Limits, Species};

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

/// The look that was given, or the built-in one of the species.
pub(crate) fn or_built_in<'a>(look: Option<&'a Look>, species: &Species) -> Result<Cow<'a, Look>> {
    Ok(match look {
        Some(look) => Cow::Borrowed(look),
        None => Cow::Owned(Look::built_in(species)?),
    })
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

/// As `tree_look_built_in`, for the species of a tree; with `plain` other than 0 as `tree_look_plain`. Free
/// the look with `tree_look_free`.
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

/// Limits for lists of which a handful is allowed; what is too many is said by the check of their ranges.
fn small() -> Limits {
    Limits { nodes: 1 << 16, ..Limits::default() }
}

/// Most leaf kinds of a look: what an index of 16 bits reaches.
const KINDS_MAX: usize = 1 << 16;

/// Makes a look of your own: `bark` goes on all wood (NULL is the default material), and `leaves` has one
/// row for each of the species' leaf kinds, in that order. All is copied but the textures, which are
/// shared. `control` may be NULL; only its limits matter. Free the look with `tree_look_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_new(
    bark: *const tree_material,
    leaves: *const tree_leaf_look,
    n_leaves: usize,
    control: *const tree_control,
    look: *mut *mut tree_look,
) -> tree_status {
    call(|| {
        let place = unsafe { out(look, "look") }?;
        let limits = unsafe { limits(control) }?;
        let bark = unsafe { read_or_default(bark, "bark")?.rust("bark") }?;
        let rows = unsafe { read_rows(leaves, n_leaves, KINDS_MAX, "leaves") }?;
        let leaves = rows
            .iter()
            .enumerate()
            .map(|(i, row)| unsafe { row.rust(&limits, &format!("leaves[{i}]")) })
            .collect::<Result<Vec<_>>>()?;
        let look = Look { bark, leaves };
        check_materials(materials(&look).cloned().collect())?;
        place.put(tree_look(look));
        Ok(())
    })
}

/// Makes a look that is as another but for the leaves of kind `kind`. Textures are shared; the other look stays as it is.
/// `control` may be NULL; only its limits matter. Free the new look with `tree_look_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_with_leaf(
    look: *const tree_look,
    kind: usize,
    leaf: *const tree_leaf_look,
    control: *const tree_control,
    changed: *mut *mut tree_look,
) -> tree_status {
    call(|| {
        let place = unsafe { out(changed, "changed") }?;
        let old = unsafe { get(look, "look") }?;
        leaf_of(old, kind)?;
        let leaf = unsafe { read(leaf, "leaf")?.rust(&limits(control)?, "leaf") }?;
        let mut look = old.rust().clone();
        look.leaves.splice(kind..=kind, [leaf]);
        check_materials(materials(&look).cloned().collect())?;
        place.put(tree_look(look));
        Ok(())
    })
}

/// The materials of the mesh that a look dresses: bark, then each leaf kind.
fn materials(look: &Look) -> impl Iterator<Item = &Material> {
    std::iter::once(&look.bark).chain(look.leaves.iter().map(|leaf| &leaf.material))
}

fn material_of(look: &tree_look, number: usize) -> Result<&Material> {
    materials(look.rust()).nth(number).ok_or_else(|| {
        let n = 1 + look.rust().leaves.len();
        let text = format!("number is {number}, the look has {n} materials");
        Failure::new(TREE_ERROR_INVALID, text)
    })
}

/// Number of leaf kinds that a look dresses; it has one material more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_leaf_count(
    look: *const tree_look,
    n_leaves: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(look, "look") }?.rust().leaves.len();
        unsafe { out_value(n_leaves, n, "n_leaves") }
    })
}

/// Views a material of a look, numbered as in the meshes it dresses: 0 is the bark's, 1 + k that of leaf
/// kind k. Set `material->struct_size` first. Valid until the look is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_material(
    look: *const tree_look,
    number: usize,
    material: *mut tree_material,
) -> tree_status {
    call(|| {
        let viewed = tree_material::of(material_of(unsafe { get(look, "look") }?, number)?);
        unsafe { write(material, "material", &viewed) }
    })
}

/// A handle of the texture of a look's material, numbered as for `tree_look_material`; the pixels are
/// shared. NULL, and no error, where the material has none. Free it with `tree_texture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_texture(
    look: *const tree_look,
    number: usize,
    texture: *mut *mut tree_texture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(texture, "texture") }?;
        let material = material_of(unsafe { get(look, "look") }?, number)?;
        if let Some(texture) = &material.texture {
            place.put(tree_texture::shared(texture.clone()));
        }
        Ok(())
    })
}

/// Views the look of leaf kind `kind`, but for its material and its mesh, which `tree_look_material` and
/// `tree_look_leaf_mesh` view. Set `leaf->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_leaf(
    look: *const tree_look,
    kind: usize,
    leaf: *mut tree_leaf_look,
) -> tree_status {
    call(|| {
        let viewed = tree_leaf_look::of(leaf_of(unsafe { get(look, "look") }?, kind)?);
        unsafe { write(leaf, "leaf", &viewed) }
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

/// Frees a look. Meshes that were built with it keep their textures.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_look_free(look: *mut tree_look) -> tree_status {
    call(|| unsafe { free(look, "look") })
}
