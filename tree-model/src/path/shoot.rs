//! One graph from end to end: strew nodes, link them, search, choose endpoints, and keep the union
//! of their paths.

use super::endpoints::Choice;
use super::graph::{Graph, LinkParams, Terrain};
use super::nodes::strew;
use super::params::Placing;
use super::search::{NO_NODE, Routes, Scratch, search_with};
use crate::error::{ModelError, Result};
use glam::Vec3;
use tree_core::{Control, Seed, Volume};

/// Share of the nodes that may be out of reach before the graph is linked anew with a longer reach.
const MAX_STRAY_SHARE: f32 = 0.05;

/// Factor on the reach, and how often it is applied, when a graph falls apart: thin trunks have
/// holes that a solid crown has not. Beyond that the volume itself is in pieces.
const WIDEN: f32 = 1.2;
const MAX_WIDENINGS: u32 = 4;

/// The order for one graph.
pub(crate) struct Plot<'a> {
    pub(crate) volume: &'a Volume,
    pub(crate) root: Vec3,
    pub(crate) graph_nodes: u32,
    pub(crate) random: u32,
    pub(crate) placed: &'a [Vec3],
    pub(crate) placing: Placing,
    pub(crate) candidates: u32,
    pub(crate) above: f32,
    pub(crate) linking: &'a LinkParams,
    pub(crate) terrain: &'a Terrain<'a>,
}

/// The union of the paths in one graph: a small skeleton whose node 0 is the root.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shoot {
    pub(crate) positions: Vec<Vec3>,
    /// Parent of each node, which comes before it; the root names itself.
    pub(crate) parents: Vec<u32>,
    /// The endpoints' nodes, placed ones first.
    pub(crate) tips: Vec<u32>,
    pub(crate) stats: GraphStats,
}

/// Size of one graph, or of several together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GraphStats {
    /// Graphs searched.
    pub n_graphs: u64,
    /// Nodes in them.
    pub n_nodes: u64,
    /// Arcs in them: two for each edge.
    pub n_arcs: u64,
    /// Nodes no path led to.
    pub n_stray_nodes: u64,
    /// Graphs that fell apart at the linking distance asked for and were linked again with a longer
    /// one.
    pub n_widened: u64,
    /// Bytes of the largest single graph.
    pub largest_bytes: u64,
}

impl GraphStats {
    pub(crate) fn add(&mut self, other: Self) {
        self.n_graphs += other.n_graphs;
        self.n_nodes += other.n_nodes;
        self.n_arcs += other.n_arcs;
        self.n_stray_nodes += other.n_stray_nodes;
        self.n_widened += other.n_widened;
        self.largest_bytes = self.largest_bytes.max(other.largest_bytes);
    }
}

/// Memory that the graphs of one thread share.
#[derive(Default)]
pub(crate) struct Workspace {
    routes: Routes,
    scratch: Scratch,
}

/// A graph, linked so that it hangs together, and the paths in it.
struct Linked {
    graph: Graph,
    separation: f32,
    root: u32,
    placed: Vec<u32>,
    stats: GraphStats,
}

impl Plot<'_> {
    /// Grows the shoot.
    pub(crate) fn grow(
        &self,
        seed: Seed,
        workspace: &mut Workspace,
        control: &Control,
    ) -> Result<Shoot> {
        let Workspace { routes, scratch } = workspace;
        let linked = self.link(seed, routes, scratch, control)?;
        for (index, &node) in linked.placed.iter().enumerate() {
            if !routes.reached(node) {
                return Err(ModelError::EndpointUnreachable {
                    index,
                    position: self.placed[index],
                });
            }
        }
        let mut targets = linked.placed.clone();
        let choice = Choice {
            positions: linked.graph.positions(),
            routes,
            root: linked.root,
            volume: self.volume,
            separation: linked.separation,
            placing: self.placing,
            above: self.above,
            candidates: self.candidates,
        };
        let mut rng = seed.stream("endpoints").rng();
        choice.draw(self.random, &mut targets, &mut rng, control)?;
        if targets.is_empty() {
            return Err(ModelError::NoCandidates { wanted: self.random });
        }
        let mut shoot = union_of_paths(&linked.graph, routes, linked.root, &targets);
        shoot.stats = linked.stats;
        Ok(shoot)
    }

    /// Strews, links and searches; widens the reach where the graph falls apart.
    fn link(
        &self,
        seed: Seed,
        routes: &mut Routes,
        scratch: &mut Scratch,
        control: &Control,
    ) -> Result<Linked> {
        if self.terrain.obstacle.is_some_and(|obstacle| obstacle.holds(self.root)) {
            return Err(ModelError::RootBlocked { root: self.root });
        }
        let mut forced = Vec::with_capacity(self.placed.len() + 1);
        forced.push(self.root);
        forced.extend_from_slice(self.placed);
        let nodes = strew(
            self.volume,
            self.terrain.obstacle,
            self.graph_nodes,
            &forced,
            seed.stream("nodes"),
            control,
        )?;
        let (root, placed) = (nodes.forced[0], nodes.forced[1..].to_vec());
        let mut linking = self.linking.clone();
        let mut widenings = 0;
        loop {
            let graph = Graph::link(&nodes, &linking, self.terrain, seed.stream("edges"), control)?;
            search_with(&graph, root, routes, scratch, control)?;
            let n_reached = routes.n_reached();
            let strays = graph.len() - n_reached;
            // What an obstacle cuts off no longer reach would bring back.
            let cut_off = self.terrain.obstacle.is_some() && n_reached > forced.len();
            let whole = strays as f32 <= MAX_STRAY_SHARE * graph.len() as f32
                && placed.iter().all(|&node| routes.reached(node));
            let widest = linking.reach * WIDEN > LinkParams::MAX_REACH;
            if whole || cut_off || widest || widenings == MAX_WIDENINGS {
                if n_reached <= forced.len() {
                    return Err(self.root_outside(&graph, root, linking.reach * nodes.separation));
                }
                let stats = GraphStats {
                    n_graphs: 1,
                    n_nodes: graph.len() as u64,
                    n_arcs: graph.n_arcs() as u64,
                    n_stray_nodes: strays as u64,
                    n_widened: u64::from(widenings > 0),
                    largest_bytes: graph.bytes() as u64,
                };
                return Ok(Linked { graph, separation: nodes.separation, root, placed, stats });
            }
            widenings += 1;
            linking.reach *= WIDEN;
        }
    }

    fn root_outside(&self, graph: &Graph, root: u32, reach: f32) -> ModelError {
        let nearest = graph
            .positions()
            .iter()
            .enumerate()
            .filter(|&(node, position)| node as u32 != root && !self.placed.contains(position))
            .map(|(_, position)| position.distance(self.root))
            .fold(f32::INFINITY, f32::min);
        ModelError::RootOutside { root: self.root, nearest, reach }
    }
}

/// Walks from every target to the root and keeps each node once, parents first.
fn union_of_paths(graph: &Graph, routes: &Routes, root: u32, targets: &[u32]) -> Shoot {
    let mut local = vec![NO_NODE; graph.len()];
    local[root as usize] = 0;
    let mut shoot = Shoot {
        positions: vec![graph.positions()[root as usize]],
        parents: vec![0],
        ..Default::default()
    };
    let mut path = Vec::new();
    for &target in targets {
        path.clear();
        let mut node = target;
        while local[node as usize] == NO_NODE {
            path.push(node);
            node = routes.from(node);
        }
        let mut parent = local[node as usize];
        for &node in path.iter().rev() {
            local[node as usize] = shoot.positions.len() as u32;
            shoot.positions.push(graph.positions()[node as usize]);
            shoot.parents.push(parent);
            parent = local[node as usize];
        }
        shoot.tips.push(local[target as usize]);
    }
    shoot
}
