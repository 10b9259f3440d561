//! What every layout begins with: columns filled up, in the engine's axes.

use super::{Indices, Packed, Stream};
use crate::convert::Convention;
use crate::error::Result;
use crate::mesh::{Mesh, Surface};
use crate::wind::{self, Branch, VertexWind};
use glam::{Vec2, Vec3, Vec4};

/// What stands for the branch of a mesh that has none: it never moves.
const STILL: Branch = Branch {
    parent: 0,
    level: 0,
    pivot: Vec3::ZERO,
    axis: Vec3::Y,
    length: 0.0,
    radius: 0.0,
    collar: 0.0,
    phase: 0.0,
    stiffness: 1.0,
};

/// A surface about to be packed.
pub(super) struct Source<'a> {
    pub(super) surface: &'a Surface,
    pub(super) branches: &'a [Branch],
    pub(super) wind: Vec<VertexWind>,
    pub(super) space: Convention,
}

impl<'a> Source<'a> {
    /// # Errors
    /// As [`Mesh::check_surface`] and [`Mesh::check_branches`].
    pub(super) fn new(mesh: &'a Mesh, number: usize, space: Convention) -> Result<Self> {
        let surface = mesh.surface(number)?;
        mesh.check_surface(number)?;
        mesh.check_branches()?;
        Ok(Self { surface, branches: &mesh.branches, wind: wind::vertices(mesh, number)?, space })
    }

    pub(super) fn len(&self) -> usize {
        self.surface.positions.len()
    }

    pub(super) fn is_leaves(&self) -> bool {
        !self.surface.anchors.is_empty()
    }

    pub(super) fn branch(&self, number: u32) -> &'a Branch {
        self.branches.get(number as usize).unwrap_or(&STILL)
    }

    /// For each branch the one at this level that carries (or is) it; `None` where that lies lower.
    pub(super) fn ancestors(&self, level: u32) -> Vec<Option<u32>> {
        let mut found: Vec<Option<u32>> = Vec::with_capacity(self.branches.len());
        for (number, branch) in (0..).zip(self.branches) {
            found.push(if branch.level <= level {
                (branch.level == level).then_some(number)
            } else {
                // Parents come first; the first branch, which carries itself, has no entry yet.
                found.get(branch.parent as usize).copied().flatten()
            });
        }
        found
    }

    pub(super) fn positions(&self) -> impl Iterator<Item = Vec3> + '_ {
        self.surface.positions.iter().map(|&p| self.space.position(p))
    }

    pub(super) fn uv(&self, vertex: usize) -> Vec2 {
        self.space.uv(self.surface.uvs.get(vertex).copied().unwrap_or_default())
    }

    pub(super) fn uv2(&self, vertex: usize) -> Vec2 {
        self.space.uv(self.surface.uvs2.get(vertex).copied().unwrap_or_default())
    }

    pub(super) fn occlusion(&self, vertex: usize) -> f32 {
        self.surface.occlusion.get(vertex).copied().unwrap_or(1.0)
    }

    /// The tangent in our axes, or one square to the normal.
    pub(super) fn tangent(&self, vertex: usize) -> Vec4 {
        self.surface.tangents.get(vertex).copied().unwrap_or_else(|| {
            let normal = self.surface.normals.get(vertex).copied().unwrap_or(Vec3::Y);
            normal.normalize_or(Vec3::Y).any_orthonormal_vector().extend(1.0)
        })
    }

    /// From a leaf's anchor to its farthest vertex, for each vertex; `None` for wood.
    pub(super) fn leaf_directions(&self) -> Option<Vec<Vec3>> {
        let size = self.surface.vertices_per_leaf().filter(|&size| size > 0)?;
        let leaves = self.surface.positions.chunks_exact(size).zip(&self.surface.anchors);
        Some(
            leaves
                .flat_map(|(corners, &anchor)| {
                    let sum = corners.iter().fold(Vec3::ZERO, |sum, &p| sum + (p - anchor));
                    std::iter::repeat_n(sum.normalize_or(Vec3::Y), size)
                })
                .collect(),
        )
    }

    /// Positions, normals and tangents, with the attributes given, and the indices turned.
    pub(super) fn finish(&self, more: Vec<Stream>) -> Packed {
        let space = self.space;
        let normals = self.surface.normals.iter().map(|&n| space.direction(n).to_array());
        let tangents = (0..self.len()).map(|v| space.tangent(self.tangent(v)).to_array());
        let mut streams = vec![
            Stream::f32("POSITION", self.positions().map(|p| p.to_array())),
            Stream::f32("NORMAL", normals),
            Stream::f32("TANGENT", tangents),
        ];
        streams.extend(more);
        Packed { space, streams, indices: self.indices() }
    }

    pub(super) fn indices(&self) -> Indices {
        let turned: Vec<u32> = self
            .surface
            .indices
            .chunks_exact(3)
            .flat_map(|corners| self.space.triangle(corners.try_into().unwrap_or_default()))
            .collect();
        Indices::new(&turned, self.len())
    }
}
