//! What is known of a photograph before it is matted.

use super::blamed;
use super::picture::tree_photo;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_INVALID, Versioned, call, free, get, init, out, read,
    read_rows, slice, tree_status, vec2s, write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use tree_model::particle::matting::{ColorSamples, Level, Stroke, Trimap};
use tree_model::tree_core::{Limits, Resource};

/// Most strokes of one call.
const STROKES_MAX: usize = 1 << 20;

/// Certainly not the tree.
pub const TREE_LEVEL_BACKGROUND: u8 = 0;
/// To be found.
pub const TREE_LEVEL_UNKNOWN: u8 = 1;
/// Certainly the tree.
pub const TREE_LEVEL_FOREGROUND: u8 = 2;

/// What is known of each pixel of a photograph.
pub struct tree_trimap {
    trimap: Trimap,
    levels: Vec<u8>,
}

impl Handle for tree_trimap {
    const NAME: &'static str = "tree_trimap";
}

impl tree_trimap {
    pub(crate) fn new(trimap: Trimap) -> Self {
        let byte = |level: &Level| match level {
            Level::Background => TREE_LEVEL_BACKGROUND,
            Level::Unknown => TREE_LEVEL_UNKNOWN,
            Level::Foreground => TREE_LEVEL_FOREGROUND,
        };
        Self { levels: trimap.levels().iter().map(byte).collect(), trimap }
    }

    pub(crate) fn rust(&self) -> &Trimap {
        &self.trimap
    }
}

/// A view of a trimap.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_trimap_columns {
    /// `sizeof(tree_trimap_columns)`.
    pub struct_size: usize,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// A `TREE_LEVEL_` constant for each pixel, rows from top to bottom.
    pub levels: *const u8,
    /// Number of pixels: `width * height`.
    pub n_pixels: usize,
    /// Pixels that are certainly not the tree.
    pub n_background: usize,
    /// Pixels to be found.
    pub n_unknown: usize,
    /// Pixels that are certainly the tree.
    pub n_foreground: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_trimap_columns {
    const NAME: &'static str = "tree_trimap_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            width: 0,
            height: 0,
            levels: std::ptr::null(),
            n_pixels: 0,
            n_background: 0,
            n_unknown: 0,
            n_foreground: 0,
        }
    }
}

/// Makes a trimap of `width * height` bytes, each a `TREE_LEVEL_` constant, rows from top to bottom.
/// `control` may be NULL; only its limits matter. Free the trimap with `tree_trimap_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_trimap_from_levels(
    width: u32,
    height: u32,
    levels: *const u8,
    n_pixels: usize,
    control: *const tree_control,
    trimap: *mut *mut tree_trimap,
) -> tree_status {
    call(|| {
        let place = unsafe { out(trimap, "trimap") }?;
        let limits = unsafe { limits(control) }?;
        let bytes = unsafe { slice(levels, n_pixels, &limits, Resource::Pixels, "levels") }?;
        let level = |(i, &byte): (usize, &u8)| match byte {
            TREE_LEVEL_BACKGROUND => Ok(Level::Background),
            TREE_LEVEL_UNKNOWN => Ok(Level::Unknown),
            TREE_LEVEL_FOREGROUND => Ok(Level::Foreground),
            other => Err(Failure::not_one_of(&format!("levels[{i}]"), other.into(), "TREE_LEVEL_")),
        };
        let levels = bytes.iter().enumerate().map(level).collect::<Result<_>>()?;
        let made = Trimap::new(width, height, levels).map_err(blamed(TREE_ERROR_INVALID))?;
        place.put(tree_trimap::new(made));
        Ok(())
    })
}

/// Reads a drawn trimap: black is background, white the tree, grey (and transparent) unknown. Free the
/// trimap with `tree_trimap_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_trimap_of_photo(
    photo: *const tree_photo,
    trimap: *mut *mut tree_trimap,
) -> tree_status {
    call(|| {
        let place = unsafe { out(trimap, "trimap") }?;
        let photo = unsafe { get(photo, "photo") }?.rust();
        place.put(tree_trimap::new(Trimap::from_photo(photo)));
        Ok(())
    })
}

/// A scribble over a photograph. Begin with `tree_trimap_stroke_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_trimap_stroke {
    /// `sizeof(tree_trimap_stroke)`.
    pub struct_size: usize,
    /// Its course: two floats for each point, in pixels from the top left corner. One point makes a dot.
    pub points: *const f32,
    /// Number of points. Default 0.
    pub n_points: usize,
    /// Its width in pixels, above 0 to 1e6. Default 1.
    pub width: f32,
    /// Whether it marks the tree; otherwise the background. Default 0.
    pub foreground: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_trimap_stroke {
    const NAME: &'static str = "tree_trimap_stroke";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            points: std::ptr::null(),
            n_points: 0,
            width: 1.0,
            foreground: 0,
        }
    }
}

/// Makes `stroke`, of `size` bytes, the default: one without points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_trimap_stroke_init(
    stroke: *mut tree_trimap_stroke,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(stroke, size) })
}

impl tree_trimap_stroke {
    unsafe fn rust(&self, limits: &Limits, name: &str) -> Result<Stroke> {
        let field = format!("{name}.points");
        let points = unsafe { vec2s(self.points, self.n_points, limits, Resource::Nodes, &field) }?;
        Ok(Stroke { points: points.to_vec(), width: self.width, foreground: self.foreground != 0 })
    }
}

/// Paints `n_strokes` strokes, in their order, over a trimap of `width` x `height` pixels of which nothing is
/// known. `control` may be NULL; `pixels` of its limits caps the trimap, `nodes` the points of a stroke. Free
/// the trimap with `tree_trimap_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_trimap_from_strokes(
    width: u32,
    height: u32,
    strokes: *const tree_trimap_stroke,
    n_strokes: usize,
    control: *const tree_control,
    trimap: *mut *mut tree_trimap,
) -> tree_status {
    call(|| {
        let place = unsafe { out(trimap, "trimap") }?;
        let limits = unsafe { limits(control) }?;
        limits.check(Resource::Pixels, u64::from(width) * u64::from(height))?;
        let strokes = unsafe { read_rows(strokes, n_strokes, STROKES_MAX, "strokes") }?
            .iter()
            .enumerate()
            .map(|(i, stroke)| unsafe { stroke.rust(&limits, &format!("strokes[{i}]")) })
            .collect::<Result<Vec<_>>>()?;
        let body = |_: &_| {
            Trimap::from_strokes(width, height, &strokes).map_err(blamed(TREE_ERROR_INVALID))
        };
        place.put(tree_trimap::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Colours picked from a photograph. Begin with `tree_color_samples_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_color_samples {
    /// `sizeof(tree_color_samples)`.
    pub struct_size: usize,
    /// Colours of the tree: three bytes each, red, green and blue (sRGB).
    pub foreground: *const u8,
    /// Number of colours of the tree; at least 1.
    pub n_foreground: usize,
    /// Colours of the background.
    pub background: *const u8,
    /// Number of colours of the background; at least 1.
    pub n_background: usize,
    /// Pixels within this distance of a sample are known: a distance in the RGB cube of side 255, 0 to 442.
    /// Default 24.
    pub tolerance: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_color_samples {
    const NAME: &'static str = "tree_color_samples";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            foreground: std::ptr::null(),
            n_foreground: 0,
            background: std::ptr::null(),
            n_background: 0,
            tolerance: ColorSamples::default().tolerance,
            reserved: 0,
        }
    }
}

/// Makes `samples`, of `size` bytes, the default: no colours.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_color_samples_init(
    samples: *mut tree_color_samples,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(samples, size) })
}

impl tree_color_samples {
    unsafe fn rust(&self, limits: &Limits) -> Result<ColorSamples> {
        let nodes = Resource::Nodes;
        let side = |first: *const u8, n, field: &str| {
            unsafe { slice::<[u8; 3]>(first.cast(), n, limits, nodes, field) }.map(<[_]>::to_vec)
        };
        Ok(ColorSamples {
            foreground: side(self.foreground, self.n_foreground, "samples.foreground")?,
            background: side(self.background, self.n_background, "samples.background")?,
            tolerance: self.tolerance,
        })
    }
}

/// Marks the pixels of a photograph that look like one of the sampled colours; where both sides do, the
/// nearer sample decides. `control` may be NULL; `nodes` of its limits caps the samples. Free the trimap
/// with `tree_trimap_free`. `TREE_ERROR_INVALID` when either side has no sample.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_trimap_from_colors(
    photo: *const tree_photo,
    samples: *const tree_color_samples,
    control: *const tree_control,
    trimap: *mut *mut tree_trimap,
) -> tree_status {
    call(|| {
        let place = unsafe { out(trimap, "trimap") }?;
        let photo = unsafe { get(photo, "photo") }?.rust();
        let limits = unsafe { limits(control) }?;
        let samples = unsafe { read(samples, "samples")?.rust(&limits) }?;
        let body = |_: &_| Trimap::from_colors(photo, &samples).map_err(blamed(TREE_ERROR_INVALID));
        place.put(tree_trimap::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Views a trimap. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_trimap_view(
    trimap: *const tree_trimap,
    columns: *mut tree_trimap_columns,
) -> tree_status {
    call(|| {
        let tree_trimap { trimap, levels } = unsafe { get(trimap, "trimap") }?;
        let found = tree_trimap_columns {
            width: trimap.width(),
            height: trimap.height(),
            levels: column(levels),
            n_pixels: levels.len(),
            n_background: trimap.count(Level::Background),
            n_unknown: trimap.count(Level::Unknown),
            n_foreground: trimap.count(Level::Foreground),
            ..tree_trimap_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// Frees a trimap.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_trimap_free(trimap: *mut tree_trimap) -> tree_status {
    call(|| unsafe { free(trimap, "trimap") })
}
