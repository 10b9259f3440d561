//! Masks of one bit per pixel.

use super::score::tree_score;
use super::take::fill_some;
use crate::border::{
    Failure, Handle, TREE_ERROR_PARAMETER, Versioned, call, free, get, out, out_value, tree_status,
    write,
};
use crate::control::{run, tree_control};
use crate::mesh::tree_mesh;
use crate::preview::tree_view;
use tree_lod::cover::{Bits, mask};

/// Which pixels a mesh covers: one bit for each. A bit is set where a triangle covers the middle of the pixel
/// and the texture's alpha there is drawn. (`tree_mask` tells how much of each pixel is covered; this one is
/// for comparing, and fast.)
pub struct tree_bits(Bits);

impl Handle for tree_bits {
    const NAME: &'static str = "tree_bits";
}

/// Size of a mask of bits.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_bits_size {
    /// `sizeof(tree_bits_size)`.
    pub struct_size: usize,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Words of all rows: what `tree_bits_words` writes.
    pub n_words: usize,
    /// Pixels of all rows: what `tree_bits_bytes` writes.
    pub n_pixels: usize,
    /// Number of set bits.
    pub count: u64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_bits_size {
    const NAME: &'static str = "tree_bits_size";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            width: 0,
            height: 0,
            n_words: 0,
            n_pixels: 0,
            count: 0,
        }
    }
}

/// The pixels that a mesh covers. Of `view`, which may be NULL for the default, camera and width count; it must
/// be as high as it is wide, 8 to 4096 pixels. `control` may be NULL. Free the mask with `tree_bits_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bits_of_mesh(
    mesh: *const tree_mesh,
    view: *const tree_view,
    control: *const tree_control,
    bits: *mut *mut tree_bits,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bits, "bits") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let view = unsafe { tree_view::read(view) }?;
        if view.width != view.height {
            let text = format!(
                "view.height is {}, but must be as view.width, {}",
                view.height, view.width
            );
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        view.camera.validate()?;
        let body = |control: &_| Ok(mask(mesh, &view.camera, view.width, control)?);
        place.put(tree_bits(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Tells how large a mask is, and how many of its bits are set. Set `found->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bits_measure(
    bits: *const tree_bits,
    found: *mut tree_bits_size,
) -> tree_status {
    call(|| {
        let bits = &unsafe { get(bits, "bits") }?.0;
        let value = tree_bits_size {
            width: bits.width(),
            height: bits.height(),
            n_words: bits.rows().map(<[u64]>::len).sum(),
            n_pixels: bits.width() as usize * bits.height() as usize,
            count: bits.count(),
            ..tree_bits_size::default_value()
        };
        unsafe { write(found, "found", &value) }
    })
}

/// Writes the words of all rows, from top to bottom, each begun in a word of its own: the pixel at x is bit
/// `x % 64` of word `x / 64` of its row. `capacity` is at least `n_words` of `tree_bits_measure`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bits_words(
    bits: *const tree_bits,
    words: *mut u64,
    capacity: usize,
) -> tree_status {
    call(|| {
        let bits = &unsafe { get(bits, "bits") }?.0;
        let found: Vec<u64> = bits.rows().flatten().copied().collect();
        unsafe { fill_some(words, capacity, &found, "words") }
    })
}

/// Writes a byte for each pixel, rows from top to bottom, 255 where it is set. `capacity` is at least
/// `n_pixels` of `tree_bits_measure`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bits_bytes(
    bits: *const tree_bits,
    bytes: *mut u8,
    capacity: usize,
) -> tree_status {
    call(|| {
        let bits = &unsafe { get(bits, "bits") }?.0;
        unsafe { fill_some(bytes, capacity, &bits.to_bytes(), "bytes") }
    })
}

/// Counts the pixels of `bits`, of a simplified model, against those of the `full` one. Masks of different sizes
/// are compared where they overlap from the top left, by whole words.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bits_score(
    bits: *const tree_bits,
    full: *const tree_bits,
    score: *mut tree_score,
) -> tree_status {
    call(|| {
        let bits = &unsafe { get(bits, "bits") }?.0;
        let full = &unsafe { get(full, "full") }?.0;
        unsafe { out_value(score, tree_score::of(&bits.score(full)), "score") }
    })
}

/// Frees a mask.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bits_free(bits: *mut tree_bits) -> tree_status {
    call(|| unsafe { free(bits, "bits") })
}
