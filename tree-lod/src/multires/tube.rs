//! Wood of which a level is a prefix: each path is a tube of its own that begins inside the wood it stems
//! from.
//!
//! * A ring stands where the path turns or tapers: what is left out lies within
//!   [`MeshParams::error`] of the tube that is drawn (Douglas, Peucker 1973, on points and radii).
//! * A ring has as few sides as keep the middle of each within the same error of the circle; neighbours of
//!   different numbers are joined side by side.
//! * The base of a branch is open: it lies inside the wood that bears it. A tip thinner than the error ends
//!   in a point, a thicker one in a cap.

use super::model::Multires;
use glam::{Quat, Vec2, Vec3};
use std::f32::consts::TAU;
use tree_core::NO_PARENT;
use tree_mesh::{MeshParams, Surface};

/// Segments shorter than this share of the radius add no ring: it would fold.
const STEP_MIN: f32 = 0.05;
/// Fewest and most sides of any tube.
const SIDES: (u32, u32) = (3, 64);
/// Nodes between rings that stand whatever the path does: what is compared with a straight line stays short.
const STRETCH: usize = 64;

/// One path: a point, a radius and a number of sides for each ring.
#[derive(Clone, Debug, Default)]
pub(super) struct Line {
    pub(super) points: Vec<Vec3>,
    radii: Vec<f32>,
    sides: Vec<u32>,
    /// The base is closed: nothing bears it.
    rooted: bool,
    /// The last ring is a single point.
    pointed: bool,
}

impl Line {
    /// The nodes of a path after its fork, without those that hardly move on and those that a straight
    /// line stands for. Fewer than two points are nothing to draw.
    pub(super) fn of_path(multires: &Multires, path: usize, params: &MeshParams) -> Self {
        let skeleton = multires.tree().skeleton();
        let first = if path == 0 { 0 } else { multires.counts(path).0 };
        let end = multires.counts(path + 1).0;
        let thick = |node: usize| skeleton.radii()[node].max(params.min_radius);
        let fork = skeleton.parents()[first];
        let mut line = Self { rooted: fork == NO_PARENT, ..Self::default() };
        if !line.rooted {
            // A branch is as thick at its fork as a little further on, not as what bears it.
            let radius = thick(first).min(thick(fork as usize));
            line.push(skeleton.positions()[fork as usize], radius);
        }
        for node in first..end {
            let (point, radius) = (skeleton.positions()[node], thick(node));
            let step = line.points.last().map_or(f32::MAX, |last| last.distance(point));
            let is_last = node + 1 == end && line.points.len() > 1;
            if step > STEP_MIN * radius {
                line.push(point, radius);
            } else if is_last {
                // The tip stays where it is.
                line.points.pop();
                line.radii.pop();
                line.push(point, radius);
            }
        }
        let error = params.error.metres();
        if let (Some(tip), true) = (line.radii.last_mut(), line.points.len() > 1) {
            line.pointed = *tip <= error;
            *tip = if line.pointed { 0.0 } else { *tip };
        }
        line.simplify(error);
        line.sides = line.radii.iter().map(|&radius| sides(radius, params)).collect();
        line
    }

    fn push(&mut self, point: Vec3, radius: f32) {
        self.points.push(point);
        self.radii.push(radius);
    }

    /// Leaves out what lies within `error` of the tube between its neighbours.
    fn simplify(&mut self, error: f32) {
        let n = self.points.len();
        let mut kept: Vec<bool> = (0..n).map(|i| i.is_multiple_of(STRETCH) || i + 1 == n).collect();
        let mut stack: Vec<(usize, usize)> =
            (0..n).step_by(STRETCH).map(|a| (a, (a + STRETCH).min(n - 1))).collect();
        while let Some((a, b)) = stack.pop() {
            let off = (a + 1..b).map(|i| (self.off(i, a, b), i));
            let worst = off.reduce(|worst, other| if other.0 > worst.0 { other } else { worst });
            if let Some((off, at)) = worst.filter(|&(off, _)| off > error)
                && off.is_finite()
            {
                kept[at] = true;
                stack.extend([(a, at), (at, b)]);
            }
        }
        let mut rows = kept.iter().copied();
        self.points.retain(|_| rows.next().unwrap_or(true));
        let mut rows = kept.iter().copied();
        self.radii.retain(|_| rows.next().unwrap_or(true));
    }

    /// How far the wood at a point leaves the straight tube between two others.
    fn off(&self, at: usize, a: usize, b: usize) -> f32 {
        let (from, way) = (self.points[a], self.points[b] - self.points[a]);
        let to = self.points[at] - from;
        let along = to.dot(way) / way.length_squared().max(f32::MIN_POSITIVE);
        let along = along.clamp(0.0, 1.0);
        let radius = self.radii[a] + (self.radii[b] - self.radii[a]) * along;
        (to - way * along).length() + (self.radii[at] - radius).abs()
    }

    fn is_drawn(&self) -> bool {
        let [first, .., last] = self.points[..] else { return false };
        self.points.len() > 2 || first != last
    }

    /// Rings of more than a point.
    fn n_rings(&self) -> usize {
        self.points.len() - usize::from(self.pointed)
    }

    /// Vertices and triangles: rings with a seam, and a point at a closed end.
    pub(super) fn size(&self) -> (u64, u64) {
        if !self.is_drawn() {
            return (0, 0);
        }
        let rings = &self.sides[..self.n_rings()];
        let sum: u64 = rings.iter().map(|&sides| u64::from(sides)).sum();
        // Each side of a ring has a triangle towards the ring before and one towards the next.
        let open = if self.rooted { 0 } else { u64::from(rings.first().copied().unwrap_or(0)) };
        let points = 1 + u64::from(self.rooted);
        (sum + rings.len() as u64 + points, 2 * sum - open)
    }

    /// Appends the tube to a surface.
    pub(super) fn draw(&self, params: &MeshParams, surface: &mut Surface) {
        if !self.is_drawn() {
            return;
        }
        let n = self.points.len();
        let around = (TAU * self.radii[0] / params.bark_width).round().max(1.0);
        let mut normal = direction(&self.points, 0).any_orthonormal_vector();
        let mut before = direction(&self.points, 0);
        let mut along = 0.0;
        let mut rings = Vec::with_capacity(n);
        for ring in 0..self.n_rings() {
            let tangent = direction(&self.points, ring);
            normal = Quat::from_rotation_arc(before, tangent) * normal;
            normal = (normal - tangent * tangent.dot(normal))
                .try_normalize()
                .unwrap_or_else(|| tangent.any_orthonormal_vector());
            before = tangent;
            along += self.step(ring);
            let binormal = tangent.cross(normal);
            let v = -along / params.bark_length;
            let (start, sides) = (surface.positions.len() as u32, self.sides[ring]);
            for side in 0..=sides {
                let share = side as f32 / sides as f32;
                let (sin, cos) = libm::sincosf(TAU * (side % sides) as f32 / sides as f32);
                let out = normal * cos + binormal * sin;
                let at = self.points[ring] + out * self.radii[ring];
                let weld = if side == sides { start } else { start + side };
                push(surface, at, out, Vec2::new(share * around, v), weld);
            }
            if let Some(&(below, n_below)) = rings.last() {
                join(below, n_below, start, sides, surface);
            }
            rings.push((start, sides));
        }
        let (Some(&(first, n_first)), Some(&(last, n_last))) = (rings.first(), rings.last()) else {
            return;
        };
        if self.rooted {
            let out = -direction(&self.points, 0);
            let vertex = surface.positions.len() as u32;
            push(surface, self.points[0], out, Vec2::new(0.5 * around, 0.0), vertex);
            let fan = |side| [vertex, first + side + 1, first + side];
            surface.indices.extend((0..n_first).flat_map(fan));
        }
        let along = along + if self.pointed { self.step(n - 1) } else { 0.0 };
        let at = Vec2::new(0.5 * around, -along / params.bark_length);
        let vertex = surface.positions.len() as u32;
        push(surface, self.points[n - 1], direction(&self.points, n - 1), at, vertex);
        let fan = |side| [vertex, last + side, last + side + 1];
        surface.indices.extend((0..n_last).flat_map(fan));
    }

    /// Length of the way to a ring.
    fn step(&self, ring: usize) -> f32 {
        ring.checked_sub(1).map_or(0.0, |below| self.points[ring].distance(self.points[below]))
    }
}

/// Triangles between two rings, whose vertices begin at `a` and `b`.
fn join(a: u32, n_a: u32, b: u32, n_b: u32, surface: &mut Surface) {
    let (mut i, mut j) = (0, 0);
    while i < n_a || j < n_b {
        // The one whose next vertex comes first goes on.
        if j == n_b || i < n_a && (i + 1) * n_b <= (j + 1) * n_a {
            surface.indices.extend([a + i, a + i + 1, b + j]);
            i += 1;
        } else {
            surface.indices.extend([a + i, b + j + 1, b + j]);
            j += 1;
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
    sides.clamp(params.min_sides.max(min), params.max_sides.clamp(min, max))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(points: Vec<Vec3>, radii: Vec<f32>) -> Line {
        let params = MeshParams::default();
        let mut line = Line { points, radii, rooted: true, ..Line::default() };
        line.simplify(params.error.metres());
        line.sides = line.radii.iter().map(|&radius| sides(radius, &params)).collect();
        line
    }

    #[test]
    fn a_straight_even_taper_has_two_rings_and_a_bend_one_more() {
        let at = |i: usize| Vec3::Y * i as f32 * 0.1;
        let radius = |i: usize| 0.1 - 0.001 * i as f32;
        let straight = line((0..40).map(at).collect(), (0..40).map(radius).collect());
        assert_eq!(straight.points, [at(0), at(39)]);
        let bent = |i: usize| if i < 20 { at(i) } else { at(20) + Vec3::X * (i - 20) as f32 * 0.1 };
        let bent = line((0..40).map(bent).collect(), (0..40).map(radius).collect());
        assert_eq!(bent.points.len(), 3);
    }

    #[test]
    fn what_is_left_out_lies_within_the_error() {
        let at = |i: usize| {
            let (sin, cos) = libm::sincosf(0.07 * i as f32);
            Vec3::new(sin, 0.03 * i as f32, cos)
        };
        let radius = |i: usize| 0.1 / (1.0 + 0.05 * i as f32);
        let all = Line {
            points: (0..500).map(at).collect(),
            radii: (0..500).map(radius).collect(),
            ..Line::default()
        };
        let few = line(all.points.clone(), all.radii.clone());
        assert!(few.points.len() < 300, "{}", few.points.len());
        let rows: Vec<usize> = few
            .points
            .iter()
            .map(|p| all.points.iter().position(|q| p == q).unwrap_or(usize::MAX))
            .collect();
        for pair in rows.windows(2) {
            for i in pair[0]..pair[1] {
                assert!(all.off(i, pair[0], pair[1]) <= MeshParams::default().error.metres());
            }
        }
    }

    #[test]
    fn counts_are_those_of_what_is_drawn_where_sides_change() {
        for (rooted, pointed) in [(true, false), (false, true), (false, false)] {
            let radii = vec![0.5, 0.1, if pointed { 0.0 } else { 0.02 }];
            let points = vec![Vec3::ZERO, Vec3::new(0.1, 1.0, 0.0), Vec3::new(0.5, 2.0, 0.1)];
            let line = Line { rooted, pointed, ..line(points, radii) };
            assert!(line.sides[0] > line.sides[1]);
            let mut surface = Surface::default();
            line.draw(&MeshParams::default(), &mut surface);
            let found = (surface.positions.len() as u64, surface.indices.len() as u64 / 3);
            assert_eq!(found, line.size());
        }
    }
}
