//! Arrays that callers point at.

use super::failure::{Failure, Result};
use super::status::{TREE_ERROR_BUFFER, TREE_ERROR_INVALID};
use bytemuck::AnyBitPattern;
use glam::{Vec2, Vec3};
use tree_model::tree_core::{Limits, Resource};

/// A caller's array. NULL is allowed for none. The count is held against `resource` first, so that a
/// count that cannot be meant is an error and not a crash.
///
/// # Safety
/// `first` is NULL or points at `n` values that stay as they are for `'a`.
pub(crate) unsafe fn slice<'a, T: AnyBitPattern>(
    first: *const T,
    n: usize,
    limits: &Limits,
    resource: Resource,
    argument: &str,
) -> Result<&'a [T]> {
    limits.check(resource, n as u64)?;
    if n == 0 {
        return Ok(&[]);
    }
    if first.is_null() {
        return Err(Failure::null(argument));
    }
    let too_large = n.checked_mul(size_of::<T>()).is_none_or(|bytes| bytes > isize::MAX as usize);
    if too_large || !first.is_aligned() {
        let what = if too_large { "is larger than memory" } else { "is not aligned" };
        return Err(Failure::new(TREE_ERROR_INVALID, format!("{argument} {what}")));
    }
    // SAFETY: not NULL, aligned, of a possible size, and there by contract.
    Ok(unsafe { std::slice::from_raw_parts(first, n) })
}

/// `n` points of three floats each.
///
/// # Safety
/// As [`slice`], with `3 * n` floats.
pub(crate) unsafe fn vec3s<'a>(
    first: *const f32,
    n: usize,
    limits: &Limits,
    resource: Resource,
    argument: &str,
) -> Result<&'a [Vec3]> {
    unsafe { slice(first.cast(), n, limits, resource, argument) }
}

/// `n` points of two floats each.
///
/// # Safety
/// As [`slice`], with `2 * n` floats.
pub(crate) unsafe fn vec2s<'a>(
    first: *const f32,
    n: usize,
    limits: &Limits,
    resource: Resource,
    argument: &str,
) -> Result<&'a [Vec2]> {
    unsafe { slice(first.cast(), n, limits, resource, argument) }
}

/// Exactly `N` floats.
///
/// # Safety
/// `first` is NULL or points at `N` floats.
pub(crate) unsafe fn floats<const N: usize>(first: *const f32, argument: &str) -> Result<[f32; N]> {
    if first.is_null() {
        return Err(Failure::null(argument));
    }
    // SAFETY: not NULL, and there by contract.
    Ok(unsafe { first.cast::<[f32; N]>().read_unaligned() })
}

/// Copies `values` to a caller's buffer of `capacity` values; nothing is written when it is too small.
///
/// # Safety
/// `first` is NULL or has room for `capacity` values.
pub(crate) unsafe fn fill<T: Copy>(
    first: *mut T,
    capacity: usize,
    values: &[T],
    argument: &str,
) -> Result<()> {
    if first.is_null() {
        return Err(Failure::null(argument));
    }
    if capacity < values.len() {
        let text =
            format!("{argument} has room for {capacity} values, {} are needed", values.len());
        return Err(Failure::new(TREE_ERROR_BUFFER, text));
    }
    if !first.is_aligned() {
        return Err(Failure::new(TREE_ERROR_INVALID, format!("{argument} is not aligned")));
    }
    // SAFETY: room for `capacity` values by contract, and no more are written.
    unsafe { first.copy_from_nonoverlapping(values.as_ptr(), values.len()) };
    Ok(())
}

/// Writes one value to a caller's place.
///
/// # Safety
/// `place` is NULL or may be written.
pub(crate) unsafe fn out_value<T: Copy>(place: *mut T, value: T, argument: &str) -> Result<()> {
    if place.is_null() {
        return Err(Failure::null(argument));
    }
    // SAFETY: not NULL, and writable by contract.
    unsafe { place.write_unaligned(value) };
    Ok(())
}
