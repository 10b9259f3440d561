//! How much each plane of a box faces the viewer, and which one a pixel draws.

use crate::border::{Failure, TREE_ERROR_PARAMETER, call, floats, out_value, tree_status};
use tree_lod::impostor::cards::{PLANES, interval, noise, weights};

/// Planes of a box.
pub const TREE_CARD_PLANES: u32 = 6;

/// The weights of the six planes of a box: `half` is three floats, half its sides, `direction` three floats, to the viewer
/// along the box's own axes (turned by the inverse of its `turn`), of any length. They sum to 1 and change
/// continuously; a plane seen edge-on has none. `TREE_ERROR_INVALID` for a direction that is zero or not finite, or half
/// sides that are not all above 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_weights(
    half: *const f32,
    direction: *const f32,
    weights: *mut [f32; 6],
) -> tree_status {
    call(|| {
        let half: [f32; 3] = unsafe { floats(half, "half") }?;
        let direction: [f32; 3] = unsafe { floats(direction, "direction") }?;
        let found = self::weights(half.into(), direction.into())?;
        unsafe { out_value(weights, found, "weights") }
    })
}

/// The part of 0 to 1 that belongs to a plane, 0 to 5, given the six `weights`: as long as its weight, after those of the
/// planes before it. A pixel draws the plane in whose interval its `tree_card_noise` lies.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_interval(
    weights: *const f32,
    plane: u32,
    interval: *mut [f32; 2],
) -> tree_status {
    call(|| {
        let weights = unsafe { floats(weights, "weights") }?;
        if plane as usize >= PLANES {
            let text = format!("plane is {plane}, it should be 0 to {}", PLANES - 1);
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let found = self::interval(&weights, plane as usize);
        unsafe { out_value(interval, found, "interval") }
    })
}

/// A pattern over pixels, 0 to 1, nearly even in each neighbourhood of 3 by 3: `pixel` is two floats, its middle as a
/// shader is told it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_card_noise(pixel: *const f32, share: *mut f32) -> tree_status {
    call(|| {
        let pixel: [f32; 2] = unsafe { floats(pixel, "pixel") }?;
        unsafe { out_value(share, noise(pixel.into()), "share") }
    })
}
