//! Files in memory.

use crate::border::{Handle, call, free, get, out_value, tree_status};
use crate::mesh::column;

/// A file in memory.
pub struct tree_bytes(Vec<u8>);

impl Handle for tree_bytes {
    const NAME: &'static str = "tree_bytes";
}

impl tree_bytes {
    pub(crate) fn new(bytes: Vec<u8>) -> Self {
        Self(bytes)
    }
}

/// Views the bytes: where they begin and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bytes_view(
    bytes: *const tree_bytes,
    data: *mut *const u8,
    len: *mut usize,
) -> tree_status {
    call(|| {
        let bytes = &unsafe { get(bytes, "bytes") }?.0;
        unsafe { out_value(data, column(bytes), "data") }?;
        unsafe { out_value(len, bytes.len(), "len") }
    })
}

/// Frees a file in memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_bytes_free(bytes: *mut tree_bytes) -> tree_status {
    call(|| unsafe { free(bytes, "bytes") })
}
