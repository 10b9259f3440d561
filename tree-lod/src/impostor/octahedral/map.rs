//! Directions to places on a square and back, and the frames around a direction.
//!
//! The octahedron |x| + |y| + |z| = 1 is unfolded (Engelhardt, Dachsbacher 2008, "Octahedron
//! environment maps"); of a hemisphere, only its upper half is used, turned by 45° so that it fills
//! the square.

use glam::{Vec2, Vec3};

/// The place of a direction to the viewer on the unit square. With `hemi`, directions below the horizon
/// are brought up to it. The direction need not have unit length, but some.
#[must_use]
pub fn encode(direction: Vec3, hemi: bool) -> Vec2 {
    let d = if hemi { direction.with_y(direction.y.max(0.0)) } else { direction };
    let d = d / (d.x.abs() + d.y.abs() + d.z.abs()).max(1e-20);
    let place = if hemi {
        Vec2::new(d.x + d.z, d.x - d.z)
    } else if d.y < 0.0 {
        Vec2::new((1.0 - d.z.abs()) * sign(d.x), (1.0 - d.x.abs()) * sign(d.z))
    } else {
        Vec2::new(d.x, d.z)
    };
    0.5 * place + 0.5
}

/// The unit direction of a place on the unit square: the inverse of [`encode`].
#[must_use]
pub fn decode(place: Vec2, hemi: bool) -> Vec3 {
    let p = 2.0 * place - 1.0;
    let d = if hemi {
        let (x, z) = (0.5 * (p.x + p.y), 0.5 * (p.x - p.y));
        Vec3::new(x, 1.0 - x.abs() - z.abs(), z)
    } else {
        let y = 1.0 - p.x.abs() - p.y.abs();
        if y < 0.0 {
            Vec3::new((1.0 - p.y.abs()) * sign(p.x), y, (1.0 - p.x.abs()) * sign(p.y))
        } else {
            Vec3::new(p.x, y, p.y)
        }
    };
    d.normalize_or(Vec3::Y)
}

fn sign(v: f32) -> f32 {
    if v < 0.0 { -1.0 } else { 1.0 }
}

/// Three frames (column and row) around a direction to the viewer, and their weights, which sum to 1: the
/// corners of the half cell it lies in, barycentric. They change continuously with the direction.
#[must_use]
pub fn frames(direction: Vec3, grid: u32, hemi: bool) -> [([u32; 2], f32); 3] {
    let last = grid.max(2) - 1;
    let at = encode(direction, hemi) * last as f32;
    let cell = at.floor().clamp(Vec2::ZERO, Vec2::splat(last as f32 - 1.0));
    let f = (at - cell).clamp(Vec2::ZERO, Vec2::ONE);
    let (x, y) = (cell.x as u32, cell.y as u32);
    let side = if f.x > f.y { [x + 1, y] } else { [x, y + 1] };
    [([x, y], 1.0 - f.x.max(f.y)), (side, (f.x - f.y).abs()), ([x + 1, y + 1], f.x.min(f.y))]
}

/// Right, up and towards the viewer of a frame. Up is as near to +Y as it can be; seen from straight
/// above or below, right is +X.
#[must_use]
pub fn axes([column, row]: [u32; 2], grid: u32, hemi: bool) -> [Vec3; 3] {
    let last = (grid.max(2) - 1) as f32;
    let toward = decode(Vec2::new(column as f32, row as f32) / last, hemi);
    let flat = toward.x * toward.x + toward.z * toward.z;
    let right =
        if flat < 1e-6 { Vec3::X } else { Vec3::new(toward.z, 0.0, -toward.x) / flat.sqrt() };
    [right, toward.cross(right), toward]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn direction(yaw: f32, y: f32) -> Vec3 {
        let (sin, cos) = libm::sincosf(yaw);
        let ring = (1.0 - y * y).max(0.0).sqrt();
        Vec3::new(ring * sin, y, ring * cos)
    }

    proptest! {
        #[test]
        fn a_direction_comes_back(yaw in 0.0_f32..6.3, y in -1.0_f32..1.0, hemi: bool) {
            let wanted = direction(yaw, if hemi { y.abs() } else { y });
            let place = encode(wanted, hemi);
            prop_assert!(place.min_element() >= -1e-6 && place.max_element() <= 1.0 + 1e-6);
            prop_assert!(decode(place, hemi).distance(wanted) < 1e-5);
        }

        #[test]
        fn weights_sum_to_one_and_change_continuously(
            yaw in 0.0_f32..6.3, y in -1.0_f32..1.0, step in -1e-4_f32..1e-4, hemi: bool,
            grid in 2_u32..20,
        ) {
            let all = |yaw| {
                let mut sums = vec![0.0_f32; (grid * grid) as usize];
                let frames = frames(direction(yaw, y), grid, hemi);
                for ([column, row], weight) in frames {
                    sums[(row * grid + column) as usize] += weight;
                }
                let total: f32 = frames.iter().map(|(_, weight)| weight).sum();
                (sums, total, frames)
            };
            let (before, total, frames) = all(yaw);
            prop_assert!((total - 1.0).abs() < 1e-5);
            prop_assert!(frames.iter().all(|(_, weight)| (0.0..=1.0).contains(weight)));
            let (after, ..) = all(yaw + step);
            // Across a fold of the full octahedron, the same directions are other frames.
            let near_fold = !hemi && encode(direction(yaw, y), false)
                .distance(encode(direction(yaw + step, y), false)) > 1e-2;
            if !near_fold {
                for (a, b) in before.iter().zip(&after) {
                    prop_assert!((a - b).abs() < 0.02);
                }
            }
        }

        #[test]
        fn the_frames_lie_around_the_direction(yaw in 0.0_f32..6.3, y in 0.0_f32..1.0) {
            let wanted = direction(yaw, y);
            let mut mean = Vec3::ZERO;
            for (frame, weight) in frames(wanted, 12, true) {
                let [right, up, toward] = axes(frame, 12, true);
                prop_assert!(right.cross(up).distance(toward) < 1e-5 && right.y.abs() < 1e-6);
                prop_assert!(toward.dot(wanted) > 0.9, "{}", toward.dot(wanted));
                mean += toward * weight;
            }
            prop_assert!(mean.normalize().dot(wanted) > 0.99);
        }
    }

    #[test]
    fn seen_from_the_front_right_is_x() {
        // The frame of +Z is a corner of the square.
        let [right, up, toward] = axes([2, 0], 3, true);
        assert!(right.distance(Vec3::X) < 1e-6 && up.distance(Vec3::Y) < 1e-6, "{right} {up}");
        assert!(toward.distance(Vec3::Z) < 1e-6, "{toward}");
        assert_eq!(axes([1, 1], 3, true)[0], Vec3::X);
    }
}
