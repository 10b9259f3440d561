//! The factor graph of a sketch, open to be read.

use super::branches::{label, tree_sketch_label};
use super::infer::{tree_sketch_infer_params, tree_sketch_posterior};
use super::omega::{omega, tree_sketch_omega};
use super::tree_plan;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PARAMETER, call, free, get, out, out_value,
    read_or_default, slice, tree_status,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use tree_model::sketch::infer::FactorGraph;
use tree_model::tree_core::{Control, Resource, Seed};

/// The factor graph of a sketch (Neubert 2012, section 4.5.1): what any depths and labels are worth. Segments are
/// numbered generation by generation, as in a `tree_inferred` of the same plan.
pub struct tree_factor_graph(FactorGraph);

impl Handle for tree_factor_graph {
    const NAME: &'static str = "tree_factor_graph";
}

/// Builds the graph that `tree_sketch_infer` with the same arguments and no pins works on. `omega`, `params` and
/// `control` may be NULL. Free it with `tree_factor_graph_free`. `TREE_ERROR_PARAMETER` names what is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_factor_graph_new(
    plan: *const tree_plan,
    omega: *const tree_sketch_omega,
    params: *const tree_sketch_infer_params,
    seed: u64,
    control: *const tree_control,
    graph: *mut *mut tree_factor_graph,
) -> tree_status {
    call(|| {
        let place = unsafe { out(graph, "graph") }?;
        let plan = unsafe { get(plan, "plan") }?.rust();
        let omega = unsafe { self::omega(omega) }?;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body =
            |control: &Control| Ok(FactorGraph::new(plan, &omega, &params, Seed(seed), control)?);
        place.put(tree_factor_graph(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Parent of each segment, `TREE_NO_PARENT` for segment 0: where they begin and how many there are. Valid until
/// `tree_factor_graph_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_factor_graph_parents(
    graph: *const tree_factor_graph,
    parents: *mut *const u32,
    n_segments: *mut usize,
) -> tree_status {
    call(|| {
        let found = unsafe { get(graph, "graph") }?.0.parents();
        unsafe { out_value(parents, column(found), "parents") }?;
        unsafe { out_value(n_segments, found.len(), "n_segments") }
    })
}

/// Length of a segment in the plane, from end to end, in metres.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_factor_graph_length(
    graph: *const tree_factor_graph,
    segment: u32,
    metres: *mut f64,
) -> tree_status {
    call(|| {
        let graph = &unsafe { get(graph, "graph") }?.0;
        let n = graph.parents().len();
        if segment as usize >= n {
            let text = format!("segment is {segment}, there are {n}, counted from 0");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        unsafe { out_value(metres, graph.length(segment as usize), "metres") }
    })
}

/// The posterior of depths, of the segments' ends in metres, and labels: `n_segments` of each. `omega` and `control`
/// may be NULL. `TREE_ERROR_INVALID` where there are not as many as segments, `TREE_ERROR_PARAMETER` for a depth
/// that is not finite.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_factor_graph_posterior(
    graph: *const tree_factor_graph,
    omega: *const tree_sketch_omega,
    depths: *const f64,
    labels: *const tree_sketch_label,
    n_segments: usize,
    control: *const tree_control,
    posterior: *mut tree_sketch_posterior,
) -> tree_status {
    call(|| {
        let graph = &unsafe { get(graph, "graph") }?.0;
        let omega = unsafe { self::omega(omega) }?;
        let (limits, nodes) = (unsafe { limits(control) }?, Resource::Nodes);
        let depths = unsafe { slice(depths, n_segments, &limits, nodes, "depths") }?;
        if let Some(segment) = depths.iter().position(|depth| !depth.is_finite()) {
            let text = format!("depths[{segment}] is {}, it must be finite", depths[segment]);
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let labels = unsafe { slice(labels, n_segments, &limits, nodes, "labels") }?;
        let label = |(i, &found): (usize, &u32)| label(found, &format!("labels[{i}]"));
        let labels = labels.iter().enumerate().map(label).collect::<Result<Vec<_>>>()?;
        let found = graph.posterior(&omega, depths, &labels)?;
        unsafe { out_value(posterior, tree_sketch_posterior::of(&found), "posterior") }
    })
}

/// Frees a factor graph.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_factor_graph_free(graph: *mut tree_factor_graph) -> tree_status {
    call(|| unsafe { free(graph, "graph") })
}
