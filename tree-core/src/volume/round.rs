//! Solids without edges: sphere, capsule, ellipsoid.

use super::check;
use super::math::{outward, segment_distance_squared};
use crate::bounds::Aabb;
use crate::error::Result;
use glam::{DVec3, Vec3};
use std::f64::consts::PI;

/// All within `radius` of a segment, which is a point in the case of the sphere.
#[derive(Debug)]
pub(super) struct Capsule {
    start: DVec3,
    end: DVec3,
    radius: f64,
}

impl Capsule {
    pub(super) fn new(start: Vec3, end: Vec3, radius: f32) -> Result<Self> {
        Ok(Self {
            start: check::point("capsule.start", start)?,
            end: check::point("capsule.end", end)?,
            radius: check::size("capsule.radius", radius)?,
        })
    }

    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        segment_distance_squared(p, self.start, self.end) <= self.radius * self.radius
    }

    pub(super) fn distance(&self, p: DVec3) -> f64 {
        segment_distance_squared(p, self.start, self.end).sqrt() - self.radius
    }

    pub(super) fn bounds(&self) -> Aabb {
        outward(self.start.min(self.end) - self.radius, self.start.max(self.end) + self.radius)
    }

    pub(super) fn measure(&self) -> f64 {
        let square = self.radius * self.radius;
        PI * square * (self.start.distance(self.end) + 4.0 / 3.0 * self.radius)
    }
}

/// A ball.
#[derive(Debug)]
pub(super) struct Sphere {
    center: DVec3,
    radius: f64,
}

impl Sphere {
    pub(super) fn new(center: Vec3, radius: f32) -> Result<Self> {
        Ok(Self {
            center: check::point("sphere.center", center)?,
            radius: check::size("sphere.radius", radius)?,
        })
    }

    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        p.distance_squared(self.center) <= self.radius * self.radius
    }

    pub(super) fn distance(&self, p: DVec3) -> f64 {
        p.distance(self.center) - self.radius
    }

    pub(super) fn bounds(&self) -> Aabb {
        outward(self.center - self.radius, self.center + self.radius)
    }

    pub(super) fn measure(&self) -> f64 {
        4.0 / 3.0 * PI * self.radius * self.radius * self.radius
    }
}

/// Newton steps towards the nearest point of an ellipsoid. Fewer than ten are usual; next to the
/// evolute a step gains only half, and the cap lets even the smallest f64 gap be covered so.
const MAX_NEWTON_STEPS: u32 = 128;

/// An axis-aligned ellipsoid.
#[derive(Debug)]
pub(super) struct Ellipsoid {
    center: DVec3,
    radii: DVec3,
    per_radius: DVec3,
}

impl Ellipsoid {
    pub(super) fn new(center: Vec3, radii: Vec3) -> Result<Self> {
        let center = check::point("ellipsoid.center", center)?;
        for (axis, &radius) in radii.as_ref().iter().enumerate() {
            crate::error::check_range(
                "ellipsoid.radii",
                axis,
                radius,
                f32::MIN_POSITIVE,
                f32::MAX,
            )?;
        }
        let radii = radii.as_dvec3();
        Ok(Self { center, radii, per_radius: radii.recip() })
    }

    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        ((p - self.center) * self.per_radius).length_squared() <= 1.0
    }

    /// The nearest surface point solves one equation in one unknown (Eberly, Distance from a Point
    /// to an Ellipse, an Ellipsoid, or a Hyperellipsoid, 2013). Departure: Newton instead of
    /// bisection, see [`nearest_parameter`].
    pub(super) fn distance(&self, p: DVec3) -> f64 {
        let offset = (p - self.center).abs();
        let mut axes = [0, 1, 2].map(|i| (self.radii[i], offset[i]));
        axes.sort_by(|a, b| b.0.total_cmp(&a.0));
        let distance = distance_in_octant(axes);
        if self.contains(p) { -distance } else { distance }
    }

    pub(super) fn bounds(&self) -> Aabb {
        outward(self.center - self.radii, self.center + self.radii)
    }

    pub(super) fn measure(&self) -> f64 {
        4.0 / 3.0 * PI * self.radii.element_product()
    }
}

/// Unsigned distance for (radius, coordinate) pairs, largest radius first, coordinates not negative.
fn distance_in_octant(axes: [(f64, f64); 3]) -> f64 {
    let [(e0, y0), (e1, y1), (e2, y2)] = axes;
    if y2 > 0.0 {
        return distance_by_root(axes);
    }
    // In the plane across the shortest axis: near the middle the nearest point is off the plane.
    let x0 = off_plane_share(e0, y0, e2);
    let x1 = off_plane_share(e1, y1, e2);
    if let (Some(x0), Some(x1)) = (x0, x1) {
        let rest = 1.0 - x0 * x0 - x1 * x1;
        if rest > 0.0 {
            return DVec3::new(e0 * x0 - y0, e1 * x1 - y1, e2 * rest.sqrt()).length();
        }
    }
    // Else it lies in the plane, and the same question is asked of the ellipse.
    if y1 > 0.0 {
        return distance_by_root([(e0, y0), (e0, 0.0), (e1, y1)]);
    }
    match off_plane_share(e0, y0, e1) {
        Some(x0) => DVec3::new(e0 * x0 - y0, e1 * (1.0 - x0 * x0).max(0.0).sqrt(), 0.0).length(),
        None => (y0 - e0).abs(),
    }
}

/// Coordinate, as a share of radius `e`, of the nearest point off the plane across the shorter
/// radius; none where the point is too far out for one.
fn off_plane_share(e: f64, y: f64, shorter: f64) -> Option<f64> {
    let (numerator, denominator) = (e * y, e * e - shorter * shorter);
    // Equal radii: any direction in their plane serves, so the centre line stays in the plane.
    (numerator < denominator)
        .then(|| numerator / denominator)
        .or((y == 0.0 && e == shorter).then_some(0.0))
}

/// The distance where the last coordinate is above zero.
fn distance_by_root(axes: [(f64, f64); 3]) -> f64 {
    let last = axes[2].0;
    // Differences of ratios to the last, so that the last is exactly 0.
    let rises = axes.map(|(e, _)| (e - last) * (e + last) / (last * last));
    let shares = axes.map(|(e, y)| y / e);
    let t = nearest_parameter(rises, shares);
    let mut square = 0.0;
    for ((_, y), rise) in axes.into_iter().zip(rises) {
        // x - y with x = (1 + rise) y / (t + rise), without the cancellation.
        let move_by = (1.0 - t) * y / (t + rise);
        square += move_by * move_by;
    }
    square.sqrt()
}

/// Root `t > 0` of g(t) = sum ((1 + rise) z / (t + rise))^2 - 1; Eberly's unknown is t - 1, which would
/// round away points next to a plane of symmetry. g falls and is convex, and at the start taken here
/// one term is 1 and none is more, so 0 <= g <= 2: Newton's steps climb to the root, never past it.
fn nearest_parameter(rises: [f64; 3], shares: [f64; 3]) -> f64 {
    let mut t =
        rises.iter().zip(shares).map(|(rise, z)| (1.0 + rise) * z - rise).fold(shares[2], f64::max);
    for _ in 0..MAX_NEWTON_STEPS {
        let (mut g, mut slope) = (-1.0, 0.0);
        for (rise, z) in rises.iter().zip(shares) {
            let term = (1.0 + rise) * z / (t + rise);
            g += term * term;
            slope -= 2.0 * term * term / (t + rise);
        }
        let next = t - g / slope;
        if next > t {
            t = next;
        } else {
            // The root to the last bit, or a slope that vanished (NaN compares false).
            break;
        }
    }
    t
}
