//! Where a photograph was taken from, as roughly as one knows it.

use crate::error::{Result, check};
use glam::{Vec2, Vec3};
use std::f32::consts::FRAC_PI_2;

/// Largest number a yaw or a pixel coordinate may be.
const LARGEST: f32 = 1e6;

/// How a photograph projects.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Projection {
    /// Parallel: what the thesis assumes, and close enough for a photograph from afar.
    #[default]
    Orthographic,
    /// Far things are smaller.
    Perspective {
        /// Vertical field of view of the whole picture in radians, 0.017 to 2.8. A phone held upright
        /// has about 1.2.
        fov: f32,
    },
}

/// The camera of one photograph. The tree's base is the world's origin, +Y is up.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Camera {
    /// Where the camera stands around the trunk, in radians: 0 on +Z (looking along -Z), a quarter turn
    /// on +X. Finite.
    pub yaw: f32,
    /// How far the camera looks down, in radians, -1.5 to 1.5. A photograph from the ground looks up:
    /// negative. Default 0.
    pub pitch: f32,
    /// How it projects. Default orthographic.
    pub projection: Projection,
    /// Size of the picture in pixels.
    pub size: Vec2,
    /// Where the tree's base is in the picture, in pixels from the top left; may lie outside.
    pub base: Vec2,
    /// Metres for a pixel, at the tree's base.
    pub scale: f32,
}

/// A camera as renderers want it: what it shows is what [`Camera::project`](Projector::project) gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// Where it stands, in metres. A parallel one stands far enough off.
    pub eye: Vec3,
    /// What is in the middle of the picture.
    pub target: Vec3,
    /// Which way is up.
    pub up: Vec3,
    /// Vertical field of view in radians; `None` for parallel projection.
    pub fov: Option<f32>,
    /// Height of the picture in metres, at the target.
    pub height: f32,
}

/// The directions of a camera in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Unit vector to the right in the picture. Always horizontal.
    pub right: Vec3,
    /// Unit vector upwards in the picture.
    pub up: Vec3,
    /// Unit vector into the picture.
    pub forward: Vec3,
}

impl Camera {
    /// Checks all numbers; `field` names the camera in the error.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field.
    pub fn validate(&self, field: &str) -> Result<()> {
        check(format!("{field}.yaw"), self.yaw, -LARGEST, LARGEST)?;
        check(format!("{field}.pitch"), self.pitch, -1.5_f32, 1.5_f32)?;
        if let Projection::Perspective { fov } = self.projection {
            check(format!("{field}.fov"), fov, 0.017_f32, 2.8_f32)?;
        }
        check(format!("{field}.size.x"), self.size.x, 1.0, LARGEST)?;
        check(format!("{field}.size.y"), self.size.y, 1.0, LARGEST)?;
        check(format!("{field}.base.x"), self.base.x, -LARGEST, LARGEST)?;
        check(format!("{field}.base.y"), self.base.y, -LARGEST, LARGEST)?;
        check(format!("{field}.scale"), self.scale, 1e-7_f32, 1e6_f32)
    }

    /// The camera's directions.
    #[must_use]
    pub fn frame(&self) -> Frame {
        let (sin_yaw, cos_yaw) = libm::sincosf(self.yaw);
        let (sin_pitch, cos_pitch) = libm::sincosf(self.pitch.clamp(-FRAC_PI_2, FRAC_PI_2));
        let forward = -Vec3::new(sin_yaw * cos_pitch, sin_pitch, cos_yaw * cos_pitch);
        let right = Vec3::new(cos_yaw, 0.0, -sin_yaw);
        Frame { right, up: right.cross(forward), forward }
    }

    /// Ready to project many points.
    #[must_use]
    pub fn projector(&self) -> Projector {
        let frame = self.frame();
        match self.projection {
            Projection::Orthographic => Projector {
                frame,
                center: self.base,
                origin: Vec3::ZERO,
                focal: 1.0 / self.scale,
                perspective: false,
            },
            Projection::Perspective { fov } => {
                let focal = 0.5 * self.size.y / libm::tanf(0.5 * fov);
                let center = 0.5 * self.size;
                let off = (self.base - center) * self.scale;
                Projector {
                    frame,
                    center,
                    origin: Vec3::new(off.x, -off.y, focal * self.scale),
                    focal,
                    perspective: true,
                }
            }
        }
    }

    /// The camera for a renderer, to draw the tree as the photograph shows it.
    #[must_use]
    pub fn stand(&self) -> Stand {
        let projector = self.projector();
        let Frame { up, forward, .. } = projector.frame;
        let height = self.size.y * self.scale;
        let (on, along) = projector.ray(0.5 * self.size);
        match self.projection {
            Projection::Orthographic => {
                let off = 4.0 * (height + self.size.x * self.scale);
                Stand { eye: on - off * forward, target: on, up, fov: None, height }
            }
            Projection::Perspective { fov } => {
                let target = on + projector.origin.z * along;
                Stand { eye: on, target, up, fov: Some(fov), height }
            }
        }
    }

    /// Where the camera stands in perspective; `None` for parallel projection.
    #[must_use]
    pub fn eye(&self) -> Option<Vec3> {
        let projector = self.projector();
        projector.perspective.then(|| projector.eye())
    }
}

/// World points to pixels and back.
#[derive(Clone, Copy, Debug)]
pub struct Projector {
    /// The camera's directions.
    pub frame: Frame,
    /// The pixel on the optical axis; in parallel projection the pixel of the base.
    center: Vec2,
    /// The base as the camera sees it: right, up, forward in metres. Zero in parallel projection.
    origin: Vec3,
    /// Pixels for a unit of (metres / depth), or for a metre in parallel projection.
    focal: f32,
    perspective: bool,
}

impl Projector {
    /// The pixel a point falls on; `None` behind the camera or beside it.
    #[must_use]
    #[inline]
    pub fn project(&self, point: Vec3) -> Option<Vec2> {
        let (x, y) = (self.frame.right.dot(point), self.frame.up.dot(point));
        if !self.perspective {
            return Some(self.center + self.focal * Vec2::new(x, -y));
        }
        let depth = self.origin.z + self.frame.forward.dot(point);
        // A thousandth of the distance to the tree: nearer than any branch.
        if depth <= 1e-3 * self.origin.z {
            return None;
        }
        let plane = Vec2::new(self.origin.x + x, -self.origin.y - y);
        Some(self.center + plane * (self.focal / depth))
    }

    /// The ray through a pixel: a point on it and its unit direction. In parallel projection the point
    /// lies on the plane through the base.
    #[must_use]
    #[inline]
    pub fn ray(&self, pixel: Vec2) -> (Vec3, Vec3) {
        let Frame { right, up, forward } = self.frame;
        let off = (pixel - self.center) / self.focal;
        if self.perspective {
            (self.eye(), (forward + right * off.x - up * off.y).normalize())
        } else {
            (right * off.x - up * off.y, forward)
        }
    }

    /// Metres for a pixel at the depth of `point`.
    #[must_use]
    #[inline]
    pub fn pixel_size(&self, point: Vec3) -> f32 {
        if self.perspective {
            let depth = self.origin.z + self.frame.forward.dot(point);
            depth.max(1e-3 * self.origin.z) / self.focal
        } else {
            1.0 / self.focal
        }
    }

    fn eye(&self) -> Vec3 {
        let Frame { right, up, forward } = self.frame;
        -(right * self.origin.x + up * self.origin.y + forward * self.origin.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(yaw: f32, pitch: f32, projection: Projection) -> Camera {
        let (size, base) = (Vec2::new(200.0, 300.0), Vec2::new(90.0, 280.0));
        Camera { yaw, pitch, projection, size, base, scale: 0.05 }
    }

    const LENSES: [Projection; 2] =
        [Projection::Orthographic, Projection::Perspective { fov: 0.9 }];

    #[test]
    fn the_origin_falls_on_the_base_and_up_is_up() {
        for projection in LENSES {
            for (yaw, pitch) in [(0.0, 0.0), (1.0, 0.3), (4.0, -0.6)] {
                let projector = camera(yaw, pitch, projection).projector();
                let base = projector.project(Vec3::ZERO).unwrap();
                assert!(base.distance(Vec2::new(90.0, 280.0)) < 1e-3, "{base}");
                assert!(projector.project(Vec3::Y).unwrap().y < base.y - 10.0);
                let right = projector.project(0.1 * projector.frame.right).unwrap();
                assert!((right.x - base.x - 2.0).abs() < 0.01, "{right}");
            }
        }
    }

    #[test]
    fn a_quarter_turn_stands_on_positive_x() {
        let camera = camera(FRAC_PI_2, 0.0, LENSES[1]);
        assert!(camera.eye().unwrap().x > 1.0);
        assert!(camera.frame().forward.distance(Vec3::NEG_X) < 1e-6);
        assert!(camera.frame().up.distance(Vec3::Y) < 1e-6);
    }

    #[test]
    fn rays_go_back_through_the_points_that_fall_on_their_pixels() {
        for projection in LENSES {
            let projector = camera(0.7, -0.2, projection).projector();
            for point in [Vec3::new(1.0, 5.0, -2.0), Vec3::new(-3.0, 9.0, 1.0)] {
                let (on, along) = projector.ray(projector.project(point).unwrap());
                let off = (point - on).reject_from_normalized(along);
                assert!(off.length() < 1e-4, "{off}");
            }
        }
    }

    #[test]
    fn a_stand_looks_along_the_middle_of_the_picture() {
        for projection in LENSES {
            let camera = camera(0.7, -0.2, projection);
            let stand = camera.stand();
            let middle = camera.projector().project(stand.target).unwrap();
            assert!(middle.distance(0.5 * camera.size) < 1e-2, "{middle}");
            let forward = (stand.target - stand.eye).normalize();
            assert!(forward.distance(camera.frame().forward) < 1e-4);
        }
    }

    #[test]
    fn what_is_behind_the_camera_falls_on_no_pixel() {
        let camera = camera(0.0, 0.0, LENSES[1]);
        assert_eq!(camera.projector().project(2.0 * camera.eye().unwrap()), None);
    }

    #[test]
    fn bad_numbers_are_named() {
        let bad = Camera { yaw: f32::NAN, ..camera(0.0, 0.0, LENSES[0]) };
        assert!(
            bad.validate("views[1].camera").unwrap_err().to_string().contains("[1].camera.yaw")
        );
        let bad = Camera { scale: 0.0, ..bad };
        assert!(Camera { yaw: 0.0, ..bad }.validate("c").is_err());
        assert!(camera(0.0, 0.0, LENSES[1]).validate("c").is_ok());
    }
}
