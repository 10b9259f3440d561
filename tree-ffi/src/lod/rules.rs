//! Rules of the literature, for comparing with.

use crate::border::{call, out_value, tree_status};
use tree_lod::quality::{contrast, cook_lambda, cook_scale, drop_and_resize, size_lambda};

/// Scale after Cook et al. (2007): `1 / lambda`, a factor on area, so that the summed area stays. `lambda` is a
/// share of geometry, more than 0; of 0 and less the scale is that of the smallest number.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_cook_scale(lambda: f32, scale: *mut f32) -> tree_status {
    call(|| unsafe { out_value(scale, cook_scale(lambda), "scale") })
}

/// Share of geometry after Cook et al. (2007), `(1 - d)^2`, for a distance `d`, which is brought into 0 to 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_cook_lambda(d: f32, lambda: *mut f32) -> tree_status {
    call(|| unsafe { out_value(lambda, cook_lambda(d), "lambda") })
}

/// Share of geometry by size on the screen (Cook et al. 2007; Neubert 2012, 6.3.2): 1 where the bounding box is
/// `full` pixels large or more, a half at `h * full`, and so on. `pixels` is its size now, 0 to 1e9; `full` 0.001 to
/// 1e9, `h` 0.001 to 0.999: `TREE_ERROR_PARAMETER` outside.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_size_lambda(
    pixels: f32,
    full: f32,
    h: f32,
    lambda: *mut f32,
) -> tree_status {
    call(|| {
        let found = size_lambda(pixels, full, h)?;
        unsafe { out_value(lambda, found, "lambda") }
    })
}

/// Factor on *length* of `k` elements left of `n` (Deussen and Lintermann 2004; Neubert 2012, eq. 6.4 with the sign
/// set right): `w * sqrt(n / k) + (1 - w)`, `w` from 0 (nothing grows) to 1 (area is kept). `TREE_ERROR_PARAMETER`
/// for another `w`, or a `k` outside 1 to `n`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_drop_and_resize(
    n: u32,
    k: u32,
    w: f32,
    growth: *mut f32,
) -> tree_status {
    call(|| {
        let found = drop_and_resize(n, k, w)?;
        unsafe { out_value(growth, found, "growth") }
    })
}

/// Factor on the contrast of colours that keeps its variance in the picture (Cook et al. 2007) when a share of
/// `lambda` of the elements is drawn, each `scale` times as large in area: `1 / (scale * sqrt(lambda))`, at most 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_contrast(
    lambda: f32,
    scale: f32,
    contrast: *mut f32,
) -> tree_status {
    call(|| unsafe { out_value(contrast, self::contrast(lambda, scale), "contrast") })
}
