//! Solids with flat faces: half-space and box.

use super::check;
use super::math::outward;
use crate::bounds::Aabb;
use crate::error::Result;
use glam::{DVec3, Vec3};

/// All on one side of a plane.
#[derive(Debug)]
pub(super) struct HalfSpace {
    point: DVec3,
    normal: DVec3,
}

impl HalfSpace {
    pub(super) fn new(point: Vec3, normal: Vec3) -> Result<Self> {
        Ok(Self {
            point: check::point("half_space.point", point)?,
            normal: check::direction("half-space", "half_space.normal", normal)?,
        })
    }

    #[inline]
    pub(super) fn distance(&self, p: DVec3) -> f64 {
        self.normal.dot(p - self.point)
    }

    /// Infinite, but for the one side that an axis-aligned normal closes.
    pub(super) fn bounds(&self) -> Aabb {
        let (mut min, mut max) = (DVec3::NEG_INFINITY, DVec3::INFINITY);
        for axis in 0..3 {
            if self.normal == DVec3::AXES[axis] {
                max[axis] = self.point[axis];
            } else if self.normal == -DVec3::AXES[axis] {
                min[axis] = self.point[axis];
            }
        }
        outward(min, max)
    }
}

/// An axis-aligned box.
#[derive(Debug)]
pub(super) struct Cuboid {
    center: DVec3,
    half: DVec3,
    bounds: Aabb,
}

impl Cuboid {
    pub(super) fn new(min: Vec3, max: Vec3) -> Result<Self> {
        let low = check::point("box.min", min)?;
        let high = check::point("box.max", max)?;
        if !low.cmplt(high).all() {
            return Err(check::problem(
                "box",
                format!("min {min} must lie below max {max} on every axis"),
            ));
        }
        Ok(Self {
            center: 0.5 * (low + high),
            half: 0.5 * (high - low),
            bounds: Aabb::new(min, max),
        })
    }

    pub(super) fn distance(&self, p: DVec3) -> f64 {
        let beyond = (p - self.center).abs() - self.half;
        beyond.max(DVec3::ZERO).length() + beyond.max_element().min(0.0)
    }

    pub(super) fn bounds(&self) -> Aabb {
        self.bounds
    }

    pub(super) fn measure(&self) -> f64 {
        8.0 * self.half.element_product()
    }
}
