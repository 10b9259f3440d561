//! Hybrid models and their parts.

use super::params::tree_hybrid_params;
use crate::border::{
    Failure, Handle, Shared, TREE_ERROR_NO_RESULT, Versioned, call, free, get, get_opt, out,
    out_value, read_or_default, tree_status, write,
};
use crate::control::{limits, run, tree_control};
use crate::impostor::tree_cards;
use crate::look::{or_built_in, tree_look};
use crate::mesh::tree_mesh;
use crate::multires::{there, tree_multi_mesh, tree_multires};
use crate::tree::tree_tree;
use bytemuck::{Pod, Zeroable};
use tree_lod::hybrid::Hybrid;

/// A tree for all distances: its wood has levels that are prefixes, its leaves are drawn as they are or by pictures of
/// boxes of them.
pub struct tree_hybrid(Shared<Hybrid>);

impl Handle for tree_hybrid {
    const NAME: &'static str = "tree_hybrid";
}

impl tree_hybrid {
    pub(super) fn rust(&self) -> &Hybrid {
        self.0.get()
    }

    pub(super) fn shared(&self) -> Shared<Hybrid> {
        self.0.clone()
    }
}

/// Makes the model of a tree: sorts its branches (`tree_multires_new`), draws them (`tree_multi_mesh_new`), puts its
/// leaves into boxes (`tree_leaf_boxes_along`) and takes their pictures (`tree_cards_bake`), which takes most of the
/// time. `look` may be NULL: the built-in textures that the tree's species names. `params` and `control` may be NULL.
/// Free the model with `tree_hybrid_free`. Errors are those of the steps.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_make(
    tree: *const tree_tree,
    look: *const tree_look,
    params: *const tree_hybrid_params,
    control: *const tree_control,
    hybrid: *mut *mut tree_hybrid,
) -> tree_status {
    call(|| {
        let place = unsafe { out(hybrid, "hybrid") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let look = unsafe { get_opt(look, "look") }?.map(tree_look::rust);
        let limits = unsafe { limits(control) }?;
        let params = unsafe { read_or_default(params, "params")?.rust(&limits) }?;
        let made = unsafe {
            run(control, |control| {
                let look = or_built_in(look, tree.species())?;
                Ok(Hybrid::make(tree, &look, &params, control)?)
            })
        }?;
        place.put(tree_hybrid(Shared::new(made)));
        Ok(())
    })
}

/// How much there is of a hybrid model.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_hybrid_totals {
    /// `sizeof(tree_hybrid_totals)`.
    pub struct_size: usize,
    /// Levels of the wood, at least 1.
    pub n_levels: usize,
    /// Surfaces of its mesh, those without triangles included; surface 0 is the wood.
    pub n_surfaces: usize,
    /// Triangles when all is drawn as it is.
    pub n_triangles: u64,
    /// Boxes of leaves; 0 for a tree without leaves.
    pub n_boxes: usize,
    /// Rows of the order of the boxes: leaves that are drawn.
    pub n_leaves: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_hybrid_totals {
    const NAME: &'static str = "tree_hybrid_totals";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_levels: 0,
            n_surfaces: 0,
            n_triangles: 0,
            n_boxes: 0,
            n_leaves: 0,
        }
    }
}

/// Tells how large a model is. Set `totals->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_measure(
    hybrid: *const tree_hybrid,
    totals: *mut tree_hybrid_totals,
) -> tree_status {
    call(|| {
        let hybrid = unsafe { get(hybrid, "hybrid") }?.rust();
        let boxes = hybrid.cards().map(|cards| cards.boxes().report()).unwrap_or_default();
        let found = tree_hybrid_totals {
            n_levels: hybrid.wood().n_levels(),
            n_surfaces: hybrid.mesh().surfaces.len(),
            n_triangles: hybrid.mesh().n_triangles() as u64,
            n_boxes: boxes.n_boxes,
            n_leaves: boxes.n_leaves,
            ..tree_hybrid_totals::default_value()
        };
        unsafe { write(totals, "totals", &found) }
    })
}

/// The mesh to upload, nothing copied: surface 0 is the wood, of which a level is a prefix; the others are leaves, kind by
/// kind, in the order of the boxes, so that each box has one window (`tree_hybrid_leaf_window`). Free it with
/// `tree_mesh_free`; it keeps alive what it is of.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_mesh(
    hybrid: *const tree_hybrid,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        place.put(tree_mesh::part(unsafe { get(hybrid, "hybrid") }?.0.part(Hybrid::mesh)));
        Ok(())
    })
}

/// The sorted tree, nothing copied. Free it with `tree_multires_free`; it keeps alive what it is of.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_multires(
    hybrid: *const tree_hybrid,
    multires: *mut *mut tree_multires,
) -> tree_status {
    call(|| {
        let place = unsafe { out(multires, "multires") }?;
        place.put(tree_multires::part(unsafe { get(hybrid, "hybrid") }?.0.part(Hybrid::multires)));
        Ok(())
    })
}

/// The wood and its levels, with leaves in the order of their paths, nothing copied: `tree_multi_mesh_branches` of surface
/// 0 and `tree_multi_mesh_draws` are right for the model's mesh too. Free it with `tree_multi_mesh_free`; it keeps alive
/// what it is of.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_wood(
    hybrid: *const tree_hybrid,
    wood: *mut *mut tree_multi_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(wood, "wood") }?;
        place.put(tree_multi_mesh::part(unsafe { get(hybrid, "hybrid") }?.0.part(Hybrid::wood)));
        Ok(())
    })
}

/// Boxes and pictures of the leaves, nothing copied. Free them with `tree_cards_free`; they keep alive what they are of.
/// `TREE_ERROR_NO_RESULT` when the tree has no leaves.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_cards(
    hybrid: *const tree_hybrid,
    cards: *mut *mut tree_cards,
) -> tree_status {
    call(|| {
        let place = unsafe { out(cards, "cards") }?;
        let found = unsafe { get(hybrid, "hybrid") }?.0.part_if(Hybrid::cards);
        let none = || Failure::new(TREE_ERROR_NO_RESULT, "the tree has no leaves, and so no cards");
        place.put(tree_cards::part(found.ok_or_else(none)?));
        Ok(())
    })
}

/// A part of an index buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
pub struct tree_index_window {
    /// The first index.
    pub first_index: u32,
    /// Number of indices; may be 0.
    pub index_count: u32,
}

/// Which indices of surface `number` of the model's mesh draw `n_leaves` leaves from row `first_leaf` on, as
/// `tree_hybrid_choice_ranges` gives them. None for the wood, and for rows that are not there. `TREE_ERROR_PARAMETER` when there is no such surface.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_leaf_window(
    hybrid: *const tree_hybrid,
    number: usize,
    first_leaf: u32,
    n_leaves: u32,
    window: *mut tree_index_window,
) -> tree_status {
    call(|| {
        let hybrid = unsafe { get(hybrid, "hybrid") }?.rust();
        there("number", number, hybrid.mesh().surfaces.len(), "surfaces")?;
        let rows = first_leaf..first_leaf.saturating_add(n_leaves);
        let (first_index, index_count) = hybrid.leaf_window(number, rows);
        unsafe { out_value(window, tree_index_window { first_index, index_count }, "window") }
    })
}

/// The fractional level of the wood where a metre covers so many pixels, 0 to infinity; it changes without a step.
/// `TREE_ERROR_PARAMETER` for less than 0, or NaN.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_level(
    hybrid: *const tree_hybrid,
    pixels_per_metre: f32,
    level: *mut f32,
) -> tree_status {
    call(|| {
        let found = unsafe { get(hybrid, "hybrid") }?.rust().level(pixels_per_metre)?;
        unsafe { out_value(level, found, "level") }
    })
}

/// Frees a model. Its parts that were asked for, and choices, stay.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_free(hybrid: *mut tree_hybrid) -> tree_status {
    call(|| unsafe { free(hybrid, "hybrid") })
}
