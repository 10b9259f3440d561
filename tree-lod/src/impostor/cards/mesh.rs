//! Planes as triangles.

use super::{Cards, PLANES, planes};
use crate::error::{LodError, Result};
use glam::Vec2;
use std::sync::Arc;
use tree_mesh::{Alpha, Material, Mesh, Surface, Texture};

impl Cards {
    /// The planes of some boxes, six squares of four vertices each, with the atlas as their texture: alpha is
    /// tested against one half, both sides are drawn. Without the shader, all six planes of a box
    /// are drawn at once, which covers more than the leaves do.
    ///
    /// # Errors
    /// [`LodError::Impostor`] when there is no such box.
    ///
    /// # Complexity
    /// O(boxes), and a copy of the atlas.
    pub fn mesh(&self, boxes: &[u32]) -> Result<Mesh> {
        self.mesh_of_planes(boxes, &std::array::from_fn::<_, PLANES, _>(|plane| plane))
    }

    /// As [`mesh`](Self::mesh), of some planes of each box only, by their places in [`planes`]. For programs
    /// without the shader: 0, 2 and 4, one for each axis, cover about as much as the leaves do.
    ///
    /// # Errors
    /// [`LodError::Impostor`] when there is no such box or plane.
    ///
    /// # Complexity
    /// As [`mesh`](Self::mesh).
    pub fn mesh_of_planes(&self, boxes: &[u32], chosen: &[usize]) -> Result<Mesh> {
        let mut surface = Surface::default();
        for &number in boxes {
            let faces = planes(self.boxes.get(number)?);
            for &plane in chosen {
                let none = LodError::Impostor("there is no plane of this number: 0 to 5");
                let face = faces.get(plane).ok_or(none)?;
                let first = surface.positions.len() as u32;
                for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                    let (right, up) = (face.right * face.half.x, face.up * face.half.y);
                    surface.positions.push(face.center + right * x + up * y);
                    surface.normals.push(face.normal);
                    let place = self.place(number, plane, Vec2::new(x, y));
                    let size = Vec2::new(self.color.width as f32, self.color.height as f32);
                    surface.uvs.push(place / size);
                }
                surface.indices.extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
            }
        }
        let texture = Texture {
            name: "cards".into(),
            width: self.color.width,
            height: self.color.height,
            pixels: self.color.pixels.clone(),
        };
        let material = material(Arc::new(texture));
        Ok(Mesh { surfaces: vec![surface], materials: vec![material], ..Mesh::default() })
    }

    /// Texel coordinates in the atlas of a place on a plane, −1 to 1 right and up.
    pub(super) fn place(&self, number: u32, plane: usize, at: Vec2) -> Vec2 {
        let [left, top] = self.origin(number, plane);
        let inside = Vec2::new(0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y) * self.inner();
        Vec2::new(left as f32, top as f32) + self.gutter as f32 + inside
    }
}

/// Alpha is tested against one half, both sides are drawn.
pub(super) fn material(texture: Arc<Texture>) -> Material {
    Material {
        name: "cards".into(),
        texture: Some(texture),
        alpha: Alpha::Mask(0.5),
        double_sided: true,
        translucency: TRANSLUCENCY,
        ..Material::default()
    }
}

/// Light that shines through a card, as through leaves.
const TRANSLUCENCY: f32 = 0.4;
