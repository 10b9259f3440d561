//! Draw arguments into the caller's buffers.

use super::select::{scene, state, tree_scene, tree_scene_state};
use super::take::buffer;
use crate::border::{Failure, Result, call, out_value, tree_status};
use bytemuck::{Pod, Zeroable};
use tree_lod::select::{DrawIndexed, InstanceLod, Written};

/// Arguments of an indexed indirect draw, laid out as Vulkan, Direct3D 12, WebGPU and Metal take them.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_draw_indexed {
    /// Number of indices.
    pub index_count: u32,
    /// Number of instances, never 0.
    pub instance_count: u32,
    /// First index.
    pub first_index: u32,
    /// Added to each index.
    pub base_vertex: i32,
    /// Row of the first instance in the buffer of `tree_instance_lod`.
    pub first_instance: u32,
}

/// How an instance is drawn in this frame, 20 bytes: for a storage buffer that vertex shaders read.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct tree_instance_lod {
    /// Number of the instance in the scene.
    pub instance: u32,
    /// Factor on the *length* of each element about its centre.
    pub scale: f32,
    /// Share of the foliage's triangles, 0 to 1. It moves smoothly; the window drawn holds at least as much.
    pub lambda: f32,
    /// Width in lambda of the end of the order that is fading: an element of rank u (0 first, 1 last) has the size
    /// `clamp((lambda - u) / fade, 0, 1)`. 0 where nothing fades: the full model.
    pub fade: f32,
    /// Factor on the contrast of colours that keeps its variance in the picture (Cook et al. 2007).
    pub contrast: f32,
}

// The callers' buffers are written as they are: both layouts are one.
const _: () = {
    use std::mem::offset_of;
    macro_rules! same {
        ($c:ty, $rust:ty, $($field:ident),+) => {
            assert!(size_of::<$c>() == size_of::<$rust>());
            assert!(align_of::<$c>() == align_of::<$rust>());
            $(assert!(offset_of!($c, $field) == offset_of!($rust, $field));)+
        };
    }
    same!(
        tree_draw_indexed,
        DrawIndexed,
        index_count,
        instance_count,
        first_index,
        base_vertex,
        first_instance
    );
    same!(tree_instance_lod, InstanceLod, instance, scale, lambda, fade, contrast);
};

/// Writes a draw for each part of each instance in view, and a row for each instance: for multi-draw indirect. Draws
/// of an instance follow one another; parts without indices are left out. `draws` and `rows` have room for
/// `draws_capacity` and `rows_capacity` of them; `tree_scene_measure` says how many always suffice. `n_draws` and
/// `n_rows` say how many were written. It takes no memory.
///
/// `TREE_ERROR_BUFFER` when a buffer is too small; its text says how many are needed, and nothing is written then.
/// Buffers may be mapped memory of a graphics processor: they are written once, in order, and not read.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_state_draws(
    state: *const tree_scene_state,
    scene: *const tree_scene,
    draws: *mut tree_draw_indexed,
    draws_capacity: usize,
    rows: *mut tree_instance_lod,
    rows_capacity: usize,
    n_draws: *mut usize,
    n_rows: *mut usize,
) -> tree_status {
    call(|| {
        let state = unsafe { self::state(state) }?;
        let scene = unsafe { self::scene(scene) }?;
        let draws = unsafe { buffer::<DrawIndexed>(draws.cast(), draws_capacity, "draws") }?;
        let rows = unsafe { buffer::<InstanceLod>(rows.cast(), rows_capacity, "rows") }?;
        unsafe { foresee_counts(n_draws, n_rows) }?;
        let written = scene.draws(&state, draws, rows)?;
        unsafe { tell(&written, n_draws, n_rows) }
    })
}

/// As `tree_scene_state_draws`, with one draw for each part of all instances of the same model at the same level: fewer
/// draws, of many instances each. Rows are not written in order.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_state_batches(
    state: *mut tree_scene_state,
    scene: *const tree_scene,
    draws: *mut tree_draw_indexed,
    draws_capacity: usize,
    rows: *mut tree_instance_lod,
    rows_capacity: usize,
    n_draws: *mut usize,
    n_rows: *mut usize,
) -> tree_status {
    call(|| {
        let mut state = unsafe { self::state(state.cast_const()) }?;
        let scene = unsafe { self::scene(scene) }?;
        let draws = unsafe { buffer::<DrawIndexed>(draws.cast(), draws_capacity, "draws") }?;
        let rows = unsafe { buffer::<InstanceLod>(rows.cast(), rows_capacity, "rows") }?;
        unsafe { foresee_counts(n_draws, n_rows) }?;
        let written = scene.batches(&mut state, draws, rows)?;
        unsafe { tell(&written, n_draws, n_rows) }
    })
}

/// Both places are looked at before anything is written.
unsafe fn foresee_counts(n_draws: *mut usize, n_rows: *mut usize) -> Result<()> {
    if n_draws.is_null() || n_rows.is_null() {
        return Err(Failure::null(if n_draws.is_null() { "n_draws" } else { "n_rows" }));
    }
    Ok(())
}

unsafe fn tell(written: &Written, n_draws: *mut usize, n_rows: *mut usize) -> Result<()> {
    unsafe { out_value(n_draws, written.draws, "n_draws") }?;
    unsafe { out_value(n_rows, written.instances, "n_rows") }
}
