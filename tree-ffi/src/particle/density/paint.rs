//! Painting and erasing density, in a view or in space.

use crate::border::{
    Result, Versioned, call, get, init, out, read_rows, tree_status, vec2s, vec3s,
};
use crate::control::{limits, run, tree_control};
use crate::particle::grid::tree_grid;
use crate::photo::tree_matte;
use tree_model::particle::density::{DensityBrush, DensityStroke, paint, paint_volume};
use tree_model::tree_core::{Limits, Resource};

/// Most strokes or brushes of one call.
const STROKES_MAX: usize = 1 << 16;

/// A stroke over a matte. Begin with `tree_density_stroke_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_density_stroke {
    /// `sizeof(tree_density_stroke)`.
    pub struct_size: usize,
    /// Its course: two floats for each point, in pixels from the top left. One point makes a dot.
    pub points: *const f32,
    /// Number of points.
    pub n_points: usize,
    /// Width in pixels, above 0. Default 20.
    pub width: f32,
    /// What the matte becomes in its middle, 0 (erase) to 1 (opaque). Default 1.
    pub value: f32,
    /// Share of its width over which it fades, 0 (hard) to 1. Default 0.5.
    pub softness: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_density_stroke {
    const NAME: &'static str = "tree_density_stroke";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let DensityStroke { width, value, softness, .. } = DensityStroke::default();
        Self {
            struct_size: size_of::<Self>(),
            points: std::ptr::null(),
            n_points: 0,
            width,
            value,
            softness,
            reserved: 0,
        }
    }
}

/// Makes `stroke`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_density_stroke_init(
    stroke: *mut tree_density_stroke,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(stroke, size) })
}

/// A stroke of a ball through a grid. Begin with `tree_density_brush_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_density_brush {
    /// `sizeof(tree_density_brush)`.
    pub struct_size: usize,
    /// Its course: three floats for each point, in metres. One point makes a ball.
    pub points: *const f32,
    /// Number of points.
    pub n_points: usize,
    /// Radius in metres, above 0. Default 0.5.
    pub radius: f32,
    /// What the grid becomes in its middle, 0 (erase) to 1e6 per metre. Default 1.
    pub value: f32,
    /// Share of its radius over which it fades, 0 (hard) to 1. Default 0.5.
    pub softness: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_density_brush {
    const NAME: &'static str = "tree_density_brush";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let DensityBrush { radius, value, softness, .. } = DensityBrush::default();
        Self {
            struct_size: size_of::<Self>(),
            points: std::ptr::null(),
            n_points: 0,
            radius,
            value,
            softness,
            reserved: 0,
        }
    }
}

/// Makes `brush`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_density_brush_init(
    brush: *mut tree_density_brush,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(brush, size) })
}

/// Copies of the strokes of an array.
pub(crate) unsafe fn strokes(
    first: *const tree_density_stroke,
    n: usize,
    limits: &Limits,
) -> Result<Vec<DensityStroke>> {
    let rows = unsafe { read_rows(first, n, STROKES_MAX, "strokes") }?;
    let stroke = |(i, row): (usize, &tree_density_stroke)| {
        let name = format!("strokes[{i}].points");
        let points = unsafe { vec2s(row.points, row.n_points, limits, Resource::Nodes, &name) }?;
        let tree_density_stroke { width, value, softness, .. } = *row;
        Ok(DensityStroke { points: points.to_vec(), width, value, softness })
    };
    rows.iter().enumerate().map(stroke).collect()
}

/// Copies of the brushes of an array.
pub(crate) unsafe fn brushes(
    first: *const tree_density_brush,
    n: usize,
    limits: &Limits,
) -> Result<Vec<DensityBrush>> {
    let rows = unsafe { read_rows(first, n, STROKES_MAX, "brushes") }?;
    let brush = |(i, row): (usize, &tree_density_brush)| {
        let name = format!("brushes[{i}].points");
        let points = unsafe { vec3s(row.points, row.n_points, limits, Resource::Nodes, &name) }?;
        let tree_density_brush { radius, value, softness, .. } = *row;
        Ok(DensityBrush { points: points.to_vec(), radius, value, softness })
    };
    rows.iter().enumerate().map(brush).collect()
}

/// A matte with strokes over it, one after the other: paints what a photograph does not show, and erases
/// what is not of the tree. Parts outside the picture do nothing. The first matte stays as it is. `control`
/// may be NULL; `nodes` of its limits caps the points of a stroke. Free the painted one with
/// `tree_matte_free`. `TREE_ERROR_PARAMETER` names the stroke that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_matte_paint(
    matte: *const tree_matte,
    strokes: *const tree_density_stroke,
    n_strokes: usize,
    control: *const tree_control,
    painted: *mut *mut tree_matte,
) -> tree_status {
    call(|| {
        let place = unsafe { out(painted, "painted") }?;
        let matte = unsafe { get(matte, "matte") }?.rust();
        let strokes = unsafe { self::strokes(strokes, n_strokes, &limits(control)?) }?;
        let body = |_: &_| Ok(paint(matte, &strokes)?);
        place.put(tree_matte::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// A grid with balls drawn through it, one after the other. Parts outside the grid do nothing. The first
/// grid stays as it is. `control` may be NULL; `nodes` of its limits caps the points of a brush. Free the
/// painted one with `tree_grid_free`. `TREE_ERROR_PARAMETER` names the brush that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grid_paint(
    grid: *const tree_grid,
    brushes: *const tree_density_brush,
    n_brushes: usize,
    control: *const tree_control,
    painted: *mut *mut tree_grid,
) -> tree_status {
    call(|| {
        let place = unsafe { out(painted, "painted") }?;
        let grid = unsafe { get(grid, "grid") }?.rust();
        let brushes = unsafe { self::brushes(brushes, n_brushes, &limits(control)?) }?;
        let body = |_: &_| {
            let mut grid = grid.clone();
            paint_volume(&mut grid, &brushes)?;
            Ok(grid)
        };
        place.put(tree_grid::new(unsafe { run(control, body) }?));
        Ok(())
    })
}
