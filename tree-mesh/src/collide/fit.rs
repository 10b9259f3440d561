//! A capsule around balls.

use super::Capsule;
use glam::{DVec3, Vec3};

/// Turns of power iteration for the longest direction; what is left of the error costs tightness only.
const TURNS: usize = 8;

/// A tight capsule that holds every ball, along the direction in which they are spread farthest.
///
/// # Complexity
/// O(balls).
pub(super) fn around(balls: &[(Vec3, f32)]) -> Capsule {
    let Some(&(first, radius)) = balls.first() else { return Capsule::default() };
    // Along the chord of the first and the last ball, which are the ends of a branch, and along the
    // direction of largest spread: the smaller of the two is taken.
    let last = balls.last().map_or(first, |&(last, _)| last);
    let chord = (last - first).try_normalize();
    let spread = widest(balls);
    [chord, spread]
        .into_iter()
        .flatten()
        .map(|direction| along(balls, direction))
        .min_by(|a, b| a.volume().total_cmp(&b.volume()))
        .unwrap_or_else(|| {
            let most = balls.iter().fold(radius, |most, &(_, radius)| most.max(radius));
            Capsule { a: first, b: first, radius: most }
        })
}

/// The direction of largest spread: the first eigenvector of the covariance, by power iteration.
fn widest(balls: &[(Vec3, f32)]) -> Option<Vec3> {
    let count = balls.len() as f64;
    let mean = balls.iter().fold(DVec3::ZERO, |sum, (p, _)| sum + p.as_dvec3()) / count;
    let (mut xx, mut xy, mut xz) = (0.0, 0.0, 0.0);
    let (mut yy, mut yz, mut zz) = (0.0, 0.0, 0.0);
    for (p, _) in balls {
        let d = p.as_dvec3() - mean;
        (xx, xy, xz) = (xx + d.x * d.x, xy + d.x * d.y, xz + d.x * d.z);
        (yy, yz, zz) = (yy + d.y * d.y, yz + d.y * d.z, zz + d.z * d.z);
    }
    let rows = [DVec3::new(xx, xy, xz), DVec3::new(xy, yy, yz), DVec3::new(xz, yz, zz)];
    // The longest column is not square to the eigenvector sought.
    let start =
        rows.into_iter().max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))?;
    let mut v = start.try_normalize()?;
    for _ in 0..TURNS {
        v = DVec3::new(rows[0].dot(v), rows[1].dot(v), rows[2].dot(v)).try_normalize()?;
    }
    v.as_vec3().try_normalize()
}

/// The capsule along a direction: about the middle of the balls' box across it, ends drawn in as far as
/// its round caps allow.
fn along(balls: &[(Vec3, f32)], direction: Vec3) -> Capsule {
    let across = direction.any_orthonormal_vector();
    let up = direction.cross(across);
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for &(p, radius) in balls {
        let at = Vec3::new(p.dot(across), p.dot(up), p.dot(direction));
        (low, high) = (low.min(at - radius), high.max(at + radius));
    }
    let middle = (low + high) * 0.5;
    let line = across * middle.x + up * middle.y;
    let off = |p: Vec3| {
        let p = p - line;
        (p - direction * p.dot(direction)).length()
    };
    let radius = balls.iter().fold(0.0_f32, |most, &(p, radius)| most.max(off(p) + radius));
    // A ball at distance d from the line lies in the cap when its middle is at most
    // √((R − r)² − d²) beyond the cap's.
    let (mut start, mut end) = (f32::INFINITY, f32::NEG_INFINITY);
    for &(p, ball) in balls {
        let (room, off, at) = (radius - ball, off(p), p.dot(direction));
        let slack = (room * room - off * off).max(0.0).sqrt();
        (start, end) = (start.min(at + slack), end.max(at - slack));
    }
    if start > end {
        start = 0.5 * (start + end);
        end = start;
    }
    // Wide enough for the roundings of 32-bit numbers.
    let far = balls.iter().fold(0.0_f32, |far, &(p, _)| far.max(p.abs().max_element()));
    let radius = radius * (1.0 + 1e-5) + far * 1e-6;
    Capsule { a: line + direction * start, b: line + direction * end, radius }
}
