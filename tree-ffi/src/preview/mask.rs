//! Masks: how much of each pixel a mesh covers.

use super::tree_picture;
use crate::border::{Handle, Versioned, call, fill, free, get, out, tree_status, write};
use crate::mesh::column;
use tree_lod::preview::Mask;

/// How much of each pixel a mesh covers.
pub struct tree_mask(Mask);

impl Handle for tree_mask {
    const NAME: &'static str = "tree_mask";
}

impl tree_mask {
    pub(crate) fn new(mask: Mask) -> Self {
        Self(mask)
    }
}

/// A view of a mask.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_mask_columns {
    /// `sizeof(tree_mask_columns)`.
    pub struct_size: usize,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// One byte for each pixel, rows from top to bottom: 0 is empty, 255 is full.
    pub coverage: *const u8,
    /// Number of pixels: `width * height`.
    pub n_pixels: usize,
    /// Covered area in pixels.
    pub area: f64,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_mask_columns {
    const NAME: &'static str = "tree_mask_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            width: 0,
            height: 0,
            coverage: std::ptr::null(),
            n_pixels: 0,
            area: 0.0,
        }
    }
}

/// Views a mask. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mask_view(
    mask: *const tree_mask,
    columns: *mut tree_mask_columns,
) -> tree_status {
    call(|| {
        let mask = &unsafe { get(mask, "mask") }?.0;
        let found = tree_mask_columns {
            width: mask.width,
            height: mask.height,
            coverage: column(&mask.coverage),
            n_pixels: mask.coverage.len(),
            area: mask.area(),
            ..tree_mask_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// Writes a byte for each pixel, rows from top to bottom: 1 where at least half of the pixel is covered,
/// else 0. `capacity` must be `width * height` or more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mask_bits(
    mask: *const tree_mask,
    bits: *mut u8,
    capacity: usize,
) -> tree_status {
    call(|| {
        let mask = &unsafe { get(mask, "mask") }?.0;
        let found: Vec<u8> = mask.bits().map(u8::from).collect();
        unsafe { fill(bits, capacity, &found, "bits") }
    })
}

/// The mask in black on white. Free the picture with `tree_picture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mask_picture(
    mask: *const tree_mask,
    picture: *mut *mut tree_picture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(picture, "picture") }?;
        let mask = &unsafe { get(mask, "mask") }?.0;
        place.put(tree_picture::new(mask.to_picture()));
        Ok(())
    })
}

/// Frees a mask.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mask_free(mask: *mut tree_mask) -> tree_status {
    call(|| unsafe { free(mask, "mask") })
}
