//! Which library this is.

use crate::border::n_live;
use std::ffi::c_char;

/// Version of the ABI that this header describes. A library with the same number has every function and
/// struct of this header; additions do not change it.
pub const TREE_ABI_VERSION: u32 = 1;

/// The library's own `TREE_ABI_VERSION`: hold it against the header's before anything else.
#[unsafe(no_mangle)]
pub extern "C" fn tree_abi_version() -> u32 {
    TREE_ABI_VERSION
}

/// The library's version, such as `0.1.0`. Valid for ever.
#[unsafe(no_mangle)]
pub extern "C" fn tree_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

/// Number of objects alive, of all kinds: for tests that look for leaks. Presets and their parts, which
/// are never freed, do not count.
#[unsafe(no_mangle)]
pub extern "C" fn tree_live_objects() -> usize {
    n_live()
}
