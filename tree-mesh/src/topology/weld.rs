//! Which vertices are one point, and a surface with one vertex a point.

use crate::error::{MeshError, Result};
use crate::mesh::{Surface, check_surface};
use glam::Vec3;
use rayon::prelude::*;

/// Marks a vertex whose point has no number yet.
const NONE: u32 = u32::MAX;

/// The points of a surface, numbered in the order of their first vertices.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Points {
    /// The point each vertex stands at.
    pub of_vertex: Vec<u32>,
    /// The first vertex of each point.
    pub first: Vec<u32>,
}

impl Points {
    /// Number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.first.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.first.is_empty()
    }

    /// Three points per triangle.
    ///
    /// # Panics
    /// None for the surface the points are of.
    pub(crate) fn triangles(&self, surface: &Surface) -> Vec<[u32; 3]> {
        let (triangles, _) = surface.indices.as_chunks::<3>();
        triangles
            .par_iter()
            .map(|triangle| triangle.map(|vertex| self.of_vertex[vertex as usize]))
            .collect()
    }
}

/// The points of a surface: by its column `welds` where there is one, otherwise vertices at exactly
/// the same place are one point.
///
/// # Errors
/// As [`Mesh::check`](crate::Mesh::check) for the columns of a surface; [`MeshError::Weld`] when a
/// vertex is welded to a later one.
///
/// # Complexity
/// O(vertices) with welds, O(vertices log vertices) without.
pub fn welded(surface: &Surface) -> Result<Points> {
    // Materials and branches are the mesh's, not the surface's.
    check_surface(None, surface, usize::MAX, usize::MAX)?;
    if surface.welds.is_empty() {
        return Ok(by_position(&surface.positions));
    }
    let mut points = Points { of_vertex: vec![NONE; surface.welds.len()], first: Vec::new() };
    for (index, &found) in surface.welds.iter().enumerate() {
        points.of_vertex[index] = if found as usize == index {
            points.first.push(found);
            points.first.len() as u32 - 1
        } else if (found as usize) < index {
            points.of_vertex[found as usize]
        } else {
            return Err(MeshError::Weld { surface: None, index, found });
        };
    }
    Ok(points)
}

fn by_position(positions: &[Vec3]) -> Points {
    // Adding zero turns -0 into 0. The vertex in the last bits keeps copies in their order.
    let bits = |x: f32| u128::from((x + 0.0).to_bits());
    let key = |(vertex, p): (usize, &Vec3)| {
        bits(p.x) << 96 | bits(p.y) << 64 | bits(p.z) << 32 | vertex as u128
    };
    let mut keys: Vec<u128> = positions.par_iter().enumerate().map(key).collect();
    keys.par_sort_unstable();
    let mut first_of = vec![NONE; positions.len()];
    for group in keys.chunk_by(|a, b| a >> 32 == b >> 32) {
        for &key in group {
            first_of[key as u32 as usize] = group[0] as u32;
        }
    }
    drop(keys);
    let mut points = Points::default();
    for (vertex, first) in first_of.iter_mut().enumerate() {
        // From here on: the number of the point. The first vertex is never after its copies.
        *first = if *first as usize == vertex {
            points.first.push(vertex as u32);
            points.first.len() as u32 - 1
        } else {
            points.of_vertex[*first as usize]
        };
        points.of_vertex.push(*first);
    }
    points
}

/// The same surface with one vertex for each point: for volumes, printers and other programs that take
/// copies for holes. Triangles that have two corners at one point are left out, and so are vertices
/// without triangles.
///
/// Normals are the means of the copies' normals, texture coordinates those of the first copy, so
/// textures are torn at seams. Tangents are dropped.
///
/// # Errors
/// As [`welded`]; [`MeshError::Leaves`] for leaves, whose cards are not closed.
///
/// # Complexity
/// As [`welded`].
pub fn weld(surface: &Surface) -> Result<Surface> {
    if !surface.anchors.is_empty() {
        return Err(MeshError::Leaves { found: surface.anchors.len() });
    }
    let points = welded(surface)?;
    let triangles: Vec<[u32; 3]> = points
        .triangles(surface)
        .into_iter()
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .collect();
    let mut number = vec![NONE; points.len()];
    for &point in triangles.as_flattened() {
        number[point as usize] = 0;
    }
    let used = number.iter_mut().zip(&points.first).filter(|(number, _)| **number == 0);
    let kept: Vec<u32> = used
        .enumerate()
        .map(|(i, (number, &first))| {
            *number = i as u32;
            first
        })
        .collect();
    let mut normals = vec![Vec3::ZERO; points.len()];
    for (&point, &normal) in points.of_vertex.iter().zip(&surface.normals) {
        normals[point as usize] += normal;
    }
    let normal_of = |vertex: u32| {
        let own = surface.normals[vertex as usize];
        normals[points.of_vertex[vertex as usize] as usize].normalize_or(own)
    };
    Ok(Surface {
        positions: pick(&surface.positions, &kept),
        normals: kept.iter().map(|&vertex| normal_of(vertex)).collect(),
        uvs: pick(&surface.uvs, &kept),
        uvs2: pick(&surface.uvs2, &kept),
        branches: pick(&surface.branches, &kept),
        occlusion: pick(&surface.occlusion, &kept),
        indices: triangles.as_flattened().iter().map(|&point| number[point as usize]).collect(),
        material: surface.material,
        ..Default::default()
    })
}

/// Rows of a column; an empty column stays empty.
fn pick<T: Copy>(column: &[T], rows: &[u32]) -> Vec<T> {
    if column.is_empty() {
        return Vec::new();
    }
    rows.iter().map(|&row| column[row as usize]).collect()
}
