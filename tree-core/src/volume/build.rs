//! Short ways to the solids, and their combinations.

use super::{MAX_SOLIDS, Solid, Volume, too_many};
use crate::error::Result;
use glam::{Affine3A, DAffine3, Vec2, Vec3};

/// One constructor for each plain solid.
///
/// Each fails as [`Volume::new`] does: not finite, a size not above 0, an axis of length 0, or as said.
impl Volume {
    /// A ball.
    ///
    /// # Errors
    /// As [`Volume::new`].
    pub fn sphere(center: Vec3, radius: f32) -> Result<Self> {
        Self::new(Solid::Sphere { center, radius })
    }

    /// An axis-aligned ellipsoid; `radii` are half its extents.
    ///
    /// # Errors
    /// As [`Volume::new`].
    pub fn ellipsoid(center: Vec3, radii: Vec3) -> Result<Self> {
        Self::new(Solid::Ellipsoid { center, radii })
    }

    /// A round cylinder between the middles of its ends.
    ///
    /// # Errors
    /// As [`Volume::new`]; `base` and `top` must differ.
    pub fn cylinder(base: Vec3, top: Vec3, radius: f32) -> Result<Self> {
        Self::new(Solid::Cylinder { base, top, radius })
    }

    /// The cone between a disc and a tip: a [`frustum`](Self::frustum) with a top radius of 0.
    ///
    /// # Errors
    /// As [`Volume::new`]; `base` and `apex` must differ.
    pub fn cone(base: Vec3, apex: Vec3, base_radius: f32) -> Result<Self> {
        Self::frustum(base, apex, base_radius, 0.0)
    }

    /// A truncated cone. One of the radii may be 0.
    ///
    /// # Errors
    /// As [`Volume::new`]; `base` and `top` must differ.
    pub fn frustum(base: Vec3, top: Vec3, base_radius: f32, top_radius: f32) -> Result<Self> {
        Self::new(Solid::Frustum { base, top, base_radius, top_radius })
    }

    /// All points within `radius` of the segment; a ball where its ends coincide.
    ///
    /// # Errors
    /// As [`Volume::new`].
    pub fn capsule(start: Vec3, end: Vec3, radius: f32) -> Result<Self> {
        Self::new(Solid::Capsule { start, end, radius })
    }

    /// An axis-aligned box.
    ///
    /// # Errors
    /// As [`Volume::new`]; `min` must lie below `max` on every axis.
    pub fn box_solid(min: Vec3, max: Vec3) -> Result<Self> {
        Self::new(Solid::Box { min, max })
    }

    /// All on the side of a plane that the normal points away from.
    ///
    /// # Errors
    /// As [`Volume::new`].
    pub fn half_space(point: Vec3, normal: Vec3) -> Result<Self> {
        Self::new(Solid::HalfSpace { point, normal })
    }

    /// The points within `radius` of the apex and within `angle` of the axis, `angle` in (0, pi].
    ///
    /// # Errors
    /// As [`Volume::new`].
    pub fn sector(apex: Vec3, axis: Vec3, angle: f32, radius: f32) -> Result<Self> {
        Self::new(Solid::Sector { apex, axis, angle, radius })
    }

    /// What a profile of (distance from the axis, height above the base) sweeps when turned.
    ///
    /// # Errors
    /// As [`Volume::new`]; distances must be 0 or more and not all 0, heights not all the same.
    pub fn revolution(base: Vec3, axis: Vec3, profile: Vec<Vec2>) -> Result<Self> {
        Self::new(Solid::Revolution { base, axis, profile })
    }

    /// What a closed triangle mesh bounds.
    ///
    /// # Errors
    /// As [`Volume::new`]; an open edge or a wrong index is named.
    pub fn mesh(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self> {
        Self::new(Solid::Mesh { positions, triangles })
    }
}

/// Combinations. Repeating the same one (a union of a union) adds parts, not depth.
impl Volume {
    /// What lies in either. For many volumes [`union_all`](Self::union_all) is faster.
    ///
    /// # Errors
    /// Beyond [`MAX_DEPTH`](super::MAX_DEPTH) or [`MAX_SOLIDS`].
    ///
    /// # Complexity
    /// O(parts) of both.
    pub fn union(&self, other: &Self) -> Result<Self> {
        self.merge(other, union_parts, Solid::Union)
    }

    /// What lies in both. May turn out empty, which is no error.
    ///
    /// # Errors
    /// Beyond [`MAX_DEPTH`](super::MAX_DEPTH) or [`MAX_SOLIDS`].
    ///
    /// # Complexity
    /// O(parts) of both.
    pub fn intersection(&self, other: &Self) -> Result<Self> {
        self.merge(other, intersection_parts, Solid::Intersection)
    }

    /// What lies in this one but not in `other`.
    ///
    /// # Errors
    /// Beyond [`MAX_DEPTH`](super::MAX_DEPTH) or [`MAX_SOLIDS`].
    ///
    /// # Complexity
    /// O(parts) of what was taken away so far.
    pub fn difference(&self, other: &Self) -> Result<Self> {
        // (a - b) - c = a - (b + c), which is one level less deep.
        if let Solid::Difference { from, without } = self.solid() {
            return Self::new(Solid::Difference {
                from: from.clone(),
                without: without.union(other)?,
            });
        }
        Self::new(Solid::Difference { from: self.clone(), without: other.clone() })
    }

    /// The volume moved, turned, scaled or sheared. Of a transformed volume both maps become one,
    /// multiplied in double precision.
    ///
    /// # Errors
    /// A map that is not finite or that flattens the volume, or beyond
    /// [`MAX_DEPTH`](super::MAX_DEPTH) or [`MAX_SOLIDS`].
    pub fn transformed(&self, world_from_local: Affine3A) -> Result<Self> {
        if let Solid::Transformed { volume, world_from_local: first } = self.solid() {
            let both: DAffine3 = world_from_local.as_daffine3() * first.as_daffine3();
            return Self::new(Solid::Transformed {
                volume: volume.clone(),
                world_from_local: both.as_affine3a(),
            });
        }
        Self::new(Solid::Transformed { volume: self.clone(), world_from_local })
    }

    /// What lies in any of the volumes; a single one is returned as it is.
    ///
    /// # Errors
    /// [`CoreError::Empty`](crate::CoreError::Empty) for none, or beyond
    /// [`MAX_DEPTH`](super::MAX_DEPTH) or [`MAX_SOLIDS`].
    ///
    /// # Complexity
    /// O(parts).
    pub fn union_all(volumes: impl IntoIterator<Item = Self>) -> Result<Self> {
        Self::merge_all(volumes, union_parts, Solid::Union)
    }

    /// What lies in all of the volumes; a single one is returned as it is.
    ///
    /// # Errors
    /// [`CoreError::Empty`](crate::CoreError::Empty) for none, or beyond
    /// [`MAX_DEPTH`](super::MAX_DEPTH) or [`MAX_SOLIDS`].
    ///
    /// # Complexity
    /// O(parts).
    pub fn intersection_all(volumes: impl IntoIterator<Item = Self>) -> Result<Self> {
        Self::merge_all(volumes, intersection_parts, Solid::Intersection)
    }

    fn merge_all(
        volumes: impl IntoIterator<Item = Self>,
        parts_of: fn(&Solid) -> Option<&[Self]>,
        make: fn(Vec<Self>) -> Solid,
    ) -> Result<Self> {
        let mut parts = Vec::new();
        let mut n_volumes = 0_usize;
        let mut last = None;
        for volume in volumes {
            extend(&mut parts, &volume, parts_of)?;
            n_volumes += 1;
            last = Some(volume);
        }
        match last {
            Some(volume) if n_volumes == 1 => Ok(volume),
            _ => Self::new(make(parts)),
        }
    }

    fn merge(
        &self,
        other: &Self,
        parts_of: fn(&Solid) -> Option<&[Self]>,
        make: fn(Vec<Self>) -> Solid,
    ) -> Result<Self> {
        let mut parts = Vec::new();
        extend(&mut parts, self, parts_of)?;
        extend(&mut parts, other, parts_of)?;
        Self::new(make(parts))
    }
}

fn union_parts(solid: &Solid) -> Option<&[Volume]> {
    match solid {
        Solid::Union(parts) => Some(parts),
        _ => None,
    }
}

fn intersection_parts(solid: &Solid) -> Option<&[Volume]> {
    match solid {
        Solid::Intersection(parts) => Some(parts),
        _ => None,
    }
}

/// Adds the parts of a combination of the same kind, or else the volume itself.
fn extend(
    parts: &mut Vec<Volume>,
    volume: &Volume,
    parts_of: fn(&Solid) -> Option<&[Volume]>,
) -> Result<()> {
    let more = parts_of(volume.solid()).unwrap_or(std::slice::from_ref(volume));
    // Before the memory is asked for.
    if parts.len() + more.len() > MAX_SOLIDS as usize {
        return Err(too_many((parts.len() + more.len()) as u64));
    }
    parts.extend_from_slice(more);
    Ok(())
}
