//! Size, quality and camera of a picture.

use crate::border::{
    Failure, Result, Versioned, call, get, init, read_or_default, tree_status, write,
};
use crate::mesh::tree_mesh;
use glam::Vec3;
use tree_lod::preview::{Camera, Framing, Lens, Pose, View};

/// How a camera is placed: one of the `TREE_CAMERA_` constants.
pub type tree_camera = u32;

/// It chooses its place so that the whole mesh is in the picture.
pub const TREE_CAMERA_FRAMED: u32 = 0;
/// It stands where it is told to.
pub const TREE_CAMERA_PLACED: u32 = 1;

/// How a camera projects: one of the `TREE_LENS_` constants.
pub type tree_lens = u32;

/// Far things are smaller.
pub const TREE_LENS_PERSPECTIVE: u32 = 0;
/// Parallel projection; what lies behind the eye is not drawn.
pub const TREE_LENS_ORTHOGRAPHIC: u32 = 1;

/// Size, quality and camera of a picture. Begin with `tree_view_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_view {
    /// `sizeof(tree_view)`.
    pub struct_size: usize,
    /// Width in pixels, 1 to 16,384. Default 1024.
    pub width: u32,
    /// Height in pixels, 1 to 16,384. Default 1024.
    pub height: u32,
    /// Samples per pixel in each direction, 1 (jagged) to 4. Cost grows with the square; default 2.
    pub samples: u32,
    /// How the camera is placed. Default `TREE_CAMERA_FRAMED`.
    pub camera: tree_camera,
    /// How the camera projects. Default `TREE_LENS_PERSPECTIVE`.
    pub lens: tree_lens,
    /// Perspective: vertical field of view in radians, 0.017 to 2.8. Default 0.6, a portrait lens.
    pub fov: f32,
    /// Framed: where the camera stands around the trunk, in radians: 0 on +Z (looking along -Z), a
    /// quarter turn on +X. Finite; default 0.6.
    pub yaw: f32,
    /// Framed: how far the camera looks down, in radians, -pi/2 (from below) to pi/2 (from above).
    /// Default 0.09.
    pub pitch: f32,
    /// Framed: empty share of the picture on each side, 0 to 0.45. Default 0.06.
    pub margin: f32,
    /// Placed and orthographic: height of the picture in metres, more than 0. Default 0: set it.
    pub lens_height: f32,
    /// Placed: where the camera stands, in metres. Default 0, 0, 0.
    pub eye: [f32; 3],
    /// Placed: what is in the middle of the picture. Default 0, 0, 0: set it.
    pub target: [f32; 3],
    /// Placed: which way is up; must not be parallel to the line of sight. Default 0, 1, 0.
    pub up: [f32; 3],
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_view {
    const NAME: &'static str = "tree_view";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&View::default())
    }
}

impl tree_view {
    pub(crate) fn of(view: &View) -> Self {
        let framing = Framing::default();
        let mut flat = Self {
            struct_size: size_of::<Self>(),
            width: view.width,
            height: view.height,
            samples: view.samples,
            camera: TREE_CAMERA_FRAMED,
            lens: TREE_LENS_PERSPECTIVE,
            fov: framing.fov,
            yaw: framing.yaw,
            pitch: framing.pitch,
            margin: framing.margin,
            lens_height: 0.0,
            eye: [0.0; 3],
            target: [0.0; 3],
            up: Vec3::Y.to_array(),
            reserved: 0,
        };
        match view.camera {
            Camera::Framed(framing) => flat.frame(&framing),
            Camera::Placed(pose) => flat.place(&pose),
        }
        flat
    }

    fn frame(&mut self, framing: &Framing) {
        self.camera = TREE_CAMERA_FRAMED;
        self.lens =
            if framing.orthographic { TREE_LENS_ORTHOGRAPHIC } else { TREE_LENS_PERSPECTIVE };
        self.fov = framing.fov;
        self.yaw = framing.yaw;
        self.pitch = framing.pitch;
        self.margin = framing.margin;
    }

    fn place(&mut self, pose: &Pose) {
        self.camera = TREE_CAMERA_PLACED;
        self.eye = pose.eye.to_array();
        self.target = pose.target.to_array();
        self.up = pose.up.to_array();
        match pose.lens {
            Lens::Perspective { fov } => {
                (self.lens, self.fov) = (TREE_LENS_PERSPECTIVE, fov);
            }
            Lens::Orthographic { height } => {
                (self.lens, self.lens_height) = (TREE_LENS_ORTHOGRAPHIC, height);
            }
        }
    }

    fn rust(&self) -> Result<View> {
        let orthographic = match self.lens {
            TREE_LENS_PERSPECTIVE => false,
            TREE_LENS_ORTHOGRAPHIC => true,
            other => return Err(Failure::not_one_of("view.lens", other, "TREE_LENS_")),
        };
        let camera = match self.camera {
            TREE_CAMERA_FRAMED => Camera::Framed(Framing {
                yaw: self.yaw,
                pitch: self.pitch,
                fov: self.fov,
                margin: self.margin,
                orthographic,
            }),
            TREE_CAMERA_PLACED => Camera::Placed(Pose {
                eye: self.eye.into(),
                target: self.target.into(),
                up: self.up.into(),
                lens: if orthographic {
                    Lens::Orthographic { height: self.lens_height }
                } else {
                    Lens::Perspective { fov: self.fov }
                },
            }),
            other => return Err(Failure::not_one_of("view.camera", other, "TREE_CAMERA_")),
        };
        Ok(View { width: self.width, height: self.height, samples: self.samples, camera })
    }

    pub(crate) unsafe fn read(view: *const Self) -> Result<View> {
        unsafe { read_or_default(view, "view") }?.rust()
    }
}

/// Makes `view`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_view_init(view: *mut tree_view, size: usize) -> tree_status {
    call(|| unsafe { init(view, size) })
}

/// The same view with the camera placed where it stands for this mesh. `view` may be NULL for the
/// default; `placed` may be the same struct. Set `placed->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_view_place(
    view: *const tree_view,
    mesh: *const tree_mesh,
    placed: *mut tree_view,
) -> tree_status {
    call(|| {
        let given = unsafe { tree_view::read(view) }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        given.validate()?;
        let pose = given.camera.pose(mesh, given.width as f32 / given.height as f32)?;
        let made = View { camera: Camera::Placed(pose), ..given };
        unsafe { write(placed, "placed", &tree_view::of(&made)) }
    })
}
