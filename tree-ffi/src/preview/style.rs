//! Light, ground and backdrop of a picture.

use crate::border::{Failure, Result, Versioned, call, init, read_or_default, tree_status, write};
use tree_lod::preview::{Backdrop, Style};

/// What is behind the mesh, and the light that comes from there: one of the `TREE_BACKDROP_` constants.
pub type tree_backdrop = u32;

/// A clear sky.
pub const TREE_BACKDROP_SKY: u32 = 0;
/// Light grey paper under soft white light.
pub const TREE_BACKDROP_STUDIO: u32 = 1;

/// Light, ground and backdrop of a picture. Begin with `tree_style_init`, a clear day on grass, or
/// `tree_style_studio`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_style {
    /// `sizeof(tree_style)`.
    pub struct_size: usize,
    /// Where the sun stands around the trunk, in radians, as `yaw` of a view: 0 on +Z, a quarter turn on
    /// +X. Finite; default -0.35.
    pub sun_yaw: f32,
    /// Height of the sun over the horizon in radians, 0.05 to pi/2. Default 0.85.
    pub sun_pitch: f32,
    /// Strength of the sun, 0 (none) to 100. Default 2.3.
    pub sun: f32,
    /// Strength of the sky, 0 (none) to 100. Default 1.
    pub sky: f32,
    /// What the light is multiplied with before the tone curve, 0.01 to 100. Default 1.
    pub exposure: f32,
    /// Sharpness of the sun's shadows: about this many texels squared, 16 to 8192. Cost grows with the
    /// square. Default 2048.
    pub sun_map_px: u32,
    /// From how many directions sky light is taken, 0 (unhindered everywhere) to 64. More gives smoother
    /// shade at a cost of one pass over all triangles each. Default 12.
    pub sky_directions: u32,
    /// Sharpness of the sky's shade: texels squared per direction, 16 to 2048. Default 256.
    pub sky_map_px: u32,
    /// What is behind the mesh. Default `TREE_BACKDROP_SKY`.
    pub backdrop: tree_backdrop,
    /// Whether there is an endless ground; without, roots stay visible. Default 1.
    pub has_ground: u32,
    /// Height of the ground in metres, -1e6 to 1e6. Default 0, the base of the tree.
    pub ground: f32,
    /// Linear colour of the ground, 0 to 1 each; varied a little over the ground under
    /// `TREE_BACKDROP_SKY`. Default 0.075, 0.098, 0.032.
    pub ground_color: [f32; 3],
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_style {
    const NAME: &'static str = "tree_style";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Style::default())
    }
}

impl tree_style {
    fn of(style: &Style) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            sun_yaw: style.sun_yaw,
            sun_pitch: style.sun_pitch,
            sun: style.sun,
            sky: style.sky,
            exposure: style.exposure,
            sun_map_px: style.sun_map_px,
            sky_directions: style.sky_directions,
            sky_map_px: style.sky_map_px,
            backdrop: match style.backdrop {
                Backdrop::Studio => TREE_BACKDROP_STUDIO,
                _ => TREE_BACKDROP_SKY,
            },
            has_ground: style.ground.is_some().into(),
            ground: style.ground.unwrap_or_default(),
            ground_color: style.ground_color,
        }
    }

    fn rust(&self) -> Result<Style> {
        Ok(Style {
            sun_yaw: self.sun_yaw,
            sun_pitch: self.sun_pitch,
            sun: self.sun,
            sky: self.sky,
            exposure: self.exposure,
            sun_map_px: self.sun_map_px,
            sky_directions: self.sky_directions,
            sky_map_px: self.sky_map_px,
            backdrop: match self.backdrop {
                TREE_BACKDROP_SKY => Backdrop::Sky,
                TREE_BACKDROP_STUDIO => Backdrop::Studio,
                other => {
                    return Err(Failure::not_one_of("style.backdrop", other, "TREE_BACKDROP_"));
                }
            },
            ground: (self.has_ground != 0).then_some(self.ground),
            ground_color: self.ground_color,
        })
    }

    pub(super) unsafe fn read(style: *const Self) -> Result<Style> {
        unsafe { read_or_default(style, "style") }?.rust()
    }
}

/// Makes `style`, of `size` bytes, the default: a clear day on grass.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_style_init(style: *mut tree_style, size: usize) -> tree_status {
    call(|| unsafe { init(style, size) })
}

/// Makes `style`, of `size` bytes, light grey paper with ground.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_style_studio(style: *mut tree_style, size: usize) -> tree_status {
    call(|| {
        unsafe { init(style, size) }?;
        unsafe { write(style, "style", &tree_style::of(&Style::studio())) }
    })
}
