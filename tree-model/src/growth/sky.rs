//! How much of the sky an obstacle leaves, and where.
//!
//! The brightness of the sky is cos² of the angle to its brightest point, above the horizon (Pirk et al.
//! 2012, Eq. 3). Rays go out from the points of a coarse lattice and are traced by the distance to the
//! obstacle; points between are interpolated.

use crate::path::Obstacle;
use glam::{IVec3, Vec3};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::f32::consts::TAU;

/// Rays to the upper hemisphere.
const N_RAYS: u32 = 96;
/// A ray that comes nearer than this share of the spacing has hit.
const TOUCH_SHARE: f32 = 0.02;
/// Steps after which a ray that only creeps along a surface counts as hidden.
const MAX_STEPS: u32 = 64;
/// Obstacles further away than so many spacings do not shade.
const RANGE: f32 = 256.0;
/// Below this weight of the lattice points outside the obstacle rays are traced from the point itself.
const LEAST_WEIGHT: f32 = 0.05;
/// Coordinates of lattice points stay this far from the end of an i32.
const MAX_CELL: f32 = 1e9;

/// The part of the sky seen from one place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Exposure {
    /// Share of the sky's light that arrives, 0 to 1.
    pub(crate) share: f32,
    /// Mean direction the light comes from, by the light of the open sky: shorter than 1.
    pub(crate) mean: Vec3,
}

/// The sky behind an obstacle.
#[derive(Clone, Debug)]
pub(crate) struct Sky {
    obstacle: Option<Obstacle>,
    spacing: f32,
    /// Unit vectors, and the share of the light that comes from each.
    rays: Vec<(Vec3, f32)>,
    open: Exposure,
    /// `None` for points in the obstacle.
    seen: BTreeMap<[i32; 3], Option<Exposure>>,
}

impl Sky {
    /// The sky whose brightest point lies in direction `light`, behind `obstacle`; `spacing` of the lattice
    /// in metres.
    #[must_use]
    pub(crate) fn new(light: Vec3, obstacle: Option<&Obstacle>, spacing: f32) -> Self {
        let light = light.normalize_or(Vec3::Y);
        let weight = |ray: Vec3| ray.dot(light).max(0.0) * ray.dot(light).max(0.0);
        let directions: Vec<Vec3> = (0..N_RAYS).map(ray).collect();
        let all: f32 = directions.iter().map(|&ray| weight(ray)).sum();
        // A light from straight below the horizon leaves an even sky.
        let share = |ray| if all > 0.0 { weight(ray) / all } else { 1.0 / N_RAYS as f32 };
        let rays: Vec<(Vec3, f32)> = directions.into_iter().map(|ray| (ray, share(ray))).collect();
        let mean = rays.iter().fold(Vec3::ZERO, |sum, &(ray, share)| sum + share * ray);
        let open = Exposure { share: 1.0, mean };
        Self { obstacle: obstacle.cloned(), spacing, rays, open, seen: BTreeMap::new() }
    }

    /// Without any obstacle.
    #[must_use]
    pub(crate) fn open(&self) -> Exposure {
        self.open
    }

    /// Traces the rays from one point. Nothing is remembered.
    ///
    /// # Complexity
    /// O(1) questions for the distance to the obstacle.
    #[must_use]
    pub(crate) fn trace(&self, point: Vec3) -> Exposure {
        self.trace_outside(point).unwrap_or_default()
    }

    fn trace_outside(&self, point: Vec3) -> Option<Exposure> {
        let Some(obstacle) = &self.obstacle else { return Some(self.open) };
        if obstacle.holds(point) {
            return None;
        }
        let mut seen = Exposure::default();
        for &(ray, share) in &self.rays {
            if self.is_clear(obstacle, point, ray) {
                seen.share += share;
                seen.mean += share * ray;
            }
        }
        Some(Exposure { share: seen.share.min(1.0), ..seen })
    }

    fn is_clear(&self, obstacle: &Obstacle, point: Vec3, ray: Vec3) -> bool {
        let mut along = 0.0;
        for _ in 0..MAX_STEPS {
            let step = obstacle.volume.distance(point + along * ray).unwrap_or(f32::INFINITY);
            if step < TOUCH_SHARE * self.spacing {
                // The first step may start beside a wall.
                if along > 0.0 {
                    return false;
                }
            }
            along += step.max(TOUCH_SHARE * self.spacing);
            if along > RANGE * self.spacing {
                return true;
            }
        }
        false
    }

    fn corner(&self, point: Vec3) -> (IVec3, Vec3) {
        let cell = (point / self.spacing).clamp(Vec3::splat(-MAX_CELL), Vec3::splat(MAX_CELL));
        (cell.floor().as_ivec3(), cell - cell.floor())
    }

    /// Traces from all lattice points around `points` that were not traced yet, in parallel.
    pub(crate) fn cover(&mut self, points: &[Vec3]) {
        if self.obstacle.is_none() {
            return;
        }
        let mut missing: Vec<IVec3> = points
            .iter()
            .flat_map(|&point| CORNERS.map(|corner| self.corner(point).0 + corner))
            .filter(|cell| !self.seen.contains_key(&cell.to_array()))
            .collect();
        missing.sort_unstable_by_key(|cell| cell.to_array());
        missing.dedup();
        let trace = |cell: &IVec3| self.trace_outside(cell.as_vec3() * self.spacing);
        let traced: Vec<Option<Exposure>> = missing.par_iter().map(trace).collect();
        self.seen.extend(missing.into_iter().map(IVec3::into).zip(traced));
    }

    /// What is seen from a point, between the lattice points around it; the open sky where these were not
    /// [covered](Self::cover).
    #[must_use]
    pub(crate) fn at(&self, point: Vec3) -> Exposure {
        if self.obstacle.is_none() {
            return self.open;
        }
        let (cell, within) = self.corner(point);
        let (mut sum, mut weights) = (Exposure::default(), 0.0);
        for corner in CORNERS {
            let near = corner.as_vec3() * within + (1.0 - corner.as_vec3()) * (1.0 - within);
            let weight = near.x * near.y * near.z;
            // What lies in the obstacle says nothing about the sky beside it.
            let seen =
                self.seen.get(&(cell + corner).to_array()).copied().unwrap_or(Some(self.open));
            let Some(seen) = seen else { continue };
            sum.share += weight * seen.share;
            sum.mean += weight * seen.mean;
            weights += weight;
        }
        if weights < LEAST_WEIGHT {
            return self.trace(point);
        }
        Exposure { share: sum.share / weights, mean: sum.mean / weights }
    }
}

const CORNERS: [IVec3; 8] = [
    IVec3::new(0, 0, 0),
    IVec3::new(1, 0, 0),
    IVec3::new(0, 1, 0),
    IVec3::new(1, 1, 0),
    IVec3::new(0, 0, 1),
    IVec3::new(1, 0, 1),
    IVec3::new(0, 1, 1),
    IVec3::new(1, 1, 1),
];

/// Evenly over the upper hemisphere, on a Fibonacci spiral.
fn ray(number: u32) -> Vec3 {
    let height = (number as f32 + 0.5) / N_RAYS as f32;
    let turn = crate::foliage::GOLDEN_ANGLE * number as f32 % TAU;
    let flat = (1.0 - height * height).max(0.0).sqrt();
    Vec3::new(flat * libm::cosf(turn), height, flat * libm::sinf(turn))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tree_core::Volume;

    fn wall() -> Obstacle {
        Obstacle { volume: Volume::half_space(Vec3::X, -Vec3::X).unwrap(), clearance: 0.0 }
    }

    #[test]
    fn a_wall_hides_half_of_the_sky_and_turns_the_rest_away() {
        let sky = Sky::new(Vec3::Y, Some(&wall()), 0.5);
        let beside = sky.trace(Vec3::new(0.9, 0.0, 0.0));
        assert!((0.4..0.6).contains(&beside.share), "{beside:?}");
        assert!(beside.mean.x < -0.1, "{beside:?}");
        let inside = sky.trace(Vec3::new(3.0, 0.0, 0.0));
        assert_eq!(inside, Exposure::default());
    }

    #[test]
    fn lattice_points_in_the_wall_do_not_darken_what_is_beside_it() {
        let mut sky = Sky::new(Vec3::Y, Some(&wall()), 0.8);
        for x in [0.5, 0.7, 0.9, 0.99] {
            let point = Vec3::new(x, 0.3, 0.2);
            sky.cover(&[point]);
            assert!((0.4..0.62).contains(&sky.at(point).share), "{x}: {:?}", sky.at(point));
        }
    }

    #[test]
    fn without_an_obstacle_all_of_it_is_seen() {
        let sky = Sky::new(Vec3::new(1.0, 1.0, 0.0), None, 0.5);
        assert_eq!(sky.at(Vec3::ZERO), sky.open());
        assert!(sky.open().share == 1.0 && sky.open().mean.x > 0.1);
        assert!(Sky::new(-Vec3::Y, None, 0.5).open().mean.y > 0.4);
    }

    #[test]
    fn between_traced_points_it_is_interpolated() {
        let mut sky = Sky::new(Vec3::Y, Some(&wall()), 0.5);
        let point = Vec3::new(0.25, 0.25, 0.25);
        assert_eq!(sky.at(point), sky.open());
        sky.cover(&[point]);
        let (found, traced) = (sky.at(point), sky.trace(point));
        assert!((found.share - traced.share).abs() < 0.05, "{found:?} {traced:?}");
    }
}
