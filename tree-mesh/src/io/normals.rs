//! Normals for surfaces that came without, or with bad ones.

use crate::mesh::Surface;
use glam::Vec3;

/// Adds each triangle's normal, weighted by its area, to its corners' rows of `sums`.
///
/// Rows that do not exist are passed over.
pub(super) fn add_faces(positions: &[Vec3], indices: &[u32], sums: &mut [Vec3]) {
    for triangle in indices.chunks_exact(3) {
        let [a, b, c] = [triangle[0] as usize, triangle[1] as usize, triangle[2] as usize];
        let (Some(&pa), Some(&pb), Some(&pc)) =
            (positions.get(a), positions.get(b), positions.get(c))
        else {
            continue;
        };
        let normal = (pb - pa).cross(pc - pa);
        if normal.is_finite() {
            for row in [a, b, c] {
                if let Some(sum) = sums.get_mut(row) {
                    *sum += normal;
                }
            }
        }
    }
}

/// The direction of `v`, even where its length would overflow or vanish; up for none.
pub(super) fn direction(v: Vec3) -> Vec3 {
    unit(v).unwrap_or(Vec3::Y)
}

/// The direction of `v`; `None` when it has none.
pub(super) fn unit(v: Vec3) -> Option<Vec3> {
    let size = v.abs().max_element();
    // Brought near 1 first: the square of a tiny or huge length is 0 or infinite.
    if size > 0.0 && size < f32::INFINITY { (v / size).try_normalize() } else { None }
}

/// Sets `normals` to the mean of the triangles around each vertex. Smooth wherever triangles share a
/// vertex, flat where they do not.
///
/// # Complexity
/// O(vertices + triangles).
pub(super) fn compute(surface: &mut Surface) {
    let mut sums = vec![Vec3::ZERO; surface.positions.len()];
    add_faces(&surface.positions, &surface.indices, &mut sums);
    for sum in &mut sums {
        *sum = direction(*sum);
    }
    surface.normals = sums;
}

/// Brings normals to unit length; those without any are computed. Returns how many were.
pub(super) fn repair(surface: &mut Surface) -> u64 {
    let mut bad = 0;
    for normal in &mut surface.normals {
        if !(0.999..=1.001).contains(&normal.length_squared()) {
            *normal = unit(*normal).unwrap_or_else(|| {
                bad += 1;
                Vec3::ZERO
            });
        }
    }
    if bad > 0 {
        let given = std::mem::take(&mut surface.normals);
        compute(surface);
        for (normal, given) in surface.normals.iter_mut().zip(given) {
            if given != Vec3::ZERO {
                *normal = given;
            }
        }
    }
    bad
}
