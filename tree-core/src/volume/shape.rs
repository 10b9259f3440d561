//! The compiled form of a solid, which answers questions, and the one place where kinds are told apart.

use super::axial::{Frustum, Sector};
use super::check;
use super::combine::{Difference, Intersection, Transformed, Union};
use super::flat::{Cuboid, HalfSpace};
use super::math::Box64;
use super::mesh::Mesh;
use super::revolution::Revolution;
use super::round::{Capsule, Ellipsoid, Sphere};
use super::solid::Solid;
use crate::bounds::Aabb;
use crate::error::Result;
use glam::DVec3;

/// A checked solid, ready to answer. Points come in double precision; bounds are not consulted here.
#[derive(Debug)]
pub(super) enum Shape {
    Sphere(Sphere),
    Ellipsoid(Ellipsoid),
    Frustum(Frustum),
    Capsule(Capsule),
    Cuboid(Cuboid),
    HalfSpace(HalfSpace),
    Sector(Sector),
    Revolution(Revolution),
    Mesh(Box<Mesh>),
    Union(Union),
    Intersection(Intersection),
    Difference(Difference),
    Transformed(Box<Transformed>),
}

impl Shape {
    pub(super) fn compile(solid: &Solid) -> Result<Self> {
        Ok(match solid {
            Solid::Sphere { center, radius } => Self::Sphere(Sphere::new(*center, *radius)?),
            Solid::Ellipsoid { center, radii } => Self::Ellipsoid(Ellipsoid::new(*center, *radii)?),
            Solid::Cylinder { base, top, radius } => {
                let base = check::point("cylinder.base", *base)?;
                let top = check::point("cylinder.top", *top)?;
                let radius = check::size("cylinder.radius", *radius)?;
                Self::Frustum(Frustum::new("cylinder", base, top, radius, radius)?)
            }
            Solid::Frustum { base, top, base_radius, top_radius } => {
                let base = check::point("frustum.base", *base)?;
                let top = check::point("frustum.top", *top)?;
                let base_radius = check::radius_or_zero("frustum.base_radius", *base_radius)?;
                let top_radius = check::radius_or_zero("frustum.top_radius", *top_radius)?;
                Self::Frustum(Frustum::new("frustum", base, top, base_radius, top_radius)?)
            }
            Solid::Capsule { start, end, radius } => {
                Self::Capsule(Capsule::new(*start, *end, *radius)?)
            }
            Solid::Box { min, max } => Self::Cuboid(Cuboid::new(*min, *max)?),
            Solid::HalfSpace { point, normal } => Self::HalfSpace(HalfSpace::new(*point, *normal)?),
            Solid::Sector { apex, axis, angle, radius } => {
                Self::Sector(Sector::new(*apex, *axis, *angle, *radius)?)
            }
            Solid::Revolution { base, axis, profile } => {
                Self::Revolution(Revolution::new(*base, *axis, profile)?)
            }
            Solid::Mesh { positions, triangles } => {
                Self::Mesh(Box::new(Mesh::new(positions, triangles)?))
            }
            Solid::Union(parts) => Self::Union(Union::new(parts)?),
            Solid::Intersection(parts) => Self::Intersection(Intersection::new(parts)?),
            Solid::Difference { from, without } => Self::Difference(Difference::new(from, without)),
            Solid::Transformed { volume, world_from_local } => {
                Self::Transformed(Box::new(Transformed::new(volume, world_from_local)?))
            }
        })
    }

    /// False for NaN.
    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        match self {
            Self::Sphere(s) => s.contains(p),
            Self::Ellipsoid(s) => s.contains(p),
            Self::Frustum(s) => s.contains(p),
            Self::Capsule(s) => s.contains(p),
            Self::Cuboid(s) => Box64::new(s.bounds()).contains(p),
            Self::HalfSpace(s) => s.distance(p) <= 0.0,
            Self::Sector(s) => s.contains(p),
            Self::Revolution(s) => s.contains(p),
            Self::Mesh(s) => s.contains(p),
            Self::Union(s) => s.contains(p),
            Self::Intersection(s) => s.contains(p),
            Self::Difference(s) => s.contains(p),
            Self::Transformed(s) => s.contains(p),
        }
    }

    /// Signed: never longer than the true distance, and of the right sign.
    pub(super) fn distance(&self, p: DVec3) -> f64 {
        match self {
            Self::Sphere(s) => s.distance(p),
            Self::Ellipsoid(s) => s.distance(p),
            Self::Frustum(s) => s.distance(p),
            Self::Capsule(s) => s.distance(p),
            Self::Cuboid(s) => s.distance(p),
            Self::HalfSpace(s) => s.distance(p),
            Self::Sector(s) => s.distance(p),
            Self::Revolution(s) => s.distance(p),
            Self::Mesh(s) => s.distance(p),
            Self::Union(s) => s.distance(p),
            Self::Intersection(s) => s.distance(p),
            Self::Difference(s) => s.distance(p),
            Self::Transformed(s) => s.distance(p),
        }
    }

    pub(super) fn distance_is_exact(&self) -> bool {
        match self {
            Self::Union(_) | Self::Intersection(_) | Self::Difference(_) => false,
            Self::Transformed(s) => s.distance_is_exact(),
            _ => true,
        }
    }

    pub(super) fn bounds(&self) -> Aabb {
        match self {
            Self::Sphere(s) => s.bounds(),
            Self::Ellipsoid(s) => s.bounds(),
            Self::Frustum(s) => s.bounds(),
            Self::Capsule(s) => s.bounds(),
            Self::Cuboid(s) => s.bounds(),
            Self::HalfSpace(s) => s.bounds(),
            Self::Sector(s) => s.bounds(),
            Self::Revolution(s) => s.bounds(),
            Self::Mesh(s) => s.bounds(),
            Self::Union(s) => s.bounds(),
            Self::Intersection(s) => s.bounds(),
            Self::Difference(s) => s.bounds(),
            Self::Transformed(s) => s.bounds(),
        }
    }

    /// Cubic metres, where there is a closed form.
    pub(super) fn measure(&self) -> Option<f64> {
        match self {
            Self::Sphere(s) => Some(s.measure()),
            Self::Ellipsoid(s) => Some(s.measure()),
            Self::Frustum(s) => Some(s.measure()),
            Self::Capsule(s) => Some(s.measure()),
            Self::Cuboid(s) => Some(s.measure()),
            Self::Sector(s) => Some(s.measure()),
            Self::Revolution(s) => Some(s.measure()),
            Self::Mesh(s) => Some(s.measure()),
            Self::Transformed(s) => s.measure(),
            Self::HalfSpace(_) | Self::Union(_) | Self::Intersection(_) | Self::Difference(_) => {
                None
            }
        }
    }
}
