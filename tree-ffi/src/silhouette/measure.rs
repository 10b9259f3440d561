//! Outlines measured.

use super::tree_outline;
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, call, floats, get, out_value, slice, tree_status, vec2s,
};
use crate::control::{limits, run, tree_control};
use crate::sketch::{answers, fill_some, spots};
use glam::Vec2;
use tree_model::tree_core::Resource;

/// A point of the plane, two finite floats.
pub(super) unsafe fn spot(first: *const f32, argument: &str) -> Result<Vec2> {
    let [x, y] = unsafe { floats(first, argument) }?;
    if x.is_finite() && y.is_finite() {
        return Ok(Vec2::new(x, y));
    }
    Err(Failure::new(TREE_ERROR_PARAMETER, format!("{argument} is not finite")))
}

/// As [`fill_some`]; nothing is written to NULL.
///
/// # Safety
/// As [`fill_some`].
pub(super) unsafe fn fill_opt<T: Copy>(
    first: *mut T,
    capacity: usize,
    values: &[T],
    argument: &str,
) -> Result<()> {
    if first.is_null() { Ok(()) } else { unsafe { fill_some(first, capacity, values, argument) } }
}

/// Says of `n_spots` points, two floats each, whether they lie inside: 1 or 0 into `inside`, which has room for
/// `capacity`. `control` may be NULL; `nodes` of its limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_contains(
    outline: *const tree_outline,
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    inside: *mut u8,
    capacity: usize,
) -> tree_status {
    call(|| {
        let outline = unsafe { get(outline, "outline") }?.rust();
        let spots = unsafe { self::spots(spots, n_spots, control) }?;
        let found = unsafe { answers(spots, control, |&spot| u8::from(outline.contains(spot))) }?;
        unsafe { fill_some(inside, capacity, &found, "inside") }
    })
}

/// How far it is along `n_rays` rays to the outline, the first crossing in front: each ray is four floats, its beginning
/// and its direction, of unit length. `exits`, which has room for `capacity`, gets metres, infinite where there is no
/// crossing; from outside it is the near side. `control` as for `tree_outline_contains`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_exits(
    outline: *const tree_outline,
    rays: *const f32,
    n_rays: usize,
    control: *const tree_control,
    exits: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let outline = unsafe { get(outline, "outline") }?.rust();
        let rays = unsafe { self::rays(rays, n_rays, control) }?;
        let exit = |&[from, way]: &[Vec2; 2]| outline.exit(from, way).unwrap_or(f32::INFINITY);
        let found = unsafe { answers(rays, control, exit) }?;
        unsafe { fill_some(exits, capacity, &found, "exits") }
    })
}

/// A caller's rays: beginning and direction of each.
pub(super) unsafe fn rays<'a>(
    rays: *const f32,
    n_rays: usize,
    control: *const tree_control,
) -> Result<&'a [[Vec2; 2]]> {
    let ends = n_rays.saturating_mul(2);
    let ends = unsafe { vec2s(rays, ends, &limits(control)?, Resource::Nodes, "rays") }?;
    Ok(ends.as_chunks().0)
}

/// The place along the outline that is nearest to each of `n_spots` points, two floats each. `lengths` gets how far that
/// is along it, in metres against the clock from the first corner, and `distances` how far it is from the point; each has room
/// for `capacity`, and one may be NULL. `control` as for `tree_outline_contains`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_nearest(
    outline: *const tree_outline,
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    lengths: *mut f32,
    distances: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let outline = unsafe { get(outline, "outline") }?.rust();
        let spots = unsafe { self::spots(spots, n_spots, control) }?;
        let found = unsafe { answers(spots, control, |&spot| outline.nearest(spot)) }?;
        let (along, away): (Vec<f32>, Vec<f32>) = found.into_iter().unzip();
        unsafe { fill_opt(lengths, capacity, &along, "lengths") }?;
        unsafe { fill_opt(distances, capacity, &away, "distances") }
    })
}

/// The points at `n_lengths` lengths along an outline, in metres against the clock from the first corner, below 0 and beyond
/// the perimeter on round; and the outline's directions there, of unit length, with the inside to the left. `points` and
/// `tangents` get two floats for each and have room for `capacity` floats; one may be NULL. `control` as for
/// `tree_outline_contains`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_along(
    outline: *const tree_outline,
    lengths: *const f32,
    n_lengths: usize,
    control: *const tree_control,
    points: *mut f32,
    tangents: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let outline = unsafe { get(outline, "outline") }?.rust();
        let nodes = Resource::Nodes;
        let rows = unsafe { slice(lengths, n_lengths, &limits(control)?, nodes, "lengths") }?;
        let at = |&length: &f32| (outline.along(length), outline.tangent(length));
        let found = unsafe { answers(rows, control, at) }?;
        let (at, along): (Vec<Vec2>, Vec<Vec2>) = found.into_iter().unzip();
        let flat = bytemuck::cast_slice::<_, f32>;
        unsafe { fill_opt(points, capacity, flat(&at), "points") }?;
        unsafe { fill_opt(tangents, capacity, flat(&along), "tangents") }
    })
}

/// The corners of the stretch from one length along an outline to another, both ends among them, into `points`, two floats
/// each; `capacity` counts floats, and twice the corners plus four always do. `to` may exceed the perimeter where
/// the stretch passes the first corner; it ends after once round. `n_points` gets their number: one where `to` is not above
/// `from`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_part(
    outline: *const tree_outline,
    from: f32,
    to: f32,
    points: *mut f32,
    capacity: usize,
    n_points: *mut usize,
) -> tree_status {
    call(|| {
        let found = unsafe { get(outline, "outline") }?.rust().part(from, to);
        unsafe { fill_some(points, capacity, bytemuck::cast_slice(&found), "points") }?;
        unsafe { out_value(n_points, found.len(), "n_points") }
    })
}

/// Area that two outlines have in common, in square metres, within about 1 %; and the same over the area they cover
/// together, 0 to 1 (the intersection over union).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_overlap(
    outline: *const tree_outline,
    other: *const tree_outline,
    area: *mut f32,
    iou: *mut f32,
) -> tree_status {
    call(|| {
        let one = unsafe { get(outline, "outline") }?.rust();
        let other = unsafe { get(other, "other") }?.rust();
        unsafe { out_value(area, one.overlap(other), "area") }?;
        unsafe { out_value(iou, one.iou(other), "iou") }
    })
}

/// Which of the `width` by `height` cells between the corners `low` and `high`, two floats each, have their centres
/// inside: 1 or 0 into `cells`, row by row from the lowest, each from the left. `cells` has room for `capacity`. `control`
/// may be NULL; `pixels` of its limits caps the cells.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_mask(
    outline: *const tree_outline,
    low: *const f32,
    high: *const f32,
    width: u32,
    height: u32,
    control: *const tree_control,
    cells: *mut u8,
    capacity: usize,
) -> tree_status {
    call(|| {
        let outline = unsafe { get(outline, "outline") }?.rust();
        let low = unsafe { spot(low, "low") }?;
        let high = unsafe { spot(high, "high") }?;
        if !(low.x < high.x && low.y < high.y) {
            let text = format!("high is {high}, which is not above low, {low}");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let n = u64::from(width) * u64::from(height);
        let limits = unsafe { limits(control) }?;
        // A row or column without cells takes memory too.
        limits.check(Resource::Pixels, n.max(width.max(height).into()))?;
        let size = (width as usize, height as usize);
        let mask = unsafe { run(control, |_| Ok(outline.mask(low, high, size.0, size.1))) }?;
        let found: Vec<u8> = mask.into_iter().map(u8::from).collect();
        unsafe { fill_some(cells, capacity, &found, "cells") }
    })
}
