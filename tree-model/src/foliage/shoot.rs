//! Leaves along one axis.

use super::LeafParams;
use glam::{Mat3, Quat, Vec3};
use std::f32::consts::TAU;
use tree_core::seed::uniform;
use tree_core::{Axis, Leaf, Rng, Skeleton};

/// What all axes share.
pub(super) struct Bearer<'a> {
    pub(super) skeleton: &'a Skeleton,
    pub(super) params: &'a LeafParams,
    pub(super) to_tip: &'a [f32],
}

impl Bearer<'_> {
    /// Appends the leaves of one axis, from its base to its tip.
    pub(super) fn bear(&self, axis: Axis<'_>, rng: &mut Rng, leaves: &mut Vec<Leaf>) {
        let positions = self.skeleton.positions();
        let radii = self.skeleton.radii();
        let mut side = Vec3::X;
        let mut turn = uniform(rng, 0.0, TAU);
        // Distance along the shoot until the next node bears.
        let mut ahead = uniform(rng, 0.3, 1.0) * self.params.spacing;
        let mut last = Vec3::Y;
        for &node in axis.nodes {
            let Some(below) = self.skeleton.parent(node) else {
                continue;
            };
            let (a, b) = (positions[below as usize], positions[node as usize]);
            let length = a.distance(b);
            if self.to_tip[node as usize] >= self.params.bearing || length <= 0.0 {
                continue;
            }
            let along = (b - a) / length;
            // Carry the frame on without twist: drop what is not across the shoot any more.
            side = (side - along * side.dot(along)).normalize_or(along.any_orthonormal_vector());
            last = along;
            let to_tip_at_a = self.to_tip[node as usize] + length;
            // A segment that reaches below the bearing zone starts bearing part of the way up.
            ahead = ahead.max(to_tip_at_a - self.params.bearing);
            // By number, not by adding up: small steps added to a large length go nowhere.
            let n_nodes = ((length - ahead) / self.params.spacing).ceil().max(0.0) as u64;
            for i in 0..n_nodes {
                let share = ((ahead + i as f32 * self.params.spacing) / length).min(1.0);
                let radius = radii[node as usize] * share
                    + radii[below as usize].min(2.0 * radii[node as usize]) * (1.0 - share);
                let site = Site { node, point: a.lerp(b, share), along, side, radius };
                self.bear_node(&site, turn, rng, leaves);
                turn = (turn + self.params.arrangement.divergence()) % TAU;
            }
            ahead = (ahead + n_nodes as f32 * self.params.spacing - length).max(0.0);
        }
        let bears_tip = self.params.terminal && self.params.bearing > 0.0;
        if let Some(&tip) = axis.nodes.last()
            && bears_tip
            && self.skeleton.parent(tip).is_some()
        {
            let point = positions[tip as usize];
            let site = Site { node: tip, point, along: last, side, radius: 0.0 };
            let pitch = uniform(rng, 0.0, 0.5 * self.params.jitter);
            leaves.push(self.leaf(&site, side, pitch, rng));
        }
    }

    /// All leaves of one node, evenly round the shoot.
    fn bear_node(&self, site: &Site, turn: f32, rng: &mut Rng, leaves: &mut Vec<Leaf>) {
        let count = self.params.arrangement.per_node();
        for i in 0..count {
            let jitter = 0.5 * self.params.jitter * uniform(rng, -1.0, 1.0);
            let angle = turn + TAU * i as f32 / count as f32 + jitter;
            let outward = Quat::from_axis_angle(site.along, angle) * site.side;
            let pitch = self.params.pitch + self.params.jitter * uniform(rng, -1.0, 1.0);
            leaves.push(self.leaf(site, outward, pitch, rng));
        }
    }

    fn leaf(&self, site: &Site, outward: Vec3, pitch: f32, rng: &mut Rng) -> Leaf {
        let params = self.params;
        let (sin, cos) = libm::sincosf(pitch);
        let held = site.along * cos + outward * sin;
        let midrib = held.lerp(Vec3::NEG_Y, params.droop).normalize_or(held);
        // Unturned, the upper face looks towards the shoot's tip (adaxial).
        let adaxial = across(site.along, midrib).unwrap_or(midrib.any_orthonormal_vector());
        let sky = across(Vec3::Y, midrib).unwrap_or(adaxial);
        let face = adaxial.lerp(sky, params.phototropism);
        let face = across(face, midrib).unwrap_or(adaxial);
        let roll = Quat::from_axis_angle(midrib, params.jitter * uniform(rng, -1.0, 1.0));
        let face = roll * face;
        let rotation = Quat::from_mat3(&Mat3::from_cols(midrib.cross(face), midrib, face));
        let vary = 1.0 + params.size_variation * uniform(rng, -1.0, 1.0);
        Leaf {
            node: site.node,
            position: site.point + outward * site.radius,
            rotation: rotation.normalize(),
            size: params.size * vary,
            kind: params.kind,
        }
    }
}

/// A place on a shoot.
struct Site {
    node: u32,
    point: Vec3,
    along: Vec3,
    side: Vec3,
    radius: f32,
}

/// The unit part of `v` across `axis`; `None` when they are nearly parallel.
fn across(v: Vec3, axis: Vec3) -> Option<Vec3> {
    let part = v - axis * v.dot(axis);
    if part.length_squared() < 1e-6 { None } else { part.try_normalize() }
}
