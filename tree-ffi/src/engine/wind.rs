//! Wind: what each vertex does in it, and vertices moved by it.

use crate::border::{
    Failure, TREE_ERROR_PARAMETER, Versioned, call, fill, get, init, out_value, read_or_default,
    tree_status,
};
use crate::mesh::tree_mesh;
use ::tree_mesh::wind::{self, VertexWind, Wind};
use std::mem::offset_of;

/// A vertex in the wind. All but the anchor lie within 0 to 1.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_vertex_wind {
    /// The branch it moves with, in the mesh's table; 0 when the mesh has none.
    pub branch: u32,
    /// How far along the branch it lies; leaves as far as the place they are attached.
    pub reach: f32,
    /// Leaves: how far from the anchor, 0 there and 1 at the leaf's farthest vertex. 0 for wood.
    pub flutter: f32,
    /// Leaves: where in its flutter the leaf starts. 0 for wood.
    pub leaf_phase: f32,
    /// Leaves: where the leaf is attached. Wood: the vertex itself.
    pub anchor: [f32; 3],
}

// One is copied as the other.
const _: () = {
    assert!(size_of::<tree_vertex_wind>() == size_of::<VertexWind>());
    assert!(align_of::<tree_vertex_wind>() == align_of::<VertexWind>());
    assert!(offset_of!(tree_vertex_wind, branch) == offset_of!(VertexWind, branch));
    assert!(offset_of!(tree_vertex_wind, reach) == offset_of!(VertexWind, reach));
    assert!(offset_of!(tree_vertex_wind, flutter) == offset_of!(VertexWind, flutter));
    assert!(offset_of!(tree_vertex_wind, leaf_phase) == offset_of!(VertexWind, leaf_phase));
    assert!(offset_of!(tree_vertex_wind, anchor) == offset_of!(VertexWind, anchor));
};

/// Writes a row for each vertex of a surface; `capacity` must be the number of its vertices or more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_wind(
    mesh: *const tree_mesh,
    surface: usize,
    rows: *mut tree_vertex_wind,
    capacity: usize,
) -> tree_status {
    call(|| {
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let found = wind::vertices(mesh, surface)?;
        unsafe { fill(rows.cast(), capacity, &found, "rows") }
    })
}

/// A steady wind with gusts. Begin with `tree_wind_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_wind {
    /// `sizeof(tree_wind)`.
    pub struct_size: usize,
    /// Where it blows to; its length does not matter. Each -1e6 to 1e6; default 1, 0, 0.
    pub direction: [f32; 3],
    /// Turn of a branch without any stiffness, in radians, -10 to 10. Default 0.5.
    pub strength: f32,
    /// Share of the turn that swings to and fro, 0 to 1. Default 0.4.
    pub gusts: f32,
    /// Swings in a second, 0 to 100. Default 0.5.
    pub frequency: f32,
    /// How far leaves turn to and fro at their anchors, in radians, -10 to 10. Default 0.3.
    pub flutter: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_wind {
    const NAME: &'static str = "tree_wind";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let default = Wind::default();
        Self {
            struct_size: size_of::<Self>(),
            direction: default.direction.to_array(),
            strength: default.strength,
            gusts: default.gusts,
            frequency: default.frequency,
            flutter: default.flutter,
            reserved: 0,
        }
    }
}

impl tree_wind {
    fn rust(&self) -> Wind {
        Wind {
            direction: self.direction.into(),
            strength: self.strength,
            gusts: self.gusts,
            frequency: self.frequency,
            flutter: self.flutter,
        }
    }
}

/// Makes `wind`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_wind_init(wind: *mut tree_wind, size: usize) -> tree_status {
    call(|| unsafe { init(wind, size) })
}

/// Moves a surface by the wind, `seconds` after it began: the reference for a vertex shader. Writes three
/// floats for each vertex, in metres; `capacity` is the room in floats, three times the number of
/// vertices or more. `wind` may be NULL. A vertex whose branch is unknown stays where it is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_bend(
    mesh: *const tree_mesh,
    wind: *const tree_wind,
    seconds: f32,
    surface: usize,
    positions: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let wind = unsafe { read_or_default(wind, "wind") }?.rust();
        wind.validate()?;
        if !seconds.is_finite() {
            return Err(Failure::new(TREE_ERROR_PARAMETER, format!("seconds is {seconds}")));
        }
        let moved = wind::bend_surface(mesh, &wind, seconds, surface)?;
        unsafe { fill(positions, capacity, bytemuck::cast_slice(&moved), "positions") }
    })
}

/// Share of its branch's turn that a point at this reach (0 to 1, else brought there) makes: 0 at the
/// collar, 1 at the tip, as a clamped beam under an even load.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_wind_sway(reach: f32, sway: *mut f32) -> tree_status {
    call(|| unsafe { out_value(sway, wind::sway(reach), "sway") })
}

/// Where in its flutter a leaf starts, 0 to 1, by its number in the surface.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_wind_leaf_phase(leaf: u32, phase: *mut f32) -> tree_status {
    call(|| unsafe { out_value(phase, wind::leaf_phase(leaf), "phase") })
}
