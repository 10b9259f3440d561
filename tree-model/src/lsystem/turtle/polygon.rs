//! Polygons between braces, and which of them are leaves.

use crate::glam::{DMat3, DQuat, DVec3, Vec3};

/// A filled outline, as drawn between `{` and `}`.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// Corners in metres, three or more, in the order they were drawn.
    pub vertices: Vec<Vec3>,
    /// Colour index when it was closed.
    pub color: u32,
    /// Skeleton node it hangs on.
    pub node: u32,
}

/// A polygon that is being drawn: module that opened it, where the turtle stood, and its corners.
#[derive(Debug)]
pub(super) struct Outline {
    pub(super) module: usize,
    pub(super) base: DVec3,
    pub(super) corners: Vec<DVec3>,
}

/// Where a leaf-like polygon begins, how it is turned, and how long it is.
pub(super) struct LeafPose {
    pub(super) base: DVec3,
    pub(super) rotation: DQuat,
    pub(super) size: f64,
}

/// A polygon is a leaf when its area is at least this share of its length squared: thinner ones are lines.
const AREA_MIN: f64 = 0.01;

impl Outline {
    /// The leaf that covers the outline: it starts where the turtle stood at `{`, its apex is the corner farthest
    /// from there, and its face is Newell's normal, on the side `up` looks to. `None` for lines and points.
    pub(super) fn leaf(&self, up: DVec3) -> Option<LeafPose> {
        let distance = |corner: &DVec3| corner.distance(self.base);
        let apex = *self.corners.iter().max_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        let size = distance(&apex);
        let normal = self.newell();
        let midrib = (apex - self.base) / size;
        let face = normal - normal.dot(midrib) * midrib;
        if size.is_nan() || size <= 0.0 || 0.5 * face.length() < AREA_MIN * size * size {
            return None;
        }
        let face = face.normalize();
        let face = if face.dot(up) < 0.0 { -face } else { face };
        let rotation = DQuat::from_mat3(&DMat3::from_cols(midrib.cross(face), midrib, face));
        Some(LeafPose { base: self.base, rotation, size })
    }

    /// Twice the area times the normal.
    fn newell(&self) -> DVec3 {
        let next = self.corners.iter().cycle().skip(1);
        self.corners.iter().zip(next).map(|(a, b)| (a - self.base).cross(b - self.base)).sum()
    }
}
