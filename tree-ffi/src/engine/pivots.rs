//! The textures of Pivot Painter 2.

use super::packed::tree_packed;
use crate::border::{
    Failure, Result, TREE_ERROR_INVALID, TREE_ERROR_PARAMETER, Versioned, call, get, tree_status,
    write,
};
use crate::mesh::column;
use ::tree_mesh::pack::pivot_painter::{Element, Textures};

/// Element of a branch that has none.
pub const TREE_NO_ELEMENT: u32 = 0xFFFF_FFFF;

pub(super) struct Pivots {
    pub(super) textures: Textures,
    halves: Vec<[u16; 4]>,
    element_of: Vec<u32>,
}

impl Pivots {
    pub(super) fn new(textures: Textures, n_branches: usize) -> Self {
        let element = |branch| textures.element_of(branch as u32).unwrap_or(TREE_NO_ELEMENT);
        let element_of = (0..n_branches).map(element).collect();
        Self { halves: textures.position_and_index_half(), element_of, textures }
    }
}

/// The textures of `TREE_LAYOUT_PIVOT_PAINTER`, the same for all surfaces of a mesh. Elements lie in rows
/// from the top left, as their branches do in the table; the trunk is its own parent.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_pivots {
    /// `sizeof(tree_pivots)`.
    pub struct_size: usize,
    /// Width in texels, a power of two.
    pub width: u32,
    /// Height in texels, a power of two.
    pub height: u32,
    /// Four floats for each texel, row by row from the top: the pivot in centimetres, in Unreal's axes,
    /// and the parent's number as a float whose half has the bits number + 1024.
    pub position_and_index: *const f32,
    /// The same as halves; the parents' numbers are exact in them too.
    pub position_and_index_half: *const u16,
    /// Four bytes for each texel: (axis + 1) / 2, and extent / 2048 cm.
    pub axis_and_extent: *const u8,
    /// One for each branch of the mesh: its element, or that of the branch it became part of.
    pub element_of: *const u32,
    /// Number of branches.
    pub n_branches: usize,
    /// Texels in use.
    pub n_elements: usize,
    /// Branches that became part of the one that carries them, since they lie too deep.
    pub n_merged: usize,
    /// Levels of the mesh.
    pub levels: u32,
    /// Levels that are left, at most 4: as many as Epic's material functions follow.
    pub kept_levels: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_pivots {
    const NAME: &'static str = "tree_pivots";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            width: 0,
            height: 0,
            position_and_index: std::ptr::null(),
            position_and_index_half: std::ptr::null(),
            axis_and_extent: std::ptr::null(),
            element_of: std::ptr::null(),
            n_branches: 0,
            n_elements: 0,
            n_merged: 0,
            levels: 0,
            kept_levels: 0,
        }
    }
}

fn pivots(packed: &tree_packed) -> Result<&Pivots> {
    packed.pivots.as_ref().ok_or_else(|| {
        let text = "packed has no pivot textures: TREE_LAYOUT_PIVOT_PAINTER has them";
        Failure::new(TREE_ERROR_INVALID, text)
    })
}

/// Views the textures of a surface packed with `TREE_LAYOUT_PIVOT_PAINTER`. Set `pivots->struct_size`
/// first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_packed_pivots(
    packed: *const tree_packed,
    pivots: *mut tree_pivots,
) -> tree_status {
    call(|| {
        let held = self::pivots(unsafe { get(packed, "packed") }?)?;
        let (textures, report) = (&held.textures, held.textures.report);
        let found = tree_pivots {
            width: textures.width,
            height: textures.height,
            position_and_index: column(&textures.position_and_index).cast(),
            position_and_index_half: column(&held.halves).cast(),
            axis_and_extent: column(&textures.axis_and_extent).cast(),
            element_of: column(&held.element_of),
            n_branches: held.element_of.len(),
            n_elements: report.elements,
            n_merged: report.merged,
            levels: report.levels,
            kept_levels: report.kept_levels,
            ..tree_pivots::default_value()
        };
        unsafe { write(pivots, "pivots", &found) }
    })
}

/// A texel of the pivot textures, read back as the shader does, in our axes.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_pivot_element {
    /// `sizeof(tree_pivot_element)`.
    pub struct_size: usize,
    /// The element that carries it; itself for the trunk.
    pub parent: u32,
    /// Pivot in metres.
    pub pivot: [f32; 3],
    /// Axis, a unit vector.
    pub axis: [f32; 3],
    /// Length in metres, 0.08 to 20.48.
    pub extent: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_pivot_element {
    const NAME: &'static str = "tree_pivot_element";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            parent: TREE_NO_ELEMENT,
            pivot: [0.0; 3],
            axis: [0.0; 3],
            extent: 0.0,
        }
    }
}

impl tree_pivot_element {
    fn of(element: &Element) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            parent: element.parent,
            pivot: element.pivot.to_array(),
            axis: element.axis.to_array(),
            extent: element.extent,
        }
    }
}

/// Reads an element back, 0 to `n_elements - 1`, to check a shader against. Set `element->struct_size`
/// first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_packed_pivot_element(
    packed: *const tree_packed,
    number: u32,
    element: *mut tree_pivot_element,
) -> tree_status {
    call(|| {
        let textures = &pivots(unsafe { get(packed, "packed") }?)?.textures;
        let n = textures.report.elements;
        let inside = textures.element(number).filter(|_| (number as usize) < n);
        let Some(found) = inside else {
            let text = format!("number is {number}, there are {n} elements");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        };
        unsafe { write(element, "element", &tree_pivot_element::of(&found)) }
    })
}
