//! The last error of each thread.

#![allow(non_camel_case_types)]

use super::failure::Failure;
use super::status::{TREE_OK, tree_status};
use std::cell::RefCell;
use std::ffi::{CString, c_char};

/// No text takes no memory: hosts set their allocator before the library has any.
type Last = (tree_status, Option<CString>);

thread_local! {
    static LAST: RefCell<Last> = const { RefCell::new((TREE_OK, None)) };
}

/// Keeps the failure for this thread.
pub(super) fn remember(failure: Failure) {
    let mut bytes = failure.text.into_bytes();
    bytes.retain(|&byte| byte != 0);
    // Without NUL bytes there is always a C string.
    let text = CString::new(bytes).ok();
    // A thread that is ending has no place for it any more.
    let _ = LAST.try_with(|last| {
        if let Ok(mut last) = last.try_borrow_mut() {
            *last = (failure.status, text);
        }
    });
}

/// What went wrong in this thread's last call that failed, in UTF-8 and with a NUL at the end: what was
/// wrong, where, and what would be right. Empty before any call failed. Never NULL; valid until the next
/// call that fails in this thread.
#[unsafe(no_mangle)]
pub extern "C" fn tree_error_text() -> *const c_char {
    LAST.try_with(|last| last.try_borrow().ok()?.1.as_ref().map(|text| text.as_ptr()))
        .ok()
        .flatten()
        .unwrap_or(c"".as_ptr())
}

/// The code of this thread's last call that failed; `TREE_OK` before any did.
#[unsafe(no_mangle)]
pub extern "C" fn tree_error_status() -> tree_status {
    LAST.try_with(|last| last.try_borrow().map(|last| last.0))
        .ok()
        .and_then(Result::ok)
        .unwrap_or(TREE_OK)
}

/// Forgets this thread's last error, and gives its memory back.
#[unsafe(no_mangle)]
pub extern "C" fn tree_error_clear() {
    let _ = LAST.try_with(|last| {
        if let Ok(mut last) = last.try_borrow_mut() {
            *last = (TREE_OK, None);
        }
    });
}
