//! Nodes of search graphs: the first stage by itself.

use super::terrain::obstacle;
use crate::border::{
    Handle, Versioned, call, free, get, init, out, read_or_default, tree_status, vec3s, write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use crate::volume::tree_volume;
use tree_model::path::nodes::{Nodes, strew};
use tree_model::tree_core::{Resource, Seed};

/// Which nodes are strewn. Begin with `tree_strew_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_strew_params {
    /// `sizeof(tree_strew_params)`.
    pub struct_size: usize,
    /// Where there are no nodes. Default NULL.
    pub obstacle: *const tree_volume,
    /// Points that become nodes wherever they lie, three floats each. Default NULL.
    pub forced: *const f32,
    /// Number of those points.
    pub n_forced: usize,
    /// Distance to keep from the obstacle in metres, 0 or more. Default 0.
    pub clearance: f32,
    /// Nodes wanted, at most `tree_limits.graph_nodes`; there will be this many within about a tenth, and
    /// up to 2.8 times as many in a volume thinner than their distance. Default 5000, as for an oak.
    pub n_nodes: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_strew_params {
    const NAME: &'static str = "tree_strew_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            obstacle: std::ptr::null(),
            forced: std::ptr::null(),
            n_forced: 0,
            clearance: 0.0,
            n_nodes: super::preset::oak().graph_nodes,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_strew_params_init(
    params: *mut tree_strew_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Nodes strewn in a volume, ready to be linked.
pub struct tree_graph_nodes(Nodes);

impl Handle for tree_graph_nodes {
    const NAME: &'static str = "tree_graph_nodes";
}

impl tree_graph_nodes {
    pub(super) fn rust(&self) -> &Nodes {
        &self.0
    }
}

/// A view of strewn nodes.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_graph_nodes_columns {
    /// `sizeof(tree_graph_nodes_columns)`.
    pub struct_size: usize,
    /// Number of nodes.
    pub n_nodes: usize,
    /// Three floats for each node, in metres.
    pub positions: *const f32,
    /// Number of forced points.
    pub n_forced: usize,
    /// For each forced point its node.
    pub forced: *const u32,
    /// No two nodes are closer than this, in metres; forced ones may be.
    pub separation: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_graph_nodes_columns {
    const NAME: &'static str = "tree_graph_nodes_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_nodes: 0,
            positions: std::ptr::null(),
            n_forced: 0,
            forced: std::ptr::null(),
            separation: 0.0,
            reserved: 0,
        }
    }
}

/// Strews nodes evenly in a bounded volume, none closer than a separation that follows from their number.
/// `params` and `control` may be NULL. The same `seed` gives the same nodes. Free them with
/// `tree_graph_nodes_free`. `TREE_ERROR_NO_RESULT` when the volume has no end or no inside.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_graph_strew(
    volume: *const tree_volume,
    params: *const tree_strew_params,
    seed: u64,
    control: *const tree_control,
    nodes: *mut *mut tree_graph_nodes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(nodes, "nodes") }?;
        let volume = unsafe { get(volume, "volume") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?;
        let obstacle = unsafe { obstacle(params.obstacle, params.clearance, "params.obstacle") }?;
        let limits = unsafe { limits(control) }?;
        let (n, resource) = (params.n_forced, Resource::GraphNodes);
        let forced = unsafe { vec3s(params.forced, n, &limits, resource, "params.forced") }?;
        let n_nodes = params.n_nodes;
        let strewn = unsafe {
            run(control, |control| {
                Ok(strew(volume, obstacle.as_ref(), n_nodes, forced, Seed(seed), control)?)
            })
        }?;
        place.put(tree_graph_nodes(strewn));
        Ok(())
    })
}

/// Views strewn nodes. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_graph_nodes_view(
    nodes: *const tree_graph_nodes,
    columns: *mut tree_graph_nodes_columns,
) -> tree_status {
    call(|| {
        let nodes = unsafe { get(nodes, "nodes") }?.rust();
        let value = tree_graph_nodes_columns {
            n_nodes: nodes.positions.len(),
            positions: column(&nodes.positions).cast(),
            n_forced: nodes.forced.len(),
            forced: column(&nodes.forced),
            separation: nodes.separation,
            ..tree_graph_nodes_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// Frees strewn nodes. Graphs made of them live on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_graph_nodes_free(nodes: *mut tree_graph_nodes) -> tree_status {
    call(|| unsafe { free(nodes, "nodes") })
}
