//! Evenly over the ground, by the golden section.
//!
//! Neubert 2012, §6.3.2, says of "drop and resize" only that elements are dropped "according to
//! positions on a horizontal plane that follows the golden section rule". What this can be good for is
//! that what is left stays evenly spread, so that is how we read it:
//!
//! 1. Elements are put along a Hilbert curve through their places on the ground (x and z): near along
//!    the curve is near on the ground.
//! 2. The k-th element drawn stands where k · 0.618… falls, whole parts dropped, on a curve of length 1.
//!    These places divide the curve in pieces of at most three lengths after every step (the three-gap
//!    theorem), so every beginning of the order is spread about as evenly as can be.
//!
//! To give every element one turn, the n places are ranked, and the k-th turn goes to the element of
//! that rank along the curve. Places are whole numbers of 64 bits: exact, and all different.

use crate::Elements;
use crate::error::{LodError, Result, check_range};
use rayon::prelude::*;
use tree_core::Aabb;

/// 2⁶⁴ times the golden section, 0.618…, as an odd number.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
/// The curve has 2¹⁶ steps along each side.
const LEVELS: u32 = 16;
/// Largest coordinate in metres that leaves differences finite.
const FAR: f64 = 1e9;

/// An order of which every beginning is evenly spread over the ground. No randomness.
///
/// # Errors
/// [`LodError::Foliage`] when there are no elements; [`LodError::Parameter`] when a centre is not within
/// ±10⁹ m.
///
/// # Complexity
/// O(n log n).
pub fn golden(elements: &Elements) -> Result<Vec<u32>> {
    if elements.is_empty() {
        return Err(LodError::Foliage("there are no elements"));
    }
    for x in elements.centers.iter().flat_map(|p| p.to_array()) {
        check_range("elements.centers", x.into(), -FAR, FAR)?;
    }
    let bounds = Aabb::of_points(&elements.centers);
    let size = bounds.size().x.max(bounds.size().z);
    let steps = (1_u32 << LEVELS) as f32;
    let scale = if size > 0.0 { steps / size } else { 0.0 };
    let step = |x: f32| ((scale * x) as u32).min((1 << LEVELS) - 1);
    let mut curve: Vec<(u32, u32)> = elements
        .centers
        .par_iter()
        .enumerate()
        .map(|(i, &center)| {
            let from = center - bounds.min;
            (hilbert(step(from.x), step(from.z)), i as u32)
        })
        .collect();
    curve.par_sort_unstable();
    let mut turns: Vec<(u64, u32)> =
        (0..elements.len() as u32).map(|k| (u64::from(k).wrapping_mul(GOLDEN), k)).collect();
    turns.par_sort_unstable();
    let mut order = vec![0; elements.len()];
    for (&(_, turn), &(_, element)) in turns.iter().zip(&curve) {
        order[turn as usize] = element;
    }
    Ok(order)
}

/// How far along Hilbert's curve a place lies: a turn or a flip for each quarter, from the largest down.
fn hilbert(mut x: u32, mut y: u32) -> u32 {
    let mut along = 0_u32;
    for level in (0..LEVELS).rev() {
        let (right, up) = (x >> level & 1, y >> level & 1);
        along = along << 2 | ((3 * right) ^ up);
        let mask = (1 << level) - 1;
        (x, y) = (x & mask, y & mask);
        if up == 0 {
            if right == 1 {
                (x, y) = (mask - x, mask - y);
            }
            std::mem::swap(&mut x, &mut y);
        }
    }
    along
}
