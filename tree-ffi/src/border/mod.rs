//! What every function at the border does: catch, check, convert, hand out.
//!
//! * [`call`] runs a body, keeps panics inside and remembers the error for [`tree_error_text`].
//! * `status`, `failure`: error codes, and how the family's errors become codes.
//! * `handle`: opaque objects, and the register of those alive.
//! * `lock`: objects that change, one call at a time.
//! * `shared`: parts of larger objects, which keep these alive.
//! * `sized`: structs that begin with their own size.
//! * `slice`, `text`: what callers point at.
//!
//! [`tree_error_text`]: crate::tree_error_text

mod failure;
mod handle;
mod last_error;
mod lock;
mod shared;
mod sized;
mod slice;
mod status;
mod text;

pub(crate) use failure::{Failure, Result};
pub(crate) use handle::{
    Handle, free, free_owned, get, get_opt, n_live, out, out_opt, out2, register_for_ever,
    register_owned,
};
pub(crate) use lock::lock_now;
pub(crate) use shared::Shared;
pub(crate) use sized::{Versioned, foresee, init, read, read_or_default, read_rows, view, write};
pub(crate) use slice::{fill, floats, out_value, slice, vec2s, vec3s};
pub(crate) use text::{bytes, path, text};

use last_error::remember;

pub use last_error::*;
pub use status::*;
pub use text::tree_str;

use std::panic::{AssertUnwindSafe, catch_unwind};

/// Runs what a function does. Nothing unwinds out of it, and an error is remembered for this thread.
pub(crate) fn call(body: impl FnOnce() -> Result<()>) -> tree_status {
    let failure = match catch_unwind(AssertUnwindSafe(body)) {
        Ok(Ok(())) => return TREE_OK,
        Ok(Err(failure)) => failure,
        Err(panic) => Failure::panic(panic.as_ref()),
    };
    let status = failure.status;
    // A panic's payload may panic when it is dropped, and remembering allocates.
    if catch_unwind(AssertUnwindSafe(|| remember(failure))).is_err() {
        return TREE_ERROR_PANIC;
    }
    status
}
