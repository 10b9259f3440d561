//! Combinations of volumes: union, intersection, difference, transform.
//!
//! Distances follow the usual rules (least, largest, opposite). They have the right sign and are never
//! too long, because a ball that stays clear of each part's surface stays clear of what the parts make.

use super::Volume;
use super::check;
use super::math::{Box64, outward};
use crate::bounds::Aabb;
use crate::error::{CoreError, Result};
use glam::{Affine3A, DAffine3, DMat3, DVec3};

/// A volume with its box at hand, so that a miss need not follow the pointer.
#[derive(Debug)]
struct Part {
    bounds: Box64,
    volume: Volume,
}

/// What lies in any part.
#[derive(Debug)]
pub(super) struct Union(Vec<Part>);

impl Union {
    pub(super) fn new(volumes: &[Volume]) -> Result<Self> {
        if volumes.is_empty() {
            return Err(CoreError::Empty { what: "union" });
        }
        let part =
            |volume: &Volume| Part { bounds: Box64::new(volume.bounds()), volume: volume.clone() };
        Ok(Self(volumes.iter().map(part).collect()))
    }

    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        self.0.iter().any(|part| part.bounds.contains(p) && part.volume.shape().contains(p))
    }

    pub(super) fn distance(&self, p: DVec3) -> f64 {
        let mut best = f64::INFINITY;
        for part in &self.0 {
            // A part whose box is farther than the best so far cannot be nearer.
            if best > 0.0 && part.bounds.distance_squared(p) >= best * best {
                continue;
            }
            if best <= 0.0 && !part.bounds.contains(p) {
                continue;
            }
            best = best.min(part.volume.shape().distance(p));
        }
        best
    }

    pub(super) fn bounds(&self) -> Aabb {
        self.0
            .iter()
            .map(|part| part.volume.bounds())
            .filter(|bounds| !bounds.is_empty())
            .fold(Aabb::EMPTY, Aabb::union)
    }
}

/// What lies in every part.
#[derive(Debug)]
pub(super) struct Intersection(Vec<Volume>);

impl Intersection {
    pub(super) fn new(volumes: &[Volume]) -> Result<Self> {
        if volumes.is_empty() {
            return Err(CoreError::Empty { what: "intersection" });
        }
        Ok(Self(volumes.to_vec()))
    }

    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        self.0.iter().all(|part| part.shape().contains(p))
    }

    pub(super) fn distance(&self, p: DVec3) -> f64 {
        self.0.iter().fold(f64::NEG_INFINITY, |most, part| most.max(part.shape().distance(p)))
    }

    pub(super) fn bounds(&self) -> Aabb {
        let everywhere = Aabb::new(glam::Vec3::NEG_INFINITY, glam::Vec3::INFINITY);
        self.0.iter().map(Volume::bounds).fold(everywhere, Aabb::intersection)
    }
}

/// What lies in `from` and not in `without`.
#[derive(Debug)]
pub(super) struct Difference {
    from: Volume,
    without: Volume,
    without_bounds: Box64,
}

impl Difference {
    pub(super) fn new(from: &Volume, without: &Volume) -> Self {
        Self {
            from: from.clone(),
            without: without.clone(),
            without_bounds: Box64::new(without.bounds()),
        }
    }

    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        self.from.shape().contains(p)
            && !(self.without_bounds.contains(p) && self.without.shape().contains(p))
    }

    pub(super) fn distance(&self, p: DVec3) -> f64 {
        self.from.shape().distance(p).max(-self.without.shape().distance(p))
    }

    pub(super) fn bounds(&self) -> Aabb {
        self.from.bounds()
    }
}

/// Least volume, as a share of that of a box with the same edges, that a transform may leave of a
/// unit cube. Below it the edges lie in a plane for all that f32 can tell.
const LEAST_VOLUME_SHARE: f64 = 1e-6;

/// How far edges may differ from the same length and from right angles, relative, and still count as
/// turning and scaling alone: a few roundings of f32.
const SIMILARITY_SHARE: f64 = 2e-6;

/// A volume seen through an affine map.
#[derive(Debug)]
pub(super) struct Transformed {
    volume: Volume,
    local_bounds: Box64,
    bounds: Aabb,
    local_from_world: DAffine3,
    /// Volume in the world per local volume.
    volume_scale: f64,
    /// Length in the world that a local length has at least.
    least_scale: f64,
    is_similarity: bool,
}

impl Transformed {
    pub(super) fn new(volume: &Volume, world_from_local: &Affine3A) -> Result<Self> {
        if !world_from_local.is_finite() {
            return Err(CoreError::NotFinite { field: "transformed.world_from_local", index: 0 });
        }
        let map = world_from_local.as_daffine3();
        let matrix = map.matrix3;
        let edges = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
        let lengths = edges.map(DVec3::length);
        let determinant = matrix.determinant();
        let box_volume: f64 = lengths.iter().product();
        let local_from_world = map.inverse();
        // Not `<=`: NaN must fail as well.
        let keeps_depth = determinant.abs() > LEAST_VOLUME_SHARE * box_volume;
        if !keeps_depth || !local_from_world.is_finite() {
            return Err(check::problem(
                "transformed",
                format!(
                    "world_from_local flattens the volume (determinant {determinant:e}): it must be \
                     invertible"
                ),
            ));
        }
        let square = lengths[0] * lengths[0];
        let near = |a: f64, b: f64| (a - b).abs() <= SIMILARITY_SHARE * square;
        let is_similarity = near(lengths[1] * lengths[1], square)
            && near(lengths[2] * lengths[2], square)
            && near(edges[0].dot(edges[1]), 0.0)
            && near(edges[1].dot(edges[2]), 0.0)
            && near(edges[2].dot(edges[0]), 0.0);
        Ok(Self {
            local_bounds: Box64::new(volume.bounds()),
            bounds: transformed_bounds(volume.bounds(), &map),
            volume: volume.clone(),
            local_from_world,
            volume_scale: determinant.abs(),
            least_scale: if is_similarity {
                libm::cbrt(determinant.abs())
            } else {
                1.0 / largest_stretch(&local_from_world.matrix3)
            },
            is_similarity,
        })
    }

    #[inline]
    pub(super) fn contains(&self, p: DVec3) -> bool {
        let local = self.local_from_world.transform_point3(p);
        self.local_bounds.contains(local) && self.volume.shape().contains(local)
    }

    pub(super) fn distance(&self, p: DVec3) -> f64 {
        let local = self.local_from_world.transform_point3(p);
        self.least_scale * self.volume.shape().distance(local)
    }

    pub(super) fn distance_is_exact(&self) -> bool {
        self.is_similarity && self.volume.distance_is_exact()
    }

    pub(super) fn bounds(&self) -> Aabb {
        self.bounds
    }

    pub(super) fn measure(&self) -> Option<f64> {
        Some(self.volume_scale * self.volume.shape().measure()?)
    }
}

/// The box around the image of a box, by intervals: sides may be infinite.
fn transformed_bounds(local: Aabb, map: &DAffine3) -> Aabb {
    if local.is_empty() {
        return Aabb::EMPTY;
    }
    let (low, high) = (local.min.as_dvec3(), local.max.as_dvec3());
    let (mut min, mut max) = (map.translation, map.translation);
    for (axis, &edge) in
        [map.matrix3.x_axis, map.matrix3.y_axis, map.matrix3.z_axis].iter().enumerate()
    {
        for row in 0..3 {
            // 0 times an infinite side is 0 here: the side does not reach along this row.
            if edge[row] != 0.0 {
                let (a, b) = (edge[row] * low[axis], edge[row] * high[axis]);
                min[row] += a.min(b);
                max[row] += a.max(b);
            }
        }
    }
    outward(min, max)
}

/// Squarings of the matrix in [`largest_stretch`]: six leave it less than 1 % above the truth.
const SQUARINGS: i32 = 6;

/// Not less than the largest factor by which the matrix stretches a vector, and hardly more. For
/// A = M^T M that is the root of the largest eigenvalue, which the Frobenius norm of A^(2^k), to the
/// power 2^-k, approaches from above.
fn largest_stretch(matrix: &DMat3) -> f64 {
    let norm = |m: &DMat3| {
        (m.x_axis.length_squared() + m.y_axis.length_squared() + m.z_axis.length_squared()).sqrt()
    };
    let mut power = matrix.transpose() * *matrix;
    let mut bound = 1.0;
    let mut exponent = 0.5;
    for _ in 0..SQUARINGS {
        let scale = norm(&power);
        bound *= libm::pow(scale, exponent);
        power *= 1.0 / scale;
        power = power * power;
        exponent *= 0.5;
    }
    bound * libm::pow(norm(&power), exponent)
}
