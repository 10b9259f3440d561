//! Triangles of every element.

use crate::element::Elements;
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
    /// The elements as they are in the mesh they were found in.
    ///
    /// # Complexity
    /// O(triangles).
    #[must_use]
    pub fn full(mesh: &Mesh, elements: &Elements) -> Self {
        let mut triangles = Vec::with_capacity(elements.n_triangles());
        for element in 0..elements.len() {
            let surface = mesh.surfaces.get(elements.surface[element] as usize);
            let (all, _) = surface.map_or(&[][..], |surface| &surface.indices).as_chunks::<3>();
            let rows = elements.triangles_of(element).iter();
            triangles.extend(rows.map(|&row| all.get(row as usize).copied().unwrap_or_default()));
        }
        Self { starts: elements.starts.clone(), triangles }
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
