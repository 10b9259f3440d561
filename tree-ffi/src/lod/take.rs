//! What all of level of detail takes from callers, and writes to them.

use crate::border::{
    Failure, Result, TREE_ERROR_BUFFER, TREE_ERROR_INVALID, TREE_ERROR_PARAMETER, fill, slice,
    vec3s,
};
use crate::control::{limits, run, tree_control};
use bytemuck::{AnyBitPattern, NoUninit};
use glam::Vec3;
use tree_model::tree_core::{Control, Limits, Resource};

/// Points that are looked up between looks at the control.
const CHUNK: usize = 1 << 12;

/// A caller's array of at most `most` values; NULL is allowed for none.
///
/// # Safety
/// As [`slice`].
pub(crate) unsafe fn few<'a, T: AnyBitPattern>(
    first: *const T,
    n: usize,
    most: usize,
    argument: &str,
) -> Result<&'a [T]> {
    if n > most {
        let text = format!("{argument}: {n} are given, at most {most} are allowed");
        return Err(Failure::new(TREE_ERROR_PARAMETER, text));
    }
    unsafe { slice(first, n, &Limits::default(), Resource::Nodes, argument) }
}

/// What `answer` says of each of `n` points, three floats each.
pub(super) unsafe fn ask<R: Send>(
    points: *const f32,
    n: usize,
    control: *const tree_control,
    answer: impl Fn(Vec3) -> R + Send,
) -> Result<Vec<R>> {
    let limits = unsafe { limits(control) }?;
    let points = unsafe { vec3s(points, n, &limits, Resource::Nodes, "points") }?;
    let body = move |control: &Control| {
        let mut answers = Vec::with_capacity(points.len());
        for chunk in points.chunks(CHUNK) {
            control.check()?;
            answers.extend(chunk.iter().map(|&point| answer(point)));
        }
        Ok(answers)
    };
    unsafe { run(control, body) }
}

/// Looks at a buffer before the work whose result goes there, so that no work is done in vain.
pub(crate) fn room_for(needed: usize, capacity: usize, argument: &str) -> Result<()> {
    if needed <= capacity {
        return Ok(());
    }
    let text = format!("{argument} has room for {capacity} values, {needed} are needed");
    Err(Failure::new(TREE_ERROR_BUFFER, text))
}

/// As [`fill`]; for no values there need be no buffer.
///
/// # Safety
/// As [`fill`].
pub(crate) unsafe fn fill_some<T: Copy>(
    first: *mut T,
    capacity: usize,
    values: &[T],
    argument: &str,
) -> Result<()> {
    if values.is_empty() {
        return Ok(());
    }
    unsafe { fill(first, capacity, values, argument) }
}

/// Points into a buffer of floats whose capacity counts floats.
///
/// # Safety
/// As [`fill`].
pub(super) unsafe fn fill_points(
    first: *mut f32,
    capacity: usize,
    points: &[Vec3],
    argument: &str,
) -> Result<()> {
    unsafe { fill_some(first, capacity, bytemuck::cast_slice(points), argument) }
}

/// A caller's buffer, written in place. NULL is allowed where there is no room.
///
/// # Safety
/// `first` is NULL or has room for `capacity` values that nobody else looks at for `'a`.
pub(crate) unsafe fn buffer<'a, T: AnyBitPattern + NoUninit>(
    first: *mut T,
    capacity: usize,
    argument: &str,
) -> Result<&'a mut [T]> {
    if capacity == 0 {
        return Ok(&mut []);
    }
    if first.is_null() {
        return Err(Failure::null(argument));
    }
    let bytes = capacity.checked_mul(size_of::<T>());
    let too_large = bytes.is_none_or(|bytes| bytes > isize::MAX as usize);
    if too_large || !first.is_aligned() {
        let what = if too_large { "is larger than memory" } else { "is not aligned" };
        return Err(Failure::new(TREE_ERROR_INVALID, format!("{argument} {what}")));
    }
    // SAFETY: not NULL, aligned, of a possible size, and there by contract; any bytes are a value.
    Ok(unsafe { std::slice::from_raw_parts_mut(first, capacity) })
}
