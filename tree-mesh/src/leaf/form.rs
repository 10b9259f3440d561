//! What shape leaves are drawn in, and a leaf as a small mesh of its own.

use crate::error::{MeshError, Result};
use glam::{Vec2, Vec3};
use std::sync::Arc;

/// Most vertices of a leaf of your own: 65,536, what 16-bit indices reach.
const MESH_VERTICES_MAX: usize = 1 << 16;

/// What a leaf is cut out of. Fold, bend and number of sheets are fields of
/// [`LeafLook`](crate::LeafLook) and go with every form but [`Mesh`](Self::Mesh).
#[derive(Clone, Debug, Default, PartialEq)]
pub enum LeafForm {
    /// A rectangle as large as the picture. Two triangles; the least memory, the most overdraw.
    #[default]
    Card,
    /// A polygon of at most `max_vertices` (4 to 64) vertices around all of the picture that is
    /// not cut away: no visible pixel is lost, few invisible ones are drawn. Eight is a good number. A
    /// picture without a mask, or all of it cut away, stays a card; the report says so.
    Outline {
        /// Most vertices of the polygon, 4 to 64.
        max_vertices: u32,
    },
    /// A leaf whose margin is modelled: a polygon along the margin of the picture, as much inside as
    /// outside, drawn without a mask. For close views and for renderers that pay for masks. Leaves are
    /// taken to be alike left and right. Pictures as above stay cards.
    Modelled {
        /// Most vertices of the polygon, 4 to 64. 12 gives up to 20 triangles when
        /// folded or bent.
        max_vertices: u32,
    },
    /// A leaf of your own, shared by all leaves of the kind.
    Mesh(Arc<LeafMesh>),
}

/// One leaf as a small mesh, in its own frame: base at the origin, midrib along +Y with the apex at a
/// height of about 1, upper face towards +Z. Triangles counter-clockwise seen from above.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LeafMesh {
    /// Positions in lengths of the leaf.
    pub positions: Vec<Vec3>,
    /// Unit normals, one per vertex.
    pub normals: Vec<Vec3>,
    /// Texture coordinates, one per vertex, v downwards.
    pub uvs: Vec<Vec2>,
    /// Where each vertex lies on the leaf's own piece of the light map, 0 to 1 both ways. Empty:
    /// above its place in the plane of the leaf, right for leaves that do not overlap themselves.
    pub uvs2: Vec<Vec2>,
    /// Three indices per triangle.
    pub indices: Vec<u32>,
}

impl LeafMesh {
    /// A flat leaf of a triangulated outline, in lengths of the leaf: base at the origin, apex at about (0, 1), triangles
    /// against the clock. Its picture, if it has one, spans the outline's bounds.
    #[must_use]
    pub fn flat(points: &[Vec2], triangles: &[[u32; 3]]) -> Self {
        let low = points.iter().copied().fold(Vec2::INFINITY, Vec2::min);
        let high = points.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
        let size = (high - low).max(Vec2::splat(f32::MIN_POSITIVE));
        let uv = |point: &Vec2| Vec2::new(point.x - low.x, high.y - point.y) / size;
        Self {
            positions: points.iter().map(|point| point.extend(0.0)).collect(),
            normals: vec![Vec3::Z; points.len()],
            uvs: points.iter().map(uv).collect(),
            uvs2: Vec::new(),
            indices: triangles.concat(),
        }
    }

    /// Number of triangles.
    #[must_use]
    pub fn n_triangles(&self) -> usize {
        self.indices.len() / 3
    }

    /// Area of all triangles together, in squared lengths of the leaf.
    #[must_use]
    pub fn area(&self) -> f32 {
        let corner = |i: u32| self.positions.get(i as usize).copied().unwrap_or_default();
        self.indices
            .chunks_exact(3)
            .map(|t| {
                0.5 * (corner(t[1]) - corner(t[0])).cross(corner(t[2]) - corner(t[0])).length()
            })
            .sum()
    }

    /// Checks that columns have equal lengths, numbers are finite, normals have unit length,
    /// indices exist, and there is something, but not more than 65,536 vertices.
    ///
    /// # Errors
    /// [`MeshError::LeafMesh`], naming what is wrong.
    pub fn check(&self) -> Result<()> {
        let n = self.positions.len();
        let bad = |problem, index| Err(MeshError::LeafMesh { problem, index });
        if n == 0 || self.indices.is_empty() {
            return bad("there are no triangles", 0);
        }
        if n > MESH_VERTICES_MAX {
            return bad("there are more than 65,536 vertices", n);
        }
        if self.normals.len() != n || self.uvs.len() != n {
            return bad("columns differ in length", n.min(self.normals.len()).min(self.uvs.len()));
        }
        if !self.uvs2.is_empty() && self.uvs2.len() != n {
            return bad("columns differ in length", self.uvs2.len());
        }
        if !self.indices.len().is_multiple_of(3) {
            return bad("indices are not whole triangles", self.indices.len());
        }
        let large = |p: &Vec3| p.abs().max_element() <= 1e3;
        if let Some(i) = self.positions.iter().position(|p| !large(p)) {
            return bad("a position is not finite or beyond 1000 leaf lengths", i);
        }
        let unit = |v: &Vec3| (v.length_squared() - 1.0).abs() <= 0.01;
        if let Some(i) = self.normals.iter().position(|v| !unit(v)) {
            return bad("a normal does not have unit length", i);
        }
        if let Some(i) = self.uvs.iter().position(|uv| !uv.is_finite()) {
            return bad("a texture coordinate is not finite", i);
        }
        let inside = |uv: &Vec2| uv.cmpge(Vec2::ZERO).all() && uv.cmple(Vec2::ONE).all();
        if let Some(i) = self.uvs2.iter().position(|uv| !inside(uv)) {
            return bad("a light-map coordinate is not within 0 to 1", i);
        }
        match self.indices.iter().position(|&i| i as usize >= n) {
            Some(i) => bad("an index names a vertex that does not exist", i),
            None => Ok(()),
        }
    }
}

/// A leaf kind's mesh and how it came about.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LeafModel {
    /// The leaf.
    pub mesh: LeafMesh,
    /// Whether the picture could not be outlined (no mask, or nothing of it visible) and the leaf
    /// is a card instead.
    pub fallback: bool,
    /// Whether the margin is modelled, so that no mask is needed.
    pub opaque: bool,
    /// Share of the picture's pixels that can be seen; 1 without a mask.
    pub visible: f32,
    /// Area of the polygon in the picture as share of the picture; 1 for a card.
    pub drawn: f32,
}
