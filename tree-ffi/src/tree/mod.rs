//! Trees: skeleton, leaves and species.

mod foliage;
mod species;

pub use foliage::*;
pub use species::*;

use crate::border::{Handle, call, free, get, out, read, read_or_default, tree_status, write};
use crate::control::{limits, tree_control};
use crate::skeleton::tree_skeleton;
use std::sync::Arc;
use tree_model::tree_core::Tree;

/// A whole tree: skeleton, leaves and species. Every leaf stands on a node that exists and has a kind
/// that exists.
pub struct tree_tree {
    tree: Arc<Tree>,
    names: SpeciesNames,
}

impl Handle for tree_tree {
    const NAME: &'static str = "tree_tree";
}

impl tree_tree {
    pub(crate) fn new(tree: Tree) -> Self {
        Self::shared(Arc::new(tree))
    }

    pub(crate) fn shared(tree: Arc<Tree>) -> Self {
        let names = SpeciesNames::of(tree.species());
        Self { tree, names }
    }

    pub(crate) fn rust(&self) -> &Tree {
        &self.tree
    }
}

/// Makes a tree of a skeleton, which is copied, and columns of leaves (NULL for none), which are copied.
/// `species` may be NULL for an oak. `control` may be NULL; only its limits matter. Free the tree with
/// `tree_tree_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tree_new(
    skeleton: *const tree_skeleton,
    foliage: *const tree_foliage,
    species: *const tree_species,
    control: *const tree_control,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust().clone();
        let foliage = unsafe { read_or_default(foliage, "foliage") }?;
        let foliage = unsafe { foliage.rust(&limits(control)?) }?;
        let species = if species.is_null() {
            Default::default()
        } else {
            unsafe { read(species, "species")?.rust("species") }?
        };
        place.put(tree_tree::new(Tree::new(skeleton, foliage, species)?));
        Ok(())
    })
}

/// The tree's skeleton, not copied. Free it with `tree_skeleton_free`; it may outlive the tree's handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tree_skeleton(
    tree: *const tree_tree,
    skeleton: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(skeleton, "skeleton") }?;
        let tree = unsafe { get(tree, "tree") }?;
        place.put(tree_skeleton::of(tree.tree.clone()));
        Ok(())
    })
}

/// Views the tree's leaves. Set `foliage->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tree_foliage(
    tree: *const tree_tree,
    foliage: *mut tree_foliage,
) -> tree_status {
    call(|| {
        let tree = unsafe { get(tree, "tree") }?;
        unsafe { write(foliage, "foliage", &tree_foliage::of(tree.rust().foliage())) }
    })
}

/// Views the tree's species. Set `species->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tree_species(
    tree: *const tree_tree,
    species: *mut tree_species,
) -> tree_status {
    call(|| {
        let tree = unsafe { get(tree, "tree") }?;
        unsafe { write(species, "species", &tree.names.view(tree.rust().species())) }
    })
}

/// Frees a tree.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tree_free(tree: *mut tree_tree) -> tree_status {
    call(|| unsafe { free(tree, "tree") })
}
