//! Pictures.

use crate::border::{self, Handle, Versioned, call, free, get, out, slice, tree_status, write};
use crate::control::{limits, tree_control};
use crate::io::tree_bytes;
use crate::mesh::column;
use std::ffi::c_char;
use tree_lod::preview::Picture;
use tree_model::tree_core::{Limits, Resource};

/// A picture: RGBA, 8 bits, sRGB, straight alpha, rows from top to bottom.
pub struct tree_picture(Picture);

impl Handle for tree_picture {
    const NAME: &'static str = "tree_picture";
}

impl tree_picture {
    pub(crate) fn new(picture: Picture) -> Self {
        Self(picture)
    }

    pub(crate) fn rust(&self) -> &Picture {
        &self.0
    }
}

/// A view of a picture's pixels.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_pixels {
    /// `sizeof(tree_pixels)`.
    pub struct_size: usize,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Four bytes for each pixel (red, green, blue, alpha), rows from top to bottom.
    pub pixels: *const u8,
    /// Number of bytes: `4 * width * height`.
    pub n_bytes: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_pixels {
    const NAME: &'static str = "tree_pixels";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            width: 0,
            height: 0,
            pixels: std::ptr::null(),
            n_bytes: 0,
        }
    }
}

impl tree_pixels {
    pub(crate) fn of(picture: &Picture) -> Self {
        Self {
            width: picture.width,
            height: picture.height,
            pixels: column(&picture.pixels),
            n_bytes: picture.pixels.len(),
            ..Self::default_value()
        }
    }
}

/// Makes a picture of `4 * width * height` bytes of a program's own, which are copied. `control` may be
/// NULL; only its limits matter. Free the picture with `tree_picture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_picture_from_pixels(
    width: u32,
    height: u32,
    pixels: *const u8,
    n_bytes: usize,
    control: *const tree_control,
    picture: *mut *mut tree_picture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(picture, "picture") }?;
        let limits = unsafe { limits(control) }?;
        let limits = Limits { pixels: limits.pixels.saturating_mul(4), ..limits };
        let pixels = unsafe { slice(pixels, n_bytes, &limits, Resource::Pixels, "pixels") }?;
        let picture = Picture { width, height, pixels: pixels.to_vec() };
        picture.check()?;
        place.put(tree_picture(picture));
        Ok(())
    })
}

/// Views a picture's pixels. Set `pixels->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_picture_view(
    picture: *const tree_picture,
    pixels: *mut tree_pixels,
) -> tree_status {
    call(|| {
        let picture = &unsafe { get(picture, "picture") }?.0;
        unsafe { write(pixels, "pixels", &tree_pixels::of(picture)) }
    })
}

/// Writes a picture to a PNG file, whole or not at all. The path, in UTF-8, has `path_len` bytes, or ends
/// with a NUL and `path_len` is `TREE_NUL_TERMINATED`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_picture_write_png(
    picture: *const tree_picture,
    path: *const c_char,
    path_len: usize,
) -> tree_status {
    call(|| {
        let picture = &unsafe { get(picture, "picture") }?.0;
        Ok(picture.save_png(unsafe { border::path(path, path_len, "path") }?)?)
    })
}

/// A picture as a PNG file in memory. Free it with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_picture_to_png(
    picture: *const tree_picture,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let picture = &unsafe { get(picture, "picture") }?.0;
        place.put(tree_bytes::new(picture.to_png()?));
        Ok(())
    })
}

/// Frees a picture.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_picture_free(picture: *mut tree_picture) -> tree_status {
    call(|| unsafe { free(picture, "picture") })
}
