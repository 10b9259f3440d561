//! What particles leave behind: traces that join on their way to the base.

use crate::error::Result;
use glam::{IVec3, Vec3};
use tree_core::{Control, NO_PARENT, Resource, Skeleton, SkeletonColumns};

/// Fewest buckets in which nodes are found.
const MIN_BUCKETS: usize = 1024;
/// Odd numbers that spread the cells of a grid over buckets (Teschner et al. 2003, *Optimized spatial hashing*).
const SPREAD: [u32; 3] = [73_856_093, 19_349_663, 83_492_791];

/// The traces of all particles, in the order in which their nodes were left behind. Node 0 is the base.
#[derive(Clone, Debug, PartialEq)]
pub struct Traces {
    positions: Vec<Vec3>,
    next: Vec<u32>,
    masses: Vec<u32>,
}

impl Traces {
    /// Where the nodes are, in metres.
    #[must_use]
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// The node each node leads to, on the way to the base; [`NO_PARENT`] at the base, node 0.
    #[must_use]
    pub fn next(&self) -> &[u32] {
        &self.next
    }

    /// Number of particles whose way led through each node.
    #[must_use]
    pub fn masses(&self) -> &[u32] {
        &self.masses
    }

    /// The traces as a skeleton, from the base to where the particles started. Radii are 0.
    ///
    /// # Errors
    /// [`ModelError::Limit`](crate::ModelError::Limit) for more nodes than allowed,
    /// [`ModelError::Cancelled`](crate::ModelError::Cancelled).
    ///
    /// # Complexity
    /// O(nodes).
    pub fn skeleton(&self, control: &Control) -> Result<Skeleton> {
        control.limits.check(Resource::Nodes, self.positions.len() as u64)?;
        let (order, parents) = from_base(&self.next);
        control.check()?;
        let positions = order.iter().map(|&node| self.positions[node as usize]).collect();
        let radii = vec![0.0; order.len()];
        Ok(Skeleton::try_from(SkeletonColumns { positions, radii, parents })?)
    }
}

/// All nodes, from the base outwards, and the place in that order of the node that each leads to.
fn from_base(next: &[u32]) -> (Vec<u32>, Vec<u32>) {
    let n = next.len();
    // Counting sort by the node that comes next gives each node's children, in order.
    let mut starts = vec![0_u32; n + 1];
    for &next in next.iter().skip(1) {
        starts[next as usize + 1] += 1;
    }
    for i in 0..n {
        starts[i + 1] += starts[i];
    }
    let mut children = vec![0_u32; n.saturating_sub(1)];
    let mut fill = starts.clone();
    for (node, &next) in next.iter().enumerate().skip(1) {
        children[fill[next as usize] as usize] = node as u32;
        fill[next as usize] += 1;
    }
    let (mut order, mut parents) = (vec![0_u32], vec![NO_PARENT]);
    let mut at = 0;
    while let Some(&node) = order.get(at) {
        let run = starts[node as usize] as usize..starts[node as usize + 1] as usize;
        for &child in &children[run] {
            order.push(child);
            parents.push(at as u32);
        }
        at += 1;
    }
    (order, parents)
}

/// Traces that still grow, and where their nodes are.
pub(super) struct Growing {
    positions: Vec<Vec3>,
    next: Vec<u32>,
    /// The particle that left each node.
    owners: Vec<u32>,
    /// For each particle, the one whose trace it leads into; itself while it leads nowhere.
    into: Vec<u32>,
    /// Side of a cell: twice the reach, so that the eight cells around a point hold all that is within it.
    side: f32,
    /// Cells share buckets. The last node in each bucket, and for each node the one before it in its bucket.
    heads: Vec<u32>,
    links: Vec<u32>,
}

impl Growing {
    /// Traces that begin at `starts`, and at the base as node 0; nodes are found within `reach`.
    pub(super) fn new(starts: &[Vec3], reach: f32) -> Self {
        let mut traces = Self {
            positions: Vec::new(),
            next: Vec::new(),
            owners: Vec::new(),
            into: (0..starts.len() as u32).collect(),
            side: 2.0 * reach,
            heads: vec![NO_PARENT; (4 * starts.len()).next_power_of_two().max(MIN_BUCKETS)],
            links: Vec::new(),
        };
        traces.positions.push(Vec3::ZERO);
        traces.next.push(NO_PARENT);
        traces.owners.push(NO_PARENT);
        // The base has a reach of its own and is not found.
        traces.links.push(NO_PARENT);
        for (i, &start) in (0_u32..).zip(starts) {
            traces.push(start, i);
        }
        traces
    }

    pub(super) fn len(&self) -> usize {
        self.positions.len()
    }

    /// A node of a particle's trace, which leads nowhere yet.
    fn push(&mut self, position: Vec3, owner: u32) -> u32 {
        let node = self.positions.len() as u32;
        self.positions.push(position);
        self.next.push(NO_PARENT);
        self.owners.push(owner);
        self.links.push(NO_PARENT);
        if self.positions.len() > self.heads.len() {
            self.spread();
        } else {
            self.link(node);
        }
        node
    }

    /// Puts a node into its bucket.
    fn link(&mut self, node: u32) {
        let bucket = self.bucket(self.cell_of(self.positions[node as usize]));
        self.links[node as usize] = self.heads[bucket];
        self.heads[bucket] = node;
    }

    /// Twice as many buckets.
    fn spread(&mut self) {
        self.heads = vec![NO_PARENT; 2 * self.heads.len()];
        for node in 1..self.positions.len() as u32 {
            self.link(node);
        }
    }

    /// The next node of a particle's trace after `last`.
    pub(super) fn go_on(&mut self, last: u32, position: Vec3, owner: u32) -> u32 {
        let node = self.push(position, owner);
        self.next[last as usize] = node;
        node
    }

    /// Leads the trace of `particle`, which ends at `last`, on to a node of another's.
    pub(super) fn lead(&mut self, particle: u32, last: u32, node: u32) {
        self.next[last as usize] = node;
        let owner = self.owners[node as usize];
        if owner != NO_PARENT {
            self.into[particle as usize] = self.leader(owner);
        }
    }

    /// Leads the trace of `particle` into another's, unless that one leads to it by now. Returns the
    /// particle that carries both on.
    pub(super) fn follow(&mut self, particle: u32, last: u32, node: u32) -> Option<u32> {
        let leader = match self.owners[node as usize] {
            NO_PARENT => NO_PARENT,
            owner => self.leader(owner),
        };
        if leader == particle {
            return None;
        }
        self.lead(particle, last, node);
        Some(leader)
    }

    /// The particle at whose live or arrived end a particle's trace ends.
    pub(super) fn leader(&self, mut particle: u32) -> u32 {
        while self.into[particle as usize] != particle {
            particle = self.into[particle as usize];
        }
        particle
    }

    /// The nearest node within `reach` of another trace that does not lead to `particle` itself and that
    /// runs roughly along `heading`; the node after it, if there is one.
    pub(super) fn nearest(
        &self,
        particle: u32,
        at: Vec3,
        heading: Vec3,
        reach: f32,
    ) -> Option<u32> {
        // The cell half a side below, and its neighbours above.
        let low = self.cell_of(at - 0.5 * self.side);
        let mut best = (reach * reach, NO_PARENT);
        for corner in 0..8 {
            let step = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
            let mut node = self.heads[self.bucket(low.wrapping_add(step))];
            while node != NO_PARENT {
                let square = self.positions[node as usize].distance_squared(at);
                if square < best.0 && self.goes_along(node, heading) {
                    let owner = self.owners[node as usize];
                    if owner != particle && self.leader(owner) != particle {
                        best = (square, node);
                    }
                }
                node = self.links[node as usize];
            }
        }
        let node = (best.1 != NO_PARENT).then_some(best.1)?;
        Some(self.next[node as usize])
    }

    /// Whether the trace goes on from `node`, and that not against `heading`.
    fn goes_along(&self, node: u32, heading: Vec3) -> bool {
        let next = self.next[node as usize];
        next != NO_PARENT
            && (self.positions[next as usize] - self.positions[node as usize]).dot(heading) >= 0.0
    }

    /// Whether each node's trace has reached the base.
    pub(super) fn at_home(&self) -> Vec<bool> {
        let (order, _) = from_base(&self.next_or_self());
        let mut home = vec![false; self.len()];
        for node in order {
            home[node as usize] = true;
        }
        home
    }

    /// Open ends lead to themselves, so that they hang on nothing.
    fn next_or_self(&self) -> Vec<u32> {
        (0_u32..)
            .zip(&self.next)
            .map(|(node, &next)| if next == NO_PARENT { node } else { next })
            .collect()
    }

    pub(super) fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// The finished traces; masses count the traces that begin above each node.
    pub(super) fn finish(self) -> Traces {
        let (order, _) = from_base(&self.next);
        let mut begins = vec![1_u32; self.next.len()];
        for &next in self.next.iter().skip(1) {
            begins[next as usize] = 0;
        }
        let mut masses = begins;
        for &node in order.iter().skip(1).rev() {
            masses[self.next[node as usize] as usize] += masses[node as usize];
        }
        if self.next.len() == 1 {
            masses[0] = 0;
        }
        Traces { positions: self.positions, next: self.next, masses }
    }

    fn cell_of(&self, point: Vec3) -> IVec3 {
        (point / self.side).floor().as_ivec3()
    }

    fn bucket(&self, cell: IVec3) -> usize {
        let [x, y, z] = cell.to_array().map(|at| at as u32);
        let mixed =
            x.wrapping_mul(SPREAD[0]) ^ y.wrapping_mul(SPREAD[1]) ^ z.wrapping_mul(SPREAD[2]);
        mixed as usize & (self.heads.len() - 1)
    }
}
