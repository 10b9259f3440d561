//! Parts of a surface's columns that threads fill side by side.

use glam::{Vec2, Vec3};

/// Part of a surface's columns, filled from front to back.
#[derive(Debug, Default)]
pub(crate) struct Columns<'a> {
    pub(crate) positions: &'a mut [Vec3],
    pub(crate) normals: &'a mut [Vec3],
    pub(crate) uvs: &'a mut [Vec2],
    pub(crate) indices: &'a mut [u32],
    /// Number in the surface of the first vertex of this part.
    pub(crate) first_vertex: u32,
    pub(crate) n_vertices: usize,
    pub(crate) n_indices: usize,
}

impl<'a> Columns<'a> {
    /// Cuts a part off the front of the columns.
    pub(crate) fn split(&mut self, n_vertices: usize, n_indices: usize) -> Columns<'a> {
        fn cut<'a, T>(slice: &mut &'a mut [T], n: usize) -> &'a mut [T] {
            let (front, back) = std::mem::take(slice).split_at_mut(n);
            *slice = back;
            front
        }
        let part = Columns {
            positions: cut(&mut self.positions, n_vertices),
            normals: cut(&mut self.normals, n_vertices),
            uvs: cut(&mut self.uvs, n_vertices),
            indices: cut(&mut self.indices, n_indices),
            first_vertex: self.first_vertex,
            n_vertices: 0,
            n_indices: 0,
        };
        self.first_vertex += n_vertices as u32;
        part
    }

    /// Adds a vertex.
    pub(crate) fn vertex(&mut self, position: Vec3, normal: Vec3, uv: Vec2) {
        let i = self.n_vertices;
        self.positions[i] = position;
        self.normals[i] = normal;
        self.uvs[i] = uv;
        self.n_vertices += 1;
    }

    /// Adds a triangle of vertices counted from the start of this part.
    pub(crate) fn triangle(&mut self, corners: [u32; 3]) {
        let i = self.n_indices;
        self.indices[i..i + 3].copy_from_slice(&corners.map(|corner| self.first_vertex + corner));
        self.n_indices += 3;
    }

    /// Number in this part of the next vertex.
    pub(crate) fn next(&self) -> u32 {
        self.n_vertices as u32
    }
}
