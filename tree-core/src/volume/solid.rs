//! The plain description of a solid, not yet checked.

use super::Volume;
use glam::{Affine3A, Vec2, Vec3};

/// What a [`Volume`] is made of: plain data that can be read, written and built by hand, and that
/// [`Volume::new`] checks. All lengths in metres, angles in radians.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Solid {
    /// A ball.
    Sphere {
        /// Its middle.
        center: Vec3,
        /// Above 0.
        radius: f32,
    },
    /// An axis-aligned ellipsoid; turn it with [`Solid::Transformed`].
    Ellipsoid {
        /// Its middle.
        center: Vec3,
        /// Half its extent along X, Y and Z, each above 0.
        radii: Vec3,
    },
    /// A round cylinder.
    Cylinder {
        /// Middle of one end.
        base: Vec3,
        /// Middle of the other end, different from `base`.
        top: Vec3,
        /// Above 0.
        radius: f32,
    },
    /// A cone, whole or truncated.
    Frustum {
        /// Middle of one end.
        base: Vec3,
        /// Middle of the other end, different from `base`.
        top: Vec3,
        /// Radius at the base; 0 or more, and one of the two radii above 0.
        base_radius: f32,
        /// Radius at the top; 0 or more.
        top_radius: f32,
    },
    /// All points within a distance of a segment.
    Capsule {
        /// One end of the segment.
        start: Vec3,
        /// The other end; where both are the same the capsule is a ball.
        end: Vec3,
        /// Above 0.
        radius: f32,
    },
    /// An axis-aligned box.
    Box {
        /// Lower corner.
        min: Vec3,
        /// Upper corner, above `min` on every axis.
        max: Vec3,
    },
    /// All on one side of a plane.
    HalfSpace {
        /// A point on the plane.
        point: Vec3,
        /// Points out of the solid; any length but 0.
        normal: Vec3,
    },
    /// The points of a ball within an angle of an axis: the search graphs of Xu and Mould (2012,
    /// section 3.3.2) have this shape.
    Sector {
        /// Middle of the ball and tip of the sector.
        apex: Vec3,
        /// Direction of the sector; any length but 0.
        axis: Vec3,
        /// Largest angle from the axis, above 0; at pi it is the whole ball.
        angle: f32,
        /// Radius of the ball, above 0.
        radius: f32,
    },
    /// What a drawn profile sweeps when it turns about an axis.
    Revolution {
        /// Where heights are counted from.
        base: Vec3,
        /// Direction of increasing height; any length but 0.
        axis: Vec3,
        /// Points (distance from the axis, height), an open line. It is closed to the axis by a
        /// level line at both ends. Distances are 0 or more and not all 0, heights not all the
        /// same; they may rise and fall (overhangs), by the even-odd rule.
        profile: Vec<Vec2>,
    },
    /// What a closed triangle mesh bounds. Inside is where the winding number is not 0.
    Mesh {
        /// Corners; those with the same coordinates count as one.
        positions: Vec<Vec3>,
        /// Indices into `positions`. Along each edge as many triangles run one way as the other.
        triangles: Vec<[u32; 3]>,
    },
    /// What lies in any part; at least one part.
    Union(Vec<Volume>),
    /// What lies in every part; at least one part.
    Intersection(Vec<Volume>),
    /// What lies in one volume but not in the other.
    Difference {
        /// What there was.
        from: Volume,
        /// What is taken away.
        without: Volume,
    },
    /// A volume moved, turned, scaled or sheared.
    Transformed {
        /// The volume before.
        volume: Volume,
        /// Where its points go; finite, and not flattening it.
        world_from_local: Affine3A,
    },
}

impl Solid {
    /// The volumes that this one combines, in order.
    pub(super) fn parts(&self) -> impl Iterator<Item = &Volume> {
        let (list, first, second): (&[Volume], _, _) = match self {
            Self::Union(parts) | Self::Intersection(parts) => (parts, None, None),
            Self::Difference { from, without } => (&[], Some(from), Some(without)),
            Self::Transformed { volume, .. } => (&[], Some(volume), None),
            _ => (&[], None, None),
        };
        list.iter().chain(first).chain(second)
    }
}
