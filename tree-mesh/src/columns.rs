//! Parts of a surface's columns that threads fill side by side.

use crate::mesh::Surface;
use glam::{Vec2, Vec3, Vec4};

/// One vertex of the bark.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vertex {
    pub(crate) position: Vec3,
    pub(crate) normal: Vec3,
    pub(crate) tangent: Vec3,
    pub(crate) uv: Vec2,
    pub(crate) branch: u32,
    pub(crate) weld: u32,
}

/// Part of a surface's columns, filled from front to back.
#[derive(Debug, Default)]
pub(crate) struct Columns<'a> {
    pub(crate) positions: &'a mut [Vec3],
    pub(crate) normals: &'a mut [Vec3],
    pub(crate) uvs: &'a mut [Vec2],
    /// Empty when they are not wanted.
    tangents: &'a mut [Vec4],
    branches: &'a mut [u32],
    welds: &'a mut [u32],
    indices: &'a mut [u32],
    /// Number in the surface of the first vertex of this part.
    first_vertex: u32,
    pub(crate) n_vertices: usize,
    pub(crate) n_indices: usize,
}

/// Some vertices of a part.
pub(crate) struct Rows<'a> {
    pub(crate) positions: &'a mut [Vec3],
    pub(crate) normals: &'a mut [Vec3],
    pub(crate) uvs: &'a mut [Vec2],
    /// Empty when they are not wanted.
    pub(crate) tangents: &'a mut [Vec4],
    pub(crate) branches: &'a mut [u32],
    pub(crate) welds: &'a mut [u32],
}

impl<'a> Columns<'a> {
    /// All columns of a surface that a bark has.
    pub(crate) fn of(surface: &'a mut Surface) -> Self {
        Self {
            positions: &mut surface.positions,
            normals: &mut surface.normals,
            uvs: &mut surface.uvs,
            tangents: &mut surface.tangents,
            branches: &mut surface.branches,
            welds: &mut surface.welds,
            indices: &mut surface.indices,
            ..Default::default()
        }
    }

    /// Cuts a part off the front of the columns.
    pub(crate) fn split(&mut self, n_vertices: usize, n_indices: usize) -> Columns<'a> {
        fn cut<'a, T>(slice: &mut &'a mut [T], n: usize) -> &'a mut [T] {
            let n = n.min(slice.len());
            let (front, back) = std::mem::take(slice).split_at_mut(n);
            *slice = back;
            front
        }
        let part = Columns {
            positions: cut(&mut self.positions, n_vertices),
            normals: cut(&mut self.normals, n_vertices),
            uvs: cut(&mut self.uvs, n_vertices),
            tangents: cut(&mut self.tangents, n_vertices),
            branches: cut(&mut self.branches, n_vertices),
            welds: cut(&mut self.welds, n_vertices),
            indices: cut(&mut self.indices, n_indices),
            first_vertex: self.first_vertex,
            n_vertices: 0,
            n_indices: 0,
        };
        self.first_vertex += n_vertices as u32;
        part
    }

    /// Adds a vertex.
    pub(crate) fn vertex(&mut self, vertex: Vertex) {
        let i = self.n_vertices;
        self.positions[i] = vertex.position;
        self.normals[i] = vertex.normal;
        self.uvs[i] = vertex.uv;
        self.branches[i] = vertex.branch;
        self.welds[i] = vertex.weld;
        if let Some(tangent) = self.tangents.get_mut(i) {
            *tangent = vertex.tangent.extend(1.0);
        }
        self.n_vertices += 1;
    }

    /// The next `n` vertices, to be written in any order.
    pub(crate) fn rows(&mut self, n: usize) -> Rows<'_> {
        let from = self.n_vertices;
        let to = from + n;
        self.n_vertices = to;
        let with_tangents = if self.tangents.is_empty() { 0..0 } else { from..to };
        Rows {
            positions: &mut self.positions[from..to],
            normals: &mut self.normals[from..to],
            uvs: &mut self.uvs[from..to],
            tangents: &mut self.tangents[with_tangents],
            branches: &mut self.branches[from..to],
            welds: &mut self.welds[from..to],
        }
    }

    /// The corners of the next `n` triangles, as numbers of the surface.
    pub(crate) fn triangles(&mut self, n: usize) -> &mut [u32] {
        let from = self.n_indices;
        self.n_indices += 3 * n;
        &mut self.indices[from..self.n_indices]
    }

    /// Adds a triangle of vertices counted from the start of this part.
    pub(crate) fn triangle(&mut self, corners: [u32; 3]) {
        self.global_triangle(corners.map(|corner| self.first_vertex + corner));
    }

    /// Adds a triangle of vertices of the surface.
    pub(crate) fn global_triangle(&mut self, corners: [u32; 3]) {
        let i = self.n_indices;
        self.indices[i..i + 3].copy_from_slice(&corners);
        self.n_indices += 3;
    }

    /// Number in this part of the next vertex.
    pub(crate) fn next(&self) -> u32 {
        self.n_vertices as u32
    }

    /// Number in the surface of a vertex of this part.
    pub(crate) fn global(&self, vertex: u32) -> u32 {
        self.first_vertex + vertex
    }
}
