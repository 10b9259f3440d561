//! Step 3a: distance over the surface from one end, by fast marching on triangles.
//!
//! R. Kimmel and J. A. Sethian, *Computing geodesic paths on manifolds*, PNAS 95 (1998): vertices
//! are taken in the order of their distance, and each triangle with two known corners gives its
//! third the arrival of the plane wave that passes them. Where that wave does not come through the
//! side between them (obtuse triangles), distances along edges stand in, as in Dijkstra's search: too
//! long by a few percent there, which bends a level line but does not break it.

use super::rows::Rows;
use super::surface::Surface;
use glam::Vec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Distance of every vertex from the seeds; infinite where none leads.
///
/// # Complexity
/// O(vertices log vertices).
pub(super) fn march(surface: &Surface, fans: &Rows, seeds: &[(u32, f32)]) -> Vec<f32> {
    let mut distances = vec![f32::INFINITY; surface.positions.len()];
    let mut known = vec![false; distances.len()];
    // Bits of floats that are not negative are ordered like the floats.
    let mut queue = BinaryHeap::new();
    for &(vertex, distance) in seeds {
        if distance < distances[vertex as usize] {
            distances[vertex as usize] = distance.max(0.0);
            queue.push(Reverse((distance.max(0.0).to_bits(), vertex)));
        }
    }
    while let Some(Reverse((bits, vertex))) = queue.pop() {
        if known[vertex as usize] || bits != distances[vertex as usize].to_bits() {
            continue;
        }
        known[vertex as usize] = true;
        for &triangle in fans.of(vertex) {
            let [a, b, c] = surface.triangles[triangle as usize];
            let (left, right) = match vertex {
                v if v == a => (b, c),
                v if v == b => (c, a),
                _ => (a, b),
            };
            for (third, other) in [(left, right), (right, left)] {
                if known[third as usize] {
                    continue;
                }
                let points = [vertex, other, third].map(|v| surface.positions[v as usize]);
                let start = distances[vertex as usize];
                let mut arrival = start + points[0].distance(points[2]);
                if known[other as usize]
                    && let Some(wave) = wave(points, [start, distances[other as usize]])
                {
                    arrival = arrival.min(wave);
                }
                if arrival < distances[third as usize] {
                    distances[third as usize] = arrival;
                    queue.push(Reverse((arrival.to_bits(), third)));
                }
            }
        }
    }
    distances
}

/// When the plane wave that passes `a` and `b` arrives at `c`; `None` when it does not come through
/// the side between them.
fn wave([a, b, c]: [Vec3; 3], [at_a, at_b]: [f32; 2]) -> Option<f32> {
    let side = a.distance(b);
    let along = (b - a) / side;
    let x = (c - a).dot(along);
    let y = (c - a).distance(along * x);
    // The wave's direction in the triangle's plane: how fast it runs along the side, and across.
    let gx = (at_b - at_a) / side;
    let gy = (1.0 - gx * gx).sqrt();
    let foot = x - y * gx / gy;
    // A NaN lies in no range.
    if !(0.0..=side).contains(&foot) {
        return None;
    }
    let arrival = at_a + gx * x + gy * y;
    (arrival >= at_a.max(at_b)).then_some(arrival)
}

#[cfg(test)]
mod tests {
    use super::super::surface::tests::{surface_of, tube};
    use super::*;

    #[test]
    fn along_a_tube_distance_is_length() {
        let points: Vec<_> = (0..20).map(|i| (Vec3::Y * i as f32 * 0.3, 0.5)).collect();
        let surface = surface_of(&tube(&points, 12));
        let seeds: Vec<_> = (0..12).map(|v| (v, 0.0)).collect();
        let distances = march(&surface, &surface.fans(), &seeds);
        for (position, distance) in surface.positions.iter().zip(distances) {
            assert!((position.y - distance).abs() < 1e-3, "{position}: {distance}");
        }
    }

    #[test]
    fn on_a_plane_distance_is_nearly_straight() {
        let mut positions = Vec::new();
        let mut indices = Vec::new();
        for i in 0..441_u32 {
            let (x, z) = (i % 21, i / 21);
            positions.push(Vec3::new(x as f32, 0.0, z as f32));
            if x > 0 && z > 0 {
                indices.extend([i, i - 1, i - 21, i - 1, i - 22, i - 21]);
            }
        }
        let surface = surface_of(&(positions, indices));
        let distances = march(&surface, &surface.fans(), &[(0, 0.0)]);
        for (position, distance) in surface.positions.iter().zip(distances) {
            let true_one = position.length();
            assert!(distance >= true_one - 1e-3 && distance < 1.1 * true_one + 0.5, "{position}");
        }
    }
}
