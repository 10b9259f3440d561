//! One connected piece of wood: vertices numbered from 0, triangles and edges.

use super::rows::{Rows, Sets};
use super::weld::Soup;
use glam::Vec3;

/// A connected surface.
#[derive(Debug)]
pub(super) struct Surface {
    pub(super) positions: Vec<Vec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// Both ends of each edge, the lower number first.
    pub(super) edges: Vec<[u32; 2]>,
    /// Edges of each triangle: from its first corner to its second, and so on.
    pub(super) edges_of: Vec<[u32; 3]>,
    /// Whether each edge is the side of one triangle only.
    pub(super) open: Vec<bool>,
}

/// A hole, or the open end of a tube.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rim {
    /// Any of its vertices.
    pub(super) vertex: u32,
    pub(super) length: f32,
}

impl Surface {
    /// Numbers what the triangles use from 0.
    pub(super) fn new(positions: &[Vec3], triangles: impl Iterator<Item = [u32; 3]>) -> Self {
        let mut triangles: Vec<[u32; 3]> = triangles.collect();
        let mut used: Vec<u32> = triangles.iter().flatten().copied().collect();
        used.sort_unstable();
        used.dedup();
        for corner in triangles.iter_mut().flatten() {
            *corner = used.partition_point(|vertex| vertex < corner) as u32;
        }
        // Each side of each triangle, sorted so that sides between the same vertices meet.
        let mut sides: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * triangles.len());
        for (triangle, &[a, b, c]) in triangles.iter().enumerate() {
            for (i, (a, b)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
                sides.push(([a.min(b), a.max(b)], (3 * triangle + i) as u32));
            }
        }
        sides.sort_unstable();
        let mut edges: Vec<[u32; 2]> = Vec::with_capacity(sides.len() / 2 + 3);
        let mut edges_of = vec![[0; 3]; triangles.len()];
        let mut open = Vec::with_capacity(edges.capacity());
        for (edge, side) in sides {
            if edges.last() == Some(&edge) {
                open.pop();
                open.push(false);
            } else {
                edges.push(edge);
                open.push(true);
            }
            edges_of[side as usize / 3][side as usize % 3] = edges.len() as u32 - 1;
        }
        let positions = used.iter().map(|&vertex| positions[vertex as usize]).collect();
        Self { positions, triangles, edges, edges_of, open }
    }

    /// All rims, and the rim of each vertex; `u32::MAX` for vertices on none.
    pub(super) fn rims(&self) -> (Vec<Rim>, Vec<u32>) {
        let mut sets = Sets::new(self.positions.len());
        let rim_edges = || self.edges.iter().zip(&self.open).filter(|(_, open)| **open);
        for (&[a, b], _) in rim_edges() {
            sets.join(a, b);
        }
        let (mut rims, mut rim_of) = (Vec::<Rim>::new(), vec![u32::MAX; self.positions.len()]);
        for (&[a, b], _) in rim_edges() {
            let first = sets.find(a);
            if rim_of[first as usize] == u32::MAX {
                rim_of[first as usize] = rims.len() as u32;
                rims.push(Rim { vertex: first, length: 0.0 });
            }
            let rim = rim_of[first as usize];
            (rim_of[a as usize], rim_of[b as usize]) = (rim, rim);
            rims[rim as usize].length +=
                self.positions[a as usize].distance(self.positions[b as usize]);
        }
        (rims, rim_of)
    }

    /// Whether this is a tube open at both ends: a ring, topologically.
    pub(super) fn is_tube(&self, rims: &[Rim]) -> bool {
        rims.len() == 2 && self.positions.len() + self.triangles.len() == self.edges.len()
    }

    /// Triangles round each vertex.
    pub(super) fn fans(&self) -> Rows {
        let corners = self.triangles.iter().zip(0_u32..);
        let pairs = corners.flat_map(|(corners, triangle)| corners.map(|v| (v, triangle)));
        Rows::of_pairs(pairs, self.positions.len())
    }
}

/// Wood triangles grouped by connection, across parts now.
pub(super) fn connect(soup: &Soup, wood: &[u32]) -> Rows {
    let mut sets = Sets::new(soup.positions.len());
    for &triangle in wood {
        let [a, b, c] = soup.triangles[triangle as usize];
        sets.join(a, b);
        sets.join(b, c);
    }
    // Sets are numbered anew over the triangles: most vertices of a leafy tree are no wood.
    let mut number = vec![u32::MAX; soup.positions.len()];
    let mut n = 0;
    let mut pairs = Vec::with_capacity(wood.len());
    for &triangle in wood {
        let slot = &mut number[sets.find(soup.triangles[triangle as usize][0]) as usize];
        if *slot == u32::MAX {
            *slot = n;
            n += 1;
        }
        pairs.push((*slot, triangle));
    }
    Rows::of_pairs(pairs.iter().copied(), n as usize)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use std::f32::consts::TAU;

    /// A tube of rings with `sides` corners each round the given points, without caps.
    pub(in super::super) fn tube(points: &[(Vec3, f32)], sides: u32) -> (Vec<Vec3>, Vec<u32>) {
        let (mut positions, mut indices) = (Vec::new(), Vec::new());
        for (i, &(center, radius)) in points.iter().enumerate() {
            let (below, above) =
                (points[i.saturating_sub(1)], points[(i + 1).min(points.len() - 1)]);
            let along = (above.0 - below.0).normalize_or(Vec3::Y);
            let (x, z) = along.any_orthonormal_pair();
            for side in 0..sides {
                let (sin, cos) = libm::sincosf(TAU * side as f32 / sides as f32);
                positions.push(center + radius * (cos * x + sin * z));
                if i > 0 {
                    let (a, b) = (i as u32 * sides + side, i as u32 * sides + (side + 1) % sides);
                    indices.extend([a, a - sides, b, b, a - sides, b - sides]);
                }
            }
        }
        (positions, indices)
    }

    pub(in super::super) fn surface_of((positions, indices): &(Vec<Vec3>, Vec<u32>)) -> Surface {
        let triangles = indices.chunks_exact(3).map(|c| [c[0], c[1], c[2]]);
        Surface::new(positions, triangles)
    }

    #[test]
    fn a_tube_has_as_many_edges_as_euler_says() {
        let surface =
            surface_of(&tube(&[(Vec3::ZERO, 1.0), (Vec3::Y, 1.0), (Vec3::Y * 2.0, 1.0)], 5));
        let (rims, rim_of) = surface.rims();
        assert!(surface.is_tube(&rims));
        assert_eq!(rim_of.iter().filter(|&&rim| rim != u32::MAX).count(), 10);
        // A ring's characteristic is 0.
        assert_eq!(surface.positions.len() + surface.triangles.len(), surface.edges.len());
        for (corners, edges) in surface.triangles.iter().zip(&surface.edges_of) {
            for i in 0..3 {
                let (a, b) = (corners[i], corners[(i + 1) % 3]);
                assert_eq!(surface.edges[edges[i] as usize], [a.min(b), a.max(b)]);
            }
        }
    }
}
