//! Outlines: closed polygons of the plane.

use crate::border::{
    Failure, Handle, TREE_ERROR_NO_RESULT, Versioned, call, floats, free, get, init, out,
    out_value, read, read_or_default, tree_status, vec2s, write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use crate::photo::tree_lines;
use crate::sketch::spots;
use glam::Affine2;
use std::ffi::c_char;
use std::sync::Arc;
use tree_model::silhouette::{Outline, OutlineParams, OutlineRepair};
use tree_model::tree_core::Resource;

/// How a drawn stroke becomes an outline. Begin with `tree_outline_close_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_outline_close_params {
    /// `sizeof(tree_outline_close_params)`.
    pub struct_size: usize,
    /// Ends closer than this share of the stroke's length count as closed by hand; wider gaps are noted as such, 0 to
    /// 1. Default 0.15.
    pub gap: f32,
    /// Most corners of an outline, 8 to 4096; those that change its shape least are left out. Default 2000.
    pub corners: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_outline_close_params {
    const NAME: &'static str = "tree_outline_close_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&OutlineParams::default())
    }
}

impl tree_outline_close_params {
    pub(crate) fn of(params: &OutlineParams) -> Self {
        let OutlineParams { gap, corners } = *params;
        Self { struct_size: size_of::<Self>(), gap, corners }
    }

    pub(crate) fn rust(&self) -> OutlineParams {
        OutlineParams { gap: self.gap, corners: self.corners }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_close_params_init(
    params: *mut tree_outline_close_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_close_params_check(
    params: *const tree_outline_close_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// What was repaired or noticed of a stroke that became an outline: a `TREE_OUTLINE_` constant. New ones may be added.
pub type tree_outline_repair_kind = u32;

/// `count` points were not finite or absurdly far away, and were left out.
pub const TREE_OUTLINE_POINTS_DROPPED: u32 = 0;
/// `count` points repeated at once were left out.
pub const TREE_OUTLINE_DUPLICATES_DROPPED: u32 = 1;
/// Of `count` points `after` were kept.
pub const TREE_OUTLINE_THINNED: u32 = 2;
/// It was open, with close ends, and was closed straight over `gap` metres.
pub const TREE_OUTLINE_CLOSED: u32 = 3;
/// It was wide open, by `gap` metres, a `share` of its length, and was closed straight.
pub const TREE_OUTLINE_WIDE_GAP_CLOSED: u32 = 4;
/// It ran out and straight back at `count` corners, which were left out.
pub const TREE_OUTLINE_SPIKES_DROPPED: u32 = 5;
/// It crossed or touched itself; what it winds round was kept.
pub const TREE_OUTLINE_CROSSING_UNDONE: u32 = 6;
/// Of what it winds round only the largest part was kept: `count` others, a `share` of the area, were left out.
pub const TREE_OUTLINE_PARTS_DROPPED: u32 = 7;
/// It ran with the clock and was turned.
pub const TREE_OUTLINE_TURNED: u32 = 8;
/// Something else: `tree_outline_repairs_text` says what.
pub const TREE_OUTLINE_OTHER: u32 = 9;

/// One thing that was repaired or noticed of a stroke. Fields that its kind does not name are 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_outline_repair {
    /// What it was.
    pub kind: tree_outline_repair_kind,
    /// How many there were.
    pub count: u32,
    /// How many there are now.
    pub after: u32,
    /// A length in metres.
    pub gap: f32,
    /// A share, 0 to 1.
    pub share: f32,
}

impl tree_outline_repair {
    fn of(repair: &OutlineRepair) -> Self {
        use OutlineRepair as R;
        let plain = |kind| Self { kind, ..Self::default() };
        let many = |kind, count: usize| Self { count: count as u32, ..plain(kind) };
        match *repair {
            R::PointsDropped { count } => many(TREE_OUTLINE_POINTS_DROPPED, count),
            R::DuplicatesDropped { count } => many(TREE_OUTLINE_DUPLICATES_DROPPED, count),
            R::Thinned { before, after } => {
                Self { after: after as u32, ..many(TREE_OUTLINE_THINNED, before) }
            }
            R::Closed { gap } => Self { gap, ..plain(TREE_OUTLINE_CLOSED) },
            R::WideGapClosed { gap, share } => {
                Self { gap, share, ..plain(TREE_OUTLINE_WIDE_GAP_CLOSED) }
            }
            R::SpikesDropped { count } => many(TREE_OUTLINE_SPIKES_DROPPED, count),
            R::CrossingUndone => plain(TREE_OUTLINE_CROSSING_UNDONE),
            R::PartsDropped { count, share } => {
                Self { share, ..many(TREE_OUTLINE_PARTS_DROPPED, count) }
            }
            R::Turned => plain(TREE_OUTLINE_TURNED),
            _ => plain(TREE_OUTLINE_OTHER),
        }
    }
}

/// A closed outline in metres, x to the right, y up: a polygon without crossings, against the clock.
pub struct tree_outline {
    outline: Arc<Outline>,
    found: Vec<OutlineRepair>,
    repairs: Vec<tree_outline_repair>,
}

impl Handle for tree_outline {
    const NAME: &'static str = "tree_outline";
}

impl tree_outline {
    pub(crate) fn new(outline: Outline) -> Self {
        Self::repaired(outline, Vec::new())
    }

    pub(crate) fn repaired(outline: Outline, found: Vec<OutlineRepair>) -> Self {
        let repairs = found.iter().map(tree_outline_repair::of).collect();
        Self { outline: Arc::new(outline), found, repairs }
    }

    pub(crate) fn rust(&self) -> &Outline {
        &self.outline
    }
}

/// Makes an outline of a drawn stroke of `n_points` points, two floats each, in metres, y up: it is closed, made simple and
/// turned against the clock. `tree_outline_repairs` tells what was done. `name`, of `name_len` bytes or
/// `TREE_NUL_TERMINATED`, is what messages call the stroke; NULL for none. `params` and `control` may be NULL; `nodes` of the
/// limits caps the points. Free the outline with `tree_outline_free`. `TREE_ERROR_INVALID` where fewer than three different
/// points are left, or it encloses next to nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_close(
    stroke: *const f32,
    n_points: usize,
    name: *const c_char,
    name_len: usize,
    params: *const tree_outline_close_params,
    control: *const tree_control,
    outline: *mut *mut tree_outline,
) -> tree_status {
    call(|| {
        let place = unsafe { out(outline, "outline") }?;
        let limits = unsafe { limits(control) }?;
        let stroke = unsafe { vec2s(stroke, n_points, &limits, Resource::Nodes, "stroke") }?;
        let name = if name.is_null() {
            ""
        } else {
            unsafe { crate::border::text(name, name_len, "name") }?
        };
        let name = if name.is_empty() { "stroke" } else { name };
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body = |_: &_| Ok(Outline::close(stroke, name, &params)?);
        let (made, repairs) = unsafe { run(control, body) }?;
        place.put(tree_outline::repaired(made, repairs));
        Ok(())
    })
}

/// Makes an outline of points that already are one, two floats each: closed (the first is not repeated at the end), against
/// the clock, without crossings, in metres, at most 4096. Nothing is repaired. `control` may be NULL; only its limits
/// matter. Free the outline with `tree_outline_free`. `TREE_ERROR_INVALID` says what is wrong and at which point.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_from_points(
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    outline: *mut *mut tree_outline,
) -> tree_status {
    call(|| {
        let place = unsafe { out(outline, "outline") }?;
        let spots = unsafe { self::spots(spots, n_spots, control) }?;
        place.put(tree_outline::new(Outline::from_points(spots.to_vec())?));
        Ok(())
    })
}

/// A view of an outline.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_outline_columns {
    /// `sizeof(tree_outline_columns)`.
    pub struct_size: usize,
    /// Number of corners, three at least.
    pub n_points: usize,
    /// Two floats for each corner, against the clock. The last is joined to the first.
    pub points: *const f32,
    /// Lowest coordinates in metres.
    pub low: [f32; 2],
    /// Highest coordinates in metres.
    pub high: [f32; 2],
    /// Area in square metres.
    pub area: f32,
    /// Length round in metres.
    pub perimeter: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_outline_columns {
    const NAME: &'static str = "tree_outline_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_points: 0,
            points: std::ptr::null(),
            low: [0.0; 2],
            high: [0.0; 2],
            area: 0.0,
            perimeter: 0.0,
        }
    }
}

/// Views an outline's corners and tells how large it is. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_view(
    outline: *const tree_outline,
    columns: *mut tree_outline_columns,
) -> tree_status {
    call(|| {
        let outline = unsafe { get(outline, "outline") }?.rust();
        let (low, high) = outline.bounds();
        let found = tree_outline_columns {
            n_points: outline.points().len(),
            points: column(outline.points()).cast(),
            low: low.to_array(),
            high: high.to_array(),
            area: outline.area(),
            perimeter: outline.perimeter(),
            ..tree_outline_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// Views what was repaired or noticed by `tree_outline_close`, in that order: where the repairs begin and how many there are.
/// None for other outlines.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_repairs(
    outline: *const tree_outline,
    repairs: *mut *const tree_outline_repair,
    n_repairs: *mut usize,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(outline, "outline") }?.repairs;
        unsafe { out_value(repairs, column(found), "repairs") }?;
        unsafe { out_value(n_repairs, found.len(), "n_repairs") }
    })
}

/// A sentence for each repair. Free the lines with `tree_lines_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_repairs_text(
    outline: *const tree_outline,
    lines: *mut *mut tree_lines,
) -> tree_status {
    call(|| {
        let place = unsafe { out(lines, "lines") }?;
        let repairs = &unsafe { get(outline, "outline") }?.found;
        place.put(tree_lines::new(repairs.iter().map(ToString::to_string).collect()));
        Ok(())
    })
}

/// The same outline by `n_points` corners at even lengths from the first on, at least 3 and at most 4096. Where so few
/// would make it cross itself, or so many are not allowed, it stays as it is. Free it with `tree_outline_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_resampled(
    outline: *const tree_outline,
    n_points: u32,
    control: *const tree_control,
    resampled: *mut *mut tree_outline,
) -> tree_status {
    call(|| {
        let place = unsafe { out(resampled, "resampled") }?;
        let outline = unsafe { get(outline, "outline") }?.rust();
        unsafe { limits(control) }?.check(Resource::Nodes, n_points.into())?;
        let body = |_: &_| Ok(outline.resampled(n_points as usize));
        place.put(tree_outline::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// The outline with every corner moved by an affine map, turned against the clock where that mirrors it. `affine` is six
/// floats, a, b, c, d, e, f, as in SVG's matrices: x becomes a·x + c·y + e, y becomes b·x + d·y + f. Free the outline with
/// `tree_outline_free`. `TREE_ERROR_NO_RESULT` where nothing is enclosed then.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_transformed(
    outline: *const tree_outline,
    affine: *const f32,
    transformed: *mut *mut tree_outline,
) -> tree_status {
    call(|| {
        let place = unsafe { out(transformed, "transformed") }?;
        let outline = unsafe { get(outline, "outline") }?.rust();
        let map = Affine2::from_cols_array(&unsafe { floats(affine, "affine") }?);
        let Some(made) = outline.transformed(|point| map.transform_point2(point)) else {
            let text = "the map leaves nothing that encloses an area";
            return Err(Failure::new(TREE_ERROR_NO_RESULT, text));
        };
        place.put(tree_outline::new(made));
        Ok(())
    })
}

/// Frees an outline. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_free(outline: *mut tree_outline) -> tree_status {
    call(|| unsafe { free(outline, "outline") })
}
