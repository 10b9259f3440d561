//! The box around leaves, in the frame of a branch.

use crate::element::Elements;
use glam::{Mat3, Quat, Vec3};
use tree_mesh::Mesh;

/// Thinnest half side, as a share of the longest: flat branches still have planes with an area.
const THINNEST: f32 = 1e-2;

/// A fitted box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fit {
    pub(super) center: Vec3,
    pub(super) half: Vec3,
    pub(super) turn: Quat,
}

impl Fit {
    pub(super) fn volume(&self) -> f64 {
        self.half.to_array().iter().map(|&half| 2.0 * f64::from(half)).product()
    }
}

/// The turtle's frame for a heading: left is level, up is what remains. For a heading straight up or down,
/// left is −X.
fn turtle(heading: Vec3) -> Quat {
    let heading = heading.normalize_or(Vec3::Y);
    let flat = Vec3::new(heading.z, 0.0, -heading.x);
    let left = if flat.length_squared() < 1e-6 { Vec3::NEG_X } else { flat.normalize() };
    Quat::from_mat3(&Mat3::from_cols(left, heading, left.cross(heading))).normalize()
}

/// The box around the vertices of `leaves`, headed from `base` to their middle. None for a single
/// point, or nothing.
pub(super) fn fit(mesh: &Mesh, elements: &Elements, leaves: &[u32], base: Vec3) -> Option<Fit> {
    let sum: Vec3 = leaves.iter().map(|&leaf| elements.centers[leaf as usize]).sum();
    let turn = turtle(sum / leaves.len().max(1) as f32 - base);
    let back = Mat3::from_quat(turn).transpose();
    let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for &leaf in leaves {
        let surface = &mesh.surfaces[elements.surface[leaf as usize] as usize];
        for &triangle in elements.triangles_of(leaf as usize) {
            let at = 3 * triangle as usize;
            for &row in &surface.indices[at..at + 3] {
                let p = back * (surface.positions[row as usize] - base);
                (min, max) = (min.min(p), max.max(p));
            }
        }
    }
    let half = 0.5 * (max - min);
    let longest = half.max_element();
    if !(longest > 1e-6 && longest < 1e6) {
        return None;
    }
    let half = half.max(Vec3::splat(THINNEST * longest));
    Some(Fit { center: base + turn * (0.5 * (min + max)), half, turn })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_frame_is_right_handed_with_a_level_left() {
        for heading in [Vec3::Y, Vec3::NEG_Y, Vec3::X, Vec3::new(0.3, 0.5, -0.2), Vec3::ZERO] {
            let turn = turtle(heading);
            assert!((turn * Vec3::Y).distance(heading.normalize_or(Vec3::Y)) < 1e-5);
            assert!((turn * Vec3::X).y.abs() < 1e-5);
        }
    }
}
