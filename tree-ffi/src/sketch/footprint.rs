//! Footprints: how far a crown reaches in every direction.

use super::{fill_some, spots};
use crate::border::{
    Failure, Result, TREE_ERROR_NO_RESULT, call, fill, out_value, slice, tree_status,
};
use crate::control::{run, tree_control};
use tree_model::sketch::{DIRECTIONS, Footprint, convex_hull};
use tree_model::tree_core::{Limits, Resource};

/// Number of distances in a footprint. Direction 0 is +x, then they turn against the clock where y goes up.
pub const TREE_FOOTPRINT_DIRECTIONS: usize = 64;
const _: () = assert!(TREE_FOOTPRINT_DIRECTIONS == DIRECTIONS);

/// The footprint of `n_spots` points, two floats each: the distances from the centre of their convex hull to the hull in
/// `TREE_FOOTPRINT_DIRECTIONS` directions, as shares of the longer side of its bounding box, into `distances`, which has
/// room for `capacity`. Points that are not finite do not count. `control` may be NULL; `nodes` of the limits caps the
/// points. `TREE_ERROR_NO_RESULT` where the hull has no area.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_footprint_of(
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    distances: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let spots = unsafe { self::spots(spots, n_spots, control) }?;
        let Some(found) = unsafe { run(control, |_| Ok(Footprint::of(spots))) }? else {
            let text = "the points have no convex hull with an area";
            return Err(Failure::new(TREE_ERROR_NO_RESULT, text));
        };
        unsafe { fill(distances, capacity, found.distances(), "distances") }
    })
}

/// How unlike two footprints are, each `TREE_FOOTPRINT_DIRECTIONS` distances: the root of the mean square of their
/// differences. 0 for equal shapes, about 0.2 for a circle and a poplar. `TREE_ERROR_INVALID` for other numbers of
/// distances, or where one is not above 0 and at most 2.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_footprint_difference(
    first: *const f32,
    n_first: usize,
    second: *const f32,
    n_second: usize,
    difference: *mut f32,
) -> tree_status {
    call(|| {
        let first = unsafe { footprint(first, n_first, "first") }?;
        let second = unsafe { footprint(second, n_second, "second") }?;
        unsafe { out_value(difference, first.distance(&second), "difference") }
    })
}

unsafe fn footprint(first: *const f32, n: usize, argument: &str) -> Result<Footprint> {
    let values = unsafe { slice(first, n, &Limits::default(), Resource::Nodes, argument) }?;
    Ok(Footprint::try_from(values.to_vec())?)
}

/// The convex hull of `n_spots` points, two floats each, against the clock where y goes up, without corners on straight
/// sides, into `corners`, which has room for `capacity` floats: twice `n_spots` always do. `n_corners` gets their number,
/// which is below 3 where the points lie on a line. Points that are not finite do not count. `control` may be NULL; `nodes`
/// of the limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_convex_hull(
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    corners: *mut f32,
    capacity: usize,
    n_corners: *mut usize,
) -> tree_status {
    call(|| {
        let spots = unsafe { self::spots(spots, n_spots, control) }?;
        let found = unsafe { run(control, |_| Ok(convex_hull(spots))) }?;
        let flat = bytemuck::cast_slice::<_, f32>(&found);
        unsafe { fill_some(corners, capacity, flat, "corners") }?;
        unsafe { out_value(n_corners, found.len(), "n_corners") }
    })
}
