//! Centre, area, normal and size.

use super::Elements;
use glam::Vec3;
use rayon::prelude::*;
use tree_mesh::{Mesh, Surface};

/// Fills the columns that follow from the triangles.
pub(super) fn measure(mesh: &Mesh, elements: &mut Elements) {
    let measured: Vec<_> = (0..elements.surface.len())
        .into_par_iter()
        .with_min_len(256)
        .map(|element| {
            let surface = &mesh.surfaces[elements.surface[element] as usize];
            one(surface, elements.triangles_of(element))
        })
        .collect();
    elements.centers = measured.iter().map(|m| m.center).collect();
    elements.normals = measured.iter().map(|m| m.normal).collect();
    elements.areas = measured.iter().map(|m| m.area).collect();
    elements.radii = measured.iter().map(|m| m.radius).collect();
}

struct Measured {
    center: Vec3,
    normal: Vec3,
    area: f32,
    radius: f32,
}

fn one(surface: &Surface, triangles: &[u32]) -> Measured {
    let corners = |&triangle: &u32| {
        let at = 3 * triangle as usize;
        [0, 1, 2].map(|k| surface.positions[surface.indices[at + k] as usize])
    };
    let (mut area, mut normal, mut moment) = (0.0, Vec3::ZERO, Vec3::ZERO);
    for [a, b, c] in triangles.iter().map(corners) {
        let cross = 0.5 * (b - a).cross(c - a);
        let size = cross.length();
        area += size;
        normal += cross;
        moment += size * (a + b + c) / 3.0;
    }
    let points = || triangles.iter().flat_map(corners);
    let n = 3.0 * triangles.len().max(1) as f32;
    // Without area, the corners' mean will do.
    let center = if area > 0.0 { moment / area } else { points().sum::<Vec3>() / n };
    let radius = points().fold(0.0_f32, |far, p| far.max(p.distance_squared(center))).sqrt();
    // A closed blade's normals cancel but for rounding.
    let normal =
        if normal.length() > 1e-3 * area { normal.normalize_or_zero() } else { Vec3::ZERO };
    Measured { center, normal, area, radius }
}
