//! What a layout made of a surface, as streams.

use super::convention::{TREE_CONVENTION_GLTF, convention_number, tree_convention};
use super::pack::{TREE_LAYOUT_VERTEX, tree_layout};
use super::pivots::Pivots;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PANIC, Versioned, call, free, get, tree_status, tree_str,
    write,
};
use crate::mesh::column;
use ::tree_mesh::pack::speedtree9::StretchLimits;
use ::tree_mesh::pack::vertex::PackedSurface;
use ::tree_mesh::pack::{Data, Indices, Packed, Stream};
use std::ffi::c_void;

/// A surface in the axes and the layout of an engine.
pub struct tree_packed {
    pub(super) layout: tree_layout,
    pub(super) content: Content,
    space: tree_convention,
    limits: StretchLimits,
    pub(super) pivots: Option<Pivots>,
    streams: Vec<tree_stream>,
}

pub(super) enum Content {
    Streams(Packed),
    Vertices(PackedSurface),
}

// SAFETY: `streams` points into `content`, which nothing changes.
unsafe impl Send for tree_packed {}
// SAFETY: as above.
unsafe impl Sync for tree_packed {}

impl Handle for tree_packed {
    const NAME: &'static str = "tree_packed";
}

impl tree_packed {
    pub(super) fn streams(layout: tree_layout, packed: Packed) -> Result<Self> {
        Ok(Self {
            layout,
            space: convention_number(packed.space)?,
            limits: StretchLimits::default(),
            pivots: None,
            streams: packed.streams.iter().map(tree_stream::of).collect::<Result<_>>()?,
            content: Content::Streams(packed),
        })
    }

    pub(super) fn vertices(packed: PackedSurface) -> Self {
        Self {
            layout: TREE_LAYOUT_VERTEX,
            space: TREE_CONVENTION_GLTF,
            limits: StretchLimits::default(),
            pivots: None,
            streams: Vec::new(),
            content: Content::Vertices(packed),
        }
    }

    pub(super) fn with_limits(self, limits: StretchLimits) -> Self {
        Self { limits, ..self }
    }

    pub(super) fn with_pivots(self, pivots: Pivots) -> Self {
        Self { pivots: Some(pivots), ..self }
    }

    fn view(&self) -> tree_packed_columns {
        let (indices, n_vertices, vertex_bytes) = match &self.content {
            Content::Streams(packed) => {
                (&packed.indices, packed.n_vertices(), packed.vertex_bytes())
            }
            Content::Vertices(packed) => {
                let row = size_of::<super::tree_packed_vertex>();
                (&packed.indices, packed.vertices.len(), row)
            }
        };
        tree_packed_columns {
            layout: self.layout,
            convention: self.space,
            n_vertices,
            vertex_bytes,
            streams: column(&self.streams),
            n_streams: self.streams.len(),
            indices: column(indices.bytes()).cast(),
            n_indices: indices.len(),
            index_bytes: match indices {
                Indices::U16(_) => 2,
                Indices::U32(_) => 4,
            },
            stretch_limits: [self.limits.branch1, self.limits.branch2],
            ..tree_packed_columns::default_value()
        }
    }
}

/// What the numbers of a stream are: one of the `TREE_NUMBER_` constants.
pub type tree_number = u32;

/// 32-bit floats.
pub const TREE_NUMBER_F32: u32 = 0;
/// 16-bit floats.
pub const TREE_NUMBER_F16: u32 = 1;
/// Whole numbers of 16 bits, without sign.
pub const TREE_NUMBER_U16: u32 = 2;
/// Bytes that stand for 0 to 1.
pub const TREE_NUMBER_UNORM8: u32 = 3;

/// One attribute of all vertices. Rows of an array; the array belongs to a `tree_packed`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_stream {
    /// The engine's name for it.
    pub name: tree_str,
    /// `components` numbers for each vertex, tightly packed, in the machine's order of bytes.
    pub data: *const c_void,
    /// Number of bytes.
    pub n_bytes: usize,
    /// Numbers of one vertex, 1 to 4.
    pub components: u32,
    /// What the numbers are.
    pub number: tree_number,
}

impl tree_stream {
    fn of(stream: &Stream) -> Result<Self> {
        let number = match &stream.data {
            Data::F32(_) => TREE_NUMBER_F32,
            Data::F16(_) => TREE_NUMBER_F16,
            Data::U16(_) => TREE_NUMBER_U16,
            Data::Unorm8(_) => TREE_NUMBER_UNORM8,
            _ => {
                let text = format!("stream {} has no TREE_NUMBER_ constant", stream.name);
                return Err(Failure::new(TREE_ERROR_PANIC, text));
            }
        };
        let bytes = stream.data.bytes();
        Ok(Self {
            name: tree_str::of(stream.name),
            data: column(bytes).cast(),
            n_bytes: bytes.len(),
            components: stream.components as u32,
            number,
        })
    }
}

/// A view of a `tree_packed`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_packed_columns {
    /// `sizeof(tree_packed_columns)`.
    pub struct_size: usize,
    /// The layout.
    pub layout: tree_layout,
    /// Whose axes the numbers are in.
    pub convention: tree_convention,
    /// Number of vertices.
    pub n_vertices: usize,
    /// Bytes of one vertex, all streams together.
    pub vertex_bytes: usize,
    /// The attributes, each with a row for every vertex. None for `TREE_LAYOUT_VERTEX`.
    pub streams: *const tree_stream,
    /// Number of streams.
    pub n_streams: usize,
    /// Three for each triangle, wound as the engine has its front faces: `uint16_t` or `uint32_t`.
    pub indices: *const c_void,
    /// Number of indices.
    pub n_indices: usize,
    /// Bytes of one index: 2 for at most 65,535 vertices, so that no index is 0xFFFF, or 4.
    pub index_bytes: u32,
    /// `TREE_LAYOUT_SPEEDTREE9`: `_ST_BranchStretchLimits`, the longest free lengths of branches 1 and 2
    /// in metres, the same for all surfaces of a mesh. Else 0.
    pub stretch_limits: [f32; 2],
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_packed_columns {
    const NAME: &'static str = "tree_packed_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            layout: TREE_LAYOUT_VERTEX,
            convention: TREE_CONVENTION_GLTF,
            n_vertices: 0,
            vertex_bytes: 0,
            streams: std::ptr::null(),
            n_streams: 0,
            indices: std::ptr::null(),
            n_indices: 0,
            index_bytes: 0,
            stretch_limits: [0.0; 2],
            reserved: 0,
        }
    }
}

/// Views streams and indices. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_packed_view(
    packed: *const tree_packed,
    columns: *mut tree_packed_columns,
) -> tree_status {
    call(|| {
        let packed = unsafe { get(packed, "packed") }?;
        unsafe { write(columns, "columns", &packed.view()) }
    })
}

/// Frees a packed surface, and with it all views of it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_packed_free(packed: *mut tree_packed) -> tree_status {
    call(|| unsafe { free(packed, "packed") })
}
