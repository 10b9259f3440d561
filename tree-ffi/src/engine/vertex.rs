//! A vertex of 32 bytes.

use super::packed::{Content, tree_packed};
use crate::border::{Failure, TREE_ERROR_INVALID, Versioned, call, get, tree_status, write};
use crate::mesh::column;
use ::tree_mesh::pack::vertex::{PackedSurface, PackedVertex};
use std::mem::offset_of;

/// A vertex of `TREE_LAYOUT_VERTEX`, in our axes. Errors are the largest, rounding of floats (1e-7 of the
/// largest coordinate) apart. Parent, pivot and axis of a branch stand in the mesh's table of branches,
/// to be uploaded as a buffer and read by the number of the branch.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_packed_vertex {
    /// Position: min + (max - min) * position / 65535 of the view's `bounds`. Error: extent / 131,070.
    pub position: [u16; 3],
    /// Angle about the normal in steps of a turn / 32768, and in the highest bit 1 for a negative sign:
    /// cos * x + sin * cross(n, x), where n is the normal as it is read back and x is (b, s + n.y * n.y *
    /// a, -n.y) with s the sign of n.z (1 or -1), a = -1 / (s + n.z) and b = n.x * n.y * a. Error: 3e-4
    /// radians.
    pub tangent: u16,
    /// Octahedral normal: x and y / 32767, z = 1 - |x| - |y|; where z is negative, x is (1 - |y|) and y
    /// (1 - |x|), each with its old sign; then brought to unit length. Error: 1e-4 radians.
    pub normal: [i16; 2],
    /// Texture coordinates over the view's `uv_range`, as positions. Error: range / 131,070.
    pub uv: [u16; 2],
    /// Light-map coordinates / 65535.
    pub uv2: [u16; 2],
    /// Number of the branch.
    pub branch: u32,
    /// How far along the branch / 65535.
    pub reach: u16,
    /// Ambient occlusion / 255.
    pub occlusion: u8,
    /// How far along the leaf / 255.
    pub flutter: u8,
    /// Phase of the branch / 255.
    pub phase: u8,
    /// Stiffness of the branch / 255.
    pub stiffness: u8,
    /// Level of the branch; 255 for more.
    pub level: u8,
    /// Phase of the leaf / 255.
    pub leaf_phase: u8,
}

// One is viewed as the other.
const _: () = {
    assert!(size_of::<tree_packed_vertex>() == size_of::<PackedVertex>());
    assert!(align_of::<tree_packed_vertex>() == align_of::<PackedVertex>());
    assert!(offset_of!(tree_packed_vertex, position) == offset_of!(PackedVertex, position));
    assert!(offset_of!(tree_packed_vertex, tangent) == offset_of!(PackedVertex, tangent));
    assert!(offset_of!(tree_packed_vertex, normal) == offset_of!(PackedVertex, normal));
    assert!(offset_of!(tree_packed_vertex, uv) == offset_of!(PackedVertex, uv));
    assert!(offset_of!(tree_packed_vertex, uv2) == offset_of!(PackedVertex, uv2));
    assert!(offset_of!(tree_packed_vertex, branch) == offset_of!(PackedVertex, branch));
    assert!(offset_of!(tree_packed_vertex, reach) == offset_of!(PackedVertex, reach));
    assert!(offset_of!(tree_packed_vertex, occlusion) == offset_of!(PackedVertex, occlusion));
    assert!(offset_of!(tree_packed_vertex, flutter) == offset_of!(PackedVertex, flutter));
    assert!(offset_of!(tree_packed_vertex, phase) == offset_of!(PackedVertex, phase));
    assert!(offset_of!(tree_packed_vertex, stiffness) == offset_of!(PackedVertex, stiffness));
    assert!(offset_of!(tree_packed_vertex, level) == offset_of!(PackedVertex, level));
    assert!(offset_of!(tree_packed_vertex, leaf_phase) == offset_of!(PackedVertex, leaf_phase));
};

/// The vertices of `TREE_LAYOUT_VERTEX`, and what a shader needs to read them.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_packed_vertices {
    /// `sizeof(tree_packed_vertices)`.
    pub struct_size: usize,
    /// The vertices.
    pub vertices: *const tree_packed_vertex,
    /// Number of vertices.
    pub n_vertices: usize,
    /// Three floats for each leaf: where it is attached, in metres. The leaf of vertex `i` is
    /// `i / (n_vertices / n_anchors)`.
    pub anchors: *const f32,
    /// Number of leaves; 0 for wood.
    pub n_anchors: usize,
    /// Box of the positions in metres: its lower corner, then its upper one.
    pub bounds: [f32; 6],
    /// Smallest, then largest texture coordinates.
    pub uv_range: [f32; 4],
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_packed_vertices {
    const NAME: &'static str = "tree_packed_vertices";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            vertices: std::ptr::null(),
            n_vertices: 0,
            anchors: std::ptr::null(),
            n_anchors: 0,
            bounds: [0.0; 6],
            uv_range: [0.0; 4],
        }
    }
}

impl tree_packed_vertices {
    fn of(packed: &PackedSurface) -> Self {
        let [a, b] = [packed.bounds.min, packed.bounds.max];
        let [low, high] = packed.uv_range;
        Self {
            struct_size: size_of::<Self>(),
            vertices: column(&packed.vertices).cast(),
            n_vertices: packed.vertices.len(),
            anchors: column(&packed.anchors).cast(),
            n_anchors: packed.anchors.len(),
            bounds: [a.x, a.y, a.z, b.x, b.y, b.z],
            uv_range: [low.x, low.y, high.x, high.y],
        }
    }
}

/// Views the vertices of a surface packed with `TREE_LAYOUT_VERTEX`; its indices are in
/// `tree_packed_view`. Set `vertices->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_packed_vertices_view(
    packed: *const tree_packed,
    vertices: *mut tree_packed_vertices,
) -> tree_status {
    call(|| match &unsafe { get(packed, "packed") }?.content {
        Content::Vertices(packed) => unsafe {
            write(vertices, "vertices", &tree_packed_vertices::of(packed))
        },
        Content::Streams(_) => {
            let text = "packed has streams and no vertices: TREE_LAYOUT_VERTEX has them";
            Err(Failure::new(TREE_ERROR_INVALID, text))
        }
    })
}
