//! The peer meshoptimizer (crate `meshopt`): the foliage of a mesh simplified to a share of its
//! triangles. The wood stays as it is, as with pruning.

use meshopt::{SimplifyOptions, simplify_decoder, simplify_sloppy_decoder};
use tree_core::glam::Vec3;
use tree_mesh::{Mesh, Surface};

/// An error that no simplification reaches: only the number of triangles ends it.
const ANY_ERROR: f32 = 1e10;

/// How meshoptimizer simplifies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum How {
    /// `simplify`, borders free, no options: with `Prune`, small pieces dropped whole, Q is the same to
    /// three digits.
    Simplify,
    /// `simplifySloppy`, which knows no pieces.
    Sloppy,
}

/// A simplified mesh.
pub(crate) struct Simplified {
    pub(crate) mesh: Mesh,
    /// Share of the foliage's triangles that is left; not always what was asked for.
    #[cfg_attr(not(test), expect(dead_code))]
    pub(crate) share: f64,
}

/// Simplifies the surfaces `foliage` of a mesh to about `share` of their triangles.
pub(crate) fn simplify(mesh: &Mesh, foliage: &[u32], share: f64, how: How) -> Simplified {
    let mut out = mesh.clone();
    for &number in foliage {
        let surface = &mut out.surfaces[number as usize];
        let points: Vec<[f32; 3]> = surface.positions.iter().map(|p| p.to_array()).collect();
        let target = 3 * (share * surface.n_triangles() as f64).round() as usize;
        let plain =
            |options| simplify_decoder(&surface.indices, &points, target, ANY_ERROR, options, None);
        let indices = match how {
            How::Simplify => plain(SimplifyOptions::None),
            How::Sloppy => {
                simplify_sloppy_decoder(&surface.indices, &points, target, ANY_ERROR, None)
            }
        };
        *surface = keep(surface, &indices);
    }
    let triangles = |mesh: &Mesh| -> usize {
        foliage.iter().map(|&number| mesh.surfaces[number as usize].n_triangles()).sum()
    };
    let share = triangles(&out) as f64 / triangles(mesh).max(1) as f64;
    Simplified { mesh: out, share }
}

/// The vertices that `indices` use, and nothing that holds for whole leaves only.
fn keep(surface: &Surface, indices: &[u32]) -> Surface {
    const NONE: u32 = u32::MAX;
    let mut new = vec![NONE; surface.positions.len()];
    let mut out = Surface { material: surface.material, ..Surface::default() };
    for &old in indices {
        let at = old as usize;
        if new[at] == NONE {
            new[at] = out.positions.len() as u32;
            out.positions.push(surface.positions[at]);
            out.normals.push(surface.normals[at]);
            out.uvs.push(surface.uvs[at]);
        }
        out.indices.push(new[at]);
    }
    out
}

/// Scales every connected piece of the foliage about its centre by √(A₀ / A), so that the area is that of
/// `full` again, as Nanite's "preserve area" does.
pub(super) fn restore_area(simplified: &Mesh, full: &Mesh, foliage: &[u32]) -> Mesh {
    let total = |mesh: &Mesh| -> f64 {
        foliage.iter().map(|&number| area(&mesh.surfaces[number as usize])).sum()
    };
    let (before, after) = (total(full), total(simplified));
    let mut out = simplified.clone();
    if after > 0.0 {
        let scale = (before / after).sqrt() as f32;
        for &number in foliage {
            scale_pieces(&mut out.surfaces[number as usize], scale);
        }
    }
    out
}

fn corners(surface: &Surface) -> impl Iterator<Item = ([u32; 3], [Vec3; 3])> + '_ {
    surface
        .indices
        .as_chunks::<3>()
        .0
        .iter()
        .map(|t| (*t, t.map(|i| surface.positions[i as usize])))
}

fn triangle_area([a, b, c]: [Vec3; 3]) -> f32 {
    0.5 * (b - a).cross(c - a).length()
}

/// Area of a surface in m².
pub(super) fn area(surface: &Surface) -> f64 {
    corners(surface).map(|(_, points)| f64::from(triangle_area(points))).sum()
}

fn scale_pieces(surface: &mut Surface, scale: f32) {
    let pieces = pieces(surface);
    let mut moments = vec![(Vec3::ZERO, 0.0_f32); surface.positions.len()];
    for (t, points) in corners(surface) {
        // A sliver without area still has a middle.
        let size = triangle_area(points).max(f32::MIN_POSITIVE);
        let moment = &mut moments[pieces[t[0] as usize] as usize];
        moment.0 += size * (points[0] + points[1] + points[2]) / 3.0;
        moment.1 += size;
    }
    for (p, &piece) in surface.positions.iter_mut().zip(&pieces) {
        let (moment, size) = moments[piece as usize];
        if size > 0.0 {
            let center = moment / size;
            *p = center + scale * (*p - center);
        }
    }
}

/// The piece of each vertex, by the lowest of its vertices.
fn pieces(surface: &Surface) -> Vec<u32> {
    let mut parents: Vec<u32> = (0..surface.positions.len() as u32).collect();
    fn root(parents: &mut [u32], mut i: u32) -> u32 {
        while parents[i as usize] != i {
            parents[i as usize] = parents[parents[i as usize] as usize];
            i = parents[i as usize];
        }
        i
    }
    for t in surface.indices.as_chunks::<3>().0 {
        for other in [t[1], t[2]] {
            let (a, b) = (root(&mut parents, t[0]), root(&mut parents, other));
            parents[a.max(b) as usize] = a.min(b);
        }
    }
    (0..parents.len() as u32).map(|i| root(&mut parents, i)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::modelled;
    use super::*;
    use tree_mesh::Mesh;

    /// Modelled leaves in a row.
    fn leaves(n: u32) -> Mesh {
        let leaf = modelled::leaf(0.6);
        let mut surface = Surface::default();
        for i in 0..n {
            let first = surface.positions.len() as u32;
            let at = Vec3::X * (2.0 * i as f32);
            surface.positions.extend(leaf.positions.iter().map(|&p| p + at));
            surface.normals.extend(&leaf.normals);
            surface.uvs.extend(&leaf.uvs);
            surface.indices.extend(leaf.indices.iter().map(|i| first + i));
            surface.anchors.push(at);
        }
        let materials = vec![modelled::material()];
        Mesh { surfaces: vec![surface], materials, branches: Vec::new() }
    }

    #[test]
    fn simplifying_reaches_the_share_and_restoring_the_area() {
        let full = leaves(50);
        for how in [How::Simplify, How::Sloppy] {
            let made = simplify(&full, &[0], 0.25, how);
            made.mesh.check().unwrap();
            assert!(made.share > 0.1 && made.share < 0.3, "{how:?}: {}", made.share);
            let restored = restore_area(&made.mesh, &full, &[0]);
            let ratio = area(&restored.surfaces[0]) / area(&full.surfaces[0]);
            assert!((ratio - 1.0).abs() < 1e-3, "{how:?}: {ratio}");
        }
    }

    #[test]
    fn pieces_grow_about_their_own_centres() {
        let mut mesh = leaves(3);
        let centers = |mesh: &Mesh| -> Vec<f32> {
            let of = |leaf: &[Vec3]| leaf.iter().map(|p| p.x).sum::<f32>() / leaf.len() as f32;
            mesh.surfaces[0].positions.chunks(modelled::VERTICES).map(of).collect()
        };
        let before = centers(&mesh);
        scale_pieces(&mut mesh.surfaces[0], 2.0);
        let apart =
            centers(&mesh).iter().zip(before).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(apart < 1e-4, "{apart}");
    }
}
