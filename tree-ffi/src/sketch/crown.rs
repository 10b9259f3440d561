//! Crowns: what was drawn as a crown becomes closed polygons and a solid.

use super::{answers, fill_some, spots};
use crate::border::{
    Handle, Versioned, call, foresee, free, get, init, out, out_value, read, read_or_default,
    tree_status, vec3s, write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use crate::photo::{strokes, tree_lines, tree_strokes, tree_strokes_columns};
use glam::Vec3;
use std::sync::Arc;
use tree_model::sketch::crown::{
    Crown, CrownParams, CrownRepair, CrownReport, OutlineParams, outline_of,
};
use tree_model::tree_core::Resource;

/// How a drawn crown is understood. Begin with `tree_crown_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_crown_params {
    /// `sizeof(tree_crown_params)`.
    pub struct_size: usize,
    /// A stroke whose ends are closer than this share of its length is a loop of its own, 0 to 1. Default 0.15.
    pub gap: f32,
    /// Ends of strokes closer than this share of the crown's size are joined, 0 to 1. Default 0.05.
    pub join: f32,
    /// Depth of the crown, along the view, over its width, 0.05 to 20. Default 1: circles.
    pub depth: f32,
    /// Whether a crown that no branch touches is an error. Default no: it is kept and reported.
    pub refuse: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_crown_params {
    const NAME: &'static str = "tree_crown_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&CrownParams::default())
    }
}

impl tree_crown_params {
    pub(crate) fn of(params: &CrownParams) -> Self {
        let CrownParams { gap, join, depth, refuse } = *params;
        Self { struct_size: size_of::<Self>(), gap, join, depth, refuse: refuse.into() }
    }

    pub(crate) fn rust(&self) -> CrownParams {
        CrownParams { gap: self.gap, join: self.join, depth: self.depth, refuse: self.refuse != 0 }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_params_init(
    params: *mut tree_crown_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_params_check(params: *const tree_crown_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust().validate()?))
}

/// What was repaired or noticed of a drawn crown: a `TREE_CROWN_` constant. New ones may be added.
pub type tree_crown_repair_kind = u32;

/// Of stroke `stroke`, `count` points were not finite or absurdly far away, and were left out.
pub const TREE_CROWN_POINTS_DROPPED: u32 = 0;
/// Stroke `stroke` has no length, and was left out.
pub const TREE_CROWN_STROKE_DROPPED: u32 = 1;
/// Stroke `stroke` is open and lies inside a closed one: it is a detail, and was left out.
pub const TREE_CROWN_DETAIL_DROPPED: u32 = 2;
/// Stroke `stroke`, or several joined ones of which it is the first, was closed straight over `gap` metres.
pub const TREE_CROWN_CLOSED: u32 = 3;
/// Strokes were joined at `count` places where their ends were close.
pub const TREE_CROWN_JOINED: u32 = 4;
/// A wide gap of `gap` metres between ends was closed; `round_branches` says whether round branches in it.
pub const TREE_CROWN_GAP_CLOSED: u32 = 5;
/// Loop `stroke`, in the order they were closed, crossed itself; what it winds round was kept.
pub const TREE_CROWN_CROSSING_UNDONE: u32 = 6;
/// `count` loops that overlap were united, and `after` polygons are left of them.
pub const TREE_CROWN_UNITED: u32 = 7;
/// `count` loops inside others are details, and were left out.
pub const TREE_CROWN_NESTED_DROPPED: u32 = 8;
/// `count` tiny parts were left out.
pub const TREE_CROWN_CRUMBS_DROPPED: u32 = 9;
/// A `share` of the branches' points lies outside.
pub const TREE_CROWN_BRANCHES_OUTSIDE: u32 = 10;
/// No branch touches the crown.
pub const TREE_CROWN_NO_BRANCH_INSIDE: u32 = 11;
/// Something else: `tree_crown_repairs_text` says what.
pub const TREE_CROWN_OTHER: u32 = 12;

/// One thing that was repaired or noticed of a drawn crown. Fields that its kind does not name are 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_crown_repair {
    /// What it was.
    pub kind: tree_crown_repair_kind,
    /// Number of a stroke of the crown, or of a loop.
    pub stroke: u32,
    /// How many there were.
    pub count: u32,
    /// How many there are now.
    pub after: u32,
    /// A length in metres.
    pub gap: f32,
    /// A share, 0 to 1.
    pub share: f32,
    /// 1 or 0.
    pub round_branches: u32,
}

impl tree_crown_repair {
    fn of(repair: &CrownRepair) -> Self {
        use CrownRepair as R;
        let plain = |kind| Self { kind, ..Self::default() };
        let of = |kind, stroke: usize| Self { stroke: stroke as u32, ..plain(kind) };
        let many = |kind, count: usize| Self { count: count as u32, ..plain(kind) };
        match *repair {
            R::PointsDropped { stroke, count } => {
                Self { stroke: stroke as u32, ..many(TREE_CROWN_POINTS_DROPPED, count) }
            }
            R::StrokeDropped { stroke } => of(TREE_CROWN_STROKE_DROPPED, stroke),
            R::DetailDropped { stroke } => of(TREE_CROWN_DETAIL_DROPPED, stroke),
            R::Closed { stroke, gap } => Self { gap, ..of(TREE_CROWN_CLOSED, stroke) },
            R::Joined { count } => many(TREE_CROWN_JOINED, count),
            R::GapClosed { gap, round_branches } => {
                let round_branches = round_branches.into();
                Self { gap, round_branches, ..plain(TREE_CROWN_GAP_CLOSED) }
            }
            R::CrossingUndone { part } => of(TREE_CROWN_CROSSING_UNDONE, part),
            R::United { before, after } => {
                Self { after: after as u32, ..many(TREE_CROWN_UNITED, before) }
            }
            R::NestedDropped { count } => many(TREE_CROWN_NESTED_DROPPED, count),
            R::CrumbsDropped { count } => many(TREE_CROWN_CRUMBS_DROPPED, count),
            R::BranchesOutside { share } => Self { share, ..plain(TREE_CROWN_BRANCHES_OUTSIDE) },
            R::NoBranchInside => plain(TREE_CROWN_NO_BRANCH_INSIDE),
            _ => plain(TREE_CROWN_OTHER),
        }
    }
}

/// A crown: polygons in the plan, and the solid they stand for. At every height each stretch of the inside is swept to
/// a circle (or an ellipse, by the depth) about its own middle.
pub struct tree_crown {
    crown: Arc<Crown>,
    polygons: tree_strokes,
    report: CrownReport,
    repairs: Vec<tree_crown_repair>,
}

impl Handle for tree_crown {
    const NAME: &'static str = "tree_crown";
}

impl tree_crown {
    pub(crate) fn new(crown: Crown, report: CrownReport) -> Self {
        let polygons = tree_strokes::new(crown.polygons().to_vec());
        let repairs = report.repairs.iter().map(tree_crown_repair::of).collect();
        Self { crown: Arc::new(crown), polygons, report, repairs }
    }

    pub(crate) fn rust(&self) -> &Crown {
        &self.crown
    }
}

/// Makes a crown of what was drawn: `columns` are lines in metres of the plan (x to the right, y up) such as those of
/// `tree_plan_crown`. Ends that lie close are joined, wide gaps closed round the branches in them, and loops that cross
/// are united. `spots` are `n_spots` points of the branches, two floats each, best without those below the first fork;
/// there may be none. `params` and `control` may be NULL; `nodes` of the limits caps the points. Free the crown with
/// `tree_crown_free`. `TREE_ERROR_INVALID` where nothing drawn encloses an area, or no branch touches the crown and
/// `refuse` says so.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_close(
    columns: *const tree_strokes_columns,
    spots: *const f32,
    n_spots: usize,
    params: *const tree_crown_params,
    control: *const tree_control,
    crown: *mut *mut tree_crown,
) -> tree_status {
    call(|| {
        let place = unsafe { out(crown, "crown") }?;
        let lines = unsafe { strokes(columns, &limits(control)?, "columns") }?;
        let spots = unsafe { self::spots(spots, n_spots, control) }?;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body = |control: &_| Ok(Crown::close(&lines, spots, &params, control)?);
        let (made, report) = unsafe { run(control, body) }?;
        place.put(tree_crown::new(made, report));
        Ok(())
    })
}

/// Makes a crown of closed polygons, in metres of the plan. They are made simple and united as drawn ones are; points
/// that are not finite are left out. `depth` is the crown's depth over its width, 0.05 to 20, 1 for circles. `control` may
/// be NULL; `nodes` of the limits caps the points. Free the crown with `tree_crown_free`. `TREE_ERROR_INVALID` where they
/// enclose no area.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_from_polygons(
    columns: *const tree_strokes_columns,
    depth: f32,
    control: *const tree_control,
    crown: *mut *mut tree_crown,
) -> tree_status {
    call(|| {
        let place = unsafe { out(crown, "crown") }?;
        let polygons = unsafe { strokes(columns, &limits(control)?, "columns") }?;
        let made = unsafe { run(control, |_| Ok(Crown::from_polygons(&polygons, depth)?)) }?;
        place.put(tree_crown::new(made, CrownReport::default()));
        Ok(())
    })
}

/// Views the polygons in metres of the plan: simple, apart from each other, against the clock, the largest first.
/// Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_polygons(
    crown: *const tree_crown,
    columns: *mut tree_strokes_columns,
) -> tree_status {
    call(|| {
        let polygons = &unsafe { get(crown, "crown") }?.polygons;
        unsafe { write(columns, "columns", &polygons.columns()) }
    })
}

/// How large a crown is.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_crown_measures {
    /// `sizeof(tree_crown_measures)`.
    pub struct_size: usize,
    /// Lowest coordinates of the polygons in metres.
    pub low: [f32; 2],
    /// Highest coordinates of the polygons in metres.
    pub high: [f32; 2],
    /// Area of the polygons in square metres.
    pub area: f32,
    /// Volume of the solid in cubic metres.
    pub volume: f32,
    /// Share of the branches' points that lay outside when it was closed, 0 to 1.
    pub outside: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_crown_measures {
    const NAME: &'static str = "tree_crown_measures";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            low: [0.0; 2],
            high: [0.0; 2],
            area: 0.0,
            volume: 0.0,
            outside: 0.0,
            reserved: 0,
        }
    }
}

/// Tells how large a crown is. Set `measures->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_measure(
    crown: *const tree_crown,
    measures: *mut tree_crown_measures,
) -> tree_status {
    call(|| {
        unsafe { foresee(measures, "measures") }?;
        let held = unsafe { get(crown, "crown") }?;
        let (low, high) = held.rust().bounds();
        let found = tree_crown_measures {
            low: low.to_array(),
            high: high.to_array(),
            area: held.rust().area(),
            volume: held.rust().volume(),
            outside: held.report.outside,
            ..tree_crown_measures::default_value()
        };
        unsafe { write(measures, "measures", &found) }
    })
}

/// Views what was repaired or noticed when the crown was closed, in that order: where the repairs begin and how many
/// there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_repairs(
    crown: *const tree_crown,
    repairs: *mut *const tree_crown_repair,
    n_repairs: *mut usize,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(crown, "crown") }?.repairs;
        unsafe { out_value(repairs, column(found), "repairs") }?;
        unsafe { out_value(n_repairs, found.len(), "n_repairs") }
    })
}

/// A sentence for each repair. Free the lines with `tree_lines_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_repairs_text(
    crown: *const tree_crown,
    lines: *mut *mut tree_lines,
) -> tree_status {
    call(|| {
        let place = unsafe { out(lines, "lines") }?;
        let repairs = &unsafe { get(crown, "crown") }?.report.repairs;
        place.put(tree_lines::new(repairs.iter().map(ToString::to_string).collect()));
        Ok(())
    })
}

/// Says of `n_spots` points of the plan, two floats each, whether they lie in the crown: 1 or 0 into `inside`, which
/// has room for `capacity`. `control` may be NULL; `nodes` of its limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_contains(
    crown: *const tree_crown,
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    inside: *mut u8,
    capacity: usize,
) -> tree_status {
    call(|| {
        let crown = unsafe { get(crown, "crown") }?.rust();
        let spots = unsafe { self::spots(spots, n_spots, control) }?;
        let found = unsafe { answers(spots, control, |&spot| u8::from(crown.contains(spot))) }?;
        unsafe { fill_some(inside, capacity, &found, "inside") }
    })
}

/// Says of `n_points` points, three floats each, how near the solid's surface they are, into `levels`, which has room
/// for `capacity`: 0 on the axis of the stretch they lie in, up to 1 inside, above 1 outside; infinite where the crown
/// has nothing at that height. The plan lies at z = 0. `control` as for `tree_crown_contains`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_levels(
    crown: *const tree_crown,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    levels: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let crown = unsafe { get(crown, "crown") }?.rust();
        let nodes = Resource::Nodes;
        let points = unsafe { vec3s(points, n_points, &limits(control)?, nodes, "points") }?;
        let found = unsafe { answers(points, control, |&point| crown.level(point)) }?;
        unsafe { fill_some(levels, capacity, &found, "levels") }
    })
}

/// Where `n_ways` straight ways first leave the solid: each is six floats in `ways`, its beginning and its end. `exits`,
/// which has room for `capacity`, gets a share of each way: 0 where it begins outside, infinite where it stays inside.
/// `control` as for `tree_crown_contains`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_exits(
    crown: *const tree_crown,
    ways: *const f32,
    n_ways: usize,
    control: *const tree_control,
    exits: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let crown = unsafe { get(crown, "crown") }?.rust();
        let ends = n_ways.saturating_mul(2);
        let ends = unsafe { vec3s(ways, ends, &limits(control)?, Resource::Nodes, "ways") }?;
        let (ways, _) = ends.as_chunks::<2>();
        let exit = |&[from, to]: &[Vec3; 2]| crown.exit(from, to).unwrap_or(f32::INFINITY);
        let found = unsafe { answers(ways, control, exit) }?;
        unsafe { fill_some(exits, capacity, &found, "exits") }
    })
}

/// Frees a crown. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_crown_free(crown: *mut tree_crown) -> tree_status {
    call(|| unsafe { free(crown, "crown") })
}

/// How outlines are drawn. Begin with `tree_sketch_outline_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_outline_params {
    /// `sizeof(tree_sketch_outline_params)`.
    pub struct_size: usize,
    /// Bays narrower than twice this share of the size are drawn across, 0.01 to 0.5. Default 0.06.
    pub closing: f32,
    /// Most corners of all outlines together, 12 to 10,000. Default 120.
    pub corners: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_sketch_outline_params {
    const NAME: &'static str = "tree_sketch_outline_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let OutlineParams { closing, corners } = OutlineParams::default();
        Self { struct_size: size_of::<Self>(), closing, corners }
    }
}

impl tree_sketch_outline_params {
    pub(crate) fn rust(&self) -> OutlineParams {
        OutlineParams { closing: self.closing, corners: self.corners }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_outline_params_init(
    params: *mut tree_sketch_outline_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// The outlines of a cloud of `n_spots` points, two floats each, such as a tree's leaves as seen from one side, drawn
/// as a person would: gaps between leaves closed, corners rounded. They are against the clock, the largest first; none
/// for fewer than three points. `params` and `control` may be NULL; `nodes` of the limits caps the points. Free the outlines
/// with `tree_strokes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_strokes_outline(
    spots: *const f32,
    n_spots: usize,
    params: *const tree_sketch_outline_params,
    control: *const tree_control,
    strokes: *mut *mut tree_strokes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(strokes, "strokes") }?;
        let spots = unsafe { self::spots(spots, n_spots, control) }?;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        params.validate()?;
        let found = unsafe { run(control, |_| Ok(outline_of(spots, &params))) }?;
        place.put(tree_strokes::new(found));
        Ok(())
    })
}
