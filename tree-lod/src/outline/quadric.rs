//! Squared distances from planes.

use glam::DVec3;
use std::ops::Add;

/// Weighted sum of squared distances from planes (Garland and Heckbert 1997, section 4).
#[derive(Clone, Copy, Default)]
pub(super) struct Quadric {
    /// Sums of n nᵀ: xx, yy, zz, xy, yz, zx.
    square: [f64; 6],
    linear: DVec3,
    constant: f64,
}

impl Quadric {
    /// The plane through `point` across the unit vector `normal`.
    pub(super) fn plane(normal: DVec3, point: DVec3, weight: f64) -> Self {
        let d = -normal.dot(point);
        let DVec3 { x, y, z } = normal;
        Self {
            square: [x * x, y * y, z * z, x * y, y * z, z * x].map(|v| v * weight),
            linear: normal * (d * weight),
            constant: d * d * weight,
        }
    }

    /// Sum of the squared distances of a point; never below 0.
    pub(super) fn at(&self, p: DVec3) -> f64 {
        let [xx, yy, zz, xy, yz, zx] = self.square;
        let square = xx * p.x * p.x + yy * p.y * p.y + zz * p.z * p.z;
        let mixed = xy * p.x * p.y + yz * p.y * p.z + zx * p.z * p.x;
        (square + 2.0 * (mixed + self.linear.dot(p)) + self.constant).max(0.0)
    }
}

impl Add for Quadric {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            square: std::array::from_fn(|i| self.square[i] + other.square[i]),
            linear: self.linear + other.linear,
            constant: self.constant + other.constant,
        }
    }
}
