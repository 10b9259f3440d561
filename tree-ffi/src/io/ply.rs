//! PLY files, written.

use super::tree_bytes;
use crate::border::{self, Versioned, call, get, init, out, read_or_default, tree_status};
use crate::control::{run, tree_control};
use crate::mesh::{ask_for_copies, tree_mesh};
use ::tree_mesh::io::ply::{self, PlyOptions};
use std::ffi::c_char;

/// How a PLY file is written. Begin with `tree_ply_options_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_ply_options {
    /// `sizeof(tree_ply_options)`.
    pub struct_size: usize,
    /// Whether numbers are written as text instead of little-endian binary: five times the size, for
    /// people and old programs. Default 0.
    pub ascii: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_ply_options {
    const NAME: &'static str = "tree_ply_options";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            ascii: PlyOptions::default().ascii.into(),
            reserved: 0,
        }
    }
}

impl tree_ply_options {
    fn rust(&self) -> PlyOptions {
        PlyOptions { ascii: self.ascii != 0 }
    }
}

/// Makes `options`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_ply_options_init(
    options: *mut tree_ply_options,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(options, size) })
}

/// Writes a mesh to a PLY file (the path is as in `tree_mesh_write_glb`), whole or not at all: all surfaces as one, each vertex with the colour of
/// its material times the mean of its texture. `options` and `control` may be NULL; of `control` only a
/// cancellation before the work begins matters.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_write_ply(
    mesh: *const tree_mesh,
    path: *const c_char,
    path_len: usize,
    options: *const tree_ply_options,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let path = unsafe { border::path(path, path_len, "path") }?;
        let options = unsafe { read_or_default(options, "options") }?.rust();
        unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([mesh], 2)?;
                Ok(ply::write_ply(mesh, path, &options)?)
            })
        }
    })
}

/// As `tree_mesh_write_ply`, in memory. Free the bytes with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_to_ply(
    mesh: *const tree_mesh,
    options: *const tree_ply_options,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let options = unsafe { read_or_default(options, "options") }?.rust();
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([mesh], 2)?;
                Ok(ply::to_bytes(mesh, &options)?)
            })
        }?;
        place.put(tree_bytes::new(made));
        Ok(())
    })
}
