//! Plans: the branches of a cleaned drawing.

use super::clean::tree_clean_repair;
use super::{answers, fill_some, spots};
use crate::border::{
    Handle, Versioned, call, free, get, out, out_value, read, slice, tree_status, vec2s, write,
};
use crate::control::{limits, tree_control};
use crate::mesh::column;
use crate::photo::{tree_lines, tree_strokes, tree_strokes_columns};
use glam::Vec2;
use tree_model::sketch::Plan;
use tree_model::sketch::clean::{CleanReport, Cleaned};
use tree_model::tree_core::Resource;

/// A cleaned drawing: its branches as one tree in the plane, the lines of its crown, and what was done to its
/// strokes.
pub struct tree_plan {
    cleaned: Cleaned,
    crown: tree_strokes,
    repairs: Vec<tree_clean_repair>,
}

impl Handle for tree_plan {
    const NAME: &'static str = "tree_plan";
}

impl tree_plan {
    pub(crate) fn new(cleaned: Cleaned) -> Self {
        let crown = tree_strokes::new(cleaned.crown.clone());
        let repairs = cleaned.report.repairs.iter().map(tree_clean_repair::of).collect();
        Self { cleaned, crown, repairs }
    }

    /// A plan that was not drawn.
    fn bare(plan: Plan) -> Self {
        let report = CleanReport::default();
        Self::new(Cleaned { plan, crown: Vec::new(), crown_strokes: Vec::new(), report })
    }

    pub(crate) fn rust(&self) -> &Plan {
        &self.cleaned.plan
    }

    /// The lines of the crown, in metres.
    pub(crate) fn crown(&self) -> &[Vec<Vec2>] {
        &self.cleaned.crown
    }
}

/// The columns of a plan: as input, or as a view of a `tree_plan`. Set `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_plan_columns {
    /// `sizeof(tree_plan_columns)`.
    pub struct_size: usize,
    /// Number of nodes, at least 1. Node 0 is the base.
    pub n_nodes: usize,
    /// Two floats for each node, in metres: x to the right, y up, the base at the origin.
    pub positions: *const f32,
    /// Parent of each node, which comes before it; `TREE_NO_PARENT` for node 0.
    pub parents: *const u32,
    /// The drawing's stroke that each node lies on. Where two meet, the node belongs to the one that bears the
    /// other.
    pub strokes: *const u32,
    /// Where the base is in the drawing.
    pub base: [f32; 2],
    /// Metres for one unit of the drawing, above 0.
    pub scale: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_plan_columns {
    const NAME: &'static str = "tree_plan_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_nodes: 0,
            positions: std::ptr::null(),
            parents: std::ptr::null(),
            strokes: std::ptr::null(),
            base: [0.0; 2],
            scale: 1.0,
            reserved: 0,
        }
    }
}

/// Makes a plan of columns, which are copied: without crown and without repairs. `control` may be NULL; `nodes`
/// of its limits counts. Free the plan with `tree_plan_free`. `TREE_ERROR_INVALID` where a number is not finite,
/// or a parent does not come before its node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plan_from_columns(
    columns: *const tree_plan_columns,
    control: *const tree_control,
    plan: *mut *mut tree_plan,
) -> tree_status {
    call(|| {
        let place = unsafe { out(plan, "plan") }?;
        let columns = unsafe { read(columns, "columns") }?;
        let limits = unsafe { limits(control) }?;
        let (n, nodes) = (columns.n_nodes, Resource::Nodes);
        let positions = unsafe { vec2s(columns.positions, n, &limits, nodes, "columns.positions") };
        let parents = unsafe { slice(columns.parents, n, &limits, nodes, "columns.parents") };
        let strokes = unsafe { slice(columns.strokes, n, &limits, nodes, "columns.strokes") };
        let (positions, parents, strokes) = (positions?.to_vec(), parents?.to_vec(), strokes?);
        let base = Vec2::from_array(columns.base);
        let made = Plan::from_columns(positions, parents, strokes.to_vec(), base, columns.scale)?;
        place.put(tree_plan::bare(made));
        Ok(())
    })
}

/// Views the columns of a plan. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plan_view(
    plan: *const tree_plan,
    columns: *mut tree_plan_columns,
) -> tree_status {
    call(|| {
        let plan = unsafe { get(plan, "plan") }?.rust();
        let found = tree_plan_columns {
            n_nodes: plan.len(),
            positions: column(plan.positions()).cast(),
            parents: column(plan.parents()),
            strokes: column(plan.strokes()),
            base: plan.base.to_array(),
            scale: plan.scale,
            ..tree_plan_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// Views the lines of the drawn crown in metres of the plan, as drawn and not yet closed; a closed one ends where it
/// begins. There may be none. Set `columns->struct_size` first. `tree_crown_close` takes them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plan_crown(
    plan: *const tree_plan,
    columns: *mut tree_strokes_columns,
) -> tree_status {
    call(|| {
        let crown = &unsafe { get(plan, "plan") }?.crown;
        unsafe { write(columns, "columns", &crown.columns()) }
    })
}

/// Views the drawing's stroke of each line of the crown: where the numbers begin and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plan_crown_strokes(
    plan: *const tree_plan,
    strokes: *mut *const u32,
    n_strokes: *mut usize,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(plan, "plan") }?.cleaned.crown_strokes;
        unsafe { out_value(strokes, column(found), "strokes") }?;
        unsafe { out_value(n_strokes, found.len(), "n_strokes") }
    })
}

/// Views what cleaning did to the drawing, in that order: where the repairs begin and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plan_repairs(
    plan: *const tree_plan,
    repairs: *mut *const tree_clean_repair,
    n_repairs: *mut usize,
) -> tree_status {
    call(|| {
        let found = &unsafe { get(plan, "plan") }?.repairs;
        unsafe { out_value(repairs, column(found), "repairs") }?;
        unsafe { out_value(n_repairs, found.len(), "n_repairs") }
    })
}

/// A sentence for each repair, which names the stroke. Free the lines with `tree_lines_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plan_repairs_text(
    plan: *const tree_plan,
    lines: *mut *mut tree_lines,
) -> tree_status {
    call(|| {
        let place = unsafe { out(lines, "lines") }?;
        let repairs = &unsafe { get(plan, "plan") }?.cleaned.report.repairs;
        place.put(tree_lines::new(repairs.iter().map(ToString::to_string).collect()));
        Ok(())
    })
}

/// The same plan, its crown with it, `factor` times as large in metres. Free it with `tree_plan_free`.
/// `TREE_ERROR_INVALID` where the factor is not above 0 or coordinates become infinite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plan_scaled(
    plan: *const tree_plan,
    factor: f32,
    scaled: *mut *mut tree_plan,
) -> tree_status {
    call(|| {
        let place = unsafe { out(scaled, "scaled") }?;
        let mut cleaned = unsafe { get(plan, "plan") }?.cleaned.clone();
        cleaned.plan = cleaned.plan.scaled(factor)?;
        cleaned.crown.iter_mut().flatten().for_each(|point| *point *= factor);
        place.put(tree_plan::new(cleaned));
        Ok(())
    })
}

/// Where points of the plan lie in the drawing: `spots` are `n_spots` times two floats in metres, `drawn` gets as many
/// in units of the drawing; `capacity` is its room in floats. `control` may be NULL; `nodes` of its limits caps the
/// points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plan_points_to_drawing(
    plan: *const tree_plan,
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    drawn: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let plan = unsafe { get(plan, "plan") }?.rust();
        let spots = unsafe { self::spots(spots, n_spots, control) }?;
        let found = unsafe { answers(spots, control, |&spot| plan.to_drawing(spot).to_array()) }?;
        unsafe { fill_some(drawn, capacity, found.as_flattened(), "drawn") }
    })
}

/// Where points of the drawing lie in the plan: as `tree_plan_points_to_drawing`, the other way. `planned` gets
/// the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plan_points_from_drawing(
    plan: *const tree_plan,
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    planned: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let plan = unsafe { get(plan, "plan") }?.rust();
        let spots = unsafe { self::spots(spots, n_spots, control) }?;
        let found = unsafe { answers(spots, control, |&spot| plan.from_drawing(spot).to_array()) }?;
        unsafe { fill_some(planned, capacity, found.as_flattened(), "planned") }
    })
}

/// Frees a plan. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plan_free(plan: *mut tree_plan) -> tree_status {
    call(|| unsafe { free(plan, "plan") })
}
