//! Hybrid models in glTF 2.0.

use super::model::tree_hybrid;
use crate::border::{self, call, get, out, tree_status};
use crate::control::{run, tree_control};
use crate::io::{read_options, tree_bytes, tree_glb_options};
use crate::lod::take::few;
use crate::mesh::ask_for_copies;
use std::ffi::c_char;

/// More levels than are sensible in a file.
const MAX_LEVELS: usize = 1 << 10;

/// Levels as the `MSFT_lod` of one GLB file, each a mesh of its own, as `tree_hybrid_choice_mesh` makes it: for programs
/// without shaders of ours. `heights` are `n_heights` heights of the tree on the screen in pixels, falling, at most 1024:
/// each level is made for its height, and shown until the tree is as high as the next one says; the last is shown to the
/// end. `screen` is the height of the screen in pixels, 1 to 1e5. `options` and `control` may be NULL, as in
/// `tree_mesh_write_glb`. Free the bytes with `tree_bytes_free`. `TREE_ERROR_INVALID` when there are no heights or they do
/// not fall.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_to_glb_levels(
    hybrid: *const tree_hybrid,
    heights: *const f32,
    n_heights: usize,
    screen: f32,
    options: *const tree_glb_options,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let hybrid = unsafe { get(hybrid, "hybrid") }?.rust();
        let heights = unsafe { few(heights, n_heights, MAX_LEVELS, "heights") }?;
        let options = unsafe { read_options(options) }?;
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([hybrid.mesh()], 3 * heights.len() as u64)?;
                Ok(hybrid.to_glb_levels(heights, screen, &options)?)
            })
        }?;
        place.put(tree_bytes::new(made));
        Ok(())
    })
}

/// As `tree_hybrid_to_glb_levels`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_hybrid_write_glb_levels(
    hybrid: *const tree_hybrid,
    heights: *const f32,
    n_heights: usize,
    screen: f32,
    path: *const c_char,
    path_len: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let hybrid = unsafe { get(hybrid, "hybrid") }?.rust();
        let heights = unsafe { few(heights, n_heights, MAX_LEVELS, "heights") }?;
        let path = unsafe { border::path(path, path_len, "path") }?;
        let options = unsafe { read_options(options) }?;
        unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([hybrid.mesh()], 3 * heights.len() as u64)?;
                Ok(hybrid.write_glb_levels(heights, screen, path, &options)?)
            })
        }
    })
}
