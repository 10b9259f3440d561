//! Solids that turn about an axis and have a closed form: frustum (with cylinder and cone) and sector.

use super::check;
use super::math::{Meridian, outward, segment_distance_squared_2d};
use crate::bounds::Aabb;
use crate::error::Result;
use glam::{DVec2, DVec3, Vec3};
use std::f64::consts::PI;

/// A truncated cone; a cylinder when both radii agree, a cone when one is zero.
#[derive(Debug)]
pub(super) struct Frustum {
    meridian: Meridian,
    height: f64,
    base_radius: f64,
    top_radius: f64,
    /// Growth of the radius per metre of height.
    slope: f64,
}

impl Frustum {
    /// `solid` is the name for errors; radii are checked by the caller, who knows their names.
    pub(super) fn new(
        solid: &'static str,
        base: DVec3,
        top: DVec3,
        base_radius: f64,
        top_radius: f64,
    ) -> Result<Self> {
        let height = base.distance(top);
        let Some(axis) = (top - base).try_normalize() else {
            return Err(check::problem(solid, "base and top are the same point: they must differ"));
        };
        if base_radius == 0.0 && top_radius == 0.0 {
            return Err(check::problem(solid, "both radii are 0: at least one must be positive"));
        }
        Ok(Self {
            meridian: Meridian { base, axis },
            height,
            base_radius,
            top_radius,
            slope: (top_radius - base_radius) / height,
        })
    }

    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        let q = self.meridian.of(p);
        q.y >= 0.0 && q.y <= self.height && q.x <= (self.base_radius + self.slope * q.y).max(0.0)
    }

    pub(super) fn distance(&self, p: DVec3) -> f64 {
        let q = self.meridian.of(p);
        let outline = [
            DVec2::ZERO,
            DVec2::new(self.base_radius, 0.0),
            DVec2::new(self.top_radius, self.height),
            DVec2::new(0.0, self.height),
        ];
        let square = outline.windows(2).fold(f64::INFINITY, |best, side| {
            best.min(segment_distance_squared_2d(q, side[0], side[1]))
        });
        signed(square.sqrt(), self.contains(p))
    }

    pub(super) fn bounds(&self) -> Aabb {
        self.meridian.bounds_of_discs(
            [DVec2::new(self.base_radius, 0.0), DVec2::new(self.top_radius, self.height)]
                .into_iter(),
        )
    }

    pub(super) fn measure(&self) -> f64 {
        let (a, b) = (self.base_radius, self.top_radius);
        PI / 3.0 * self.height * (a * a + a * b + b * b)
    }
}

/// The points of a ball within an angle of an axis through its middle.
#[derive(Debug)]
pub(super) struct Sector {
    meridian: Meridian,
    radius: f64,
    sine: f64,
    cosine: f64,
}

impl Sector {
    pub(super) fn new(apex: Vec3, axis: Vec3, angle: f32, radius: f32) -> Result<Self> {
        let base = check::point("sector.apex", apex)?;
        let axis = check::direction("sector", "sector.axis", axis)?;
        crate::check_parameter("sector.angle", angle, f32::MIN_POSITIVE, std::f32::consts::PI)?;
        let radius = check::size("sector.radius", radius)?;
        // The f32 nearest to pi is a little more than pi: take it for the whole ball.
        let (sine, cosine) = if angle >= std::f32::consts::PI {
            (0.0, -1.0)
        } else {
            libm::sincos(f64::from(angle))
        };
        Ok(Self { meridian: Meridian { base, axis }, radius, sine, cosine })
    }

    /// Whether the angle is at most the sector's: sin(angle - theta) >= 0, without any arc function.
    #[inline]
    fn within_angle(&self, q: DVec2) -> bool {
        self.sine * q.y >= self.cosine * q.x
    }

    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        let q = self.meridian.of(p);
        q.length_squared() <= self.radius * self.radius && self.within_angle(q)
    }

    pub(super) fn distance(&self, p: DVec3) -> f64 {
        let q = self.meridian.of(p);
        let to_ball = q.length() - self.radius;
        if self.sine == 0.0 {
            return to_ball;
        }
        let rim = self.radius * DVec2::new(self.sine, self.cosine);
        let to_cone = segment_distance_squared_2d(q, DVec2::ZERO, rim).sqrt();
        match (self.within_angle(q), to_ball > 0.0) {
            (true, true) => to_ball,
            (true, false) => to_ball.max(-to_cone),
            (false, _) => to_cone,
        }
    }

    pub(super) fn bounds(&self) -> Aabb {
        let sines = self.meridian.sines();
        // Reach towards a direction at angle b from the axis: the radius if b is within the sector,
        // else that of the rim point nearest to it, cos(b - angle), or the apex.
        let reach = |cos_b: f64, sin_b: f64| {
            if self.within_angle(DVec2::new(sin_b, cos_b)) {
                self.radius
            } else {
                self.radius * (cos_b * self.cosine + sin_b * self.sine).max(0.0)
            }
        };
        let axis = self.meridian.axis;
        let up = DVec3::from_array([0, 1, 2].map(|i| reach(axis[i], sines[i])));
        let down = DVec3::from_array([0, 1, 2].map(|i| reach(-axis[i], sines[i])));
        outward(self.meridian.base - down, self.meridian.base + up)
    }

    pub(super) fn measure(&self) -> f64 {
        // 1 - cos cancels for narrow sectors; sin^2 / (1 + cos) does not.
        let versine = if self.cosine > 0.0 {
            self.sine * self.sine / (1.0 + self.cosine)
        } else {
            1.0 - self.cosine
        };
        2.0 / 3.0 * PI * self.radius * self.radius * self.radius * versine
    }
}

/// Negative inside.
pub(super) fn signed(distance: f64, inside: bool) -> f64 {
    if inside { -distance } else { distance }
}
