//! Steps 1G and 1H of Xu & Mould's algorithm: nodes closer than a linking distance are joined, and
//! each edge gets a random cost.
//!
//! The paper uses one length to keep nodes apart and to link them, by which no edge would exist.
//! Two are meant: a separation, and a linking distance of [`LinkParams::reach`] separations. At 2, a
//! strewing without holes is always connected: balls of one separation round the nodes then cover
//! the volume, and neighbouring balls touch.

use super::nodes::{FILL, Nodes};
use super::obstacle::Obstacle;
use crate::error::{ModelError, Result, check};
use glam::Vec3;
use rayon::prelude::*;
use std::sync::Arc as Shared;
use tree_core::{Control, Limits, Resource, Seed, Volume};

/// Nodes linked by one task. Graphs up to this size are linked on the calling thread, because the
/// many small graphs of one level already keep all threads busy.
const CHUNK: usize = 4096;

/// Arcs of a node deep inside a graph of reach 1: the nodes in a ball of one separation.
const ARCS_PER_NODE: f32 = 4.0 / 3.0 * std::f32::consts::PI * FILL;

/// Most arcs of a graph, whatever the limits: rows begin at offsets of 32 bits, and arcs are estimated before
/// they are counted.
const ARCS_MAX: u64 = 1 << 31;

/// One direction of an edge.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Arc {
    /// The node it leads to.
    pub to: u32,
    /// What it costs, 0 or more.
    pub cost: f32,
}

/// An undirected graph with costs, as compressed rows of arcs.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    positions: Vec<Vec3>,
    starts: Vec<u32>,
    arcs: Vec<Arc>,
    /// Mean and largest cost of an arc.
    mean_cost: f32,
    max_cost: f32,
}

/// How nodes are linked and what edges cost.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct LinkParams {
    /// Linking distance in separations, 1.2 to 4, default 2. More links make straighter paths and
    /// cost time and memory with the third power; under 1.6 graphs fall apart.
    pub reach: f32,
    /// An edge costs its length times a random weight from `low` to 1; 0.01 to 1, default 0.25.
    /// Low values make crooked branches that run together, 1 makes straight ones.
    pub low: f32,
    /// Weights are `low + (1 - low) · u^bias` with u uniform in 0 to 1; 0.1 to 10, default 1. Above
    /// 1 cheap edges are many, below 1 few.
    pub bias: f32,
}

impl Default for LinkParams {
    fn default() -> Self {
        Self { reach: 2.0, low: 0.25, bias: 1.0 }
    }
}

impl LinkParams {
    /// Longest linking distance in separations: a node has about a hundred arcs there.
    pub const MAX_REACH: f32 = 4.0;

    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the field.
    pub fn validate(&self) -> Result<()> {
        check("linking.reach", self.reach, 1.2, Self::MAX_REACH)?;
        check("linking.low", self.low, 0.01, 1.0)?;
        check("linking.bias", self.bias, 0.1, 10.0)
    }
}

/// Makes edges dearer or cheaper inside a volume: the paper's painted maps of edge weights (§5).
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Paint {
    /// Where: edges whose middle lies inside.
    pub volume: Volume,
    /// Their cost is multiplied by this, 0 to 1000. Below 1 attracts branches, above 1 repels them.
    pub factor: f32,
}

/// A cost factor for every point in space, given by the user. Must be finite and not negative.
pub type CostField = Shared<dyn Fn(Vec3) -> f32 + Send + Sync>;

/// What makes edges cost more or less, and where none may pass.
#[derive(Clone, Default)]
pub struct Terrain<'a> {
    /// Painted factors; where several overlap, they multiply.
    pub paint: &'a [Paint],
    /// A factor for every point.
    pub cost: Option<&'a CostField>,
    /// Where no path may enter.
    pub obstacle: Option<&'a Obstacle>,
}

impl Terrain<'_> {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the field.
    pub fn validate(&self) -> Result<()> {
        for (i, paint) in self.paint.iter().enumerate() {
            check(format!("paint[{i}].factor"), paint.factor, 0, 1000)?;
        }
        self.obstacle.map_or(Ok(()), Obstacle::validate)
    }
}

impl Graph {
    /// Links `nodes`.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] for `linking` or `terrain` out of range, [`ModelError::Cost`] when the user's field answers with no cost, [`ModelError::Limit`] when the
    /// arcs would exceed [`Limits::graph_arcs`](tree_core::Limits), [`ModelError::Cancelled`].
    ///
    /// # Complexity
    /// O(nodes · reach³) time; at the default reach about 15 arcs of 8 bytes a node.
    pub fn link(
        nodes: &Nodes,
        linking: &LinkParams,
        terrain: &Terrain<'_>,
        seed: Seed,
        control: &Control,
    ) -> Result<Self> {
        linking.validate()?;
        terrain.validate()?;
        let n_nodes = nodes.positions.len();
        let reach = linking.reach * nodes.separation;
        let arcs = n_nodes as f64
            * f64::from(ARCS_PER_NODE * linking.reach * linking.reach * linking.reach);
        let cap = control.limits.graph_arcs.min(ARCS_MAX);
        Limits { graph_arcs: cap, ..control.limits }.check(Resource::GraphArcs, arcs as u64)?;
        let linker = Linker { nodes, linking, terrain, seed, reach };
        let ranges: Vec<_> =
            (0..n_nodes).step_by(CHUNK).map(|start| start..(start + CHUNK).min(n_nodes)).collect();
        let link = |range: &std::ops::Range<usize>| {
            control.check()?;
            linker.edges(range.clone())
        };
        let chunks = match ranges.as_slice() {
            [one] => vec![link(one)?],
            many => many.par_iter().map(link).collect::<Result<Vec<_>>>()?,
        };
        Ok(Self::assemble(nodes.positions.clone(), &chunks))
    }

    /// Both directions of every edge, as compressed rows: degrees, running sums, then fill. The
    /// arcs of a row come in the order of the node they lead to.
    fn assemble(positions: Vec<Vec3>, chunks: &[Vec<Edge>]) -> Self {
        let edges = || chunks.iter().flatten();
        let mut starts = vec![0_u32; positions.len() + 1];
        for edge in edges() {
            starts[edge.from as usize + 1] += 1;
            starts[edge.to as usize + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let mut arcs = vec![Arc::default(); starts.last().map_or(0, |&n| n as usize)];
        let (mut sum, mut max_cost) = (0.0_f64, 0.0_f32);
        for edge in edges() {
            sum += f64::from(edge.cost);
            max_cost = max_cost.max(edge.cost);
            for (from, to) in [(edge.from, edge.to), (edge.to, edge.from)] {
                let slot = &mut next[from as usize];
                arcs[*slot as usize] = Arc { to, cost: edge.cost };
                *slot += 1;
            }
        }
        let mean_cost = (2.0 * sum / arcs.len().max(1) as f64) as f32;
        Self { positions, starts, arcs, mean_cost, max_cost }
    }

    /// Makes a graph of undirected edges (node, node, cost), for graphs from elsewhere.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] when an edge names a node that is not there or has a negative or
    /// infinite cost.
    pub fn from_edges(positions: Vec<Vec3>, edges: &[(u32, u32, f32)]) -> Result<Self> {
        let last = positions.len() as f64 - 1.0;
        let mut checked = Vec::with_capacity(edges.len());
        for (i, &(from, to, cost)) in edges.iter().enumerate() {
            check(format!("edges[{i}].0"), from, 0, last)?;
            check(format!("edges[{i}].1"), to, 0, last)?;
            check(format!("edges[{i}].2"), cost, 0.0, f32::MAX)?;
            checked.push(Edge { from, to, cost });
        }
        Ok(Self::assemble(positions, &[checked]))
    }

    /// Number of nodes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there is no node.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// Number of arcs: two for each edge.
    #[must_use]
    pub fn n_arcs(&self) -> usize {
        self.arcs.len()
    }

    /// Positions of the nodes in metres.
    #[must_use]
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// Arcs that leave `node`; none for a node that does not exist.
    #[must_use]
    #[inline]
    pub fn arcs(&self, node: u32) -> &[Arc] {
        let node = node as usize;
        match (self.starts.get(node), self.starts.get(node + 1)) {
            (Some(&start), Some(&end)) => &self.arcs[start as usize..end as usize],
            _ => &[],
        }
    }

    /// Where each node's arcs begin in [`all_arcs`](Self::all_arcs), and at the end their number.
    #[must_use]
    pub fn starts(&self) -> &[u32] {
        &self.starts
    }

    /// The arcs of all nodes, node by node.
    #[must_use]
    pub fn all_arcs(&self) -> &[Arc] {
        &self.arcs
    }

    /// Bytes held.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of_val(self.positions.as_slice())
            + size_of_val(self.starts.as_slice())
            + size_of_val(self.arcs.as_slice())
    }

    /// Mean and largest cost of an arc; (0, 0) without arcs.
    pub(crate) fn cost_range(&self) -> (f32, f32) {
        (self.mean_cost, self.max_cost)
    }
}

/// An edge, named by its lower node first.
struct Edge {
    from: u32,
    to: u32,
    cost: f32,
}

struct Linker<'a> {
    nodes: &'a Nodes,
    linking: &'a LinkParams,
    terrain: &'a Terrain<'a>,
    seed: Seed,
    reach: f32,
}

impl Linker<'_> {
    /// All edges whose lower node lies in `range`.
    fn edges(&self, range: std::ops::Range<usize>) -> Result<Vec<Edge>> {
        let positions = &self.nodes.positions;
        let reach_squared = self.reach * self.reach;
        let plain = self.terrain.paint.is_empty()
            && self.terrain.cost.is_none()
            && self.terrain.obstacle.is_none();
        let mut edges = Vec::with_capacity(8 * range.len());
        for a in range {
            let here = positions[a];
            // Each node draws the weights of its edges from a stream of its own.
            let stream = self.seed.child(a as u64);
            self.nodes.grid.for_runs_after(a, here, self.reach, |run| {
                let first = run.start;
                for (i, &there) in positions[run].iter().enumerate() {
                    let length_squared = here.distance_squared(there);
                    if length_squared < reach_squared {
                        let to = (first + i) as u32;
                        let cost = length_squared.sqrt() * self.weight(stream.unit(u64::from(to)));
                        edges.push(Edge { from: a as u32, to, cost });
                    }
                }
            });
        }
        if !plain {
            self.lay_terrain(&mut edges)?;
        }
        Ok(edges)
    }

    #[inline]
    fn weight(&self, mut u: f32) -> f32 {
        if self.linking.bias != 1.0 {
            u = libm::powf(u, self.linking.bias);
        }
        self.linking.low + (1.0 - self.linking.low) * u
    }

    /// Makes edges dearer or cheaper, and takes out those that an obstacle is in the way of.
    fn lay_terrain(&self, edges: &mut Vec<Edge>) -> Result<()> {
        let mut error = None;
        edges.retain_mut(|edge| match self.factor(edge) {
            Ok(Some(factor)) => {
                edge.cost = (edge.cost * factor).min(f32::MAX);
                true
            }
            Ok(None) => false,
            Err(e) => {
                error.get_or_insert(e);
                false
            }
        });
        error.map_or(Ok(()), Err)
    }

    /// The factor on the cost of an edge; `None` where an obstacle is in the way.
    fn factor(&self, edge: &Edge) -> Result<Option<f32>> {
        let positions = &self.nodes.positions;
        let (from, to) = (positions[edge.from as usize], positions[edge.to as usize]);
        if self.terrain.obstacle.is_some_and(|obstacle| !obstacle.is_free(from, to)) {
            return Ok(None);
        }
        let middle = 0.5 * (from + to);
        let mut factor = 1.0;
        for paint in self.terrain.paint {
            if paint.volume.contains(middle) {
                factor *= paint.factor;
            }
        }
        if let Some(field) = self.terrain.cost {
            let found = field(middle);
            if !found.is_finite() || found < 0.0 {
                return Err(ModelError::Cost { position: middle, found });
            }
            factor *= found;
        }
        Ok(Some(factor))
    }
}
