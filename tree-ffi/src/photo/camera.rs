//! Where a photograph was taken from.

use crate::border::{Result, Versioned, call, init, out_value, read, tree_status};
use glam::Vec2;
use tree_model::particle::{Camera, Projection};

/// The camera of one photograph. The tree's base is the world's origin, +Y is up. Begin with
/// `tree_particle_camera_init`, or let `tree_align` find it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_particle_camera {
    /// `sizeof(tree_particle_camera)`.
    pub struct_size: usize,
    /// Where the camera stands around the trunk, in radians: 0 on +Z (looking along -Z), a quarter turn on
    /// +X. -1e6 to 1e6; default 0.
    pub yaw: f32,
    /// How far the camera looks down, in radians, -1.5 to 1.5. A photograph from the ground looks up:
    /// negative. Default 0.
    pub pitch: f32,
    /// Vertical field of view of the whole picture in radians, 0.017 to 2.8: a phone held upright has about
    /// 1.2. 0, the default, is parallel projection, close enough for a photograph from afar.
    pub fov: f32,
    /// Size of the picture in pixels, 1 to 1e6 each. Default 1, 1: set it.
    pub size: [f32; 2],
    /// Where the tree's base is in the picture, in pixels from the top left; may lie outside. Default 0.5, 1:
    /// set it.
    pub base: [f32; 2],
    /// Metres for a pixel, at the tree's base, 1e-7 to 1e6. Default 1: set it.
    pub scale: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_particle_camera {
    const NAME: &'static str = "tree_particle_camera";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            yaw: 0.0,
            pitch: 0.0,
            fov: 0.0,
            size: [1.0, 1.0],
            base: [0.5, 1.0],
            scale: 1.0,
        }
    }
}

/// A field of view as a projection: 0 is parallel.
pub(crate) fn projection(fov: f32) -> Projection {
    if fov == 0.0 { Projection::Orthographic } else { Projection::Perspective { fov } }
}

/// A projection as a field of view.
pub(crate) fn fov(projection: Projection) -> f32 {
    match projection {
        Projection::Orthographic => 0.0,
        Projection::Perspective { fov } => fov,
    }
}

impl tree_particle_camera {
    pub(crate) fn of(camera: &Camera) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            yaw: camera.yaw,
            pitch: camera.pitch,
            fov: fov(camera.projection),
            size: camera.size.to_array(),
            base: camera.base.to_array(),
            scale: camera.scale,
        }
    }

    /// Not checked.
    pub(crate) fn rust(&self) -> Camera {
        Camera {
            yaw: self.yaw,
            pitch: self.pitch,
            projection: projection(self.fov),
            size: Vec2::from_array(self.size),
            base: Vec2::from_array(self.base),
            scale: self.scale,
        }
    }

    /// The caller's camera, checked.
    ///
    /// # Safety
    /// As [`read`].
    pub(crate) unsafe fn get(camera: *const Self) -> Result<Camera> {
        let camera = unsafe { read(camera, "camera") }?.rust();
        camera.validate("camera")?;
        Ok(camera)
    }
}

/// Makes `camera`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_particle_camera_init(
    camera: *mut tree_particle_camera,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(camera, size) })
}

/// Checks all numbers of a camera: `TREE_ERROR_PARAMETER` names the one out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_particle_camera_check(
    camera: *const tree_particle_camera,
) -> tree_status {
    call(|| unsafe { tree_particle_camera::get(camera) }.map(drop))
}

/// The directions of a camera in the world, as unit vectors: `right` in the picture, always horizontal,
/// `up` in it, and `forward` into it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_particle_camera_frame(
    camera: *const tree_particle_camera,
    right: *mut [f32; 3],
    up: *mut [f32; 3],
    forward: *mut [f32; 3],
) -> tree_status {
    call(|| {
        let frame = unsafe { tree_particle_camera::get(camera) }?.frame();
        unsafe { out_value(right, frame.right.to_array(), "right") }?;
        unsafe { out_value(up, frame.up.to_array(), "up") }?;
        unsafe { out_value(forward, frame.forward.to_array(), "forward") }
    })
}
