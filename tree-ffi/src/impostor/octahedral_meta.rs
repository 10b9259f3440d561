//! Numbers that go with the two pictures of an octahedral impostor.

use crate::border::{Versioned, call, out_value, read, tree_status};
use tree_lod::impostor::octahedral::OctahedralMeta;

/// Numbers that go with the two pictures of an octahedral impostor: what a shader needs to know. Set `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_octahedral_meta {
    /// `sizeof(tree_octahedral_meta)`.
    pub struct_size: usize,
    /// Views along each side of the square of directions, 2 to 64.
    pub grid: u32,
    /// Whether only the upper hemisphere is there.
    pub hemi: u32,
    /// Side of the picture of colours in texels.
    pub side: u32,
    /// Side of a view in texels of the picture of colours, gutter included. View (column, row) begins at
    /// (column, row) * tile.
    pub tile: u32,
    /// Side of the picture of normals and depths: `side`, or half of it.
    pub detail_side: u32,
    /// Middle of the tree in metres.
    pub center: [f32; 3],
    /// Radius of the ball around it in metres. Depths go from minus this to it, towards the viewer.
    pub radius: f32,
    /// Radius in metres of the upright cylinder around it, and a gutter more.
    pub wide: f32,
    /// Half the height in metres of that cylinder, and a gutter more.
    pub high: f32,
    /// Metres of a texel: the largest of any view. It follows from the others, and is not read.
    pub texel: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_octahedral_meta {
    const NAME: &'static str = "tree_octahedral_meta";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            grid: 0,
            hemi: 0,
            side: 0,
            tile: 0,
            detail_side: 0,
            center: [0.0; 3],
            radius: 0.0,
            wide: 0.0,
            high: 0.0,
            texel: 0.0,
        }
    }
}

impl tree_octahedral_meta {
    pub(super) fn of(meta: &OctahedralMeta) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            grid: meta.grid,
            hemi: meta.hemi.into(),
            side: meta.side,
            tile: meta.tile,
            detail_side: meta.detail_side,
            center: meta.center.to_array(),
            radius: meta.radius,
            wide: meta.wide,
            high: meta.high,
            texel: meta.texel(),
        }
    }

    pub(super) fn rust(&self) -> OctahedralMeta {
        OctahedralMeta {
            grid: self.grid,
            hemi: self.hemi != 0,
            side: self.side,
            tile: self.tile,
            detail_side: self.detail_side,
            center: self.center.into(),
            radius: self.radius,
            wide: self.wide,
            high: self.high,
        }
    }
}

/// Checks that the numbers fit each other: `TREE_ERROR_PARAMETER` names the first that is out of range,
/// `TREE_ERROR_INVALID` says what is wrong with `detail_side`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_meta_check(
    meta: *const tree_octahedral_meta,
) -> tree_status {
    call(|| Ok(unsafe { read(meta, "meta") }?.rust().validate()?))
}

/// Half width and half height in metres of a view whose direction to the viewer, of unit length, has this `y`, and half
/// the depth of the tree in it: what the cylinder around it fills.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_octahedral_meta_extent(
    meta: *const tree_octahedral_meta,
    y: f32,
    half: *mut [f32; 2],
    reach: *mut f32,
) -> tree_status {
    call(|| {
        let meta = unsafe { read(meta, "meta") }?.rust();
        meta.validate()?;
        unsafe { out_value(half, meta.half(y).to_array(), "half") }?;
        unsafe { out_value(reach, meta.depth(y), "reach") }
    })
}
