//! Step 3A of Xu & Mould's algorithm: least-cost paths from the root to every node.
//!
//! One single-source search serves all endpoints, and the union of its paths is a tree by
//! construction. The queue is a ring of buckets (Dial 1969; Denardo & Fox 1979) worked label-correcting
//! within a bucket (Meyer & Sanders 2003, *Δ-stepping*), which needs no heap: time is linear in nodes
//! and arcs, as the paper claims, where Dijkstra's algorithm with a heap pays a logarithm more. Costs
//! that differ by powers of ten (painted maps) would crowd one bucket; then the queue moves into a
//! heap, and the search ends as Dijkstra's. The costs are the same to the last bit either way,
//! because each is the least floating-point sum over all paths.

use super::graph::Graph;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use tree_core::{Cancelled, Control};

/// Predecessor of the root, and of nodes that cannot be reached.
pub const NO_NODE: u32 = u32::MAX;

/// Most buckets in the ring: beyond that, skipping empty ones costs more than it saves.
const MAX_BUCKETS: f32 = 4096.0;

/// Bucket width as a share of the mean arc cost. Wider buckets relax nodes twice, narrower ones
/// are empty; the time is flat between a tenth and a half.
const WIDTH_SHARE: f32 = 0.25;

/// Entries worked per node before the buckets are given up for a heap. Ordinary graphs take two.
const PATIENCE: usize = 8;

/// Heap entries worked between checks for cancellation.
const POPS_PER_CHECK: usize = 4096;

/// Cost and predecessor of every node.
#[derive(Clone, Debug, Default)]
pub struct Routes {
    // Two columns: the search compares costs far more often than it writes predecessors.
    costs: Vec<f32>,
    from: Vec<u32>,
}

impl Routes {
    /// Cost of the cheapest path from the root; infinite where there is none.
    #[must_use]
    pub fn cost(&self, node: u32) -> f32 {
        self.costs.get(node as usize).copied().unwrap_or(f32::INFINITY)
    }

    /// The node before `node` on that path; [`NO_NODE`] at the root and where there is no path.
    #[must_use]
    pub fn from(&self, node: u32) -> u32 {
        self.from.get(node as usize).copied().unwrap_or(NO_NODE)
    }

    /// Whether a path leads to `node`.
    #[must_use]
    pub fn reached(&self, node: u32) -> bool {
        self.cost(node) < f32::INFINITY
    }

    /// Number of nodes with a path.
    #[must_use]
    pub fn n_reached(&self) -> usize {
        self.costs.iter().filter(|&&cost| cost < f32::INFINITY).count()
    }
}

/// Least-cost paths from `root` to all nodes of `graph`.
///
/// # Errors
/// [`Cancelled`].
///
/// # Complexity
/// O(nodes + arcs) for costs within a few powers of ten of each other, O(arcs · log nodes) at worst;
/// 8 bytes a node.
pub fn search(graph: &Graph, root: u32, control: &Control) -> Result<Routes, Cancelled> {
    let mut routes = Routes::default();
    search_with(graph, root, &mut routes, &mut Scratch::default(), control)?;
    Ok(routes)
}

/// Memory that many searches share.
#[derive(Debug, Default)]
pub struct Scratch {
    ring: Vec<Vec<(f32, u32)>>,
}

/// As [`search`], into `routes`, reusing `scratch`.
///
/// # Errors
/// [`Cancelled`].
pub fn search_with(
    graph: &Graph,
    root: u32,
    routes: &mut Routes,
    scratch: &mut Scratch,
    control: &Control,
) -> Result<(), Cancelled> {
    let n_nodes = graph.len();
    let Routes { costs, from } = routes;
    costs.clear();
    costs.resize(n_nodes, f32::INFINITY);
    from.clear();
    from.resize(n_nodes, NO_NODE);
    if root as usize >= n_nodes {
        return Ok(());
    }
    let (mean, max) = graph.cost_range();
    let width = (WIDTH_SHARE * mean).max(max / MAX_BUCKETS).max(f32::MIN_POSITIVE);
    let per_width = width.recip().min(f32::MAX);
    // One lap must hold the costliest arc from anywhere in a bucket, plus rounding. A power of two,
    // so that places on the ring are found by masking.
    let lap = ((max * per_width) as usize + 3).next_power_of_two();
    scratch.ring.iter_mut().for_each(Vec::clear);
    if scratch.ring.len() < lap {
        scratch.ring.resize_with(lap, Vec::new);
    }
    let ring = &mut scratch.ring[..lap];

    costs[root as usize] = 0.0;
    ring[0].push((0.0, root));
    let mut n_queued = 1_usize;
    let mut bucket = 0_usize;
    let mut patience = PATIENCE * n_nodes;
    while n_queued > 0 {
        control.check()?;
        let floor = bucket as f32 * width;
        let slot = bucket & (lap - 1);
        while let Some((cost, node)) = ring[slot].pop() {
            n_queued -= 1;
            if patience == 0 {
                ring[slot].push((cost, node));
                return search_by_heap(graph, ring, routes, control);
            }
            patience -= 1;
            // An entry whose cost was undercut since is stale.
            if cost > costs[node as usize] {
                continue;
            }
            // Touching the next node's arcs while this one's are at work hides the way to memory.
            if let Some(&(_, next)) = ring[slot].last() {
                std::hint::black_box(graph.arcs(next).first().map_or(0, |arc| arc.to));
            }
            for arc in graph.arcs(node) {
                let reach = cost + arc.cost;
                let known = &mut costs[arc.to as usize];
                if reach < *known {
                    *known = reach;
                    from[arc.to as usize] = node;
                    // Rounding may put an entry into a neighbouring bucket. That costs time at
                    // worst: a node whose cost falls later is worked again.
                    let ahead = ((reach - floor) * per_width) as u32 as usize;
                    ring[(slot + ahead.min(lap - 1)) & (lap - 1)].push((reach, arc.to));
                    n_queued += 1;
                }
            }
        }
        bucket += 1;
    }
    Ok(())
}

/// Goes on from where the buckets were given up: all that is queued moves into a heap. Every node
/// whose cost is not final has an entry, so each is worked at most once more.
fn search_by_heap(
    graph: &Graph,
    ring: &mut [Vec<(f32, u32)>],
    routes: &mut Routes,
    control: &Control,
) -> Result<(), Cancelled> {
    // Costs are not negative, so that their bits are in the order of their values.
    let entry = |(cost, node): (f32, u32)| Reverse((cost.to_bits(), node));
    let mut heap: BinaryHeap<_> = ring.iter_mut().flat_map(|b| b.drain(..)).map(entry).collect();
    let Routes { costs, from } = routes;
    let mut n_pops = 0_usize;
    while let Some(Reverse((bits, node))) = heap.pop() {
        n_pops += 1;
        if n_pops.is_multiple_of(POPS_PER_CHECK) {
            control.check()?;
        }
        let cost = f32::from_bits(bits);
        if cost > costs[node as usize] {
            continue;
        }
        for arc in graph.arcs(node) {
            let reach = cost + arc.cost;
            if reach < costs[arc.to as usize] {
                costs[arc.to as usize] = reach;
                from[arc.to as usize] = node;
                heap.push(entry((reach, arc.to)));
            }
        }
    }
    Ok(())
}
