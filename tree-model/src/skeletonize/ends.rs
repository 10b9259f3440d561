//! Step 3c: where a piece of wood begins, and distances from there.
//!
//! A first, coarse run from the lowest vertex finds an end of the piece, a second one from there all
//! its ends and how thick they are. The thickest (of the piece that stands on the ground: a low
//! one) becomes the base. Distances near a single vertex would run in circles round it, so all
//! vertices of the base get their height above the base plane to start with. An open rim about as
//! thick as the thickest end is a better base; stout tubes, wider than long, have no other ends.

use super::field::march;
use super::rows::Rows;
use super::slices::{NONE, Slices};
use super::surface::{Rim, Surface};
use glam::Vec3;
use std::f32::consts::TAU;

/// Levels per edge in the coarse runs.
const COARSE: f32 = 3.0;
/// Height of the base, which gets its distances from the plane, in radii.
const BASE_HEIGHT: f32 = 0.7;
/// Vertices of the base lie within this many radii of its middle.
const BASE_REACH: f32 = 2.5;
/// The same on the ground, where buttresses may spread.
const GROUNDED_REACH: f32 = 6.0;
/// An end is on the ground when it is within this many radii of the lowest vertex.
const FOOT: f32 = 3.0;
/// How much thicker an end that stands higher must be, per length, in the piece on the ground.
const HEIGHT_COST: f32 = 0.1;

/// A rim is the base when it is at least this share as thick as the thickest end found otherwise.
const RIM_SHARE: f32 = 0.7;

/// An end of a piece and its looks.
#[derive(Clone, Copy, Debug)]
struct End {
    place: Vec3,
    /// Unit vector into the wood.
    inward: Vec3,
    radius: f32,
}

/// Distances from the base of a surface; `grounded` when it stands on the ground.
pub(super) fn from_base(surface: &Surface, fans: &Rows, grounded: bool) -> Vec<f32> {
    let height_cost = if grounded { HEIGHT_COST } else { 0.0 };
    let (rims, rim_of) = surface.rims();
    let rim = best_rim(surface, &rims, height_cost);
    let from_rim = |rim: u32| {
        let on_rim = (0..).zip(&rim_of).filter(|&(_, &of)| of == rim);
        let seeds: Vec<(u32, f32)> = on_rim.map(|(vertex, _)| (vertex, 0.0)).collect();
        march(surface, fans, &seeds)
    };
    if let Some((rim, _)) = rim
        && surface.is_tube(&rims)
    {
        return from_rim(rim);
    }
    let height = |vertex: u32| surface.positions[vertex as usize].y;
    let lowest = (0..surface.positions.len() as u32)
        .min_by(|&a, &b| height(a).total_cmp(&height(b)))
        .unwrap_or(0);
    let far = farthest(&march(surface, fans, &[(lowest, 0.0)]));
    let distances = march(surface, fans, &[(far, 0.0)]);
    let slices = Slices::new(surface, &distances, COARSE);
    let heirs = slices.heirs();
    let score = |end: &End| end.radius - height_cost * end.place.y;
    let end = std::iter::once(0)
        .chain(slices.first_end..slices.parents.len() as u32)
        .map(|node| slices.end(&heirs, node))
        // The first of equals, so that rounding on one platform cannot choose otherwise.
        .reduce(|best, end| if score(&end) > score(&best) { end } else { best });
    let Some(end) = end else {
        return distances;
    };
    if let Some((rim, found)) = rim
        && found >= score(&end) - (1.0 - RIM_SHARE) * end.radius
    {
        return from_rim(rim);
    }
    let low = end.place.y - height(lowest) < FOOT * end.radius;
    let (end, reach) = if grounded && low {
        // Buttresses pull the end to one side; a trunk stands upright enough.
        (End { inward: Vec3::Y, ..end }, GROUNDED_REACH)
    } else {
        (end, BASE_REACH)
    };
    let seeds = seeds(surface, fans, &end, reach);
    if seeds.is_empty() { distances } else { march(surface, fans, &seeds) }
}

/// The thickest rim and its score.
fn best_rim(surface: &Surface, rims: &[Rim], height_cost: f32) -> Option<(u32, f32)> {
    let score =
        |rim: &Rim| rim.length / TAU - height_cost * surface.positions[rim.vertex as usize].y;
    (0..).zip(rims.iter().map(score)).reduce(|a, b| if b.1 > a.1 { b } else { a })
}

fn farthest(distances: &[f32]) -> u32 {
    let mut best = (f32::NEG_INFINITY, 0);
    for (&distance, vertex) in distances.iter().zip(0..) {
        if distance.is_finite() && distance > best.0 {
            best = (distance, vertex);
        }
    }
    best.1
}

/// The connected vertices round the base, with their heights above it.
fn seeds(surface: &Surface, fans: &Rows, end: &End, reach: f32) -> Vec<(u32, f32)> {
    let height = |vertex: u32| (surface.positions[vertex as usize] - end.place).dot(end.inward);
    let belongs = |vertex: u32| {
        height(vertex) <= BASE_HEIGHT * end.radius
            && surface.positions[vertex as usize].distance(end.place) <= reach * end.radius
    };
    let near = |a: &u32, b: &u32| {
        let to = |v: u32| surface.positions[v as usize].distance_squared(end.place);
        to(*a).total_cmp(&to(*b))
    };
    let Some(first) = (0..surface.positions.len() as u32).min_by(near) else {
        return Vec::new();
    };
    let mut found = vec![first];
    let mut seen = vec![false; surface.positions.len()];
    seen[first as usize] = true;
    let mut head = 0;
    while let Some(&vertex) = found.get(head) {
        head += 1;
        for &triangle in fans.of(vertex) {
            for corner in surface.triangles[triangle as usize] {
                if !seen[corner as usize] && belongs(corner) {
                    seen[corner as usize] = true;
                    found.push(corner);
                }
            }
        }
    }
    let lowest = found.iter().fold(f32::INFINITY, |low, &vertex| low.min(height(vertex)));
    found.iter().map(|&vertex| (vertex, height(vertex) - lowest)).collect()
}

impl Slices {
    /// For each node the child that goes on: the one that bears most surface. [`NONE`] at ends.
    pub(super) fn heirs(&self) -> Vec<u32> {
        let mut borne = self.lengths.clone();
        let mut heirs = vec![NONE; borne.len()];
        for node in (0..borne.len()).rev() {
            let parent = self.parents[node] as usize;
            if self.parents[node] == NONE {
                continue;
            }
            // Backwards, so `>=` leaves the first of equals.
            let heir = heirs[parent];
            if heir == NONE || borne[node] >= borne[heir as usize] {
                heirs[parent] = node as u32;
            }
            borne[parent] += borne[node];
        }
        heirs
    }

    /// What the piece looks like at the end node `node`.
    fn end(&self, heirs: &[u32], node: u32) -> End {
        let place = self.middles[node as usize];
        let (mut at, mut radius) = (node, 0.0_f32);
        loop {
            radius = radius.max(self.lengths[at as usize] / TAU);
            // Inwards is up from the start and down from all ends.
            let next = if node == 0 { heirs[at as usize] } else { self.parents[at as usize] };
            if next == NONE
                || place.distance(self.middles[at as usize]) > 2.0 * radius.max(self.step)
            {
                break;
            }
            at = next;
        }
        let inward = (self.middles[at as usize] - place).normalize_or(Vec3::Y);
        End { place, inward, radius }
    }
}

#[cfg(test)]
mod tests {
    use super::super::surface::tests::{surface_of, tube};
    use super::*;

    #[test]
    fn distances_start_flat_at_the_thick_end() {
        // The thick end is above.
        let points: Vec<_> =
            (0..12).map(|i| (Vec3::Y * i as f32 * 0.4, 0.05 + 0.02 * i as f32)).collect();
        let surface = surface_of(&tube(&points, 8));
        let distances = from_base(&surface, &surface.fans(), false);
        for (position, distance) in surface.positions.iter().zip(&distances) {
            assert!((4.4 - position.y - distance).abs() < 0.1, "{position}: {distance}");
        }
        let (top, bottom) = (&distances[88..], &distances[..8]);
        assert!(top.iter().all(|&d| d < 1e-4), "{top:?}");
        let (low, high) =
            bottom.iter().fold((f32::MAX, 0.0_f32), |(l, h), &d| (l.min(d), h.max(d)));
        assert!(high - low < 0.01, "{low} to {high}");
    }
}
