//! Step 1: one soup of triangles of unit size, with vertices at one place made one.
//!
//! Vertices are sorted by the cell of a fine grid four times, the grid moved by a quarter of a cell
//! along its diagonal each time. Two vertices nearer than a quarter cell are kept apart along each
//! axis by at most one of the four grids, so at least one grid joins them.

use super::part::check;
use super::rows::Sets;
use crate::error::{ModelError, Result};
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use tree_core::{Control, Part, Resource};

/// A soup of triangles. Positions are relative to the mesh's centre, in units of its size.
#[derive(Debug)]
pub(super) struct Soup {
    /// Welded vertices, within about −0.5 to 0.5.
    pub(super) positions: Vec<Vec3>,
    /// Corners of each triangle, all different.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Part and number there of each triangle.
    pub(super) sources: Vec<(u32, u32)>,
    /// Connected component of each triangle within its part.
    pub(super) components: Vec<u32>,
    pub(super) n_components: usize,
    /// Triangles without area, and triangles of one part that lie on one another.
    pub(super) n_degenerate: usize,
    center: DVec3,
    /// Longest side of the box around the mesh.
    pub(super) size: f64,
}

impl Soup {
    /// Back to the units of the mesh.
    pub(super) fn outward(&self, point: Vec3) -> Vec3 {
        let most = DVec3::splat(f64::from(f32::MAX));
        (self.center + self.size * point.as_dvec3()).clamp(-most, most).as_vec3()
    }

    /// The corners of a triangle.
    pub(super) fn corners(&self, triangle: u32) -> [Vec3; 3] {
        self.triangles[triangle as usize].map(|corner| self.positions[corner as usize])
    }
}

/// Checks the parts and welds them.
pub(super) fn weld(parts: &[Part<'_>], share: f32, control: &Control) -> Result<Soup> {
    let n_triangles: u64 = parts.iter().map(|part| part.indices.len() as u64 / 3).sum();
    control.limits.check(Resource::Triangles, n_triangles)?;
    let n_vertices: u64 = parts.iter().map(|part| part.positions.len() as u64).sum();
    // Not a limit of its own: a mesh needs no more vertices than corners.
    control.limits.check(Resource::Triangles, n_vertices / 3)?;
    if n_vertices.max(3 * n_triangles) >= u64::from(u32::MAX) {
        let problem = format!("{n_vertices} vertices together, at most {} can be", u32::MAX - 1);
        return Err(ModelError::BadPart { part: parts.len().saturating_sub(1), problem });
    }
    for (number, part) in parts.iter().enumerate() {
        check(part, number)?;
    }
    let (center, size) = frame(parts)?;
    let inward = |p: &Vec3| ((p.as_dvec3() - center) / size).as_vec3();
    let positions: Vec<Vec3> = parts.iter().flat_map(|p| p.positions.iter().map(inward)).collect();
    control.check()?;
    let welded = join_near(&positions, share);
    control.check()?;
    Ok(triangles_of(parts, &positions, &welded, (center, size)))
}

/// Centre and longest side of the box around all vertices that are used.
fn frame(parts: &[Part<'_>]) -> Result<(DVec3, f64)> {
    let used = parts.iter().flat_map(|p| p.indices.iter().map(|&i| p.positions[i as usize]));
    let (low, high) = used.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| {
        (low.min(p.as_dvec3()), high.max(p.as_dvec3()))
    });
    let size = (high - low).max_element();
    // Below, f32 has no room for the differences between vertices.
    if size > f64::from(f32::MIN_POSITIVE) && size > 1e-6 * low.abs().max(high.abs()).max_element()
    {
        return Ok((0.5 * (low + high), size));
    }
    Err(ModelError::NoWood { problem: "the mesh has no triangles, or no extent" })
}

/// For each vertex the number of the welded one it becomes.
fn join_near(positions: &[Vec3], share: f32) -> (Vec<u32>, usize) {
    let mut sets = Sets::new(positions.len());
    let mut cells = Vec::with_capacity(positions.len());
    for shift in [0.0, 0.25, 0.5, 0.75] {
        cells.clear();
        cells.extend(positions.iter().zip(0_u32..).map(|(&p, i)| {
            let cell = (p / share + shift).floor();
            // A cast from float saturates; vertices that are not used may lie anywhere.
            ([cell.x as i32, cell.y as i32, cell.z as i32], i)
        }));
        cells.par_sort_unstable();
        for pair in cells.windows(2) {
            if pair[0].0 == pair[1].0 {
                sets.join(pair[0].1, pair[1].1);
            }
        }
    }
    sets.labels()
}

/// The corners in rising order: the same for both windings.
pub(super) fn sorted(mut corners: [u32; 3]) -> [u32; 3] {
    corners.sort_unstable();
    corners
}

fn triangles_of(
    parts: &[Part<'_>],
    positions: &[Vec3],
    (welded, n_welded): &(Vec<u32>, usize),
    (center, size): (DVec3, f64),
) -> Soup {
    let mut soup = Soup {
        positions: vec![Vec3::ZERO; *n_welded],
        triangles: Vec::new(),
        sources: Vec::new(),
        components: Vec::new(),
        n_components: 0,
        n_degenerate: 0,
        center,
        size,
    };
    // Backwards, so that the first vertex of a set gives the place.
    for (&to, &position) in welded.iter().zip(positions).rev() {
        soup.positions[to as usize] = position;
    }
    let mut first = 0;
    // Of each part, the vertices it uses are numbered anew: parts do not connect here.
    let mut seen = vec![u32::MAX; *n_welded];
    let mut local_of_corner = Vec::new();
    let mut n_local = 0;
    for (number, part) in parts.iter().enumerate() {
        let first_local = n_local;
        let mut own = Vec::with_capacity(part.indices.len() / 3);
        for (row, corners) in part.indices.chunks_exact(3).enumerate() {
            let corner = |i: usize| welded[first + corners[i] as usize];
            let triangle = [corner(0), corner(1), corner(2)];
            let [a, b, c] = triangle.map(|v| soup.positions[v as usize]);
            let flat = (b - a).cross(c - a).length_squared() <= 0.0;
            if triangle[0] == triangle[1]
                || triangle[1] == triangle[2]
                || triangle[2] == triangle[0]
            {
                soup.n_degenerate += 1;
                continue;
            }
            // Slivers stay: they hold the surface together.
            soup.n_degenerate += usize::from(flat);
            own.push((sorted(triangle), row as u32, triangle));
        }
        own.sort_unstable();
        let all = own.len();
        own.dedup_by_key(|&mut (corners, ..)| corners);
        soup.n_degenerate += all - own.len();
        own.sort_unstable_by_key(|&(_, row, _)| row);
        for (_, row, triangle) in own {
            soup.triangles.push(triangle);
            soup.sources.push((number as u32, row));
            local_of_corner.push(triangle.map(|v| {
                let local = &mut seen[v as usize];
                // Numbers below `first_local` are left from other parts.
                if *local == u32::MAX || *local < first_local {
                    *local = n_local;
                    n_local += 1;
                }
                *local
            }));
        }
        first += part.positions.len();
    }
    let mut sets = Sets::new(n_local as usize);
    for [a, b, c] in &local_of_corner {
        sets.join(*a, *b);
        sets.join(*b, *c);
    }
    let (labels, n) = sets.labels();
    soup.components = local_of_corner.iter().map(|corners| labels[corners[0] as usize]).collect();
    soup.n_components = n;
    soup
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [u32; 6] = [0, 1, 2, 3, 4, 5];

    fn two_triangles(gap: f32) -> Vec<Vec3> {
        vec![
            Vec3::ZERO,
            Vec3::X,
            Vec3::Y,
            Vec3::new(1.0 + gap, gap, -gap),
            Vec3::new(gap, 1.0 - gap, gap),
            Vec3::ONE,
        ]
    }

    #[test]
    fn vertices_within_a_quarter_cell_are_joined_and_farther_ones_not() {
        let welded = |gap| {
            let positions = two_triangles(gap);
            let part = Part { positions: &positions, indices: &TRIANGLE, ..Default::default() };
            let soup = weld(&[part], 1e-3, &Control::default()).unwrap();
            (soup.positions.len(), soup.n_components)
        };
        assert_eq!(welded(0.0), (4, 1));
        assert_eq!(welded(2e-4), (4, 1));
        assert_eq!(welded(3e-3), (6, 2));
    }

    #[test]
    fn parts_share_vertices_but_not_components() {
        let positions = two_triangles(0.0);
        let part = Part { positions: &positions, indices: &TRIANGLE, ..Default::default() };
        let soup = weld(&[part, part], 1e-3, &Control::default()).unwrap();
        assert_eq!((soup.positions.len(), soup.n_components), (4, 2));
        assert!((soup.outward(soup.positions[1]) - Vec3::X).length() < 1e-6);
    }

    #[test]
    fn bad_parts_are_refused_by_name() {
        let positions = two_triangles(0.0);
        let good = Part { positions: &positions, indices: &TRIANGLE, ..Default::default() };
        let refuse = |part| weld(&[good, part], 1e-3, &Control::default()).unwrap_err().to_string();
        assert!(refuse(Part { indices: &[0, 1, 6], ..good }).contains("index 6"));
        assert!(refuse(Part { indices: &[0, 1], ..good }).contains("multiple of 3"));
        assert!(refuse(Part { uvs: &[glam::Vec2::ZERO], ..good }).contains("1 uvs"));
        let holes = [Vec3::NAN; 6];
        assert!(refuse(Part { positions: &holes, ..good }).contains("parts[1].positions[0]"));
        let none = weld(&[], 1e-3, &Control::default()).unwrap_err();
        assert!(matches!(none, ModelError::NoWood { .. }), "{none}");
    }
}
