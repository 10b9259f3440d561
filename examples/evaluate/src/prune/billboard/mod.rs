//! Billboard clouds, the baseline of Fig. 7.16 (evaluation only): the foliage of a tree on textured
//! quads. The wood stays as it is, as with pruning.
//!
//! * [`decoret()`]: Décoret et al. 2003, greedy choice of planes in a discretised dual space.
//! * [`behrendt()`]: Behrendt et al. 2005, clusters by k-means with one to three billboards each (§6.2).
//! * [`bake()`]: draws the elements of each billboard onto it.

mod bake;
mod decoret;
mod kmeans;

pub(super) use bake::bake;
pub(super) use decoret::decoret;
pub(super) use kmeans::behrendt;

use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use tree_core::glam::{Vec2, Vec3};
use tree_lod::Elements;
use tree_mesh::Mesh;

/// A textured quad and the elements it stands for.
#[derive(Clone, Debug)]
pub(super) struct Billboard {
    pub(super) center: Vec3,
    /// Unit vectors in its plane; the picture's rows run along `right`, its columns against `up`.
    pub(super) right: Vec3,
    pub(super) up: Vec3,
    /// Half its width and height in metres.
    pub(super) half: Vec2,
    pub(super) elements: Vec<u32>,
}

impl Billboard {
    /// The billboard of some elements in the plane through `point`; as large as they are when projected.
    fn around(mesh: &Mesh, all: &Elements, elements: Vec<u32>, normal: Vec3, point: Vec3) -> Self {
        // Upright where that is possible.
        let up = Vec3::Y - normal * normal.y;
        let up = up.try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector());
        let right = up.cross(normal);
        let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
        for &element in &elements {
            for p in corners(mesh, all, element as usize) {
                let flat = Vec2::new(right.dot(p), up.dot(p));
                (low, high) = (low.min(flat), high.max(flat));
            }
        }
        let middle = 0.5 * (low + high);
        let center = right * middle.x + up * middle.y + normal * normal.dot(point);
        Self { center, right, up, half: 0.5 * (high - low), elements }
    }

    fn normal(&self) -> Vec3 {
        self.right.cross(self.up)
    }
}

/// Corners of an element's triangles.
fn corners<'a>(
    mesh: &'a Mesh,
    elements: &'a Elements,
    element: usize,
) -> impl Iterator<Item = Vec3> + 'a {
    let surface = &mesh.surfaces[elements.surface[element] as usize];
    let triangles = elements.triangles_of(element).iter();
    triangles.flat_map(|&t| {
        [0, 1, 2].map(|k| surface.positions[surface.indices[3 * t as usize + k] as usize])
    })
}

/// Unit axes of the spread of some points about their mean, the least spread first.
fn principal_axes(points: &[Vec3]) -> [Vec3; 3] {
    let mean = points.iter().sum::<Vec3>() / points.len().max(1) as f32;
    let mut spread = Matrix3::<f32>::zeros();
    for p in points {
        let d = Vector3::from((*p - mean).to_array());
        spread += d * d.transpose();
    }
    let eigen = SymmetricEigen::new(spread);
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));
    order.map(|i| {
        let axis = eigen.eigenvectors.column(i);
        Vec3::new(axis[0], axis[1], axis[2]).normalize_or(Vec3::Y)
    })
}

#[cfg(test)]
mod tests;
