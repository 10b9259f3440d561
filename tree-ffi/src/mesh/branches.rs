//! The branches that vertices move with in the wind.

use super::{column, tree_mesh};
use crate::border::{call, get, out_value, tree_status};
use ::tree_mesh::wind::Branch;
use std::mem::offset_of;

/// A branch as the wind sees it: a rod that turns about its pivot, carried by its parent. Has no
/// `struct_size`: it is a row of a table, and never changes.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub struct tree_wind_branch {
    /// The branch that carries this one; itself for the trunk. Parents come first.
    pub parent: u32,
    /// 0 for the trunk, one more than the parent otherwise.
    pub level: u32,
    /// Where it is attached: the point it turns about, in metres.
    pub pivot: [f32; 3],
    /// Unit vector from pivot to tip.
    pub axis: [f32; 3],
    /// Length along its bends in metres.
    pub length: f32,
    /// Radius at the base in metres.
    pub radius: f32,
    /// Distance from the pivot, in metres, up to which wood moves with the parent.
    pub collar: f32,
    /// Where in the swing it starts, 0 to 1: so that branches do not move in step.
    pub phase: f32,
    /// 1 does not give at all, 0 hangs in the wind: 1 / (1 + (length / radius / 100)³).
    pub stiffness: f32,
}

// The two are one in memory.
const _: () = {
    assert!(size_of::<tree_wind_branch>() == size_of::<Branch>());
    assert!(align_of::<tree_wind_branch>() == align_of::<Branch>());
    assert!(offset_of!(tree_wind_branch, parent) == offset_of!(Branch, parent));
    assert!(offset_of!(tree_wind_branch, level) == offset_of!(Branch, level));
    assert!(offset_of!(tree_wind_branch, pivot) == offset_of!(Branch, pivot));
    assert!(offset_of!(tree_wind_branch, axis) == offset_of!(Branch, axis));
    assert!(offset_of!(tree_wind_branch, length) == offset_of!(Branch, length));
    assert!(offset_of!(tree_wind_branch, radius) == offset_of!(Branch, radius));
    assert!(offset_of!(tree_wind_branch, collar) == offset_of!(Branch, collar));
    assert!(offset_of!(tree_wind_branch, phase) == offset_of!(Branch, phase));
    assert!(offset_of!(tree_wind_branch, stiffness) == offset_of!(Branch, stiffness));
};

/// Views the branches that a mesh's vertices move with, parents first: where they begin, NULL for none,
/// and how many there are. Valid until the mesh is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_branches(
    mesh: *const tree_mesh,
    branches: *mut *const tree_wind_branch,
    n_branches: *mut usize,
) -> tree_status {
    call(|| {
        let rows = &unsafe { get(mesh, "mesh") }?.rust().branches;
        unsafe { out_value(branches, column(rows).cast(), "branches") }?;
        unsafe { out_value(n_branches, rows.len(), "n_branches") }
    })
}
