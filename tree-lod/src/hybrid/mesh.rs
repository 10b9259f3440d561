//! A choice as a plain mesh.

use super::choose::HybridChoice;
use super::make::Hybrid;
use crate::error::Result;
use crate::impostor::choose::Watcher;
use crate::prune::vertices::compact;
use glam::Vec3;
use tree_mesh::Mesh;

/// From how many times the size of the tree levels are chosen: so far that all of it is at one scale.
const FAR: f32 = 1e3;

impl Hybrid {
    /// What is chosen as a mesh of its own, for previews, files and measuring: the wood grown to its level,
    /// leaves, and three planes of each box, with light in their picture ([`Cards::plain`](crate::impostor::cards::Cards::plain)).
    ///
    /// # Errors
    /// As [`MultiMesh::mesh_at`](crate::multires::MultiMesh::mesh_at); [`LodError::Impostor`](crate::LodError::Impostor)
    /// for a choice of another model.
    ///
    /// # Complexity
    /// O(vertices + triangles + texels).
    pub fn mesh_of(&self, choice: &HybridChoice) -> Result<Mesh> {
        let mut mesh = self.wood.mesh_at(choice.level)?;
        let Some(leaves) = &choice.leaves else { return Ok(mesh) };
        for (number, whole) in self.mesh.surfaces.iter().enumerate().skip(1) {
            let mut surface = whole.clone();
            surface.indices.clear();
            for rows in &leaves.leaves {
                let (first, count) = self.leaf_window(number, rows.clone());
                let window = first as usize..(first + count) as usize;
                surface.indices.extend_from_slice(&whole.indices[window]);
            }
            let mut kept = vec![false; surface.positions.len()];
            surface.indices.iter().for_each(|&index| kept[index as usize] = true);
            compact(&mut surface, &kept);
            mesh.surfaces[number] = surface;
        }
        if let (Some(cards), false) = (&self.cards, leaves.boxes.is_empty()) {
            let planes = cards.plain(&leaves.boxes)?;
            let first = mesh.materials.len() as u32;
            mesh.materials.extend(planes.materials);
            for mut surface in planes.surfaces {
                surface.material += first;
                mesh.surfaces.push(surface);
            }
        }
        mesh.surfaces.retain(|surface| !surface.positions.is_empty());
        Ok(mesh)
    }

    /// What is chosen where the whole tree is so many pixels high, the same scale everywhere.
    ///
    /// # Errors
    /// [`LodError::Parameter`](crate::LodError::Parameter) for a height that is not above 0, or above 10⁵.
    pub fn choice_for_height(&self, pixels: f32) -> Result<HybridChoice> {
        crate::error::check_range("pixels", pixels.into(), f64::from(f32::MIN_POSITIVE), 1e5)?;
        let bounds = self.bounds;
        let height = (bounds.max.y - bounds.min.y).max(f32::MIN_POSITIVE);
        let size = (bounds.max - bounds.min).length();
        let away = FAR * size;
        let eye = bounds.center() + Vec3::Z * away;
        let mut choice = self.choice()?;
        self.update(&mut choice, &Watcher { eye, pixels_per_metre: pixels / height * away })?;
        Ok(choice)
    }
}
