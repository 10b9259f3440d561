//! Levels as meshes of their own: for files, previews and measuring.

use super::level::Level;
use super::model::PrunedModel;
use super::shader::position;
use super::vertices::compact;
use crate::error::Result;
use rayon::prelude::*;
use tree_mesh::Mesh;

impl PrunedModel {
    /// The level for a λ as a plain mesh, wood included: see [`mesh_of`](Self::mesh_of). Nothing fades in
    /// it, as nothing will move.
    ///
    /// # Errors
    /// As [`level`](Self::level).
    pub fn mesh_at(&self, lambda: f32) -> Result<Mesh> {
        self.mesh_of(&Level { fade: 0.0, ..self.level(lambda)? })
    }

    /// A level as a plain mesh, wood included: elements scaled as the shader does, what is not drawn left
    /// out, surfaces numbered as in the model. Colours keep their contrast: a mesh has no place for
    /// it. Surfaces that lose vertices lose their anchors.
    ///
    /// # Errors
    /// [`LodError::Foliage`](crate::LodError::Foliage) when the level is one of another model;
    /// [`LodError::Parameter`](crate::LodError::Parameter) for numbers outside their ranges.
    ///
    /// # Complexity
    /// O(vertices + triangles), in parallel over surfaces.
    pub fn mesh_of(&self, level: &Level) -> Result<Mesh> {
        self.check_level(level)?;
        let mut mesh = self.mesh.clone();
        mesh.surfaces.par_iter_mut().enumerate().for_each(|(number, surface)| {
            let part = self.parts.binary_search_by_key(&number, |part| part.surface as usize);
            let Ok(part) = part else { return };
            let (window, centers) = (&level.windows[part], &self.parts[part].centers);
            let first = window.first_index as usize;
            surface.indices = surface.indices[first..first + window.index_count as usize].to_vec();
            for (p, &center) in surface.positions.iter_mut().zip(centers) {
                *p = position(*p, center, level.growth, level.lambda, level.fade);
            }
            let mut kept = vec![false; surface.positions.len()];
            for &index in &surface.indices {
                kept[index as usize] = true;
            }
            let whole = kept.iter().all(|&keep| keep);
            compact(surface, &kept);
            if !whole {
                surface.anchors = Vec::new();
            }
        });
        Ok(mesh)
    }
}
