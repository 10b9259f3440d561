//! Meshes with levels in glTF 2.0.

use super::mesh::tree_multi_mesh;
use super::stream::save;
use crate::border::{self, Result, call, get, out, slice, tree_status};
use crate::control::{run, tree_control};
use crate::io::{read_options, tree_bytes, tree_glb_options};
use crate::mesh::ask_for_copies;
use bytemuck::{Pod, Zeroable};
use std::ffi::c_char;
use tree_lod::LodError;
use tree_lod::multires::MultiMesh;
use tree_lod::tree_mesh::io::gltf::GlbOptions;
use tree_model::tree_core::{Limits, Resource};

/// More levels than are sensible in a file.
const MAX_LEVELS: u64 = 1 << 10;

/// A level in a file, and when it is shown.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_level_share {
    /// The level, as in `tree_multi_mesh_mesh_at`.
    pub level: f32,
    /// Share of the screen's height, 0 to 1, from which on it is shown.
    pub share: f32,
}

/// What a file has, when the memory for it is there.
unsafe fn file(
    multi_mesh: *const tree_multi_mesh,
    options: *const tree_glb_options,
    control: *const tree_control,
    times: u64,
    write: impl FnOnce(&MultiMesh, &GlbOptions) -> std::result::Result<Vec<u8>, LodError> + Send,
) -> Result<Vec<u8>> {
    let multi = unsafe { get(multi_mesh, "multi_mesh") }?.rust();
    let options = unsafe { read_options(options) }?;
    unsafe {
        run(control, |control| {
            control.check()?;
            ask_for_copies([multi.mesh()], 3 * times)?;
            Ok(write(multi, &options)?)
        })
    }
}

unsafe fn levels_file(
    multi_mesh: *const tree_multi_mesh,
    levels: *const tree_level_share,
    n_levels: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
) -> Result<Vec<u8>> {
    let limits = Limits { nodes: MAX_LEVELS, ..Limits::default() };
    let levels = unsafe { slice(levels, n_levels, &limits, Resource::Nodes, "levels") }?;
    let rows: Vec<_> = levels.iter().map(|row| (row.level, row.share)).collect();
    let write = |multi: &MultiMesh, options: &_| multi.to_glb_levels(&rows, options);
    unsafe { file(multi_mesh, options, control, rows.len() as u64, write) }
}

/// A mesh with all its levels as a GLB file in memory, for engines that draw prefixes: an attribute `_TREE_BRANCH` of 4
/// floats a vertex, as in `tree_multi_mesh_column`, is what lets branches grow in. Other programs show the whole tree.
/// `options` and `control` may be NULL, as in `tree_mesh_write_glb`. Free the bytes with `tree_bytes_free`.
/// `TREE_ERROR_PARAMETER` for `quantize`: shaders need positions in metres.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_to_glb(
    multi_mesh: *const tree_multi_mesh,
    options: *const tree_glb_options,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let made = unsafe { file(multi_mesh, options, control, 1, MultiMesh::to_glb) }?;
        place.put(tree_bytes::new(made));
        Ok(())
    })
}

/// As `tree_multi_mesh_to_glb`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_write_glb(
    multi_mesh: *const tree_multi_mesh,
    path: *const c_char,
    path_len: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let path = unsafe { border::path(path, path_len, "path") }?;
        save(path, &unsafe { file(multi_mesh, options, control, 1, MultiMesh::to_glb) }?)
    })
}

/// Levels, at most 1024 of them, as the `MSFT_lod` of one GLB file, each a mesh of its own: for programs without shaders
/// of ours. Both levels and shares fall. `options` and `control` may be NULL, as in `tree_mesh_write_glb`. Free the
/// bytes with `tree_bytes_free`. `TREE_ERROR_INVALID` when there are no levels, or levels or shares do not fall.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_to_glb_levels(
    multi_mesh: *const tree_multi_mesh,
    levels: *const tree_level_share,
    n_levels: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let made = unsafe { levels_file(multi_mesh, levels, n_levels, options, control) }?;
        place.put(tree_bytes::new(made));
        Ok(())
    })
}

/// As `tree_multi_mesh_to_glb_levels`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_write_glb_levels(
    multi_mesh: *const tree_multi_mesh,
    levels: *const tree_level_share,
    n_levels: usize,
    path: *const c_char,
    path_len: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let path = unsafe { border::path(path, path_len, "path") }?;
        save(path, &unsafe { levels_file(multi_mesh, levels, n_levels, options, control) }?)
    })
}
