//! Search graphs and least-cost paths: the second and third stage by themselves.

use super::nodes::tree_graph_nodes;
use super::terrain::{cost_field, obstacle, paints, tree_link_params};
use crate::border::{
    Handle, Versioned, call, fill, free, get, out, read_or_default, slice, tree_status, vec3s,
    write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use std::mem::offset_of;
use tree_model::path::LinkParams;
use tree_model::path::graph::{Arc, Graph, Terrain};
use tree_model::path::search::search;
use tree_model::tree_core::{Resource, Seed};

/// Predecessor of the root, and of nodes that no path leads to.
pub const TREE_NO_NODE: u32 = 0xFFFF_FFFF;
const _: () = assert!(TREE_NO_NODE == tree_model::path::search::NO_NODE);

/// An undirected graph with costs.
pub struct tree_graph(Graph);

impl Handle for tree_graph {
    const NAME: &'static str = "tree_graph";
}

/// One direction of an edge.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_graph_arc {
    /// The node it leads to.
    pub to: u32,
    /// What it costs, 0 or more.
    pub cost: f32,
}

// One is viewed as the other.
const _: () = {
    assert!(size_of::<tree_graph_arc>() == size_of::<Arc>());
    assert!(align_of::<tree_graph_arc>() == align_of::<Arc>());
    assert!(offset_of!(tree_graph_arc, to) == offset_of!(Arc, to));
    assert!(offset_of!(tree_graph_arc, cost) == offset_of!(Arc, cost));
};

/// A view of a graph, as compressed rows: the arcs that leave node `i` are `arcs[starts[i]]` up to, but
/// not including, `arcs[starts[i + 1]]`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_graph_columns {
    /// `sizeof(tree_graph_columns)`.
    pub struct_size: usize,
    /// Number of nodes.
    pub n_nodes: usize,
    /// Three floats for each node, in metres.
    pub positions: *const f32,
    /// `n_nodes + 1` numbers.
    pub starts: *const u32,
    /// Number of arcs: two for each edge.
    pub n_arcs: usize,
    /// The arcs, node by node.
    pub arcs: *const tree_graph_arc,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_graph_columns {
    const NAME: &'static str = "tree_graph_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_nodes: 0,
            positions: std::ptr::null(),
            starts: std::ptr::null(),
            n_arcs: 0,
            arcs: std::ptr::null(),
        }
    }
}

/// Joins nodes that are nearer than a linking distance by edges of random cost. `params` and `control` may
/// be NULL. The same `seed` gives the same graph. Free it with `tree_graph_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_graph_link(
    nodes: *const tree_graph_nodes,
    params: *const tree_link_params,
    seed: u64,
    control: *const tree_control,
    graph: *mut *mut tree_graph,
) -> tree_status {
    call(|| {
        let place = unsafe { out(graph, "graph") }?;
        let nodes = unsafe { get(nodes, "nodes") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?;
        let paint = unsafe { paints(params.paints, params.n_paints, "params.paints") }?;
        let cost = cost_field(params.cost, params.cost_user);
        let obstacle = unsafe { obstacle(params.obstacle, params.clearance, "params.obstacle") }?;
        let linking = LinkParams { reach: params.reach, low: params.low, bias: params.bias };
        let linked = unsafe {
            run(control, |control| {
                let obstacle = obstacle.as_ref();
                let terrain = Terrain { paint: &paint, cost: cost.as_ref(), obstacle };
                Ok(Graph::link(nodes, &linking, &terrain, Seed(seed), control)?)
            })
        }?;
        place.put(tree_graph(linked));
        Ok(())
    })
}

/// Makes a graph from elsewhere: `positions` is `n_nodes` times three floats, `edges` is `n_edges` times
/// the two nodes that it joins, `costs` a finite cost of 0 or more for each edge. `control` may be NULL;
/// only its limits matter. Free the graph with `tree_graph_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_graph_from_edges(
    positions: *const f32,
    n_nodes: usize,
    edges: *const u32,
    costs: *const f32,
    n_edges: usize,
    control: *const tree_control,
    graph: *mut *mut tree_graph,
) -> tree_status {
    call(|| {
        let place = unsafe { out(graph, "graph") }?;
        let limits = unsafe { limits(control) }?;
        limits.check(Resource::GraphArcs, (n_edges as u64).saturating_mul(2))?;
        let (nodes, arcs) = (Resource::GraphNodes, Resource::GraphArcs);
        let positions = unsafe { vec3s(positions, n_nodes, &limits, nodes, "positions") }?;
        let edges: &[[u32; 2]] = unsafe { slice(edges.cast(), n_edges, &limits, arcs, "edges") }?;
        let costs = unsafe { slice(costs, n_edges, &limits, arcs, "costs") }?;
        let rows: Vec<_> = edges.iter().zip(costs).map(|(&[a, b], &cost)| (a, b, cost)).collect();
        place.put(tree_graph(Graph::from_edges(positions.to_vec(), &rows)?));
        Ok(())
    })
}

/// Views a graph. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_graph_view(
    graph: *const tree_graph,
    columns: *mut tree_graph_columns,
) -> tree_status {
    call(|| {
        let graph = &unsafe { get(graph, "graph") }?.0;
        let value = tree_graph_columns {
            n_nodes: graph.len(),
            positions: column(graph.positions()).cast(),
            starts: column(graph.starts()),
            n_arcs: graph.n_arcs(),
            arcs: column(graph.all_arcs()).cast(),
            ..tree_graph_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// Finds the least-cost paths from `root` to all nodes. `costs`, NULL or with room for `capacity` floats,
/// gets for each node what the path to it costs, infinity where there is none; `predecessors`, NULL or with
/// room for `capacity` numbers, gets the node before it on that path, or `TREE_NO_NODE`. `capacity` must
/// reach for all nodes. A root that does not exist reaches nothing. `control` may be NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_graph_search(
    graph: *const tree_graph,
    root: u32,
    control: *const tree_control,
    costs: *mut f32,
    predecessors: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let graph = &unsafe { get(graph, "graph") }?.0;
        let routes = unsafe { run(control, |control| Ok(search(graph, root, control)?)) }?;
        let nodes = 0..graph.len() as u32;
        if !costs.is_null() {
            let found: Vec<f32> = nodes.clone().map(|node| routes.cost(node)).collect();
            unsafe { fill(costs, capacity, &found, "costs") }?;
        }
        if !predecessors.is_null() {
            let found: Vec<u32> = nodes.map(|node| routes.from(node)).collect();
            unsafe { fill(predecessors, capacity, &found, "predecessors") }?;
        }
        Ok(())
    })
}

/// Frees a graph.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_graph_free(graph: *mut tree_graph) -> tree_status {
    call(|| unsafe { free(graph, "graph") })
}
