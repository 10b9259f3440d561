//! Where the picture is taken from: cameras, framing, and the projection into samples.

use crate::error::{LodError, Result, check_range};
use glam::{Vec2, Vec3};
use std::f32::consts::{FRAC_PI_2, PI};
use tree_mesh::Mesh;

/// Widest and narrowest vertical field of view in radians (1° and 160°).
const FOV_RANGE: (f64, f64) = (0.017, 2.8);
/// Largest coordinate of an eye or target in metres.
const FARTHEST: f64 = 1e6;
/// The near plane lies at this share of the mesh's size (or of the eye's distance from its target,
/// if that is less). Smaller lets the camera come closer, larger resolves depth better.
const NEAR_SHARE: f32 = 1e-3;

/// The camera of a [`View`](super::View).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Camera {
    /// Chooses its place so that the whole mesh is in the picture.
    Framed(Framing),
    /// Stands where it is told to.
    Placed(Pose),
}

impl Default for Camera {
    fn default() -> Self {
        Self::Framed(Framing::default())
    }
}

/// From which side to look at the mesh; distance and centre follow from its vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Framing {
    /// Where the camera stands around the trunk, in radians: 0 on +Z (looking along -Z), a quarter
    /// turn on +X. Finite; default 0.6.
    pub yaw: f32,
    /// How far the camera looks down, in radians, -π/2 (from below) to π/2 (from above). Default 0.09.
    pub pitch: f32,
    /// Vertical field of view in radians, 0.017 to 2.8. Default 0.6, a portrait lens. Unused when
    /// `orthographic`.
    pub fov: f32,
    /// Empty share of the picture on each side, 0 to 0.45. Default 0.06.
    pub margin: f32,
    /// Parallel instead of perspective projection. Default false.
    pub orthographic: bool,
}

impl Default for Framing {
    fn default() -> Self {
        Self { yaw: 0.6, pitch: 0.09, fov: 0.6, margin: 0.06, orthographic: false }
    }
}

/// A camera at a given place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Where the camera stands, in metres.
    pub eye: Vec3,
    /// What is in the middle of the picture.
    pub target: Vec3,
    /// Which way is up; must not be parallel to the line of sight. Usually +Y.
    pub up: Vec3,
    /// How it projects.
    pub lens: Lens,
}

/// How a [`Pose`] projects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lens {
    /// Far things are smaller.
    Perspective {
        /// Vertical field of view in radians, 0.017 to 2.8.
        fov: f32,
    },
    /// Parallel projection; what lies behind the eye is not drawn.
    Orthographic {
        /// Height of the picture in metres, more than 0.
        height: f32,
    },
}

impl Camera {
    /// Checks all numbers.
    ///
    /// # Errors
    /// [`LodError::Parameter`] or [`LodError::Camera`], naming the field.
    pub fn validate(&self) -> Result<()> {
        match self {
            Self::Framed(framing) => framing.validate(),
            Self::Placed(pose) => pose.validate(),
        }
    }

    /// The pose this camera takes for `mesh` in a picture of `aspect` = width / height.
    ///
    /// # Errors
    /// As [`validate`](Self::validate).
    ///
    /// # Complexity
    /// One pass over all vertices for [`Camera::Framed`].
    pub fn pose(&self, mesh: &Mesh, aspect: f32) -> Result<Pose> {
        self.validate()?;
        check_range("aspect", aspect.into(), 1e-5, 1e5)?;
        Ok(match self {
            Self::Framed(framing) => framing.around(mesh, aspect),
            Self::Placed(pose) => *pose,
        })
    }
}

impl Framing {
    fn validate(&self) -> Result<()> {
        check_range("camera.yaw", self.yaw.into(), -FARTHEST, FARTHEST)?;
        let quarter = f64::from(FRAC_PI_2);
        check_range("camera.pitch", self.pitch.into(), -quarter, quarter)?;
        if !self.orthographic {
            check_range("camera.fov", self.fov.into(), FOV_RANGE.0, FOV_RANGE.1)?;
        }
        check_range("camera.margin", self.margin.into(), 0.0, 0.45)
    }

    /// Each side of the frustum is pushed out until it touches its extreme vertex; the eye is where
    /// the tighter pair of sides meets.
    fn around(&self, mesh: &Mesh, aspect: f32) -> Pose {
        let (sin_yaw, cos_yaw) = libm::sincosf(self.yaw);
        let (sin_pitch, cos_pitch) = libm::sincosf(self.pitch);
        let forward = -Vec3::new(sin_yaw * cos_pitch, sin_pitch, cos_yaw * cos_pitch);
        let right = Vec3::new(cos_yaw, 0.0, -sin_yaw);
        let up = right.cross(forward);
        let bounds = mesh.bounds();
        let (center, corners) = if bounds.is_empty() {
            // Nothing to frame: pretend a small tree, so that the ground is seen as usual.
            let bounds = tree_core::Aabb::new(Vec3::new(-2.0, 0.0, -2.0), Vec3::new(2.0, 5.0, 2.0));
            (bounds.center(), bounds.corners().to_vec())
        } else {
            (bounds.center(), Vec::new())
        };
        let inner = 1.0 - 2.0 * self.margin;
        let tan_y = inner * libm::tanf(0.5 * self.fov.clamp(0.01, 3.0));
        let (tan_x, tan_y) = if self.orthographic { (0.0, 0.0) } else { (tan_y * aspect, tan_y) };
        // Largest of ±x - tan·z, ±y - tan·z, and the nearest z.
        let mut most = [f32::NEG_INFINITY; 5];
        let vertices = mesh.surfaces.iter().flat_map(|surface| &surface.positions).chain(&corners);
        for &p in vertices {
            let d = p - center;
            let (x, y, z) = (right.dot(d), up.dot(d), forward.dot(d));
            let sides = [x - tan_x * z, -x - tan_x * z, y - tan_y * z, -y - tan_y * z, -z];
            for (most, side) in most.iter_mut().zip(sides) {
                *most = most.max(side);
            }
        }
        let [right_side, left_side, top, bottom, nearest] = most;
        let middle =
            center + right * (0.5 * (right_side - left_side)) + up * (0.5 * (top - bottom));
        let size = bounds.size().max_element().max(1e-3);
        let (width, height) = ((right_side + left_side).max(0.0), (top + bottom).max(0.0));
        let (distance, lens) = if self.orthographic {
            let height = (height.max(width / aspect) / inner).max(1e-3 * size);
            (nearest + size, Lens::Orthographic { height })
        } else {
            // A flat or single-point mesh still needs some distance.
            let distance = (0.5 * width / tan_x).max(0.5 * height / tan_y);
            let distance = distance.max(nearest + 0.05 * size);
            (distance, Lens::Perspective { fov: self.fov })
        };
        let eye = middle - forward * distance;
        Pose { eye, target: eye + forward * distance, up, lens }
    }
}

impl Pose {
    fn validate(&self) -> Result<()> {
        for (field, v) in
            [("camera.eye", self.eye), ("camera.target", self.target), ("camera.up", self.up)]
        {
            for coordinate in v.to_array() {
                check_range(field, coordinate.into(), -FARTHEST, FARTHEST)?;
            }
        }
        match self.lens {
            Lens::Perspective { fov } => {
                check_range("camera.fov", fov.into(), FOV_RANGE.0, FOV_RANGE.1)?;
            }
            Lens::Orthographic { height } => {
                check_range("camera.height", height.into(), 1e-6, FARTHEST)?;
            }
        }
        let problem = |field, problem| Err(LodError::Camera { field, problem });
        let Some(forward) = (self.target - self.eye).try_normalize() else {
            return problem("camera.target", "must not coincide with the eye");
        };
        let Some(up) = self.up.try_normalize() else {
            return problem("camera.up", "must not be zero");
        };
        if forward.cross(up).length_squared() < 1e-8 {
            return problem("camera.up", "must not be parallel to the line of sight");
        }
        Ok(())
    }
}

/// World space to samples of a picture or texels of a depth map. Depth grows towards the viewer:
/// 1 / distance in perspective, -distance in parallel projection, so that it is linear on screen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Projector {
    pub(crate) eye: Vec3,
    pub(crate) right: Vec3,
    pub(crate) up: Vec3,
    pub(crate) forward: Vec3,
    /// Samples per metre at distance 1 (perspective) or at any distance.
    pub(crate) scale: f32,
    /// The sample coordinates of the optical axis.
    pub(crate) center: Vec2,
    pub(crate) near: f32,
    pub(crate) perspective: bool,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

impl Projector {
    /// For a valid pose and a picture of so many samples; `size` is the extent of the mesh.
    pub(crate) fn new(pose: &Pose, width: u32, height: u32, size: f32) -> Self {
        let toward = pose.target - pose.eye;
        let forward = toward.normalize_or(Vec3::NEG_Z);
        let right = forward.cross(pose.up).normalize_or(Vec3::X);
        let (scale, perspective) = match pose.lens {
            Lens::Perspective { fov } => {
                (0.5 * height as f32 / libm::tanf(0.5 * fov.clamp(0.01, PI - 0.1)), true)
            }
            Lens::Orthographic { height: metres } => (height as f32 / metres, false),
        };
        Self {
            eye: pose.eye,
            right,
            up: right.cross(forward),
            forward,
            scale,
            center: 0.5 * Vec2::new(width as f32, height as f32),
            near: if perspective { NEAR_SHARE * size.min(toward.length()).max(1e-4) } else { 0.0 },
            perspective,
            width,
            height,
        }
    }

    /// Looks along `forward` at everything in `vertices`, in parallel projection with about
    /// `side`² texels and `border` empty ones on each side.
    pub(super) fn over(
        vertices: impl Iterator<Item = Vec3>,
        forward: Vec3,
        side: u32,
        border: f32,
    ) -> Self {
        let right = forward.any_orthonormal_vector();
        let up = right.cross(forward);
        let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for p in vertices {
            let q = Vec3::new(right.dot(p), up.dot(p), forward.dot(p));
            min = min.min(q);
            max = max.max(q);
        }
        if min.cmpgt(max).any() {
            (min, max) = (Vec3::ZERO, Vec3::ZERO);
        }
        let extent = (max - min).max(Vec3::splat(1e-4));
        let side = side as f32;
        // The budget of texels is spread over the rectangle; a sliver stays below four times the side.
        let scale = (side / (extent.x * extent.y).sqrt())
            .min(4.0 * side / extent.x)
            .min(4.0 * side / extent.y);
        let texels = |metres: f32| (metres * scale + 2.0 * border) as u32 + 1;
        let (width, height) = (texels(extent.x), texels(extent.y));
        let middle = 0.5 * (min + max);
        Self {
            eye: right * middle.x + up * middle.y + forward * min.z,
            right,
            up,
            forward,
            scale,
            center: 0.5 * Vec2::new(width as f32, height as f32),
            near: f32::NEG_INFINITY,
            perspective: false,
            width,
            height,
        }
    }

    /// View coordinates: right, up, distance along the line of sight.
    #[inline]
    pub(crate) fn view(&self, p: Vec3) -> Vec3 {
        let d = p - self.eye;
        Vec3::new(self.right.dot(d), self.up.dot(d), self.forward.dot(d))
    }

    /// The ray through a point of the picture, in samples: origin and direction. The direction
    /// advances by 1 along the line of sight.
    #[inline]
    pub(crate) fn ray(&self, x: f32, y: f32) -> (Vec3, Vec3) {
        let across = (x - self.center.x) / self.scale;
        let down = (y - self.center.y) / self.scale;
        let shift = self.right * across - self.up * down;
        if self.perspective {
            (self.eye, self.forward + shift)
        } else {
            (self.eye + shift, self.forward)
        }
    }

    /// Depth (as everywhere here, larger is nearer) of the horizontal plane at height `y`, as
    /// value at sample (0, 0) and change per sample right and down. None where the eye is not
    /// above the plane or the plane is seen edge-on in parallel projection.
    pub(super) fn plane_depth(&self, y: f32) -> Option<[f32; 3]> {
        let above = self.eye.y - y;
        // Along a ray o + t·d the plane is met at t = (y - o.y) / d.y.
        let at = |x: f32, row: f32| {
            let (origin, direction) = self.ray(x, row);
            if self.perspective { -direction.y / above } else { (origin.y - y) / direction.y }
        };
        if self.perspective && above <= self.near || !self.perspective && self.forward.y > -1e-4 {
            return None;
        }
        let first = at(0.0, 0.0);
        let step = (0.5 * self.width as f32, 0.5 * self.height as f32);
        Some([first, (at(step.0, 0.0) - first) / step.0, (at(0.0, step.1) - first) / step.1])
    }
}
