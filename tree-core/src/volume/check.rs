//! What the parameters of a solid must fulfil.

use crate::error::{CoreError, Result, check_finite};
use crate::parameter::check_parameter;
use glam::{DVec3, Vec3};

/// An error about the solid as a whole.
pub(super) fn problem(solid: &'static str, problem: impl Into<String>) -> CoreError {
    CoreError::Volume { solid, problem: problem.into() }
}

/// A finite point, in double precision.
pub(super) fn point(field: &'static str, found: Vec3) -> Result<DVec3> {
    check_finite(field, &[found])?;
    Ok(found.as_dvec3())
}

/// A length above zero. Subnormal numbers are not lengths: their reciprocals overflow.
pub(super) fn size(field: &'static str, found: f32) -> Result<f64> {
    check_parameter(field, found, f32::MIN_POSITIVE, f32::MAX)?;
    Ok(f64::from(found))
}

/// A radius that may be zero.
pub(super) fn radius_or_zero(field: &'static str, found: f32) -> Result<f64> {
    check_parameter(field, found, 0.0, f32::MAX)?;
    Ok(f64::from(found))
}

/// A direction of any length but zero, made a unit vector.
pub(super) fn direction(solid: &'static str, field: &'static str, found: Vec3) -> Result<DVec3> {
    point(field, found)?
        .try_normalize()
        .ok_or_else(|| problem(solid, format!("{field} has no direction: it must not be zero")))
}
