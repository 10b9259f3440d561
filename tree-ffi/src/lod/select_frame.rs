//! A frame: where a scene is looked at from, and what hides trees.

use super::select::{scene, state, tree_scene, tree_scene_state};
use crate::border::{
    Failure, Result, Versioned, call, floats, foresee, init, out_value, read, read_or_default,
    slice, tree_status, view,
};
use glam::Mat4;
use std::ptr::null;
use tree_lod::select::{DepthBuffer, Eye, Frame, Occlusion, SceneParams, Selected};
use tree_lod::tree_core::{Limits, Resource};

/// How it is found out what stands before a tree: one of the `TREE_SCENE_OCCLUSION_` constants.
pub type tree_scene_occlusion = u32;

/// Not at all: every tree counts as seen.
pub const TREE_SCENE_OCCLUSION_NONE: u32 = 0;
/// From depths the engine drew.
pub const TREE_SCENE_OCCLUSION_DEPTH: u32 = 1;
/// From the models' occluders, drawn by the library; ground and houses hide nothing.
pub const TREE_SCENE_OCCLUSION_BUILT_IN: u32 = 2;

/// How shares of geometry follow what is seen. Begin with `tree_scene_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_scene_params {
    /// `sizeof(tree_scene_params)`.
    pub struct_size: usize,
    /// Least factor on lambda of a tree that is hidden, 0.001 to 1. Default 0.1.
    pub hidden: f32,
    /// Width of the band in which nothing changes, as a share of lambda, 0 to 1. Default 0.05. Wider: calmer, but
    /// up to so much more is drawn.
    pub band: f32,
    /// Seconds in which lambda comes nearer to its aim by two thirds, 0 (at once) to 60. Default 0.2.
    pub time: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_scene_params {
    const NAME: &'static str = "tree_scene_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let SceneParams { hidden, band, time } = SceneParams::default();
        Self { struct_size: size_of::<Self>(), hidden, band, time, reserved: 0 }
    }
}

impl tree_scene_params {
    fn rust(&self) -> SceneParams {
        SceneParams { hidden: self.hidden, band: self.band, time: self.time }
    }

    /// The default for NULL.
    pub(super) unsafe fn read(params: *const Self) -> Result<SceneParams> {
        Ok(unsafe { read_or_default(params, "params") }?.rust())
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_params_init(
    params: *mut tree_scene_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_params_check(params: *const tree_scene_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// One picture that is to be drawn. Begin with `tree_scene_frame_init`.
///
/// Matrices have 16 floats, column by column, as engines hand them to shaders. A view turns and moves only; the
/// eye looks along -Z of it. A projection is right-handed with depth from 0 to 1: perspective or orthographic, its
/// far end finite or infinite, its depth reversed or not, off centre, upside down (Vulkan).
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_scene_frame {
    /// `sizeof(tree_scene_frame)`.
    pub struct_size: usize,
    /// From the world to the eye's space. No default: zeros, which are refused.
    pub view: [f32; 16],
    /// From the eye's space to clip space. No default: zeros, which are refused.
    pub projection: [f32; 16],
    /// Seconds since the last frame, 0 to 1e6. Default 0: no time has passed.
    pub seconds: f32,
    /// Whether the camera has jumped: all shares are then what they should be at once. Default 0.
    pub cut: u32,
    /// What hides trees: a `TREE_SCENE_OCCLUSION_` constant. Default `TREE_SCENE_OCCLUSION_NONE`. All that follows
    /// is for `TREE_SCENE_OCCLUSION_DEPTH`.
    pub occlusion: tree_scene_occlusion,
    /// Whether the first row of depths lies at clip y = -w, as in Vulkan and OpenGL; otherwise it lies at +w, as in
    /// Direct3D, Metal and WebGPU. Default 0.
    pub depth_y_down: u32,
    /// Depth of each pixel from 0 to 1, row by row, of the previous frame or some frames ago. They are not copied.
    pub depths: *const f32,
    /// Number of depths: `depth_width * depth_height`.
    pub n_depths: usize,
    /// Pixels in a row, 1 to 32,768. 256 by 144 do.
    pub depth_width: u32,
    /// Rows, 1 to 32,768.
    pub depth_height: u32,
    /// The view the depths were drawn with.
    pub depth_view: [f32; 16],
    /// The projection the depths were drawn with; it tells whether depth is reversed.
    pub depth_projection: [f32; 16],
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_scene_frame {
    const NAME: &'static str = "tree_scene_frame";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            view: [0.0; 16],
            projection: [0.0; 16],
            seconds: 0.0,
            cut: 0,
            occlusion: TREE_SCENE_OCCLUSION_NONE,
            depth_y_down: 0,
            depths: null(),
            n_depths: 0,
            depth_width: 0,
            depth_height: 0,
            depth_view: [0.0; 16],
            depth_projection: [0.0; 16],
        }
    }
}

fn eye(view: &[f32; 16], projection: &[f32; 16]) -> Eye {
    Eye { view: Mat4::from_cols_array(view), projection: Mat4::from_cols_array(projection) }
}

impl tree_scene_frame {
    unsafe fn rust<'a>(&self) -> Result<Frame<'a>> {
        let occlusion = match self.occlusion {
            TREE_SCENE_OCCLUSION_NONE => Occlusion::None,
            TREE_SCENE_OCCLUSION_BUILT_IN => Occlusion::BuiltIn,
            TREE_SCENE_OCCLUSION_DEPTH => Occlusion::Depth(unsafe { self.depth() }?),
            other => {
                let constants = "TREE_SCENE_OCCLUSION_";
                return Err(Failure::not_one_of("frame.occlusion", other, constants));
            }
        };
        Ok(Frame {
            eye: eye(&self.view, &self.projection),
            occlusion,
            seconds: self.seconds,
            cut: self.cut != 0,
        })
    }

    unsafe fn depth<'a>(&self) -> Result<DepthBuffer<'a>> {
        let (limits, pixels) = (Limits::default(), Resource::Pixels);
        Ok(DepthBuffer {
            depths: unsafe { slice(self.depths, self.n_depths, &limits, pixels, "frame.depths") }?,
            width: self.depth_width,
            height: self.depth_height,
            eye: eye(&self.depth_view, &self.depth_projection),
            y_down: self.depth_y_down != 0,
        })
    }
}

/// Makes `frame`, of `size` bytes, the default: its matrices must be set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_frame_init(
    frame: *mut tree_scene_frame,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(frame, size) })
}

/// Checks a camera, two matrices as in `tree_scene_frame`, and tells whether near things have the greater depth, 1 or
/// 0. `TREE_ERROR_PARAMETER` names the matrix that is none of a camera.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_eye_check(
    view: *const f32,
    projection: *const f32,
    is_reversed: *mut u32,
) -> tree_status {
    call(|| {
        let view = unsafe { floats(view, "view") }?;
        let projection = unsafe { floats(projection, "projection") }?;
        let found = eye(&view, &projection).is_reversed()?;
        unsafe { out_value(is_reversed, u32::from(found), "is_reversed") }
    })
}

/// What a frame draws.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_scene_report {
    /// `sizeof(tree_scene_report)`.
    pub struct_size: usize,
    /// Instances in view.
    pub n_drawn: u64,
    /// Instances out of view.
    pub n_culled: u64,
    /// Instances in view of which some sample points are hidden. What is so far that it is drawn as coarsely as can
    /// be is not tested, and counts as seen.
    pub n_occluded: u64,
    /// Instances in view of which all are.
    pub n_hidden: u64,
    /// Indices drawn: what a vertex shader sees at most.
    pub n_indices: u64,
    /// Triangles drawn, if all are lists.
    pub n_triangles: u64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_scene_report {
    const NAME: &'static str = "tree_scene_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Selected::default())
    }
}

impl tree_scene_report {
    fn of(selected: &Selected) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_drawn: selected.n_drawn as u64,
            n_culled: selected.n_culled as u64,
            n_occluded: selected.n_occluded as u64,
            n_hidden: selected.n_hidden as u64,
            n_indices: selected.n_indices,
            n_triangles: selected.n_triangles,
        }
    }
}

/// Finds what of `scene` is in view, and how finely it is drawn. `state` keeps it for `tree_scene_state_draws` and
/// `tree_scene_state_batches`. `params` may be NULL for the defaults, `report` when it is not wanted. It takes about 100 ns
/// for each instance in view, and no memory.
///
/// `TREE_ERROR_PARAMETER` for matrices that are no camera and numbers out of range, `TREE_ERROR_INVALID` for a depth
/// buffer of the wrong size and for a state of another scene. The state is left as it was then.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_scene_state_select(
    state: *mut tree_scene_state,
    scene: *const tree_scene,
    frame: *const tree_scene_frame,
    params: *const tree_scene_params,
    report: *mut tree_scene_report,
) -> tree_status {
    call(|| {
        unsafe { foresee(report.cast_const(), "report") }?;
        let mut state = unsafe { self::state(state.cast_const()) }?;
        let scene = unsafe { self::scene(scene) }?;
        let frame = unsafe { read(frame, "frame")?.rust() }?;
        let params = unsafe { tree_scene_params::read(params) }?;
        let found = scene.select(&frame, &params, &mut state)?;
        unsafe { view(report, "report", &tree_scene_report::of(&found)) }
    })
}
