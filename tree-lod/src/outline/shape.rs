//! Elements in numbers of their own, and their connected blades.

use glam::Vec3;

/// Triangles of one element in numbers of its own: 0 is the lowest of its vertices. Elements that were
/// made alike have the same.
pub(super) struct Local {
    /// Vertex of the surface for each local number, rising.
    pub(super) vertices: Vec<u32>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Local {
    pub(super) fn of(triangles: &[[u32; 3]]) -> Self {
        let vertices = Self::vertices(triangles);
        let number = |v: u32| vertices.binary_search(&v).unwrap_or_default() as u32;
        let triangles = triangles.iter().map(|t| t.map(number)).collect();
        Self { vertices, triangles }
    }

    pub(super) fn vertices(triangles: &[[u32; 3]]) -> Vec<u32> {
        let mut vertices = triangles.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }
}

/// A connected piece in its own frame: about the mean of its surface, with an area of 1.
#[derive(Clone, Debug)]
pub(super) struct Blade {
    pub(super) points: Vec<Vec3>,
    /// Local vertex of the element that stands for each point.
    pub(super) vertices: Vec<u32>,
    /// Rows of points. Triangles without area are left out.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Area in the element's units, squared.
    pub(super) area: f32,
}

impl Blade {
    pub(super) fn corners(&self, triangle: [u32; 3]) -> [Vec3; 3] {
        triangle.map(|p| self.points[p as usize])
    }

    /// Vector area of a triangle.
    pub(super) fn cross(&self, triangle: [u32; 3]) -> Vec3 {
        let [a, b, c] = self.corners(triangle);
        0.5 * (b - a).cross(c - a)
    }

    pub(super) fn area_of(&self, triangles: &[[u32; 3]]) -> f32 {
        triangles.iter().map(|&t| self.cross(t).length()).sum()
    }
}

/// The connected blades of an element, by their first triangle. Vertices at the same place are one.
pub(super) fn blades(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Blade> {
    let first = first_there(positions);
    let triangles: Vec<[u32; 3]> = triangles
        .iter()
        .map(|t| t.map(|v| first[v as usize]))
        .filter(|&[a, b, c]| {
            let [p, q, r] = [a, b, c].map(|v| positions[v as usize]);
            (q - p).cross(r - p).length_squared() > 0.0
        })
        .collect();
    let mut parents: Vec<u32> = (0..positions.len() as u32).collect();
    for &[a, b, c] in &triangles {
        join(&mut parents, a, b);
        join(&mut parents, b, c);
    }
    let mut rows: Vec<(u32, u32)> = triangles
        .iter()
        .enumerate()
        .map(|(row, t)| (root(&mut parents, t[0]), row as u32))
        .collect();
    rows.sort_unstable();
    rows.chunk_by(|a, b| a.0 == b.0)
        .filter_map(|of| {
            let own: Vec<_> = of.iter().map(|&(_, row)| triangles[row as usize]).collect();
            framed(positions, &own)
        })
        .collect()
}

/// A blade about its mean, with area 1; none when that cannot be.
fn framed(positions: &[Vec3], triangles: &[[u32; 3]]) -> Option<Blade> {
    let local = Local::of(triangles);
    let points = local.vertices.iter().map(|&v| positions[v as usize]).collect();
    let mut blade =
        Blade { points, vertices: local.vertices, triangles: local.triangles, area: 0.0 };
    blade.area = blade.area_of(&blade.triangles);
    let moment: Vec3 = blade
        .triangles
        .iter()
        .map(|&t| blade.cross(t).length() * blade.corners(t).iter().sum::<Vec3>() / 3.0)
        .sum();
    let (center, scale) = (moment / blade.area, 1.0 / blade.area.sqrt());
    blade.points.iter_mut().for_each(|p| *p = (*p - center) * scale);
    blade.points.iter().all(|p| p.is_finite()).then_some(blade)
}

/// For each vertex the first one at the same place.
fn first_there(positions: &[Vec3]) -> Vec<u32> {
    // Adding zero makes −0 and 0 the same.
    let key = |v: u32| (positions[v as usize] + Vec3::ZERO).to_array().map(f32::to_bits);
    let mut order: Vec<u32> = (0..positions.len() as u32).collect();
    order.sort_unstable_by_key(|&v| (key(v), v));
    let mut first = vec![0; positions.len()];
    for same in order.chunk_by(|&a, &b| key(a) == key(b)) {
        same.iter().for_each(|&v| first[v as usize] = same[0]);
    }
    first
}

fn root(parents: &mut [u32], mut v: u32) -> u32 {
    while parents[v as usize] != v {
        let above = parents[parents[v as usize] as usize];
        parents[v as usize] = above;
        v = above;
    }
    v
}

fn join(parents: &mut [u32], a: u32, b: u32) {
    let (a, b) = (root(parents, a), root(parents, b));
    parents[a.max(b) as usize] = a.min(b);
}
