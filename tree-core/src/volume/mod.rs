//! Solids and their combinations: crowns, search graphs and obstacles.
//!
//! A [`Volume`] is made of a [`Solid`], plain data that is checked once, and then answers
//! [`contains`](Volume::contains), [`bounds`](Volume::bounds), [`distance`](Volume::distance),
//! [`measure`](Volume::measure) and [`sample`](Volume::sample) for any finite point, without panics and
//! without NaN. Volumes are cheap to clone and may be shared between threads.
//!
//! ```
//! use tree_core::{Volume, glam::Vec3};
//! // A crown that grows round a street lamp.
//! let crown = Volume::ellipsoid(Vec3::new(0.0, 6.0, 0.0), Vec3::new(3.0, 4.0, 3.0))?;
//! let lamp = Volume::capsule(Vec3::X, Vec3::new(1.0, 5.0, 0.0), 0.5)?;
//! let free = crown.difference(&lamp)?;
//! assert!(free.contains(Vec3::new(0.0, 6.0, 0.0)) && !free.contains(Vec3::new(1.0, 5.0, 0.0)));
//! # Ok::<(), tree_core::CoreError>(())
//! ```
//!
//! # The surface
//!
//! Plain solids contain their surface, but for rounding; a revolution and a mesh contain one side of
//! it (half-open rules), so that solids set side by side share no point there. Questions are answered
//! in double precision, after [`bounds`](Volume::bounds), so nothing contained lies outside these.
//!
//! # Accuracy of distances
//!
//! | solid | distance |
//! |---|---|
//! | sphere, ellipsoid, cylinder, cone, frustum, capsule, box, half-space, sector | exact |
//! | revolution | exact where the profile does not run back along itself |
//! | mesh | exact where the surface does not pass through itself; else short inside |
//! | turned, moved, uniformly scaled | as the volume itself |
//! | otherwise transformed | not too long: shortened to the direction of least stretch |
//! | union | of exact parts: exact outside, not too long inside |
//! | intersection, difference | of exact parts: exact inside, not too long outside |
//!
//! "Exact" is to f32 rounding. Where it is a bound the sign is right all the same, so a step by the
//! distance never passes through a surface.

mod axial;
mod build;
mod check;
mod combine;
mod flat;
mod math;
mod mesh;
mod revolution;
mod round;
mod sample;
#[cfg(feature = "serde")]
mod serial;
mod shape;
mod solid;

pub use solid::Solid;

use crate::bounds::Aabb;
use crate::error::{CoreError, Result};
use crate::parameter::ParameterError;
use glam::Vec3;
use math::Box64;
use shape::Shape;
use std::fmt;
use std::sync::Arc;

/// Deepest nesting of combinations in one another. Questions, drops and reading recurse, so the stack
/// must hold it; and `serde_json`, which stops at 128 brackets, must read whatever it wrote, at two
/// brackets for each combination and four for a solid.
pub const MAX_DEPTH: u32 = 48;

/// Most solids and combinations in one volume, counted with repetition. A volume united with itself
/// twenty times over reaches this; without the cap forty times would never answer.
pub const MAX_SOLIDS: u32 = 1 << 20;

/// A checked solid or combination of solids. See the [module](self) for surface and accuracy.
#[derive(Clone)]
pub struct Volume(Arc<Node>);

struct Node {
    solid: Solid,
    shape: Shape,
    bounds: Aabb,
    bounds_64: Box64,
    depth: u32,
    n_solids: u32,
    cost: u64,
}

impl Volume {
    /// Checks a solid and prepares it for questions.
    ///
    /// # Errors
    /// * [`CoreError::Parameter`], [`CoreError::NotFinite`] and [`CoreError::OutOfRange`] name the parameter, as
    ///   `sphere.radius`, and the row in it where there are several;
    /// * [`CoreError::Empty`] for a mesh, a profile or a combination without elements;
    /// * [`CoreError::Volume`] for a direction of length 0, a solid without extent, a mesh with an
    ///   open edge or an index out of range, a transform that flattens, and combinations beyond
    ///   [`MAX_DEPTH`] or [`MAX_SOLIDS`].
    ///
    /// # Complexity
    /// O(n log n) for n mesh triangles, O(n) for n profile points or parts.
    pub fn new(solid: Solid) -> Result<Self> {
        let mut depth = 0;
        let mut n_solids = 1_u32;
        let mut cost = own_cost(&solid);
        for part in solid.parts() {
            depth = depth.max(part.0.depth + 1);
            n_solids = n_solids.saturating_add(part.0.n_solids);
            cost = cost.saturating_add(part.0.cost);
        }
        if depth > MAX_DEPTH {
            return Err(too_deep(depth));
        }
        if n_solids > MAX_SOLIDS {
            return Err(too_many(u64::from(n_solids)));
        }
        let shape = Shape::compile(&solid)?;
        let bounds = shape.bounds();
        Ok(Self(Arc::new(Node {
            solid,
            bounds,
            bounds_64: Box64::new(bounds),
            shape,
            depth,
            n_solids,
            cost,
        })))
    }

    /// What it is made of.
    #[must_use]
    pub fn solid(&self) -> &Solid {
        &self.0.solid
    }

    /// Most steps that a question about one point takes, roughly: 1 for each solid and combination, each
    /// triangle of a mesh and each point of a profile, counted with repetition. Says how many questions
    /// to answer between looks at a [`Control`](crate::Control).
    #[must_use]
    pub fn cost(&self) -> u64 {
        self.0.cost
    }

    fn shape(&self) -> &Shape {
        &self.0.shape
    }

    /// Whether the point lies inside. False for points that are not finite.
    ///
    /// # Complexity
    /// Constant for plain solids. Revolution: the profile segments at that height. Mesh: the triangles
    /// above and below the point, a handful for a closed mesh whose triangles are of similar size, all
    /// of them if each spans the whole ground. Combinations: their parts; a union passes over those
    /// whose bounds the point misses.
    #[must_use]
    #[inline]
    pub fn contains(&self, point: Vec3) -> bool {
        let p = point.as_dvec3();
        self.0.bounds_64.contains(p) && p.is_finite() && self.0.shape.contains(p)
    }

    /// A box around the volume: the smallest for plain solids (rounded outwards), else not always. It
    /// is infinite for half-spaces, may be empty for intersections, and that of the first volume for
    /// differences.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        self.0.bounds
    }

    /// Whether [`bounds`](Self::bounds) are finite, so that the volume can be sampled.
    #[must_use]
    pub fn is_bounded(&self) -> bool {
        self.0.bounds.is_empty() || self.0.bounds.is_finite()
    }

    /// Signed distance from the surface in metres, negative inside; none for points that are not
    /// finite. The [module](self) says where it is exact and where only not too long.
    ///
    /// # Complexity
    /// Constant for plain solids, O(n) for n profile points or parts, about O(log n) for n mesh
    /// triangles near the surface and O(n) where all are equally far.
    #[must_use]
    pub fn distance(&self, point: Vec3) -> Option<f32> {
        if !point.is_finite() {
            return None;
        }
        let distance = self.0.shape.distance(point.as_dvec3());
        // Chained transforms near the ends of f32's range may leave that of f64.
        (!distance.is_nan()).then(|| math::narrow(distance))
    }

    /// Whether [`distance`](Self::distance) is exact everywhere, not only not too long. True for plain
    /// solids, turned, moved and uniformly scaled or not; false for combinations.
    #[must_use]
    pub fn distance_is_exact(&self) -> bool {
        self.0.shape.distance_is_exact()
    }

    /// Cubic metres inside, where there is a closed form: for all plain solids but half-spaces, and
    /// these transformed. None for other combinations (see [`estimate_measure`](Self::estimate_measure))
    /// and for what exceeds f32.
    ///
    /// A profile that crosses itself, and mesh shells that overlap or nest with the same orientation,
    /// are counted with the sign and multiplicity of their parts; there too the estimate is right.
    ///
    /// # Complexity
    /// O(n) for n mesh triangles or profile points.
    #[must_use]
    pub fn measure(&self) -> Option<f32> {
        let measure = self.0.shape.measure()? as f32;
        measure.is_finite().then_some(measure)
    }
}

fn too_deep(found: u32) -> CoreError {
    let (found, max) = (f64::from(found), f64::from(MAX_DEPTH));
    ParameterError { field: "volume.depth".into(), found, min: 0.0, max }.into()
}

/// Steps of a question without those of the parts.
fn own_cost(solid: &Solid) -> u64 {
    match solid {
        Solid::Revolution { profile, .. } => 1 + profile.len() as u64,
        Solid::Mesh { triangles, .. } => 1 + triangles.len() as u64,
        _ => 1,
    }
}

fn too_many(found: u64) -> CoreError {
    let (found, max) = (found as f64, f64::from(MAX_SOLIDS));
    ParameterError { field: "volume.solids".into(), found, min: 1.0, max }.into()
}

impl fmt::Debug for Volume {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Volume").field(&self.0.solid).finish()
    }
}

/// Equal when described by equal solids; the same set of points described otherwise is not equal.
impl PartialEq for Volume {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || self.0.solid == other.0.solid
    }
}

impl TryFrom<Solid> for Volume {
    type Error = CoreError;

    fn try_from(solid: Solid) -> Result<Self> {
        Self::new(solid)
    }
}

impl From<Volume> for Solid {
    fn from(volume: Volume) -> Self {
        match Arc::try_unwrap(volume.0) {
            Ok(node) => node.solid,
            Err(shared) => shared.solid.clone(),
        }
    }
}

#[cfg(test)]
mod tests;
