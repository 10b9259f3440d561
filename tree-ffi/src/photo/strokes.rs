//! Strokes that a person drew.

use super::attractor::tree_attractor;
use super::{fill_opt, vec2};
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_INVALID, TREE_ERROR_TEXT, Versioned, bytes, call, foresee,
    free, get, init, out, read, read_or_default, slice, tree_status, vec2s, view, write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use glam::Vec2;
use std::ffi::c_char;
use tree_model::particle::attractor::{StrokeParams, StrokeReport, from_strokes, strokes_from_svg};
use tree_model::tree_core::{Limits, Resource};

/// How strokes are cleaned and joined. Begin with `tree_stroke_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_stroke_params {
    /// `sizeof(tree_stroke_params)`.
    pub struct_size: usize,
    /// Distance between nodes as a share of the drawing's size, 0.001 to 0.5. Default 0.02.
    pub spacing: f32,
    /// Gaps up to this share of the drawing's size are closed by moving the stroke's end, 0 to 1; wider
    /// ones are bridged by a straight line and reported. Default 0.03.
    pub snap: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_stroke_params {
    const NAME: &'static str = "tree_stroke_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&StrokeParams::default())
    }
}

impl tree_stroke_params {
    pub(crate) fn of(params: &StrokeParams) -> Self {
        let StrokeParams { spacing, snap } = *params;
        Self { struct_size: size_of::<Self>(), spacing, snap }
    }

    pub(crate) fn rust(&self) -> StrokeParams {
        StrokeParams { spacing: self.spacing, snap: self.snap }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stroke_params_init(
    params: *mut tree_stroke_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// What became of strokes.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_stroke_report {
    /// `sizeof(tree_stroke_report)`.
    pub struct_size: usize,
    /// Points left out because they were not finite.
    pub n_bad_points: u32,
    /// Strokes left out because they had no length.
    pub n_empty: u32,
    /// Strokes that were joined over a gap wider than the snapping distance.
    pub n_bridged: u32,
    /// Strokes joined by their middle, in two parts.
    pub n_split: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_stroke_report {
    const NAME: &'static str = "tree_stroke_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&StrokeReport::default())
    }
}

impl tree_stroke_report {
    pub(crate) fn of(report: &StrokeReport) -> Self {
        let StrokeReport { n_bad_points, n_empty, n_bridged, n_split, .. } = *report;
        Self { struct_size: size_of::<Self>(), n_bad_points, n_empty, n_bridged, n_split }
    }
}

/// Strokes over a picture, or other lines of the plane. The points of stroke `i` are rows `starts[i]` up to,
/// but not including, `starts[i + 1]`. Set `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_strokes_columns {
    /// `sizeof(tree_strokes_columns)`.
    pub struct_size: usize,
    /// Number of strokes.
    pub n_strokes: usize,
    /// `n_strokes + 1` numbers: 0 first, none below the one before it, `n_points` last. NULL for no strokes.
    pub starts: *const u64,
    /// Number of points of all strokes.
    pub n_points: usize,
    /// Two floats for each point, in pixels from the top left of the picture where nothing else is said.
    pub points: *const f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_strokes_columns {
    const NAME: &'static str = "tree_strokes_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_strokes: 0,
            starts: std::ptr::null(),
            n_points: 0,
            points: std::ptr::null(),
        }
    }
}

/// The caller's strokes.
pub(crate) unsafe fn strokes(
    columns: *const tree_strokes_columns,
    limits: &Limits,
    name: &str,
) -> Result<Vec<Vec<Vec2>>> {
    let columns = unsafe { read(columns, name) }?;
    let part = |field: &str| format!("{name}.{field}");
    let (n, nodes) = (columns.n_strokes, Resource::Nodes);
    let points =
        unsafe { vec2s(columns.points, columns.n_points, limits, nodes, &part("points")) }?;
    limits.check(nodes, n as u64)?;
    if n == 0 {
        return Ok(Vec::new());
    }
    // One more than there are strokes.
    let room = Limits { nodes: limits.nodes.saturating_add(1), ..*limits };
    let n_starts = n.saturating_add(1);
    let starts = unsafe { slice(columns.starts, n_starts, &room, nodes, &part("starts")) }?;
    let ends = (starts.first(), starts.last());
    if ends != (Some(&0), Some(&(points.len() as u64))) {
        let text = format!("{name}.starts must begin with 0 and end with n_points");
        return Err(Failure::new(TREE_ERROR_INVALID, text));
    }
    let stroke = |(i, pair): (usize, &[u64])| {
        let found = points.get(pair[0] as usize..pair[1] as usize);
        found.map(<[Vec2]>::to_vec).ok_or_else(|| {
            let text = format!("{name}.starts[{}] is below the one before it", i + 1);
            Failure::new(TREE_ERROR_INVALID, text)
        })
    };
    starts.windows(2).enumerate().map(stroke).collect()
}

/// Gaps as C has them: NaN where a stroke was left out.
pub(crate) fn or_nan(gaps: &[Option<f32>]) -> Vec<f32> {
    gaps.iter().map(|gap| gap.unwrap_or(f32::NAN)).collect()
}

/// Makes a graph of strokes that a person drew, whose root is at `base_pixel`, two floats. `params`,
/// `control` and `report` may be NULL; `nodes` of the limits caps the points. `gaps`, which may be NULL, gets
/// for each stroke the gap in pixels that was closed, NaN where the stroke was left out; `capacity` must be the
/// number of strokes or more. Free the graph with `tree_attractor_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_attractor_from_strokes(
    columns: *const tree_strokes_columns,
    base_pixel: *const f32,
    params: *const tree_stroke_params,
    control: *const tree_control,
    report: *mut tree_stroke_report,
    gaps: *mut f32,
    capacity: usize,
    attractor: *mut *mut tree_attractor,
) -> tree_status {
    call(|| {
        let place = unsafe { out(attractor, "attractor") }?;
        unsafe { foresee(report, "report") }?;
        let strokes = unsafe { strokes(columns, &limits(control)?, "columns") }?;
        let base = unsafe { vec2(base_pixel, "base_pixel") }?;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body = |control: &_| Ok(from_strokes(&strokes, base, &params, control)?);
        let (made, told) = unsafe { run(control, body) }?;
        unsafe { fill_opt(gaps, capacity, &or_nan(&told.gaps), "gaps") }?;
        unsafe { view(report, "report", &tree_stroke_report::of(&told)) }?;
        place.put(tree_attractor::new(made));
        Ok(())
    })
}

/// Strokes read from a drawing, a session's branches as strokes, or outlines.
pub struct tree_strokes {
    starts: Vec<u64>,
    points: Vec<Vec2>,
}

impl tree_strokes {
    pub(crate) fn new(strokes: Vec<Vec<Vec2>>) -> Self {
        let mut made = Self { starts: vec![0], points: Vec::new() };
        for stroke in strokes {
            made.points.extend(stroke);
            made.starts.push(made.points.len() as u64);
        }
        made
    }

    /// A view of the strokes.
    pub(crate) fn columns(&self) -> tree_strokes_columns {
        tree_strokes_columns {
            n_strokes: self.starts.len().saturating_sub(1),
            starts: column(&self.starts),
            n_points: self.points.len(),
            points: column(&self.points).cast(),
            ..tree_strokes_columns::default_value()
        }
    }
}

impl Handle for tree_strokes {
    const NAME: &'static str = "tree_strokes";
}

/// Reads the strokes of an SVG drawing made over a picture of `width` x `height` pixels, 1 to 1e6 each: `svg`
/// of `len` bytes or `TREE_NUL_TERMINATED`. Every path, line and polyline with its transforms is one, a
/// closed shape is a loop. The drawing's view box (or its width and height) is stretched to the picture;
/// without either its units are pixels. `control` may be NULL. Free the strokes with `tree_strokes_free`.
/// `TREE_ERROR_FORMAT` when the text is no SVG or draws nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_strokes_from_svg(
    svg: *const c_char,
    len: usize,
    width: f32,
    height: f32,
    control: *const tree_control,
    strokes: *mut *mut tree_strokes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(strokes, "strokes") }?;
        let bytes = unsafe { bytes(svg.cast(), len, &limits(control)?, "svg") }?;
        let text = std::str::from_utf8(bytes).map_err(|error| {
            let at = error.valid_up_to();
            Failure::new(TREE_ERROR_TEXT, format!("svg is not UTF-8 from byte {at} on"))
        })?;
        let size = Vec2::new(width, height);
        let found = unsafe { run(control, |_| Ok(strokes_from_svg(text, size)?)) }?;
        place.put(tree_strokes::new(found));
        Ok(())
    })
}

/// Views strokes, as `tree_attractor_from_strokes` takes them. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_strokes_view(
    strokes: *const tree_strokes,
    columns: *mut tree_strokes_columns,
) -> tree_status {
    call(|| {
        let strokes = unsafe { get(strokes, "strokes") }?;
        unsafe { write(columns, "columns", &strokes.columns()) }
    })
}

/// Frees strokes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_strokes_free(strokes: *mut tree_strokes) -> tree_status {
    call(|| unsafe { free(strokes, "strokes") })
}
