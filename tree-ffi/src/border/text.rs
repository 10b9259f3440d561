//! Texts and paths.

#![allow(non_camel_case_types)]

use super::failure::{Failure, Result};
use super::status::TREE_ERROR_TEXT;
use std::ffi::{CStr, c_char};
use std::path::Path;
use tree_model::tree_core::{Limits, Resource};

/// Length of a text that ends with a NUL byte instead: `TREE_NUL_TERMINATED` in the header.
const NUL_TERMINATED: usize = usize::MAX;
/// Longest name or path in bytes.
const NAME_MAX: usize = 1 << 16;

/// A text in UTF-8. As input, `len` may be `TREE_NUL_TERMINATED` and `data` NULL for an empty text. As
/// output it is borrowed, and no NUL byte need follow it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_str {
    /// The first byte.
    pub data: *const c_char,
    /// Number of bytes.
    pub len: usize,
}

impl tree_str {
    /// No text.
    pub(crate) const EMPTY: Self = Self { data: std::ptr::null(), len: 0 };

    /// A view of `text`.
    pub(crate) const fn of(text: &str) -> Self {
        Self { data: text.as_ptr().cast(), len: text.len() }
    }

    /// The text; empty when there is none.
    ///
    /// # Safety
    /// `data` is NULL or points at `len` bytes that stay for `'a`.
    pub(crate) unsafe fn get<'a>(self, argument: &str) -> Result<&'a str> {
        if self.data.is_null() {
            if self.len == 0 || self.len == NUL_TERMINATED {
                return Ok("");
            }
            return Err(Failure::null(argument));
        }
        unsafe { text(self.data, self.len, argument) }
    }
}

/// Bytes of a caller's text or file, at most `Limits::input_bytes`.
///
/// # Safety
/// `data` is NULL or points at `len` bytes, or at a text with a NUL at its end when `len` says so, that
/// stay for `'a`.
pub(crate) unsafe fn bytes<'a>(
    data: *const u8,
    len: usize,
    limits: &Limits,
    argument: &str,
) -> Result<&'a [u8]> {
    if data.is_null() {
        return Err(Failure::null(argument));
    }
    if len == NUL_TERMINATED {
        // SAFETY: by contract there is a NUL.
        let bytes = unsafe { CStr::from_ptr(data.cast()) }.to_bytes();
        limits.check(Resource::InputBytes, bytes.len() as u64)?;
        return Ok(bytes);
    }
    unsafe { super::slice(data, len, limits, Resource::InputBytes, argument) }
}

/// A name.
///
/// # Safety
/// As [`bytes`].
pub(crate) unsafe fn text<'a>(data: *const c_char, len: usize, argument: &str) -> Result<&'a str> {
    let limits = Limits { input_bytes: NAME_MAX as u64, ..Limits::default() };
    let bytes = unsafe { bytes(data.cast(), len, &limits, argument) }?;
    std::str::from_utf8(bytes).map_err(|error| {
        let at = error.valid_up_to();
        Failure::new(TREE_ERROR_TEXT, format!("{argument} is not UTF-8 from byte {at} on"))
    })
}

/// A path, in UTF-8.
///
/// # Safety
/// As [`bytes`].
pub(crate) unsafe fn path<'a>(data: *const c_char, len: usize, argument: &str) -> Result<&'a Path> {
    let text = unsafe { text(data, len, argument) }?;
    if text.is_empty() || text.contains('\0') {
        let what = if text.is_empty() { "is empty" } else { "has a NUL byte in it" };
        return Err(Failure::new(
            TREE_ERROR_TEXT,
            format!("{argument} {what}: no file has this name"),
        ));
    }
    Ok(Path::new(text))
}
