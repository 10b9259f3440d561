//! What is dropped and scaled as one: a leaf, a card, the blade of a compound leaf, a twig.
//!
//! 1. [`LeafSurfaces`] says which surfaces are pruned; the rest of the mesh (wood) is always drawn.
//! 2. `split`: their triangles are divided into elements, by leaves or by connected pieces.
//! 3. `measure`: centre, area, normal and size of each.

mod measure;
mod split;

pub use split::{Grain, LeafSurfaces};

use crate::error::{LodError, Result};
use glam::Vec3;
use std::ops::Range;
use tree_mesh::Mesh;

/// The elements of a mesh, in columns: a row each, in the order of surfaces and triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Elements {
    /// Surfaces that are pruned, rising; all others are always drawn.
    pub surfaces: Vec<u32>,
    /// Surface of each element, a value of `surfaces`.
    pub surface: Vec<u32>,
    /// Where the triangles of each element begin in `triangles`, and their number at the end.
    pub starts: Vec<u32>,
    /// Triangles of each element: their numbers in its surface.
    pub triangles: Vec<u32>,
    /// Mean of each element's surface in metres: what it is scaled about.
    pub centers: Vec<Vec3>,
    /// Mean normal, weighted by area; zero where it has none (a closed blade, no area).
    pub normals: Vec<Vec3>,
    /// Area of the triangles in m².
    pub areas: Vec<f32>,
    /// Largest distance of a vertex from the mean of its own triangles, in metres.
    pub radii: Vec<f32>,
}

impl Elements {
    /// Checks that the elements are of this mesh: columns of equal length, surfaces and triangles that
    /// exist, finite centres.
    ///
    /// # Errors
    /// [`LodError::Length`] or [`LodError::Foliage`].
    pub fn check(&self, mesh: &Mesh) -> Result<()> {
        let n = self.centers.len();
        for (what, found, expected) in [
            ("surface", self.surface.len(), n),
            ("starts", self.starts.len(), n + 1),
            ("normals", self.normals.len(), n),
            ("areas", self.areas.len(), n),
            ("radii", self.radii.len(), n),
        ] {
            if found != expected {
                return Err(LodError::Length { what, found, expected });
            }
        }
        if n == 0 {
            return Err(LodError::Foliage("there are no elements"));
        }
        let finite = self.centers.iter().chain(&self.normals).all(|v| v.is_finite())
            && self.areas.iter().chain(&self.radii).all(|v| v.is_finite());
        if !finite {
            return Err(LodError::Foliage("centres, normals, areas and radii must be finite"));
        }
        if self.surfaces.windows(2).any(|pair| pair[0] >= pair[1]) {
            return Err(LodError::Foliage("the pruned surfaces must rise"));
        }
        if !self.surface.iter().all(|surface| self.surfaces.binary_search(surface).is_ok()) {
            return Err(LodError::Foliage("an element is on a surface that is not pruned"));
        }
        let rising = self.starts.windows(2).all(|pair| pair[0] <= pair[1]);
        let ends = (self.starts.first(), self.starts.last());
        if !rising || ends != (Some(&0), Some(&(self.triangles.len() as u32))) {
            return Err(LodError::Foliage("starts must rise from 0 to the number of triangles"));
        }
        let exists = |element: usize| {
            mesh.surfaces.get(self.surface[element] as usize).is_some_and(|surface| {
                let n = surface.n_triangles();
                self.triangles_of(element).iter().all(|&triangle| (triangle as usize) < n)
            })
        };
        if !(0..n).all(exists) {
            return Err(LodError::Foliage("an element has a surface or triangle the mesh lacks"));
        }
        Ok(())
    }

    /// Number of elements.
    #[must_use]
    pub fn len(&self) -> usize {
        self.centers.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.centers.is_empty()
    }

    /// Rows of an element's triangles in [`triangles`](Self::triangles).
    pub(crate) fn rows(&self, element: usize) -> Range<usize> {
        self.starts[element] as usize..self.starts[element + 1] as usize
    }

    /// Triangles of an element.
    ///
    /// # Panics
    /// When there is no such element.
    #[must_use]
    pub fn triangles_of(&self, element: usize) -> &[u32] {
        &self.triangles[self.rows(element)]
    }

    /// Triangles of all elements.
    #[must_use]
    pub fn n_triangles(&self) -> usize {
        self.triangles.len()
    }
}

#[cfg(test)]
mod tests;
