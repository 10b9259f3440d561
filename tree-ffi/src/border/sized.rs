//! Structs that begin with their own size, so that they can grow and old programs go on.
//!
//! A caller's struct may be shorter than ours (an older header: what it lacks has its default) or longer
//! (a newer header: what we do not know must be zero). Arrays of such structs step by the size that the
//! first one states.

use super::failure::{Failure, Result};
use super::status::TREE_ERROR_STRUCT_SIZE;
use std::mem::MaybeUninit;

/// A struct of the ABI whose first field is `struct_size: usize`.
///
/// # Safety
/// The type is `repr(C)`, starts with `struct_size: usize`, and any bytes are a valid value of every
/// field that a caller sets (numbers, raw pointers, `Option`s of functions).
pub(crate) unsafe trait Versioned: Copy {
    /// Its name in C.
    const NAME: &'static str;
    /// Bytes of its first version.
    const FIRST: usize;
    /// The value of fields that a caller does not know, `struct_size` included.
    fn default_value() -> Self;
}

/// Most bytes a struct may claim: beyond what any version will have, and not so many that an accidental
/// number often passes.
const SIZE_MAX: usize = 1 << 13;

unsafe fn size_of_at<T: Versioned>(place: *const T, argument: &str) -> Result<usize> {
    if place.is_null() {
        return Err(Failure::null(argument));
    }
    // SAFETY: not NULL; a struct of this kind begins with its size.
    let size = unsafe { place.cast::<usize>().read_unaligned() };
    check_size::<T>(size, argument)?;
    Ok(size)
}

fn check_size<T: Versioned>(size: usize, argument: &str) -> Result<()> {
    if (T::FIRST..=SIZE_MAX).contains(&size) {
        return Ok(());
    }
    let text = format!(
        "{argument}: struct_size is {size}, a {} has {} bytes: set it to sizeof({})",
        T::NAME,
        size_of::<T>(),
        T::NAME
    );
    Err(Failure::new(TREE_ERROR_STRUCT_SIZE, text))
}

/// Reads a caller's struct.
///
/// # Safety
/// `place` is NULL or points at a struct of the size it states.
pub(crate) unsafe fn read<T: Versioned>(place: *const T, argument: &str) -> Result<T> {
    let size = unsafe { size_of_at(place, argument) }?;
    let known = size.min(size_of::<T>());
    let mut value = MaybeUninit::new(T::default_value());
    // SAFETY: the caller's struct has `size` bytes, ours at least `known`; every field takes any bytes.
    let value = unsafe {
        std::ptr::copy_nonoverlapping(place.cast::<u8>(), value.as_mut_ptr().cast::<u8>(), known);
        value.assume_init()
    };
    // SAFETY: as above.
    let unknown = (known..size).any(|at| unsafe { place.cast::<u8>().add(at).read() } != 0);
    if unknown {
        let text = format!(
            "{argument}: this library's {} has {} bytes, and what is set beyond is not known here",
            T::NAME,
            size_of::<T>()
        );
        return Err(Failure::new(TREE_ERROR_STRUCT_SIZE, text));
    }
    Ok(value)
}

/// As [`read`]; NULL is the default.
///
/// # Safety
/// As [`read`].
pub(crate) unsafe fn read_or_default<T: Versioned>(place: *const T, argument: &str) -> Result<T> {
    if place.is_null() { Ok(T::default_value()) } else { unsafe { read(place, argument) } }
}

/// Reads an array of `n` structs; NULL is allowed for none. `most` is how many are sensible.
///
/// # Safety
/// `first` is NULL or points at `n` structs, each of the size that the first states.
pub(crate) unsafe fn read_rows<T: Versioned>(
    first: *const T,
    n: usize,
    most: usize,
    argument: &str,
) -> Result<Vec<T>> {
    if n == 0 {
        return Ok(Vec::new());
    }
    if n > most {
        let text = format!("{argument}: {n} are given, at most {most} are allowed");
        return Err(Failure::new(super::status::TREE_ERROR_LIMIT, text));
    }
    let stride = unsafe { size_of_at(first, argument) }?;
    (0..n)
        .map(|i| {
            let name = format!("{argument}[{i}]");
            // SAFETY: within the caller's array.
            let row = unsafe { first.cast::<u8>().add(i * stride) }.cast::<T>();
            if unsafe { size_of_at(row, &name) }? != stride {
                let text = format!("{name}: struct_size differs from that of {argument}[0]");
                return Err(Failure::new(TREE_ERROR_STRUCT_SIZE, text));
            }
            unsafe { read(row, &name) }
        })
        .collect()
}

/// Writes `value` into a caller's struct, which states how much of it there is room for.
///
/// # Safety
/// `place` is NULL or points at a struct of the size it states, which may be written.
pub(crate) unsafe fn write<T: Versioned>(place: *mut T, argument: &str, value: &T) -> Result<()> {
    let size = unsafe { size_of_at(place.cast_const(), argument) }?;
    unsafe { write_sized(place, size, value) };
    Ok(())
}

/// Looks at the size of a report before the work that it tells of, so that no work is done in vain.
///
/// # Safety
/// `place` is NULL or points at a struct of the size it states.
pub(crate) unsafe fn foresee<T: Versioned>(place: *const T, argument: &str) -> Result<()> {
    if place.is_null() { Ok(()) } else { unsafe { size_of_at(place, argument) }.map(drop) }
}

/// As [`write`]; nothing is written to NULL.
///
/// # Safety
/// As [`write`].
pub(crate) unsafe fn view<T: Versioned>(place: *mut T, argument: &str, value: &T) -> Result<()> {
    if place.is_null() { Ok(()) } else { unsafe { write(place, argument, value) } }
}

/// Makes the caller's struct of `size` bytes the default.
///
/// # Safety
/// `place` is NULL or has `size` bytes that may be written.
pub(crate) unsafe fn init<T: Versioned>(place: *mut T, size: usize) -> Result<()> {
    if place.is_null() {
        return Err(Failure::null(T::NAME));
    }
    check_size::<T>(size, T::NAME)?;
    unsafe { write_sized(place, size, &T::default_value()) };
    Ok(())
}

unsafe fn write_sized<T: Versioned>(place: *mut T, size: usize, value: &T) {
    let known = size.min(size_of::<T>());
    // SAFETY: `size` bytes may be written; what we do not know becomes zero, `struct_size` stays.
    unsafe {
        let to = place.cast::<u8>();
        std::ptr::copy_nonoverlapping(std::ptr::from_ref(value).cast::<u8>(), to, known);
        to.add(known).write_bytes(0, size - known);
        place.cast::<usize>().write_unaligned(size);
    }
}
