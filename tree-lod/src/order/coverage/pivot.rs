//! Points that elements may grow about.

use super::Scene;
use glam::Vec3;
use rayon::prelude::*;
use std::f32::consts::TAU;

/// Directions in the plane of an element; one more option is its centre.
const DIRECTIONS: usize = 8;

/// The options of all candidates, the same number each.
pub(super) struct Pivots {
    pub(super) options: usize,
    points: Vec<Vec3>,
}

impl Pivots {
    /// Centres only.
    pub(super) fn centers(scene: &Scene<'_>, candidates: &[u32]) -> Self {
        let center = |&element: &u32| scene.elements.centers[element as usize];
        Self { options: 1, points: candidates.iter().map(center).collect() }
    }

    /// The centre, and points on the rim all around it.
    pub(super) fn rim(scene: &Scene<'_>, candidates: &[u32]) -> Self {
        let points = candidates.par_iter().flat_map_iter(|&element| rim(scene, element as usize));
        Self { options: DIRECTIONS + 1, points: points.collect() }
    }

    /// Options of a candidate, by its place in the list.
    pub(super) fn of(&self, candidate: usize) -> &[Vec3] {
        &self.points[candidate * self.options..(candidate + 1) * self.options]
    }
}

fn rim(scene: &Scene<'_>, element: usize) -> [Vec3; DIRECTIONS + 1] {
    let surface = &scene.stage.mesh().surfaces[scene.elements.surface[element] as usize];
    let center = scene.elements.centers[element];
    let corners = || {
        let vertices = scene.tier.of(element).iter().flatten();
        vertices.map(|&vertex| surface.positions[vertex as usize] - center)
    };
    let normal = scene.elements.normals[element];
    // Along the element, so that mirrored leaves choose among mirrored points.
    let far = corners().fold(Vec3::ZERO, |far, corner| {
        if corner.length_squared() > far.length_squared() { corner } else { far }
    });
    let along = far.reject_from(normal.normalize_or(Vec3::Y)).normalize_or(Vec3::X);
    let across = normal.cross(along).normalize_or(along.any_orthonormal_vector());
    std::array::from_fn(|option| {
        if option == DIRECTIONS {
            return center;
        }
        let (sin, cos) = libm::sincosf(TAU * option as f32 / DIRECTIONS as f32);
        let direction = along * cos + across * sin;
        let reach = corners().map(|corner| corner.dot(direction)).fold(0.0_f32, f32::max);
        center + direction * reach
    })
}
