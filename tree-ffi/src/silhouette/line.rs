//! Lines in the plane, measured along.

use super::measure::fill_opt;
use crate::border::{
    Failure, Result, TREE_ERROR_INVALID, TREE_ERROR_NO_RESULT, TREE_ERROR_PARAMETER, call,
    out_value, slice, tree_status, vec2s,
};
use crate::control::{limits, tree_control};
use crate::sketch::{answers, fill_some, spots};
use glam::Vec2;
use tree_model::silhouette::Line;
use tree_model::tree_core::Resource;

/// A caller's line.
///
/// # Safety
/// As [`vec2s`].
pub(crate) unsafe fn line_of(
    first: *const f32,
    n: usize,
    control: *const tree_control,
    argument: &str,
) -> Result<Line> {
    let points = unsafe { vec2s(first, n, &limits(control)?, Resource::Nodes, argument) }?;
    Line::new(points.to_vec()).ok_or_else(|| {
        let text = format!("{argument} is no line: it needs two different finite points");
        Failure::new(TREE_ERROR_INVALID, text)
    })
}

/// A line's points into a caller's buffer of floats.
pub(super) unsafe fn fill_line(
    line: &Line,
    points: *mut f32,
    capacity: usize,
    n_points: *mut usize,
) -> Result<()> {
    let found = line.points();
    unsafe { fill_some(points, capacity, bytemuck::cast_slice(found), "points") }?;
    unsafe { out_value(n_points, found.len(), "n_points") }
}

/// Length in metres of a line of `n_line` points, two floats each: points that are not finite, and repeated ones, are left
/// out. `control` may be NULL; `nodes` of its limits caps the points. `TREE_ERROR_INVALID` where fewer than two are left.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_line_length(
    line: *const f32,
    n_line: usize,
    control: *const tree_control,
    length: *mut f32,
) -> tree_status {
    call(|| {
        let line = unsafe { line_of(line, n_line, control, "line") }?;
        unsafe { out_value(length, line.length(), "length") }
    })
}

/// The points at `n_places` places along a line, shares of its length from 0 to 1, and its directions there, of unit
/// length. `points` and `tangents` get two floats for each and have room for `capacity` floats; one may be NULL. The line
/// and `control` are as for `tree_line_length`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_line_at(
    line: *const f32,
    n_line: usize,
    places: *const f32,
    n_places: usize,
    control: *const tree_control,
    points: *mut f32,
    tangents: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let line = unsafe { line_of(line, n_line, control, "line") }?;
        let nodes = Resource::Nodes;
        let places = unsafe { slice(places, n_places, &limits(control)?, nodes, "places") }?;
        let found = unsafe { answers(places, control, |&t: &f32| (line.at(t), line.tangent(t))) }?;
        let (at, along): (Vec<Vec2>, Vec<Vec2>) = found.into_iter().unzip();
        let flat = bytemuck::cast_slice::<_, f32>;
        unsafe { fill_opt(points, capacity, flat(&at), "points") }?;
        unsafe { fill_opt(tangents, capacity, flat(&along), "tangents") }
    })
}

/// The place along a line that is nearest to each of `n_spots` points, two floats each. `shares` gets where that is as a
/// share of the length, and `distances` how far it is from the point; each has room for `capacity`, and one may be NULL.
/// The line and `control` are as for `tree_line_length`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_line_nearest(
    line: *const f32,
    n_line: usize,
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    shares: *mut f32,
    distances: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let line = unsafe { line_of(line, n_line, control, "line") }?;
        let spots = unsafe { self::spots(spots, n_spots, control) }?;
        let found = unsafe { answers(spots, control, |&spot| line.nearest(spot)) }?;
        let (along, away): (Vec<f32>, Vec<f32>) = found.into_iter().unzip();
        unsafe { fill_opt(shares, capacity, &along, "shares") }?;
        unsafe { fill_opt(distances, capacity, &away, "distances") }
    })
}

/// A line by points at even distances, from `from` to a greater `to`, shares of its length from 0 to 1: `count` of them,
/// 2 at least, or 0 for its own points there. They go into `points`, two floats each; `capacity` counts floats. `n_points`
/// gets their number. The line and `control` are as for `tree_line_length`. `TREE_ERROR_NO_RESULT` where nothing is left.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_line_part(
    line: *const f32,
    n_line: usize,
    from: f32,
    to: f32,
    count: u32,
    control: *const tree_control,
    points: *mut f32,
    capacity: usize,
    n_points: *mut usize,
) -> tree_status {
    call(|| {
        let line = unsafe { line_of(line, n_line, control, "line") }?;
        check_within(from, to)?;
        unsafe { limits(control) }?.check(Resource::Nodes, count.into())?;
        let Some(part) = line.part(from, to) else {
            let text = format!("nothing of the line lies between {from} and {to}");
            return Err(Failure::new(TREE_ERROR_NO_RESULT, text));
        };
        let part = if count > 0 { part.resampled(count as usize) } else { part };
        unsafe { fill_line(&part, points, capacity, n_points) }
    })
}

/// Shares of a length.
pub(super) fn check_within(from: f32, to: f32) -> Result<()> {
    if (0.0..=1.0).contains(&from) && (from..=1.0).contains(&to) {
        return Ok(());
    }
    let text = format!("from is {from} and to is {to}, allowed is 0 ≤ from ≤ to ≤ 1");
    Err(Failure::new(TREE_ERROR_PARAMETER, text))
}
