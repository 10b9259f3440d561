//! What particles leave behind.

use super::params::{tree_flow_params, tree_flow_report};
use super::way::{flow_views, tree_flow_view, tree_way};
use crate::border::{
    Handle, Versioned, call, foresee, free, get, out, read_or_default, tree_status, vec3s, view,
    write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use crate::skeleton::tree_skeleton;
use tree_model::particle::flow::{Forces, Traces, run as let_flow};
use tree_model::tree_core::Resource;

/// What particles left behind: traces that join on their way to the base.
pub struct tree_traces(Traces);

impl Handle for tree_traces {
    const NAME: &'static str = "tree_traces";
}

impl tree_traces {
    pub(crate) fn new(traces: Traces) -> Self {
        Self(traces)
    }

    pub(crate) fn rust(&self) -> &Traces {
        &self.0
    }
}

/// A view of traces. Nodes are in the order in which they were left behind; node 0 is the base.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_traces_columns {
    /// `sizeof(tree_traces_columns)`.
    pub struct_size: usize,
    /// Number of nodes, at least 1.
    pub n_nodes: usize,
    /// Three floats for each node: where it is, in metres.
    pub positions: *const f32,
    /// For each node the one it leads to, on the way to the base; `TREE_NO_PARENT` at the base.
    pub next: *const u32,
    /// For each node the number of particles whose way led through it.
    pub masses: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_traces_columns {
    const NAME: &'static str = "tree_traces_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_nodes: 0,
            positions: std::ptr::null(),
            next: std::ptr::null(),
            masses: std::ptr::null(),
        }
    }
}

/// Lets particles flow from `n_starts` points, three floats each in metres, to the base, along `way` and the
/// fields of `n_views` views (none will do). `height` is the tree's in metres, 1e-3 to 1e5. `params`,
/// `control` and `report` may be NULL; `particles` of the params does not count. The same starts give the same
/// bits for any number of threads. Free the traces with `tree_traces_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_traces_flow(
    way: *const tree_way,
    views: *const tree_flow_view,
    n_views: usize,
    starts: *const f32,
    n_starts: usize,
    height: f32,
    params: *const tree_flow_params,
    control: *const tree_control,
    report: *mut tree_flow_report,
    traces: *mut *mut tree_traces,
) -> tree_status {
    call(|| {
        let place = unsafe { out(traces, "traces") }?;
        unsafe { foresee(report, "report") }?;
        let way = unsafe { get(way, "way") }?.rust();
        let views = unsafe { flow_views(views, n_views) }?;
        let limits = unsafe { limits(control) }?;
        let starts = unsafe { vec3s(starts, n_starts, &limits, Resource::Nodes, "starts") }?;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        params.validate()?;
        let forces = Forces::new(&views, way, &params);
        let body = |control: &_| Ok(let_flow(starts, height, &forces, &params, control)?);
        let flow = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_flow_report::of(&flow.report)) }?;
        place.put(tree_traces(flow.traces));
        Ok(())
    })
}

/// Views traces. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_traces_view(
    traces: *const tree_traces,
    columns: *mut tree_traces_columns,
) -> tree_status {
    call(|| {
        let traces = unsafe { get(traces, "traces") }?.rust();
        let value = tree_traces_columns {
            n_nodes: traces.positions().len(),
            positions: column(traces.positions()).cast(),
            next: column(traces.next()),
            masses: column(traces.masses()),
            ..tree_traces_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// Traces as a skeleton, from the base to where the particles started, with radii of 0. Free it with
/// `tree_skeleton_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_traces_skeleton(
    traces: *const tree_traces,
    control: *const tree_control,
    skeleton: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(skeleton, "skeleton") }?;
        let traces = unsafe { get(traces, "traces") }?.rust();
        let body = |control: &_| Ok(traces.skeleton(control)?);
        place.put(tree_skeleton::own(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Frees traces.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_traces_free(traces: *mut tree_traces) -> tree_status {
    call(|| unsafe { free(traces, "traces") })
}
