//! Mattes: how much of each pixel a tree covers.

use super::camera::tree_particle_camera;
use super::picture::tree_photo;
use super::{blamed, fill_some};
use crate::border::{
    self, Handle, TREE_ERROR_INVALID, Versioned, call, foresee, free, get, get_opt, out, out_opt,
    slice, tree_status, vec2s, write,
};
use crate::control::{limits, tree_control};
use crate::io::tree_bytes;
use crate::mesh::column;
use std::ffi::c_char;
use tree_model::particle::{Matte, View, matting};
use tree_model::tree_core::Resource;

/// How much of each pixel of a photograph the tree covers, 0 (nothing) to 1 (all).
pub struct tree_matte(Matte);

impl Handle for tree_matte {
    const NAME: &'static str = "tree_matte";
}

impl tree_matte {
    pub(crate) fn new(matte: Matte) -> Self {
        Self(matte)
    }

    pub(crate) fn rust(&self) -> &Matte {
        &self.0
    }
}

/// A view of a matte. Pixel 0 is at the top left; its area runs from (0, 0) to (1, 1), so its centre is
/// (0.5, 0.5), as everywhere where pixels are counted with fractions.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_matte_columns {
    /// `sizeof(tree_matte_columns)`.
    pub struct_size: usize,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// One float for each pixel, rows from top to bottom: 0 is empty, 1 is full.
    pub alpha: *const f32,
    /// Number of pixels: `width * height`.
    pub n_pixels: usize,
    /// Covered area in pixels.
    pub area: f64,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_matte_columns {
    const NAME: &'static str = "tree_matte_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            width: 0,
            height: 0,
            alpha: std::ptr::null(),
            n_pixels: 0,
            area: 0.0,
        }
    }
}

/// Makes a matte of `width * height` floats, which are copied, rows from top to bottom; clamped to 0 to 1,
/// not NaN. `control` may be NULL; only its limits matter. Free the matte with `tree_matte_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_from_alpha(
    width: u32,
    height: u32,
    alpha: *const f32,
    n_pixels: usize,
    control: *const tree_control,
    matte: *mut *mut tree_matte,
) -> tree_status {
    call(|| {
        let place = unsafe { out(matte, "matte") }?;
        let limits = unsafe { limits(control) }?;
        let alpha = unsafe { slice(alpha, n_pixels, &limits, Resource::Pixels, "alpha") }?;
        let made = Matte::new(width, height, alpha.to_vec());
        place.put(tree_matte(made.map_err(blamed(TREE_ERROR_INVALID))?));
        Ok(())
    })
}

/// The alpha of a photograph as a matte. Free it with `tree_matte_free`. `TREE_ERROR_NO_RESULT` where all
/// pixels are opaque or all transparent.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_of_photo(
    photo: *const tree_photo,
    matte: *mut *mut tree_matte,
) -> tree_status {
    call(|| {
        let place = unsafe { out(matte, "matte") }?;
        place.put(tree_matte(matting::alpha_of(unsafe { get(photo, "photo") }?.rust())?));
        Ok(())
    })
}

/// Views a matte. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_view(
    matte: *const tree_matte,
    columns: *mut tree_matte_columns,
) -> tree_status {
    call(|| {
        let matte = unsafe { get(matte, "matte") }?.rust();
        let found = tree_matte_columns {
            width: matte.width(),
            height: matte.height(),
            alpha: column(matte.alpha()),
            n_pixels: matte.alpha().len(),
            area: matte.area(),
            ..tree_matte_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// Writes the values at `n_spots` points of a matte, two floats each in pixels from the top left, between
/// pixel centres by bilinear interpolation; 0 outside. `capacity` must be `n_spots` or more. `control` may
/// be NULL; `nodes` of its limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_sample(
    matte: *const tree_matte,
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    values: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let matte = unsafe { get(matte, "matte") }?.rust();
        let limits = unsafe { limits(control) }?;
        let spots = unsafe { vec2s(spots, n_spots, &limits, Resource::Nodes, "spots") }?;
        let found: Vec<f32> = spots.iter().map(|&spot| matte.sample(spot)).collect();
        unsafe { fill_some(values, capacity, &found, "values") }
    })
}

/// A matte with left and right exchanged. Free it with `tree_matte_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_mirrored(
    matte: *const tree_matte,
    mirrored: *mut *mut tree_matte,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mirrored, "mirrored") }?;
        place.put(tree_matte(unsafe { get(matte, "matte") }?.rust().mirrored()));
        Ok(())
    })
}

/// A view mirrored and a quarter turn round: what a tree may look like from its side, where there is one
/// photograph only. `photo` may be NULL, and `turned_photo` too, which gets NULL without a photograph. Set
/// `turned_camera->struct_size` first. Free what comes out with `tree_photo_free` and `tree_matte_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_turned(
    matte: *const tree_matte,
    photo: *const tree_photo,
    camera: *const tree_particle_camera,
    turned_camera: *mut tree_particle_camera,
    turned_photo: *mut *mut tree_photo,
    turned: *mut *mut tree_matte,
) -> tree_status {
    call(|| {
        let (turned_photo, place) =
            unsafe { (out_opt(turned_photo, "turned_photo"), out(turned, "turned")) };
        let (turned_photo, place) = (turned_photo?, place?);
        unsafe { foresee(turned_camera, "turned_camera") }?;
        let matte = unsafe { get(matte, "matte") }?.rust().clone();
        let photo = unsafe { get_opt(photo, "photo") }?.map(|photo| photo.rust().clone());
        let camera = unsafe { tree_particle_camera::get(camera) }?;
        let made = View { matte, photo, camera }.turned();
        unsafe { write(turned_camera, "turned_camera", &tree_particle_camera::of(&made.camera)) }?;
        if let (Some(place), Some(photo)) = (turned_photo, made.photo) {
            place.put(tree_photo::new(photo));
        }
        place.put(tree_matte(made.matte));
        Ok(())
    })
}

/// A matte as a PNG file in memory: grey, black for 0 and white for 1. Free it with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_to_png(
    matte: *const tree_matte,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        place.put(tree_bytes::new(unsafe { get(matte, "matte") }?.rust().to_png()?));
        Ok(())
    })
}

/// Writes a matte to a PNG file, as `tree_matte_to_png`, whole or not at all. The path, in UTF-8, has
/// `path_len` bytes, or ends with a NUL and `path_len` is `TREE_NUL_TERMINATED`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_write_png(
    matte: *const tree_matte,
    path: *const c_char,
    path_len: usize,
) -> tree_status {
    call(|| {
        let matte = unsafe { get(matte, "matte") }?.rust();
        Ok(matte.save_png(unsafe { border::path(path, path_len, "path") }?)?)
    })
}

/// Frees a matte. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_free(matte: *mut tree_matte) -> tree_status {
    call(|| unsafe { free(matte, "matte") })
}
