//! A vertex of 32 bytes with everything in it.
//!
//! | bytes | field | holds | error |
//! |---|---|---|---|
//! | 0 to 5 | position | 3 × u16 over the surface's bounds | extent / 131,070 a side |
//! | 6 to 7 | tangent | 15 bits of angle about the normal, 1 bit of sign | 3·10⁻⁴ radians |
//! | 8 to 11 | normal | octahedral, 2 × i16 | 10⁻⁴ radians |
//! | 12 to 15 | uv | 2 × u16 over the surface's range | range / 131,070 |
//! | 16 to 19 | uv2 | 2 × unorm16 | 1 / 131,070 |
//! | 20 to 23 | branch | number in the table: 4 billion | none |
//! | 24 to 25 | reach | unorm16 | 1 / 131,070 |
//! | 26 | occlusion | unorm8 | 1 / 510 |
//! | 27 | flutter | unorm8 | 1 / 510 |
//! | 28 | phase | unorm8 of the branch's phase | 1 / 510 |
//! | 29 | stiffness | unorm8 of the branch's stiffness | 1 / 510 |
//! | 30 | level | level of the branch, 255 for more | none up to 254 |
//! | 31 | leaf phase | unorm8 | 1 / 510 |
//!
//! To the errors of positions and uvs comes the rounding of f32, 10⁻⁷ of the largest coordinate. Phase,
//! stiffness and level stand in the vertex so that simple shaders need no table; parent, pivot and axis
//! are in the table ([`Mesh::branches`]), 48 bytes a branch, to be uploaded as a buffer and read by the
//! number of the branch. Anchors are one for each leaf: of vertex `i` that of leaf
//! `i / vertices_per_leaf`. Axes, winding and v are ours: glTF's.
//!
//! uvs are not halves: at 40 repeats of the bark a half has steps of 1/32.

use super::common::Source;
use super::{Indices, Unpacked, direction, half};
use crate::convert::Convention;
use crate::error::Result;
use crate::mesh::Mesh;
use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3, Vec4};
use std::f32::consts::TAU;
use tree_core::Aabb;

/// Steps of the tangent's angle, and the bit that holds its sign.
const TANGENT_STEPS: u16 = 0x8000;

/// A vertex, quantised. See the [module](self) for what each field holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct PackedVertex {
    /// Position over the bounds.
    pub position: [u16; 3],
    /// Angle about the normal, and in the highest bit 1 for a negative sign.
    pub tangent: u16,
    /// Octahedral normal.
    pub normal: [i16; 2],
    /// Texture coordinates over their range.
    pub uv: [u16; 2],
    /// Light-map coordinates.
    pub uv2: [u16; 2],
    /// Number of the branch.
    pub branch: u32,
    /// How far along the branch.
    pub reach: u16,
    /// Ambient occlusion.
    pub occlusion: u8,
    /// How far along the leaf.
    pub flutter: u8,
    /// Phase of the branch.
    pub phase: u8,
    /// Stiffness of the branch.
    pub stiffness: u8,
    /// Level of the branch.
    pub level: u8,
    /// Phase of the leaf.
    pub leaf_phase: u8,
}

/// Vertices of a surface, and what is needed to read them.
#[derive(Clone, Debug, PartialEq)]
pub struct PackedSurface {
    /// The vertices.
    pub vertices: Vec<PackedVertex>,
    /// Triangles, counter-clockwise.
    pub indices: Indices,
    /// Box of the positions.
    pub bounds: Aabb,
    /// Smallest and largest texture coordinates.
    pub uv_range: [Vec2; 2],
    /// Anchors of the leaves.
    pub anchors: Vec<Vec3>,
}

/// Packs a surface.
///
/// # Errors
/// As [`Mesh::check`], of this surface.
pub fn pack(mesh: &Mesh, surface: usize) -> Result<PackedSurface> {
    let source = Source::new(mesh, surface, Convention::Gltf)?;
    let columns = source.surface;
    let bounds = columns.bounds();
    let none = (Vec2::INFINITY, Vec2::NEG_INFINITY);
    let range = columns.uvs.iter().fold(none, |(low, high), &uv| (low.min(uv), high.max(uv)));
    let vertex = |(row, &position): (usize, &Vec3)| {
        let normal = columns.normals.get(row).copied().unwrap_or(Vec3::Y);
        let normal = direction::octahedral_16(normal);
        let wind = source.wind.get(row).copied().unwrap_or_default();
        let branch = source.branch(wind.branch);
        PackedVertex {
            position: shares(position, bounds.min, bounds.max).map(half::short),
            tangent: pack_tangent(source.tangent(row), direction::from_octahedral_16(normal)),
            normal,
            uv: {
                let uv = source.uv(row).extend(0.0);
                let [u, v, _] = shares(uv, range.0.extend(0.0), range.1.extend(0.0));
                [u, v].map(half::short)
            },
            uv2: source.uv2(row).to_array().map(half::short),
            branch: wind.branch,
            reach: half::short(wind.reach),
            occlusion: half::byte(source.occlusion(row)),
            flutter: half::byte(wind.flutter),
            phase: half::byte(branch.phase),
            stiffness: half::byte(branch.stiffness),
            level: u8::try_from(branch.level).unwrap_or(u8::MAX),
            leaf_phase: half::byte(wind.leaf_phase),
        }
    };
    Ok(PackedSurface {
        vertices: columns.positions.iter().enumerate().map(vertex).collect(),
        indices: source.indices(),
        bounds,
        uv_range: [range.0, range.1],
        anchors: columns.anchors.clone(),
    })
}

/// How far between two corners of a box each coordinate lies, 0 to 1. In f64, so that neither wide nor
/// narrow boxes lose steps.
fn shares(at: Vec3, low: Vec3, high: Vec3) -> [f32; 3] {
    let share = |at: f32, low: f32, high: f32| {
        let wide = f64::from(high) - f64::from(low);
        if wide > 0.0 { ((f64::from(at) - f64::from(low)) / wide) as f32 } else { 0.0 }
    };
    [share(at.x, low.x, high.x), share(at.y, low.y, high.y), share(at.z, low.z, high.z)]
}

fn between(share: u16, low: f32, high: f32) -> f32 {
    let share = f64::from(share) / 65_535.0;
    (f64::from(low) + (f64::from(high) - f64::from(low)) * share) as f32
}

/// Two unit vectors square to the normal and to each other, that packing and unpacking share.
fn basis(normal: Vec3) -> (Vec3, Vec3) {
    let across = normal.any_orthonormal_vector();
    (across, normal.cross(across))
}

fn pack_tangent(tangent: Vec4, normal: Vec3) -> u16 {
    let (x, y) = basis(normal);
    let along = tangent.truncate();
    let turn = libm::atan2f(along.dot(y), along.dot(x)) / TAU;
    let turn = turn - turn.floor();
    let steps = (turn * f32::from(TANGENT_STEPS) + 0.5) as u16 % TANGENT_STEPS;
    if tangent.w < 0.0 { steps | TANGENT_STEPS } else { steps }
}

fn unpack_tangent(packed: u16, normal: Vec3) -> Vec4 {
    let (x, y) = basis(normal);
    let turn = f32::from(packed % TANGENT_STEPS) / f32::from(TANGENT_STEPS);
    let (sin, cos) = libm::sincosf(turn * TAU);
    let sign = if packed >= TANGENT_STEPS { -1.0 } else { 1.0 };
    (x * cos + y * sin).normalize_or(x).extend(sign)
}

impl PackedSurface {
    /// The vertices as bytes, as an engine uploads them (in the machine's order of bytes).
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(&self.vertices)
    }

    /// Reads everything back, as the shader does; `mesh` gives the table of branches.
    #[must_use]
    pub fn unpack(&self, mesh: &Mesh) -> Unpacked {
        let mut back = Unpacked { indices: self.indices.to_u32(), ..Unpacked::default() };
        let (min, max) = (self.bounds.min, self.bounds.max);
        let [low, high] = self.uv_range;
        let size = self.vertices.len().checked_div(self.anchors.len()).filter(|&size| size > 0);
        for (row, vertex) in self.vertices.iter().enumerate() {
            let [x, y, z] = vertex.position;
            let position = Vec3::new(
                between(x, min.x, max.x),
                between(y, min.y, max.y),
                between(z, min.z, max.z),
            );
            let normal = direction::from_octahedral_16(vertex.normal);
            let branch = mesh.branches.get(vertex.branch as usize).copied().unwrap_or_default();
            let anchor = size.and_then(|size| self.anchors.get(row / size));
            back.positions.push(position);
            back.normals.push(normal);
            back.tangents.push(unpack_tangent(vertex.tangent, normal));
            let [u, v] = vertex.uv;
            back.uvs.push(Vec2::new(between(u, low.x, high.x), between(v, low.y, high.y)));
            back.uvs2.push(Vec2::from_array(vertex.uv2.map(half::from_short)));
            back.occlusion.push(half::from_byte(vertex.occlusion));
            back.branches.push(vertex.branch);
            back.parents.push(branch.parent);
            back.pivots.push(branch.pivot);
            back.axes.push(branch.axis);
            back.levels.push(u32::from(vertex.level));
            back.phases.push(half::from_byte(vertex.phase));
            back.stiffness.push(half::from_byte(vertex.stiffness));
            back.reach.push(half::from_short(vertex.reach));
            back.flutter.push(half::from_byte(vertex.flutter));
            back.leaf_phases.push(half::from_byte(vertex.leaf_phase));
            back.anchors.push(anchor.copied().unwrap_or(position));
            back.is_leaf.push(anchor.is_some());
        }
        back
    }
}
