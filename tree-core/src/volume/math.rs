//! Small geometry in f64 that the solids share. Single precision comes in and goes out; in between
//! squares and cubes of any finite f32 neither overflow nor vanish.

use crate::bounds::Aabb;
use glam::{DVec2, DVec3};

/// To single precision; what is beyond its range becomes its largest number, never infinite.
pub(super) fn narrow(x: f64) -> f32 {
    x.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) as f32
}

/// The largest f32 that is not above `x`.
fn below(x: f64) -> f32 {
    let near = x as f32;
    if f64::from(near) > x { near.next_down() } else { near }
}

/// The box in single precision, rounded outwards so that it loses nothing.
pub(super) fn outward(min: DVec3, max: DVec3) -> Aabb {
    Aabb::new(
        glam::Vec3::new(below(min.x), below(min.y), below(min.z)),
        -glam::Vec3::new(below(-max.x), below(-max.y), below(-max.z)),
    )
}

/// An [`Aabb`] in double precision, as the inner loops want it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Box64 {
    min: DVec3,
    max: DVec3,
}

impl Box64 {
    pub(super) fn new(aabb: Aabb) -> Self {
        Self { min: aabb.min.as_dvec3(), max: aabb.max.as_dvec3() }
    }

    /// Closed; false for NaN and for an empty box.
    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        self.min.cmple(p).all() && p.cmple(self.max).all()
    }

    /// Zero inside.
    #[inline]
    pub(super) fn distance_squared(&self, p: DVec3) -> f64 {
        (self.min - p).max(p - self.max).max(DVec3::ZERO).length_squared()
    }
}

/// An axis in space. What turns about it is described in the half-plane of (radius, height).
#[derive(Clone, Copy, Debug)]
pub(super) struct Meridian {
    pub(super) base: DVec3,
    /// Unit length.
    pub(super) axis: DVec3,
}

impl Meridian {
    /// (distance from the axis, height above the base) of a point.
    #[inline]
    pub(super) fn of(&self, p: DVec3) -> DVec2 {
        let from_base = p - self.base;
        let height = from_base.dot(self.axis);
        // Not |d|^2 - h^2: that cancels near the axis.
        DVec2::new((from_base - height * self.axis).length(), height)
    }

    /// Sine of the angle between the axis and each coordinate axis.
    pub(super) fn sines(&self) -> DVec3 {
        let squares = self.axis * self.axis;
        let sine = |a: f64, b: f64| (a + b).sqrt();
        DVec3::new(
            sine(squares.y, squares.z),
            sine(squares.z, squares.x),
            sine(squares.x, squares.y),
        )
    }

    /// The box around discs of (radius, height), which is also that of their convex hull.
    pub(super) fn bounds_of_discs(&self, discs: impl Iterator<Item = DVec2>) -> Aabb {
        let sines = self.sines();
        let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for disc in discs {
            let center = self.base + disc.y * self.axis;
            min = min.min(center - disc.x * sines);
            max = max.max(center + disc.x * sines);
        }
        outward(min, max)
    }
}

/// Share of the way from `a` to `b` that is nearest to a point, from its dot products.
#[inline]
fn nearest_share(along: f64, length_squared: f64) -> f64 {
    if length_squared > 0.0 { (along / length_squared).clamp(0.0, 1.0) } else { 0.0 }
}

/// Squared distance of a point from the segment `a b` in the plane.
#[inline]
pub(super) fn segment_distance_squared_2d(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let (ab, ap) = (b - a, p - a);
    (ap - nearest_share(ap.dot(ab), ab.length_squared()) * ab).length_squared()
}

/// Squared distance of a point from the segment `a b` in space.
#[inline]
pub(super) fn segment_distance_squared(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let (ab, ap) = (b - a, p - a);
    (ap - nearest_share(ap.dot(ab), ab.length_squared()) * ab).length_squared()
}

/// Squared distance of a point from a triangle, which may be degenerate.
pub(super) fn triangle_distance_squared(p: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a);
    let square = normal.length_squared();
    let within = |from: DVec3, to: DVec3| normal.cross(to - from).dot(p - from) >= 0.0;
    if square > 0.0 && within(a, b) && within(b, c) && within(c, a) {
        let height = normal.dot(p - a);
        return height * height / square;
    }
    segment_distance_squared(p, a, b)
        .min(segment_distance_squared(p, b, c))
        .min(segment_distance_squared(p, c, a))
}
