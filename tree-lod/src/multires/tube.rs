//! Wood of which a level is a prefix: each path is a closed tube of its own that begins inside the wood it
//! stems from.

use super::model::Multires;
use glam::{Quat, Vec2, Vec3};
use std::f32::consts::TAU;
use tree_core::NO_PARENT;
use tree_mesh::{MeshParams, Surface};

/// Segments shorter than this share of the radius add no ring: it would fold.
const STEP_MIN: f32 = 0.05;
/// Fewest and most sides of any tube.
const SIDES: (u32, u32) = (3, 64);

/// One path: a point and a radius for each ring.
#[derive(Clone, Debug, Default)]
pub(super) struct Line {
    pub(super) points: Vec<Vec3>,
    radii: Vec<f32>,
    sides: u32,
}

impl Line {
    /// The nodes of a path after its fork, without those that hardly move on. Fewer than two points are
    /// nothing to draw.
    pub(super) fn of_path(multires: &Multires, path: usize, params: &MeshParams) -> Self {
        let skeleton = multires.tree().skeleton();
        let first = if path == 0 { 0 } else { multires.counts(path).0 };
        let end = multires.counts(path + 1).0;
        let thick = |node: usize| skeleton.radii()[node].max(params.radius_min);
        let mut line = Self::default();
        let fork = skeleton.parents()[first];
        if fork != NO_PARENT {
            line.points.push(skeleton.positions()[fork as usize]);
            // A branch is as thick at its fork as a little further on, not as what bears it.
            line.radii.push(thick(first).min(thick(fork as usize)));
        }
        for node in first..end {
            let (point, radius) = (skeleton.positions()[node], thick(node));
            let step = line.points.last().map_or(f32::MAX, |last| last.distance(point));
            let is_last = node + 1 == end && line.points.len() > 1;
            if step > STEP_MIN * radius {
                line.points.push(point);
                line.radii.push(radius);
            } else if is_last {
                // The tip stays where it is.
                line.points.pop();
                line.radii.pop();
                line.points.push(point);
                line.radii.push(radius);
            }
        }
        let thickest = line.radii.iter().copied().fold(0.0, f32::max);
        line.sides = sides(thickest, params);
        line
    }

    fn is_drawn(&self) -> bool {
        let [first, .., last] = self.points[..] else { return false };
        self.points.len() > 2 || first != last
    }

    /// Vertices and triangles: rings with a seam, and a point at either end.
    pub(super) fn size(&self) -> (u64, u64) {
        if !self.is_drawn() {
            return (0, 0);
        }
        let (rings, sides) = (self.points.len() as u64, u64::from(self.sides));
        (rings * (sides + 1) + 2, 2 * sides * (rings - 1) + 2 * sides)
    }

    /// Appends the tube to a surface.
    pub(super) fn draw(&self, params: &MeshParams, surface: &mut Surface) {
        if !self.is_drawn() {
            return;
        }
        let (n, sides) = (self.points.len(), self.sides);
        let around = (TAU * self.radii[0] / params.bark_width).round().max(1.0);
        let mut normal = direction(&self.points, 0).any_orthonormal_vector();
        let mut before = direction(&self.points, 0);
        let first = surface.positions.len() as u32;
        let mut along = 0.0;
        for ring in 0..n {
            let tangent = direction(&self.points, ring);
            normal = Quat::from_rotation_arc(before, tangent) * normal;
            normal = (normal - tangent * tangent.dot(normal))
                .try_normalize()
                .unwrap_or_else(|| tangent.any_orthonormal_vector());
            before = tangent;
            if ring > 0 {
                along += self.points[ring].distance(self.points[ring - 1]);
            }
            let binormal = tangent.cross(normal);
            let v = -along / params.bark_length;
            let start = surface.positions.len() as u32;
            for side in 0..=sides {
                let share = side as f32 / sides as f32;
                let (sin, cos) = libm::sincosf(TAU * (side % sides) as f32 / sides as f32);
                let out = normal * cos + binormal * sin;
                let at = self.points[ring] + out * self.radii[ring];
                let weld = if side == sides { start } else { start + side };
                push(surface, at, out, Vec2::new(share * around, v), weld);
            }
        }
        let (base, tip) = (direction(&self.points, 0), direction(&self.points, n - 1));
        for (at, out, v) in [(0, -base, 0.0), (n - 1, tip, -along / params.bark_length)] {
            let vertex = surface.positions.len() as u32;
            push(surface, self.points[at], out, Vec2::new(0.5 * around, v), vertex);
        }
        self.index(first, surface);
    }

    fn index(&self, first: u32, surface: &mut Surface) {
        let (n, sides) = (self.points.len() as u32, self.sides);
        let at = |ring: u32, side: u32| first + ring * (sides + 1) + side;
        let ends = first + n * (sides + 1);
        for side in 0..sides {
            surface.indices.extend([ends, at(0, side + 1), at(0, side)]);
        }
        for ring in 1..n {
            for side in 0..sides {
                let (a, b) = (at(ring - 1, side), at(ring - 1, side + 1));
                let (c, d) = (at(ring, side), at(ring, side + 1));
                surface.indices.extend([a, b, d, a, d, c]);
            }
        }
        for side in 0..sides {
            surface.indices.extend([ends + 1, at(n - 1, side), at(n - 1, side + 1)]);
        }
    }
}

fn push(surface: &mut Surface, position: Vec3, normal: Vec3, uv: Vec2, weld: u32) {
    surface.positions.push(position);
    surface.normals.push(normal);
    surface.uvs.push(uv);
    surface.welds.push(weld);
}

/// Where a line leads at a point: between the segments before and after it.
fn direction(points: &[Vec3], at: usize) -> Vec3 {
    let step = |i: usize| (points[i + 1] - points[i]).try_normalize();
    let before = at.checked_sub(1).and_then(step);
    let after = if at + 1 < points.len() { step(at) } else { None };
    let both = before.unwrap_or_default() + after.unwrap_or_default();
    both.try_normalize().or(after).or(before).unwrap_or(Vec3::Y)
}

/// As few sides as keep the middle of each within the error of the circle.
fn sides(radius: f32, params: &MeshParams) -> u32 {
    let error = (params.error.metres() / radius).min(1.0);
    let half = libm::acosf(1.0 - error).max(0.01);
    let sides = (std::f32::consts::PI / half).ceil() as u32;
    let (min, max) = SIDES;
    sides.clamp(params.sides_min.max(min), params.sides_max.clamp(min, max))
}
