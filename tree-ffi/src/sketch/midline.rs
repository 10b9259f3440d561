//! Middle lines of branches that are drawn as a filled area.

use crate::border::{
    Failure, Handle, Result, Versioned, call, free, get, init, out, read_or_default, tree_status,
    write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use crate::photo::{strokes, tree_strokes, tree_strokes_columns};
use tree_model::sketch::{FillRule, MidlineParams, midlines_of};

/// What lies inside where contours cross or nest: a `TREE_FILL_` constant.
pub type tree_fill_rule = u32;

/// What is wound round. The default, as in SVG.
pub const TREE_FILL_NON_ZERO: u32 = 0;
/// What is wound round an odd number of times.
pub const TREE_FILL_EVEN_ODD: u32 = 1;

/// How middle lines are found. Begin with `tree_midline_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_midline_params {
    /// `sizeof(tree_midline_params)`.
    pub struct_size: usize,
    /// Side lines shorter than this share of the area's width where they leave are no branches, 0 to 10. Default 1.
    pub spur: f32,
    /// What lies inside. Default `TREE_FILL_NON_ZERO`.
    pub rule: tree_fill_rule,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_midline_params {
    const NAME: &'static str = "tree_midline_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let MidlineParams { spur, rule } = MidlineParams::default();
        let rule = match rule {
            FillRule::NonZero => TREE_FILL_NON_ZERO,
            FillRule::EvenOdd => TREE_FILL_EVEN_ODD,
        };
        Self { struct_size: size_of::<Self>(), spur, rule }
    }
}

impl tree_midline_params {
    fn rust(&self) -> Result<MidlineParams> {
        let rule = match self.rule {
            TREE_FILL_NON_ZERO => FillRule::NonZero,
            TREE_FILL_EVEN_ODD => FillRule::EvenOdd,
            other => return Err(Failure::not_one_of("midline.rule", other, "TREE_FILL_")),
        };
        Ok(MidlineParams { spur: self.spur, rule })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_midline_params_init(
    params: *mut tree_midline_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// The middle lines of a filled area.
pub struct tree_midlines {
    lines: tree_strokes,
    half_widths: Vec<f32>,
}

impl Handle for tree_midlines {
    const NAME: &'static str = "tree_midlines";
}

/// Finds the middle lines of a filled area with these closed contours, which may cross: the main line first, then those
/// that leave it, the strongest first. A side line begins at a point of the line that bears it. Points that are not finite
/// are left out; what has no area has no lines. `params` and `control` may be NULL; `nodes` of the limits caps the
/// points. Free the lines with `tree_midlines_free`. `tree_drawing_clean` does this for strokes that are `filled`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_midlines_of(
    columns: *const tree_strokes_columns,
    params: *const tree_midline_params,
    control: *const tree_control,
    midlines: *mut *mut tree_midlines,
) -> tree_status {
    call(|| {
        let place = unsafe { out(midlines, "midlines") }?;
        let contours = unsafe { strokes(columns, &limits(control)?, "columns") }?;
        let params = unsafe { read_or_default(params, "params") }?.rust()?;
        params.validate()?;
        let found = unsafe { run(control, |_| Ok(midlines_of(&contours, &params))) }?;
        let half_widths = found.iter().flat_map(|line| line.half_widths.iter().copied()).collect();
        let lines = tree_strokes::new(found.into_iter().map(|line| line.points).collect());
        place.put(tree_midlines { lines, half_widths });
        Ok(())
    })
}

/// Views middle lines, in the units of the contours. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_midlines_view(
    midlines: *const tree_midlines,
    columns: *mut tree_strokes_columns,
) -> tree_status {
    call(|| {
        let lines = &unsafe { get(midlines, "midlines") }?.lines;
        unsafe { write(columns, "columns", &lines.columns()) }
    })
}

/// Views half the area's width at every point of `tree_midlines_view`: where the numbers begin and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_midlines_half_widths(
    midlines: *const tree_midlines,
    half_widths: *mut *const f32,
    n_points: *mut usize,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(midlines, "midlines") }?.half_widths;
        unsafe { crate::border::out_value(half_widths, column(found), "half_widths") }?;
        unsafe { crate::border::out_value(n_points, found.len(), "n_points") }
    })
}

/// Frees middle lines.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_midlines_free(midlines: *mut tree_midlines) -> tree_status {
    call(|| unsafe { free(midlines, "midlines") })
}
