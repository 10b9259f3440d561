//! Plans: the branches of a cleaned drawing.

use super::clean::tree_clean_repair;
use crate::border::{
    Handle, Result, TREE_ERROR_INVALID, Versioned, call, fill, free, get, out, out_value, read,
    slice, tree_status, vec2s, write,
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

/// Frees a plan. What was made of it lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_plan_free(plan: *mut tree_plan) -> tree_status {
    call(|| unsafe { free(plan, "plan") })
}
