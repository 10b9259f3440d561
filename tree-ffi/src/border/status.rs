//! Error codes. Numbers never change their meaning; retired ones stay reserved.

#![allow(non_camel_case_types)]

/// What a function says of itself: `TREE_OK`, or one of the `TREE_ERROR_` codes. New codes may be
/// added: treat those you do not know as errors.
pub type tree_status = i32;

/// Done.
pub const TREE_OK: i32 = 0;
/// A pointer that must not be NULL is.
pub const TREE_ERROR_NULL: i32 = 1;
/// A handle is not alive: it was freed, is of another kind, or never was one.
pub const TREE_ERROR_HANDLE: i32 = 2;
/// A struct's `struct_size` fits no version of it. Usually it was not set.
pub const TREE_ERROR_STRUCT_SIZE: i32 = 3;
/// A text is not UTF-8, or a path or a name has a NUL byte in it.
pub const TREE_ERROR_TEXT: i32 = 4;
/// A number that should be one of a set of constants is none of them.
pub const TREE_ERROR_ENUM: i32 = 5;
/// A number, in a parameter or in a column, lies outside its range or is not finite.
pub const TREE_ERROR_PARAMETER: i32 = 6;
/// Columns do not fit together: lengths, orders, indices that name nothing.
pub const TREE_ERROR_INVALID: i32 = 7;
/// No preset, texture or format has this name.
pub const TREE_ERROR_UNKNOWN_NAME: i32 = 8;
/// More was asked for than the limits of `tree_control` allow.
pub const TREE_ERROR_LIMIT: i32 = 9;
/// The memory budget does not allow it.
pub const TREE_ERROR_MEMORY: i32 = 10;
/// The caller cancelled. Nothing was written, and nothing was changed but where a function says so.
pub const TREE_ERROR_CANCELLED: i32 = 11;
/// A file could not be read or written.
pub const TREE_ERROR_IO: i32 = 12;
/// A file is not what its format asks for, or needs what this library cannot do.
pub const TREE_ERROR_FORMAT: i32 = 13;
/// The parameters are each in order, but no tree, mesh or picture comes of them.
pub const TREE_ERROR_NO_RESULT: i32 = 14;
/// The caller's buffer is too small.
pub const TREE_ERROR_BUFFER: i32 = 15;
/// A call that cannot be made now, such as freeing a pool that is at work.
pub const TREE_ERROR_ORDER: i32 = 16;
/// A defect in the library. Please report it with the text.
pub const TREE_ERROR_PANIC: i32 = 17;

/// Name of a status, such as `TREE_ERROR_NULL`. Never NULL, and valid for ever.
#[unsafe(no_mangle)]
pub extern "C" fn tree_status_name(status: tree_status) -> *const std::ffi::c_char {
    let name = match status {
        TREE_OK => c"TREE_OK",
        TREE_ERROR_NULL => c"TREE_ERROR_NULL",
        TREE_ERROR_HANDLE => c"TREE_ERROR_HANDLE",
        TREE_ERROR_STRUCT_SIZE => c"TREE_ERROR_STRUCT_SIZE",
        TREE_ERROR_TEXT => c"TREE_ERROR_TEXT",
        TREE_ERROR_ENUM => c"TREE_ERROR_ENUM",
        TREE_ERROR_PARAMETER => c"TREE_ERROR_PARAMETER",
        TREE_ERROR_INVALID => c"TREE_ERROR_INVALID",
        TREE_ERROR_UNKNOWN_NAME => c"TREE_ERROR_UNKNOWN_NAME",
        TREE_ERROR_LIMIT => c"TREE_ERROR_LIMIT",
        TREE_ERROR_MEMORY => c"TREE_ERROR_MEMORY",
        TREE_ERROR_CANCELLED => c"TREE_ERROR_CANCELLED",
        TREE_ERROR_IO => c"TREE_ERROR_IO",
        TREE_ERROR_FORMAT => c"TREE_ERROR_FORMAT",
        TREE_ERROR_NO_RESULT => c"TREE_ERROR_NO_RESULT",
        TREE_ERROR_BUFFER => c"TREE_ERROR_BUFFER",
        TREE_ERROR_ORDER => c"TREE_ERROR_ORDER",
        TREE_ERROR_PANIC => c"TREE_ERROR_PANIC",
        _ => c"unknown status",
    };
    name.as_ptr()
}
