//! Photographs.

use super::blamed;
use crate::border::{
    self, Failure, Handle, TREE_ERROR_FORMAT, TREE_ERROR_INVALID, call, free, get, out, out_value,
    slice, tree_status, write,
};
use crate::control::{limits, run, tree_control};
use crate::io::tree_bytes;
use crate::mesh::column;
use crate::preview::tree_pixels;
use std::ffi::c_char;
use tree_model::particle::Photo;
use tree_model::tree_core::{Control, Limits, Resource};

/// A photograph: RGBA, 8 bits, sRGB, straight alpha, rows from top to bottom.
pub struct tree_photo(Photo);

impl Handle for tree_photo {
    const NAME: &'static str = "tree_photo";
}

impl tree_photo {
    pub(crate) fn new(photo: Photo) -> Self {
        Self(photo)
    }

    pub(crate) fn rust(&self) -> &Photo {
        &self.0
    }
}

/// Makes a photograph of `4 * width * height` bytes of a program's own, which are copied: red, green, blue
/// and alpha for each pixel, rows from top to bottom. `control` may be NULL; only its limits matter. Free
/// the photograph with `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_from_pixels(
    width: u32,
    height: u32,
    pixels: *const u8,
    n_bytes: usize,
    control: *const tree_control,
    photo: *mut *mut tree_photo,
) -> tree_status {
    call(|| {
        let place = unsafe { out(photo, "photo") }?;
        let limits = unsafe { limits(control) }?;
        let limits = Limits { pixels: limits.pixels.saturating_mul(4), ..limits };
        let bytes = unsafe { slice(pixels, n_bytes, &limits, Resource::Pixels, "pixels") }?;
        let (pixels, rest) = bytes.as_chunks();
        if !rest.is_empty() {
            let text = format!("pixels has {n_bytes} bytes; each pixel takes four");
            return Err(Failure::new(TREE_ERROR_INVALID, text));
        }
        let made = Photo::new(width, height, pixels.to_vec());
        place.put(tree_photo(made.map_err(blamed(TREE_ERROR_INVALID))?));
        Ok(())
    })
}

/// Reads a PNG or JPEG file, recognised by its content. A photograph is turned upright as its camera noted.
/// `control` may be NULL; `input_bytes` and `pixels` of its limits are looked at before the picture is
/// decoded. Free the photograph with `tree_photo_free`. `TREE_ERROR_FORMAT` for what is no such picture.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_read(
    path: *const c_char,
    path_len: usize,
    control: *const tree_control,
    photo: *mut *mut tree_photo,
) -> tree_status {
    call(|| {
        let place = unsafe { out(photo, "photo") }?;
        let path = unsafe { border::path(path, path_len, "path") }?;
        let read = |control: &Control| {
            Photo::open(path, &control.limits).map_err(blamed(TREE_ERROR_FORMAT))
        };
        place.put(tree_photo(unsafe { run(control, read) }?));
        Ok(())
    })
}

/// As `tree_photo_read`, of a file held in memory: `len` bytes from `data` on, which are not kept.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_from_bytes(
    data: *const u8,
    len: usize,
    control: *const tree_control,
    photo: *mut *mut tree_photo,
) -> tree_status {
    call(|| {
        let place = unsafe { out(photo, "photo") }?;
        let limits = unsafe { limits(control) }?;
        let bytes = unsafe { slice(data, len, &limits, Resource::InputBytes, "data") }?;
        let decode = |control: &Control| {
            Photo::decode(bytes, &control.limits).map_err(blamed(TREE_ERROR_FORMAT))
        };
        place.put(tree_photo(unsafe { run(control, decode) }?));
        Ok(())
    })
}

/// Views a photograph's pixels, and says how large it is. Set `pixels->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_view(
    photo: *const tree_photo,
    pixels: *mut tree_pixels,
) -> tree_status {
    call(|| {
        let photo = unsafe { get(photo, "photo") }?.rust();
        let bytes = photo.pixels().as_flattened();
        let found = tree_pixels {
            width: photo.width(),
            height: photo.height(),
            pixels: column(bytes),
            n_bytes: bytes.len(),
            ..border::Versioned::default_value()
        };
        unsafe { write(pixels, "pixels", &found) }
    })
}

/// Whether any pixel is not fully opaque: 1 or 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_has_alpha(
    photo: *const tree_photo,
    is_translucent: *mut u32,
) -> tree_status {
    call(|| {
        let found = unsafe { get(photo, "photo") }?.rust().has_alpha();
        unsafe { out_value(is_translucent, found.into(), "is_translucent") }
    })
}

/// A photograph with left and right exchanged. Free it with `tree_photo_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_mirrored(
    photo: *const tree_photo,
    mirrored: *mut *mut tree_photo,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mirrored, "mirrored") }?;
        place.put(tree_photo(unsafe { get(photo, "photo") }?.rust().mirrored()));
        Ok(())
    })
}

/// A photograph as a PNG file in memory, with alpha. Free it with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_to_png(
    photo: *const tree_photo,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        place.put(tree_bytes::new(unsafe { get(photo, "photo") }?.rust().to_png()?));
        Ok(())
    })
}

/// Writes a photograph to a PNG file, with alpha, whole or not at all. The path, in UTF-8, has `path_len`
/// bytes, or ends with a NUL and `path_len` is `TREE_NUL_TERMINATED`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_write_png(
    photo: *const tree_photo,
    path: *const c_char,
    path_len: usize,
) -> tree_status {
    call(|| {
        let photo = unsafe { get(photo, "photo") }?.rust();
        Ok(photo.save_png(unsafe { border::path(path, path_len, "path") }?)?)
    })
}

/// Frees a photograph. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_photo_free(photo: *mut tree_photo) -> tree_status {
    call(|| unsafe { free(photo, "photo") })
}
