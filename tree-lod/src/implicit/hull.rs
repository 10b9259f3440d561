//! The surface around a plant.

use super::nearest::{Nearest, closest};
use glam::{Vec2, Vec3};
use tree_core::Seed;
use tree_mesh::{Material, Mesh, Surface};

/// Most samples.
const MAX_SAMPLES: usize = 1 << 24;
/// A closed surface around a plant, facing outwards: plain columns, metres.
#[derive(Clone, Debug)]
pub struct Hull {
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    /// Triangles near each other in space are near each other here.
    triangles: Vec<[u32; 3]>,
    nearest: Nearest,
}

/// A place on a hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Where it is, in metres.
    pub position: Vec3,
    /// Unit normal there, outwards.
    pub normal: Vec3,
}

impl Hull {
    pub(super) fn new(
        positions: Vec<Vec3>,
        normals: Vec<Vec3>,
        mut triangles: Vec<[u32; 3]>,
    ) -> Self {
        let nearest = Nearest::new(&positions, &mut triangles);
        Self { positions, normals, triangles, nearest }
    }

    /// Places of vertices, each once.
    #[must_use]
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// Unit normals of vertices: against the gradient of the field, outwards.
    #[must_use]
    pub fn normals(&self) -> &[Vec3] {
        &self.normals
    }

    /// Three vertices per triangle, counter-clockwise seen from outside.
    #[must_use]
    pub fn indices(&self) -> &[u32] {
        self.triangles.as_flattened()
    }

    /// A mesh of one surface, for looking at it.
    #[must_use]
    pub fn to_mesh(&self) -> Mesh {
        let surface = Surface {
            positions: self.positions.clone(),
            normals: self.normals.clone(),
            uvs: vec![Vec2::ZERO; self.positions.len()],
            indices: self.indices().to_vec(),
            ..Surface::default()
        };
        let material = Material { name: "hull".into(), ..Material::default() };
        Mesh { surfaces: vec![surface], materials: vec![material], ..Mesh::default() }
    }

    /// `n` places evenly by area, at most 16,777,216.
    ///
    /// The area is divided into `n` equal parts along the order of the triangles, which keeps near
    /// things near, and each part gets one place at random.
    ///
    /// # Complexity
    /// O(triangles + n).
    #[must_use]
    pub fn sample(&self, n: usize, seed: Seed) -> Vec<Sample> {
        let n = n.min(MAX_SAMPLES);
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| self.positions[v as usize]);
            f64::from((b - a).cross(c - a).length())
        };
        let part = self.triangles.iter().map(area).sum::<f64>() / n.max(1) as f64;
        let (along, place) = (seed.stream("hull part"), seed.stream("hull place"));
        let mut samples = Vec::with_capacity(n);
        let (mut end, mut triangles) = (0.0, self.triangles.iter());
        let mut current = None;
        for i in 0..n as u64 {
            let at = part * (i as f64 + f64::from(along.unit(i)));
            while current.is_none() || end <= at {
                // Sums round: the last place may lie past the last triangle.
                let Some(next) = triangles.next() else { break };
                end += area(next);
                current = Some(next);
            }
            let Some(&triangle) = current else { break };
            let (u, v) = (place.unit(2 * i), place.unit(2 * i + 1));
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            samples.push(self.at(triangle, [1.0 - u - v, u, v]));
        }
        samples
    }

    /// The place of the surface that is nearest to a point, or another that is at most 1 % farther from it;
    /// `None` when the point is not finite, or too
    /// far off (10¹⁸ m) to tell.
    ///
    /// # Complexity
    /// O(log triangles) near the surface; more where many triangles are about as near.
    #[must_use]
    pub fn nearest(&self, point: Vec3) -> Option<Sample> {
        let triangle =
            *self.triangles.get(self.nearest.find(&self.positions, &self.triangles, point)?)?;
        let weights = closest(triangle.map(|v| self.positions[v as usize]), point);
        Some(self.at(triangle, weights))
    }

    /// The unit normal of the surface where it is nearest to a point; zero where
    /// [`nearest`](Self::nearest) has none.
    #[must_use]
    pub fn nearest_normal(&self, point: Vec3) -> Vec3 {
        self.nearest(point).map_or(Vec3::ZERO, |sample| sample.normal)
    }

    fn at(&self, triangle: [u32; 3], weights: [f32; 3]) -> Sample {
        let mean = |column: &[Vec3]| {
            let [a, b, c] = triangle.map(|v| column[v as usize]);
            weights[0] * a + weights[1] * b + weights[2] * c
        };
        let normal = mean(&self.normals).normalize_or(self.normals[triangle[0] as usize]);
        Sample { position: mean(&self.positions), normal }
    }
}
