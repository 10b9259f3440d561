//! Pruned models in glTF 2.0.

use super::distance::tree_lod_distance;
use super::pruned::tree_pruned;
use super::take::few;
use crate::border::{
    self, Result, Versioned, call, get, init, out, out_value, read, read_or_default, tree_status,
};
use crate::control::{run, tree_control};
use crate::io::{read_options, tree_bytes, tree_glb_options};
use crate::mesh::ask_for_copies;
use std::ffi::c_char;
use std::ptr::null;
use tree_lod::prune::Screen;
use tree_lod::quality::Distance;

/// More levels than are sensible in a file.
const MAX_LEVELS: usize = 1 << 10;

/// When levels in a file change. Begin with `tree_lod_screen_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_lod_screen {
    /// `sizeof(tree_lod_screen)`.
    pub struct_size: usize,
    /// Lambda for each distance, 0 at `near` and 1 at `far`. NULL, the default: that of `tree_lod_distance_cook`.
    pub distance: *const tree_lod_distance,
    /// Distance in metres up to which the full model is wanted, in a field of view of 60 degrees, 0 or more.
    /// Default 10.
    pub near: f32,
    /// Distance from which on the least will do, more than `near`, at most 1e9. Default 500.
    pub far: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_lod_screen {
    const NAME: &'static str = "tree_lod_screen";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let Screen { near, far, .. } = Screen::default();
        Self { struct_size: size_of::<Self>(), distance: null(), near, far }
    }
}

impl tree_lod_screen {
    unsafe fn rust(&self) -> Result<Screen> {
        let distance = match self.distance.is_null() {
            true => Distance::cook(),
            false => unsafe { tree_lod_distance::read(self.distance, "screen.distance") }?,
        };
        Ok(Screen { distance, near: self.near, far: self.far })
    }

    /// The default for NULL.
    unsafe fn read(screen: *const Self) -> Result<Screen> {
        unsafe { read_or_default(screen, "screen")?.rust() }
    }
}

/// Makes `screen`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_screen_init(
    screen: *mut tree_lod_screen,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(screen, size) })
}

/// Checks every field of `screen`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_screen_check(screen: *const tree_lod_screen) -> tree_status {
    call(|| Ok(unsafe { read(screen, "screen")?.rust() }?.validate()?))
}

/// Share of the screen's height, 0 to 1, that something of `size` metres has where lambda has fallen to `lambda`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lod_screen_coverage(
    screen: *const tree_lod_screen,
    lambda: f32,
    size: f32,
    coverage: *mut f32,
) -> tree_status {
    call(|| {
        let found = unsafe { read(screen, "screen")?.rust() }?.coverage(lambda, size)?;
        unsafe { out_value(coverage, found, "coverage") }
    })
}

/// A model as a GLB file in memory, for engines that draw windows: foliage with all tiers in its index buffers, and an
/// attribute `_TREE_CENTER` of 4 floats a vertex, as in `tree_pruned_part`. The levels go beside it, as
/// `tree_pruned_to_json`. Programs that draw all of it draw leaves several times. `options` and `control` may be NULL,
/// as in `tree_mesh_write_glb`. Free the bytes with `tree_bytes_free`. `TREE_ERROR_PARAMETER` for `quantize`: shaders
/// need positions in metres.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_to_glb(
    pruned: *const tree_pruned,
    options: *const tree_glb_options,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let model = unsafe { get(pruned, "pruned") }?.rust();
        let options = unsafe { read_options(options) }?;
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([model.mesh()], 3)?;
                Ok(model.to_glb(&options)?)
            })
        }?;
        place.put(tree_bytes::new(made));
        Ok(())
    })
}

/// As `tree_pruned_to_glb`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_write_glb(
    pruned: *const tree_pruned,
    path: *const c_char,
    path_len: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let model = unsafe { get(pruned, "pruned") }?.rust();
        let path = unsafe { border::path(path, path_len, "path") }?;
        let options = unsafe { read_options(options) }?;
        unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([model.mesh()], 3)?;
                Ok(model.write_glb(path, &options)?)
            })
        }
    })
}

/// Levels for `n_lambdas` falling lambdas, each 0 to 1 and at most 1024 of them, as the `MSFT_lod` of one GLB file,
/// each a mesh of its own: for programs without shaders of ours. A level is shown until the lambda of the distance
/// has fallen to that of the next one; the last is shown to the end. `screen`, `options` and `control` may be NULL.
/// Free the bytes with `tree_bytes_free`. `TREE_ERROR_INVALID` when there are no lambdas or they do not fall.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_to_glb_levels(
    pruned: *const tree_pruned,
    lambdas: *const f32,
    n_lambdas: usize,
    screen: *const tree_lod_screen,
    options: *const tree_glb_options,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let model = unsafe { get(pruned, "pruned") }?.rust();
        let lambdas = unsafe { few(lambdas, n_lambdas, MAX_LEVELS, "lambdas") }?;
        let screen = unsafe { tree_lod_screen::read(screen) }?;
        let options = unsafe { read_options(options) }?;
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([model.mesh()], 3 * lambdas.len() as u64)?;
                Ok(model.to_glb_levels(lambdas, &screen, &options)?)
            })
        }?;
        place.put(tree_bytes::new(made));
        Ok(())
    })
}

/// As `tree_pruned_to_glb_levels`, into a file, whole or not at all; the path as in `tree_mesh_write_glb`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_write_glb_levels(
    pruned: *const tree_pruned,
    lambdas: *const f32,
    n_lambdas: usize,
    screen: *const tree_lod_screen,
    path: *const c_char,
    path_len: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let model = unsafe { get(pruned, "pruned") }?.rust();
        let lambdas = unsafe { few(lambdas, n_lambdas, MAX_LEVELS, "lambdas") }?;
        let screen = unsafe { tree_lod_screen::read(screen) }?;
        let path = unsafe { border::path(path, path_len, "path") }?;
        let options = unsafe { read_options(options) }?;
        unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([model.mesh()], 3 * lambdas.len() as u64)?;
                Ok(model.write_glb_levels(lambdas, &screen, path, &options)?)
            })
        }
    })
}
