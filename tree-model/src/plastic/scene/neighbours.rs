//! Which trees may shade each other.

use super::super::light::{Ball, may_shade};
use super::super::shade::LEAST;
use super::edit::Planted;
use glam::Vec3;

/// What is asked of a tree from afar.
struct Far {
    /// Around it, in the world.
    ball: Ball,
    /// Radius of its largest cluster, and how dark it is.
    largest: f32,
    dark: f32,
}

/// For each tree those whose clusters may shade it at all, in an order that depends on where they stand alone.
/// O(trees²).
pub(super) fn neighbours(trees: &[Planted], brightest: Vec3) -> Vec<Vec<u32>> {
    let far: Vec<Far> = trees.iter().map(Far::of).collect();
    let key = |tree: &u32| {
        let pose = trees[*tree as usize].pose;
        let p = pose.position;
        let q = pose.rotation;
        [p.x, p.y, p.z, q.x, q.y, q.z, q.w].map(|v| v.to_bits())
    };
    (0..trees.len())
        .map(|one| {
            let mut near: Vec<u32> = (0..trees.len() as u32)
                .filter(|&other| {
                    other as usize != one && far[other as usize].shades(&far[one], brightest)
                })
                .collect();
            near.sort_by_key(key);
            near
        })
        .collect()
}

impl Far {
    fn of(tree: &Planted) -> Self {
        let around = tree.model.crown;
        let center = tree.pose.to_world(around.center);
        let clusters = &tree.model.plan.clusters;
        let largest = clusters.iter().map(|c| c.ball.radius).fold(0.0, f32::max);
        let dark = clusters.iter().map(|c| 1.0 - c.ball.translucency).fold(0.0, f32::max);
        Self { ball: Ball { center, ..around }, largest, dark }
    }

    /// Whether one of this tree's clusters may keep light from the other: the largest and darkest, where it comes nearest.
    fn shades(&self, other: &Self, brightest: Vec3) -> bool {
        let translucency = 1.0 - self.dark;
        let largest = Ball { center: self.ball.center, radius: self.largest, translucency };
        let around = Ball { radius: self.ball.radius + other.ball.radius, ..other.ball };
        may_shade(&largest, &around, brightest, LEAST)
    }
}
