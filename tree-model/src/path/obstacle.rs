//! Obstacles: volumes that no path may enter.

use glam::Vec3;
use tree_core::Volume;

/// Steps along a segment where the obstacle has no distance to step by.
const BLIND_STEPS: u32 = 16;

/// Cap on steps by distance: a segment that grazes a surface steps ever shorter.
const MAX_STEPS: u32 = 64;

/// A volume to stay out of, with a clearance.
#[derive(Clone, Debug)]
pub(crate) struct Obstacle {
    pub(crate) volume: Volume,
    /// Distance to keep in metres, where the volume knows distances.
    pub(crate) clearance: f32,
}

impl Obstacle {
    pub(crate) fn holds(&self, point: Vec3) -> bool {
        match self.volume.distance(point) {
            Some(distance) if self.clearance > 0.0 => distance < self.clearance,
            _ => self.volume.contains(point),
        }
    }

    /// Whether the segment from `a` to `b` stays outside. Steps by the distance to the obstacle
    /// (sphere tracing, Hart 1996), so that no wall is too thin, or blindly where there is none.
    pub(crate) fn is_free(&self, a: Vec3, b: Vec3) -> bool {
        let length = a.distance(b);
        if self.holds(a) || self.holds(b) {
            return false;
        }
        if self.volume.distance(a).is_none() {
            return (1..BLIND_STEPS)
                .all(|i| !self.volume.contains(a.lerp(b, i as f32 / BLIND_STEPS as f32)));
        }
        let least = length / MAX_STEPS as f32;
        let mut along = 0.0;
        while along < length {
            let point = a.lerp(b, along / length);
            let distance = self.volume.distance(point).unwrap_or(0.0) - self.clearance;
            if distance < 0.0 || self.volume.contains(point) {
                return false;
            }
            along += distance.max(least);
        }
        true
    }
}
