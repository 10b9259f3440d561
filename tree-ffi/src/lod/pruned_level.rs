//! What is drawn for a lambda.

use super::pruned::tree_pruned;
use super::take::{few, fill_some, room_for};
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, call, get, out, out_value, tree_status,
};
use crate::control::{run, tree_control};
use crate::io::tree_bytes;
use crate::mesh::{ask_for_copies, tree_mesh};
use bytemuck::{Pod, Zeroable};
use tree_lod::prune::{Level, Window};

/// Most levels of a list, and most windows of a level; beyond what a model has.
const MAX_LEVELS: usize = 1 << 16;
const WINDOWS_MAX: usize = 1 << 24;

/// What is drawn for a lambda, and the numbers that the shader needs. Its windows stand in an array of their own.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_lod_level {
    /// Share of the foliage's triangles, more than 0, at most 1. No less than what one element needs.
    pub lambda: f32,
    /// Factor on the area of each element.
    pub scale: f32,
    /// Factor on its lengths: the square root of `scale`.
    pub growth: f32,
    /// Factor on the contrast of colours, more than 0, at most 1.
    pub contrast: f32,
    /// Width in lambda over which the last elements fade; 0 where all are drawn.
    pub fade: f32,
    /// 0.
    pub reserved: u32,
    /// Triangles of the foliage that are drawn.
    pub n_triangles: u64,
}

/// A piece of a surface's index buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_lod_window {
    /// Number of the surface.
    pub surface: u32,
    /// First index.
    pub first_index: u32,
    /// Number of indices; may be 0.
    pub index_count: u32,
}

impl tree_lod_level {
    fn of(level: &Level) -> Self {
        Self {
            lambda: level.lambda,
            scale: level.scale,
            growth: level.growth,
            contrast: level.contrast,
            fade: level.fade,
            reserved: 0,
            n_triangles: level.n_triangles,
        }
    }

    fn rust(&self, windows: &[tree_lod_window]) -> Level {
        Level {
            lambda: self.lambda,
            scale: self.scale,
            growth: self.growth,
            contrast: self.contrast,
            fade: self.fade,
            windows: windows.iter().map(tree_lod_window::rust).collect(),
            n_triangles: self.n_triangles,
        }
    }
}

impl tree_lod_window {
    fn of(window: &Window) -> Self {
        let Window { surface, first_index, index_count } = *window;
        Self { surface, first_index, index_count }
    }

    fn rust(&self) -> Window {
        let Self { surface, first_index, index_count } = *self;
        Window { surface, first_index, index_count }
    }
}

/// What is drawn for `lambda`, 0 to 1: at most so much of the full foliage, but at least one element. `windows` has
/// room for `capacity` of them, at least `n_parts` of `tree_pruned_measure`: one for each part, in their order. It is
/// quick enough for every frame.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_level(
    pruned: *const tree_pruned,
    lambda: f32,
    level: *mut tree_lod_level,
    windows: *mut tree_lod_window,
    capacity: usize,
) -> tree_status {
    call(|| {
        let model = unsafe { get(pruned, "pruned") }?.rust();
        let found = model.level(lambda)?;
        if level.is_null() {
            return Err(Failure::null("level"));
        }
        unsafe { fill_windows(windows, capacity, std::slice::from_ref(&found)) }?;
        unsafe { out_value(level, tree_lod_level::of(&found), "level") }
    })
}

/// `n` levels, 2 to 1024, with rising lambda: from the first of the table to the full model, in equal ratios. `levels`
/// has room for `levels_capacity` of them, at least `n`; `windows` for `windows_capacity`, at least `n` times the
/// parts: those of the first level, then those of the next. `n_levels` says how many there are: fewer than `n` where
/// the table begins at 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_levels(
    pruned: *const tree_pruned,
    n: usize,
    levels: *mut tree_lod_level,
    levels_capacity: usize,
    windows: *mut tree_lod_window,
    windows_capacity: usize,
    n_levels: *mut usize,
) -> tree_status {
    call(|| {
        let model = unsafe { get(pruned, "pruned") }?.rust();
        let found = model.levels(n)?;
        room_for(found.len(), levels_capacity, "levels")?;
        if n_levels.is_null() || levels.is_null() {
            return Err(Failure::null(if levels.is_null() { "levels" } else { "n_levels" }));
        }
        unsafe { fill_windows(windows, windows_capacity, &found) }?;
        let rows: Vec<_> = found.iter().map(tree_lod_level::of).collect();
        unsafe { fill_some(levels, levels_capacity, &rows, "levels") }?;
        unsafe { out_value(n_levels, rows.len(), "n_levels") }
    })
}

unsafe fn fill_windows(
    windows: *mut tree_lod_window,
    capacity: usize,
    levels: &[Level],
) -> Result<()> {
    let rows = levels.iter().flat_map(|level| &level.windows).map(tree_lod_window::of);
    unsafe { fill_some(windows, capacity, &rows.collect::<Vec<_>>(), "windows") }
}

/// The level for `lambda`, 0 to 1, as a plain mesh, wood included: elements scaled as the shader does, what is not
/// drawn left out. Nothing fades in it. Free it with `tree_mesh_free`. `control` may be NULL; of it only threads
/// matter, and a cancellation before the work begins.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_mesh_at(
    pruned: *const tree_pruned,
    lambda: f32,
    control: *const tree_control,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let model = unsafe { get(pruned, "pruned") }?.rust();
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([model.mesh()], 1)?;
                Ok(model.mesh_at(lambda)?)
            })
        }?;
        place.put(tree_mesh::new(made));
        Ok(())
    })
}

/// As `tree_pruned_mesh_at`, for a level with its `n_windows` windows, which may fade. `TREE_ERROR_INVALID` when
/// they are of another model.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_mesh_of(
    pruned: *const tree_pruned,
    level: *const tree_lod_level,
    windows: *const tree_lod_window,
    n_windows: usize,
    control: *const tree_control,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let model = unsafe { get(pruned, "pruned") }?.rust();
        let levels = unsafe { levels(level, 1, windows, n_windows, n_windows) }?;
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask_for_copies([model.mesh()], 1)?;
                let [level] = &levels[..] else { return Err(Failure::null("level")) };
                Ok(model.mesh_of(level)?)
            })
        }?;
        place.put(tree_mesh::new(made));
        Ok(())
    })
}

/// A caller's levels, each with `parts` windows.
unsafe fn levels(
    levels: *const tree_lod_level,
    n_levels: usize,
    windows: *const tree_lod_window,
    n_windows: usize,
    parts: usize,
) -> Result<Vec<Level>> {
    let levels = unsafe { few(levels, n_levels, MAX_LEVELS, "levels") }?;
    let windows = unsafe { few(windows, n_windows, WINDOWS_MAX, "windows") }?;
    if levels.len().checked_mul(parts) != Some(windows.len()) {
        let text = format!(
            "n_windows is {n_windows}, but {n_levels} levels of {parts} parts have {}",
            levels.len().saturating_mul(parts)
        );
        return Err(Failure::new(TREE_ERROR_PARAMETER, text));
    }
    let of = |i: usize| windows.get(i * parts..(i + 1) * parts).unwrap_or(&[]);
    Ok(levels.iter().enumerate().map(|(i, level)| level.rust(of(i))).collect())
}

/// Levels as JSON, to be stored beside the mesh: counts, the surface and colour of each part, the table, and for
/// each level its numbers and windows. `levels` and `windows` as `tree_pruned_levels` writes them. Free the bytes,
/// which are UTF-8, with `tree_bytes_free`. `TREE_ERROR_PARAMETER` when there are not as many windows as levels
/// times parts.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pruned_to_json(
    pruned: *const tree_pruned,
    levels: *const tree_lod_level,
    n_levels: usize,
    windows: *const tree_lod_window,
    n_windows: usize,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let model = unsafe { get(pruned, "pruned") }?.rust();
        let parts = model.parts().len();
        let levels = unsafe { self::levels(levels, n_levels, windows, n_windows, parts) }?;
        place.put(tree_bytes::new(model.to_json(&levels).into_bytes()));
        Ok(())
    })
}
