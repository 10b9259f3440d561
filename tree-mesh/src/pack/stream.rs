//! Named columns of vertex data, and what is read back from them.

use super::Indices;
use super::half;
use crate::convert::Convention;
use glam::{Vec2, Vec3, Vec4};

/// Numbers of a stream, vertex after vertex.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Data {
    /// 32-bit floats.
    F32(Vec<f32>),
    /// 16-bit floats.
    F16(Vec<u16>),
    /// Whole numbers.
    U16(Vec<u16>),
    /// Bytes that stand for 0 to 1.
    Unorm8(Vec<u8>),
}

impl Data {
    /// Number of numbers.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::F32(data) => data.len(),
            Self::F16(data) | Self::U16(data) => data.len(),
            Self::Unorm8(data) => data.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Bytes of one number.
    #[must_use]
    pub const fn width(&self) -> usize {
        match self {
            Self::F32(_) => 4,
            Self::F16(_) | Self::U16(_) => 2,
            Self::Unorm8(_) => 1,
        }
    }

    /// The numbers as bytes, as an engine uploads them (in the machine's order of bytes).
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        match self {
            Self::F32(data) => bytemuck::cast_slice(data),
            Self::F16(data) | Self::U16(data) => bytemuck::cast_slice(data),
            Self::Unorm8(data) => data,
        }
    }

    /// One number, as a shader reads it; 0 where there is none.
    #[must_use]
    pub fn get(&self, index: usize) -> f32 {
        match self {
            Self::F32(data) => data.get(index).copied(),
            Self::F16(data) => data.get(index).map(|&bits| half::to_f32(bits)),
            Self::U16(data) => data.get(index).map(|&value| f32::from(value)),
            Self::Unorm8(data) => data.get(index).map(|&value| half::from_byte(value)),
        }
        .unwrap_or(0.0)
    }
}

/// One attribute of all vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct Stream {
    /// The engine's name for it.
    pub name: &'static str,
    /// Numbers of one vertex, 1 to 4.
    pub components: usize,
    /// `components` numbers for each vertex.
    pub data: Data,
}

impl Stream {
    pub(super) fn f32<const N: usize>(
        name: &'static str,
        rows: impl Iterator<Item = [f32; N]>,
    ) -> Self {
        Self { name, components: N, data: Data::F32(rows.flatten().collect()) }
    }

    pub(super) fn f16<const N: usize>(
        name: &'static str,
        rows: impl Iterator<Item = [f32; N]>,
    ) -> Self {
        Self { name, components: N, data: Data::F16(rows.flatten().map(half::from_f32).collect()) }
    }

    pub(super) fn unorm8(name: &'static str, rows: impl Iterator<Item = [f32; 4]>) -> Self {
        Self { name, components: 4, data: Data::Unorm8(rows.flatten().map(half::byte).collect()) }
    }

    /// The numbers of one vertex; what is missing is 0.
    #[must_use]
    pub fn row(&self, vertex: usize) -> Vec4 {
        let first = vertex.saturating_mul(self.components);
        let at = |i: usize| {
            if i < self.components { self.data.get(first.saturating_add(i)) } else { 0.0 }
        };
        Vec4::new(at(0), at(1), at(2), at(3))
    }

    /// Number of vertices.
    #[must_use]
    pub fn n_vertices(&self) -> usize {
        self.data.len().checked_div(self.components).unwrap_or(0)
    }
}

/// A surface in the axes and the layout of an engine.
#[derive(Clone, Debug, PartialEq)]
pub struct Packed {
    /// Whose axes the numbers are in.
    pub space: Convention,
    /// The attributes, each with a row for every vertex.
    pub streams: Vec<Stream>,
    /// Three for each triangle, wound as the engine has its front faces.
    pub indices: Indices,
}

impl Packed {
    /// The attribute of this name.
    #[must_use]
    pub fn stream(&self, name: &str) -> Option<&Stream> {
        self.streams.iter().find(|stream| stream.name == name)
    }

    /// Number of vertices.
    #[must_use]
    pub fn n_vertices(&self) -> usize {
        self.streams.first().map_or(0, Stream::n_vertices)
    }

    /// Bytes of one vertex, all attributes together.
    #[must_use]
    pub fn vertex_bytes(&self) -> usize {
        self.streams
            .iter()
            .map(|stream| stream.components.saturating_mul(stream.data.width()))
            .sum()
    }

    /// Every vertex's row of an attribute; nothing when there is no such attribute.
    pub(super) fn rows(&self, name: &str) -> impl Iterator<Item = Vec4> + '_ {
        let stream = self.stream(name);
        let count = stream.map_or(0, Stream::n_vertices);
        (0..count).map(move |vertex| stream.map_or(Vec4::ZERO, |stream| stream.row(vertex)))
    }

    /// The attributes that every layout has in common, back in our axes.
    pub(super) fn unpack_common(&self, uv: &str, uv2: &str) -> Unpacked {
        let space = self.space;
        Unpacked {
            positions: self.rows("POSITION").map(|p| space.position_back(p.truncate())).collect(),
            normals: self.rows("NORMAL").map(|n| space.direction_back(n.truncate())).collect(),
            tangents: self.rows("TANGENT").map(|t| space.tangent_back(t)).collect(),
            uvs: self.rows(uv).map(|uv| space.uv(Vec2::new(uv.x, uv.y))).collect(),
            uvs2: self.rows(uv2).map(|uv| space.uv(Vec2::new(uv.x, uv.y))).collect(),
            indices: self
                .indices
                .to_u32()
                .chunks_exact(3)
                .flat_map(|corners| space.triangle(corners.try_into().unwrap_or_default()))
                .collect(),
            ..Unpacked::default()
        }
    }
}

/// What a layout holds of each vertex, back in our axes, metres and winding. A column is empty when
/// the layout has no place for it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Unpacked {
    /// Positions in metres.
    pub positions: Vec<Vec3>,
    /// Normals.
    pub normals: Vec<Vec3>,
    /// Tangents, as in [`Surface::tangents`](crate::Surface::tangents).
    pub tangents: Vec<Vec4>,
    /// Texture coordinates.
    pub uvs: Vec<Vec2>,
    /// Light-map coordinates.
    pub uvs2: Vec<Vec2>,
    /// Three for each triangle.
    pub indices: Vec<u32>,
    /// Ambient occlusion.
    pub occlusion: Vec<f32>,
    /// The branch, its number in the table.
    pub branches: Vec<u32>,
    /// The branch that carries it.
    pub parents: Vec<u32>,
    /// Level of the branch.
    pub levels: Vec<u32>,
    /// Pivot of the branch.
    pub pivots: Vec<Vec3>,
    /// Axis of the branch.
    pub axes: Vec<Vec3>,
    /// Phase of the branch.
    pub phases: Vec<f32>,
    /// Stiffness of the branch.
    pub stiffness: Vec<f32>,
    /// How far along the branch.
    pub reach: Vec<f32>,
    /// How far along the leaf.
    pub flutter: Vec<f32>,
    /// Phase of the leaf.
    pub leaf_phases: Vec<f32>,
    /// Where the leaf is attached.
    pub anchors: Vec<Vec3>,
    /// Whether the vertex is part of a leaf.
    pub is_leaf: Vec<bool>,
    /// Bend weights; what they weigh is said by the layout.
    pub weights: Vec<Vec2>,
    /// Directions kept in few bits; which ones is said by the layout.
    pub directions: Vec<[Vec3; 2]>,
}
