//! Triangles of every element.

use crate::element::Elements;
use crate::error::{LodError, Result};
use tree_mesh::Mesh;

/// Triangles of every element: rows of vertices of the element's surface.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tier {
    /// Where the triangles of each element begin, and their number at the end.
    pub starts: Vec<u32>,
    /// Three vertices each, in the winding of the model.
    pub triangles: Vec<[u32; 3]>,
}

impl Tier {
    /// The elements as they are in the mesh they were found in. Of elements of another mesh
    /// ([`Elements::check`]) nothing sensible becomes.
    ///
    /// # Complexity
    /// O(triangles).
    #[must_use]
    pub fn full(mesh: &Mesh, elements: &Elements) -> Self {
        let mut triangles = Vec::with_capacity(elements.n_triangles());
        for (pair, &surface) in elements.starts.windows(2).zip(&elements.surface) {
            let surface = mesh.surfaces.get(surface as usize);
            let (all, _) = surface.map_or(&[][..], |surface| &surface.indices).as_chunks::<3>();
            let rows = elements.triangles.get(pair[0] as usize..pair[1] as usize);
            let rows = rows.unwrap_or(&[]).iter();
            triangles.extend(rows.map(|&row| all.get(row as usize).copied().unwrap_or_default()));
        }
        Self { starts: elements.starts.clone(), triangles }
    }

    /// Checks that the tier has triangles for these elements, of vertices of this mesh.
    ///
    /// # Errors
    /// [`LodError::Length`] or [`LodError::Foliage`].
    pub fn check(&self, mesh: &Mesh, elements: &Elements) -> Result<()> {
        elements.check(mesh)?;
        let (found, expected) = (self.starts.len(), elements.len() + 1);
        if found != expected {
            return Err(LodError::Length { what: "tier.starts", found, expected });
        }
        let rising = self.starts.windows(2).all(|pair| pair[0] <= pair[1]);
        let ends = (self.starts.first(), self.starts.last());
        if !rising || ends != (Some(&0), Some(&(self.triangles.len() as u32))) {
            return Err(LodError::Foliage("a tier's starts must rise from 0 to its triangles"));
        }
        let exists = |element: usize| {
            let n = mesh.surfaces[elements.surface[element] as usize].positions.len();
            self.of(element).iter().flatten().all(|&vertex| (vertex as usize) < n)
        };
        if !(0..elements.len()).all(exists) {
            return Err(LodError::Foliage("a tier has a vertex that its surface lacks"));
        }
        Ok(())
    }

    /// Triangles of an element.
    ///
    /// # Panics
    /// When there is no such element.
    #[must_use]
    pub fn of(&self, element: usize) -> &[[u32; 3]] {
        &self.triangles[self.starts[element] as usize..self.starts[element + 1] as usize]
    }

    /// Number of triangles of an element.
    ///
    /// # Panics
    /// When there is no such element.
    #[must_use]
    pub fn cost(&self, element: usize) -> u32 {
        self.starts[element + 1] - self.starts[element]
    }
}
