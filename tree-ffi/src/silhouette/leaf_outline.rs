//! Outlines drawn as leaves.

use super::measure::spot;
use super::tree_outline;
use crate::border::{Handle, Versioned, call, free, get, out, out_value, tree_status, write};
use crate::look::tree_leaf_model;
use crate::mesh::column;
use ::tree_mesh::{LeafForm, LeafLook, LeafMesh};
use std::sync::Arc;
use tree_model::silhouette::LeafOutline;

/// A drawn leaf in its own plane: base at the origin, tip at (0, 1), in triangles. Multiplied by the leaf's length it is in
/// metres.
pub struct tree_leaf_outline(LeafOutline);

impl Handle for tree_leaf_outline {
    const NAME: &'static str = "tree_leaf_outline";
}

impl tree_leaf_outline {
    pub(crate) fn new(leaf: LeafOutline) -> Self {
        Self(leaf)
    }

    pub(crate) fn rust(&self) -> &LeafOutline {
        &self.0
    }
}

/// Makes a leaf of an outline that is attached at `base` and points to `tip`, two floats each. Its border is thinned to at most
/// 64 corners. Free the leaf with `tree_leaf_outline_free`. `TREE_ERROR_INVALID` where both are the same point.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_outline_of(
    outline: *const tree_outline,
    base: *const f32,
    tip: *const f32,
    leaf: *mut *mut tree_leaf_outline,
) -> tree_status {
    call(|| {
        let place = unsafe { out(leaf, "leaf") }?;
        let outline = unsafe { get(outline, "outline") }?.rust();
        let ends = unsafe { (spot(base, "base")?, spot(tip, "tip")?) };
        place.put(tree_leaf_outline::new(LeafOutline::of(outline, ends.0, ends.1)?));
        Ok(())
    })
}

/// As `tree_leaf_outline_of`, with base and tip as `tree_leaf_outline_ends` finds them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_outline_guess(
    outline: *const tree_outline,
    leaf: *mut *mut tree_leaf_outline,
) -> tree_status {
    call(|| {
        let place = unsafe { out(leaf, "leaf") }?;
        let outline = unsafe { get(outline, "outline") }?.rust();
        place.put(tree_leaf_outline::new(LeafOutline::guess(outline)?));
        Ok(())
    })
}

/// Where a drawn leaf is attached and what it points to, as it looks: `base` gets the end of its stalk where it has one,
/// else the lowest point near the middle of an upright leaf and the left end of a lying one; `tip` the point farthest from
/// there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_outline_ends(
    outline: *const tree_outline,
    base: *mut [f32; 2],
    tip: *mut [f32; 2],
) -> tree_status {
    call(|| {
        let outline = unsafe { get(outline, "outline") }?.rust();
        let from = LeafOutline::base_of(outline);
        unsafe { out_value(base, from.to_array(), "base") }?;
        unsafe { out_value(tip, LeafOutline::tip_of(outline, from).to_array(), "tip") }
    })
}

/// A view of a drawn leaf, in lengths of the leaf.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_leaf_outline_columns {
    /// `sizeof(tree_leaf_outline_columns)`.
    pub struct_size: usize,
    /// Number of corners, at most 64.
    pub n_points: usize,
    /// Number of indices, three for each triangle.
    pub n_indices: usize,
    /// Two floats for each corner: the border, against the clock.
    pub points: *const f32,
    /// Three for each triangle, against the clock: its corners.
    pub indices: *const u32,
    /// Lowest coordinates.
    pub low: [f32; 2],
    /// Highest coordinates.
    pub high: [f32; 2],
    /// Area for a leaf of length 1.
    pub area: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_leaf_outline_columns {
    const NAME: &'static str = "tree_leaf_outline_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_points: 0,
            n_indices: 0,
            points: std::ptr::null(),
            indices: std::ptr::null(),
            low: [0.0; 2],
            high: [0.0; 2],
            area: 0.0,
            reserved: 0,
        }
    }
}

/// Views a drawn leaf. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_outline_view(
    leaf: *const tree_leaf_outline,
    columns: *mut tree_leaf_outline_columns,
) -> tree_status {
    call(|| {
        let leaf = unsafe { get(leaf, "leaf") }?.rust();
        let (low, high) = leaf.bounds();
        let found = tree_leaf_outline_columns {
            n_points: leaf.points.len(),
            n_indices: 3 * leaf.triangles.len(),
            points: column(&leaf.points).cast(),
            indices: column(&leaf.triangles).cast(),
            low: low.to_array(),
            high: high.to_array(),
            area: leaf.area(),
            ..tree_leaf_outline_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// The flat mesh of a drawn leaf; its picture, if it gets one, spans the leaf's bounds. Free the model with
/// `tree_leaf_model_free`. `tree_leaf_model_view` views it as `mesh` of a `tree_leaf_look` takes it: with the form
/// `TREE_LEAF_MESH` that goes into `tree_look_new` or `tree_look_with_leaf`, and all leaves of the kind are as drawn.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_outline_model(
    leaf: *const tree_leaf_outline,
    model: *mut *mut tree_leaf_model,
) -> tree_status {
    call(|| {
        let place = unsafe { out(model, "model") }?;
        let leaf = unsafe { get(leaf, "leaf") }?.rust();
        let mesh = LeafMesh::flat(&leaf.points, &leaf.triangles);
        let look = LeafLook { form: LeafForm::Mesh(Arc::new(mesh)), ..LeafLook::default() };
        place.put(tree_leaf_model::new(look.model()?));
        Ok(())
    })
}

/// Frees a drawn leaf.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_leaf_outline_free(leaf: *mut tree_leaf_outline) -> tree_status {
    call(|| unsafe { free(leaf, "leaf") })
}
