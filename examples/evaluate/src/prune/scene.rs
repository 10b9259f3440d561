//! Forests and ways through them.

use super::Outcome;
use std::f32::consts::TAU;
use tree_core::Seed;
use tree_core::glam::{Mat4, Quat, Vec2, Vec3};
use tree_core::seed::{Rng, uniform};
use tree_lod::preview::{Lens, Pose};

/// Trees of the scene of Fig. 7.17.
pub(super) const STANDARD: u32 = 1276;
/// Trees of the scene of Fig. 7.18.
pub(super) const LARGE: u32 = 5000;
/// Vertices of all full models of that scene, at least.
pub(super) const LARGE_VERTICES: u64 = 1_300_000_000;
/// Share of the ground that discs of half the least distance cover. Random packing ends at 0.547.
const FILLED: f32 = 0.4;
/// Darts per tree before the forest is taken to be full.
const DARTS: u32 = 400;
/// Half the width of the walk, in metres: no tree stands in the camera.
const WALK: f32 = 1.5;
/// Where the path begins and ends, in sides of the forest from its middle.
const OUTSIDE: f32 = 2.0;
/// Height of the eye on the walk and at the ends of the path, in metres.
const EYE: [f32; 2] = [1.7, 40.0];
/// Sides of the forest over which the path comes down, from the edge outwards.
const DESCENT: f32 = 1.5;
/// When the camera turns round; the walk ends at 2/3.
const TURN: [f32; 2] = [0.52, 0.66];
/// Vertical field of view in radians.
pub(super) const FOV: f32 = 0.9;

/// A tree in a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Instance {
    /// Number of its model.
    pub(super) model: u32,
    /// Foot of the trunk, on y = 0.
    pub(super) position: Vec3,
    /// Turn about +Y in radians.
    pub(super) yaw: f32,
    /// Factor on size, 0.8 to 1.2.
    pub(super) scale: f32,
}

impl Instance {
    pub(super) fn matrix(&self) -> Mat4 {
        let turn =
            Quat::from_xyzw(0.0, libm::sinf(0.5 * self.yaw), 0.0, libm::cosf(0.5 * self.yaw));
        Mat4::from_scale_rotation_translation(Vec3::splat(self.scale), turn, self.position)
    }
}

/// Trees on a square around the origin.
pub(super) struct Forest {
    pub(super) instances: Vec<Instance>,
    /// Side of the square in metres.
    pub(super) side: f32,
}

impl Forest {
    /// `n` trees of `n_models` models, no two nearer than `spacing` metres: Poisson discs by darts.
    ///
    /// # Errors
    /// When they do not find room.
    pub(super) fn new(n: u32, n_models: u32, spacing: f32, seed: Seed) -> Outcome<Self> {
        let disc = TAU / 8.0 * spacing * spacing;
        let side = (n as f32 * disc / FILLED).sqrt();
        let feet = poisson(n, side, spacing, seed.stream("positions"))?;
        let seed = seed.stream("trees");
        let instances = feet.iter().enumerate().map(|(i, foot)| {
            let mut rng = seed.child(i as u64).rng();
            let pick = uniform(&mut rng, 0.0, n_models as f32) as u32;
            Instance {
                model: pick.min(n_models.saturating_sub(1)),
                position: Vec3::new(foot.x, 0.0, foot.y),
                yaw: uniform(&mut rng, 0.0, TAU),
                scale: uniform(&mut rng, 0.8, 1.2),
            }
        });
        Ok(Self { instances: instances.collect(), side })
    }

    /// The distance in metres at which Cook's rule draws nothing any more (d = 1): from one end of the
    /// path to the far corner of the forest.
    pub(super) fn far(&self) -> f32 {
        Vec2::new(OUTSIDE + 0.5, 0.5).length() * self.side
    }

    /// The standard path: distant views at both ends, a walk through the forest between.
    pub(super) fn path(&self, frames: u32) -> Vec<Pose> {
        let frames = frames.max(2);
        (0..frames).map(|i| self.pose(i as f32 / (frames - 1) as f32)).collect()
    }

    /// Views of the whole forest from all around and above.
    pub(super) fn overviews(&self, frames: u32) -> Vec<Pose> {
        // The half diagonal must fit into half the field of view.
        let distance = 0.75 * self.side / libm::tanf(0.5 * FOV);
        let pose = |i| {
            let (sin, cos) = libm::sincosf(TAU * i as f32 / frames as f32);
            let eye = distance * Vec3::new(cos, 0.5, sin);
            Pose { eye, target: Vec3::ZERO, up: Vec3::Y, lens: Lens::Perspective { fov: FOV } }
        };
        (0..frames).map(pose).collect()
    }

    /// The path at a time from 0 to 1: a third each of approach, walk and leave.
    fn pose(&self, time: f32) -> Pose {
        let along = |time: f32| {
            let third = 3.0 * time.clamp(0.0, 1.0);
            // Outside the way per frame is longer; it joins at the edges of the forest.
            let sides = if third < 1.0 {
                -OUTSIDE + (OUTSIDE - 0.5) * third
            } else if third < 2.0 {
                third - 1.5
            } else {
                0.5 + (OUTSIDE - 0.5) * (third - 2.0)
            };
            self.way(sides)
        };
        // Looks where it will be a little later; at the end, on.
        let (eye, ahead) = (along(time), along(time + 0.02));
        let back = along(time - 0.02);
        let toward = if time < 0.98 { ahead - eye } else { eye - back };
        // Towards the end of the walk the camera turns round, so that the forest stays in view.
        let turned = ((time - TURN[0]) / (TURN[1] - TURN[0])).clamp(0.0, 1.0);
        let (sin, cos) = libm::sincosf(0.5 * TAU * turned * turned * (3.0 - 2.0 * turned));
        let (x, z) = (cos * toward.x + sin * toward.z, cos * toward.z - sin * toward.x);
        let down = if turned > 0.0 { -toward.y } else { toward.y };
        let target = eye + Vec3::new(x, down, z);
        Pose { eye, target, up: Vec3::Y, lens: Lens::Perspective { fov: FOV } }
    }

    fn way(&self, sides: f32) -> Vec3 {
        let out = ((sides.abs() - 0.5) / DESCENT).clamp(0.0, 1.0);
        let height = EYE[0] + (EYE[1] - EYE[0]) * out * out * (3.0 - 2.0 * out);
        let foot = walk(sides, self.side);
        Vec3::new(foot.x, height, foot.y)
    }
}

/// The walk on the ground: a line with gentle bends.
fn walk(sides: f32, side: f32) -> Vec2 {
    Vec2::new(sides, 0.08 * libm::sinf(TAU * 1.2 * sides.clamp(-0.6, 0.6))) * side
}

/// Whether a foot keeps clear of the walk: z of the walk at the same x is near enough the nearest.
fn clear(foot: Vec2, side: f32) -> bool {
    (walk(foot.x / side, side).y - foot.y).abs() > WALK
}

/// Darts that are at least `spacing` apart, on a grid whose cells hold one at most.
fn poisson(n: u32, side: f32, spacing: f32, seed: Seed) -> Outcome<Vec<Vec2>> {
    let cell = spacing / std::f32::consts::SQRT_2;
    let across = (side / cell) as usize + 1;
    let mut grid: Vec<Option<Vec2>> = vec![None; across * across];
    let mut rng: Rng = seed.rng();
    let mut feet = Vec::with_capacity(n as usize);
    for _ in 0..u64::from(n) * u64::from(DARTS) {
        if feet.len() == n as usize {
            break;
        }
        let half = 0.5 * side;
        let foot = Vec2::new(uniform(&mut rng, -half, half), uniform(&mut rng, -half, half));
        let at = |v: f32| (((v + half) / cell) as usize).min(across - 1);
        let (x, y) = (at(foot.x), at(foot.y));
        let rows = y.saturating_sub(2)..(y + 3).min(across);
        let near = |row: usize| &grid[row * across..][x.saturating_sub(2)..(x + 3).min(across)];
        let free = rows.flat_map(near).flatten().all(|other| other.distance(foot) >= spacing);
        if free && clear(foot, side) {
            grid[y * across + x] = Some(foot);
            feet.push(foot);
        }
    }
    if feet.len() < n as usize {
        return Err(format!("{} of {n} trees found room", feet.len()).into());
    }
    Ok(feet)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_forest_has_its_trees_apart_and_is_the_same_again() {
        let forest = Forest::new(STANDARD, 7, 5.0, Seed(1)).unwrap();
        assert_eq!(forest.instances.len(), STANDARD as usize);
        for (i, a) in forest.instances.iter().enumerate() {
            assert!(a.model < 7 && (0.8..=1.2).contains(&a.scale));
            let alone = |b: &Instance| a.position.distance(b.position) >= 5.0;
            assert!(forest.instances[..i].iter().all(alone));
        }
        assert_eq!(forest.instances, Forest::new(STANDARD, 7, 5.0, Seed(1)).unwrap().instances);
    }

    #[test]
    fn the_path_comes_from_afar_walks_through_and_leaves() {
        let forest = Forest::new(300, 3, 5.0, Seed(1)).unwrap();
        let path = forest.path(90);
        let reach = |pose: &Pose| pose.eye.x.abs().max(pose.eye.z.abs()) / forest.side;
        assert!(reach(&path[0]) > 1.9 && reach(&path[89]) > 1.9);
        let within = path.iter().filter(|pose| reach(pose) < 0.5).count();
        assert!((25..35).contains(&within), "{within}");
        for pose in &path {
            let near = |tree: &Instance| {
                (tree.position - pose.eye).with_y(0.0).length() < 0.5 * WALK && pose.eye.y < 3.0
            };
            assert!(!forest.instances.iter().any(near));
            assert!(pose.eye.distance(pose.target) > 0.01);
        }
    }

    #[test]
    fn every_frame_sees_trees() {
        let forest = Forest::new(300, 3, 5.0, Seed(1)).unwrap();
        for (i, pose) in forest.path(80).iter().enumerate() {
            let forward = (pose.target - pose.eye).normalize();
            let seen = |tree: &&Instance| {
                (tree.position - pose.eye).normalize().dot(forward) > libm::cosf(0.5 * FOV)
            };
            assert!(forest.instances.iter().filter(seen).count() > 10, "frame {i}");
        }
    }

    #[test]
    fn overviews_see_every_tree() {
        let forest = Forest::new(300, 3, 5.0, Seed(1)).unwrap();
        for pose in forest.overviews(12) {
            let forward = (pose.target - pose.eye).normalize();
            for tree in &forest.instances {
                let to = tree.position - pose.eye;
                let angle = libm::acosf(to.normalize().dot(forward));
                assert!(angle < 0.5 * FOV, "{angle}");
            }
        }
    }
}
