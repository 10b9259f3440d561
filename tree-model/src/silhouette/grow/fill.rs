//! Twigs and leaves for cells of the outlines that stayed empty.
//!
//! From the front, and then from the side, the outline is cut into cells, and the leaf area in front of each is summed. From cells where
//! there is wood, cells without enough leaves are reached over their neighbours; each gets a node, joined to the node of
//! the cell it was reached from, and the leaves it lacks.
//!
//! O(nodes + leaves + cells).

use super::fence::{Fence, View, views};
use super::params::GrowParams;
use crate::error::Result;
use crate::silhouette::plan::Plan;
use glam::{Mat3, Quat, Vec2, Vec3};
use std::collections::VecDeque;
use tree_core::seed::{Rng, uniform, unit_vector};
use tree_core::{Control, Foliage, Leaf, Resource, Seed};

/// Cells along the longer side of an outline.
const CELLS: usize = 60;
/// Area of a leaf over its length squared, where none was drawn.
const BLADE: f32 = 0.3;
/// New leaves are seen slantwise: so much of their area counts.
const SLANT: f32 = 0.5;
/// Leaves added to one cell, at most.
const MOST_LEAVES: u32 = 32;
/// A leaf that sticks out is tried again, so much smaller.
const SMALLER: f32 = 0.85;
/// A twig that would be longer than this many cells is left out: it would hang in the air.
const FAR: f32 = 4.0;
/// Twigs lean at most this far from the wood below them, in radians, where there is a place for it.
const LEAN: f32 = 0.9;
/// Nodes that are tried for it.
const MOST_BACK: u32 = 32;
/// No cell is smaller than this many leaf lengths.
const FINE: f32 = 0.5;
/// Stands for a node where there is none.
const NONE: u32 = u32::MAX;

/// Fills gaps.
pub(super) struct Gaps<'a> {
    pub(super) plan: &'a Plan,
    pub(super) params: &'a GrowParams,
    pub(super) fence: &'a Fence,
    /// Length of leaves in metres.
    pub(super) leaf: Option<f32>,
}

impl Gaps<'_> {
    /// Adds nodes and leaves; returns the number of leaves.
    pub(super) fn fill(
        &self,
        (positions, parents): (&mut Vec<Vec3>, &mut Vec<u32>),
        leaves: &mut Foliage,
        seed: Seed,
        control: &Control,
    ) -> Result<u64> {
        let (Some(length), Some(_)) = (self.leaf, &self.params.leaves) else { return Ok(0) };
        if self.params.fill == 0.0 {
            return Ok(0);
        }
        let before = leaves.len();
        let (low, high) = self.plan.system.outline.bounds();
        let cells = ((high - low).max_element() / (FINE * length)).clamp(4.0, CELLS as f32);
        for (i, view) in views(self.plan, cells as usize).iter().enumerate() {
            control.check()?;
            let mut rng = seed.child(i as u64).rng();
            let mut grid = Grid::of(view, positions, leaves, self.blade());
            let wanted = self.params.fill * view.cell * view.cell;
            while let Some((cell, node)) = grid.next() {
                let lack = wanted - grid.area[cell];
                if lack <= 0.0 {
                    continue;
                }
                let base = positions[node as usize];
                let there = grow(view, cell, base, &mut rng);
                let Some(here) = self.placed(view, there, base) else { continue };
                control.limits.check(Resource::Nodes, positions.len() as u64 + 1)?;
                let node = fork(positions, parents, (node, here), FAR * view.cell);
                positions.push(here);
                parents.push(node);
                let node = positions.len() as u32 - 1;
                grid.nodes[cell] = node;
                let way = (here - base).normalize_or_zero();
                let (mut lack, mut count) = (lack, 0);
                while lack > 0.0 && count < MOST_LEAVES {
                    control.limits.check(Resource::Leaves, leaves.len() as u64 + 1)?;
                    let leaf = self.leaf(view, (here, way, node), length, &mut rng);
                    lack -= SLANT * self.blade() * leaf.size * leaf.size;
                    count += 1;
                    leaves.push(leaf)?;
                }
            }
        }
        Ok((leaves.len() - before) as u64)
    }

    /// A place inside from all sides and near where the twig begins; else, from the front, the place itself: what was drawn
    /// comes first.
    fn placed(&self, view: &View, there: Vec3, base: Vec3) -> Option<Vec3> {
        let far = FAR * view.cell;
        let fenced = if self.params.fence { self.fence.drawn_in(there) } else { Some(there) };
        let near = fenced.filter(|here| here.distance(base) < far);
        near.or_else(|| (!view.is_side && there.distance(base) < far).then_some(there))
    }

    fn blade(&self) -> f32 {
        self.plan.leaf.as_ref().map_or(BLADE, |leaf| leaf.outline.area())
    }

    /// A leaf about a node, its middle somewhere in the node's cell, and if it can be all of it inside. It stands along the
    /// twig rather than across.
    fn leaf(
        &self,
        view: &View,
        (here, way, node): (Vec3, Vec3, u32),
        length: f32,
        rng: &mut Rng,
    ) -> Leaf {
        /// Leaves that are tried.
        const TRIES: u32 = 4;
        let mut size = length * uniform(rng, 0.8, 1.05);
        let mut found = (here, Vec3::Y);
        let pointing = |rng: &mut Rng| (unit_vector(rng) + 0.6 * way).try_normalize();
        for _ in 0..TRIES {
            let off = 0.5 * view.cell * Vec2::new(uniform(rng, -1.0, 1.0), uniform(rng, -1.0, 1.0));
            let midrib = pointing(rng).unwrap_or(Vec3::Y);
            found = (view.at_depth_of(view.seen(here) + off, here), midrib);
            let ends = [-0.5, 0.0, 0.5].map(|part| found.0 + part * size * found.1);
            if !self.params.fence || ends.into_iter().all(|end| self.fence.contains(end)) {
                break;
            }
            size *= SMALLER;
        }
        let (middle, midrib) = found;
        // Upper faces look anywhere, but up rather than down.
        let face = unit_vector(rng) + 0.5 * Vec3::Y;
        let side = midrib.cross(face).try_normalize().unwrap_or(Vec3::X);
        let face = side.cross(midrib);
        let turn = Quat::from_mat3(&Mat3::from_cols(midrib.cross(face), midrib, face));
        let rotation = turn.normalize();
        Leaf { node, position: middle - 0.5 * size * midrib, rotation, size, kind: 0 }
    }
}

/// Where a twig to a place forks off: the wood nearest to a place lies square to the way there, but twigs lean towards the tip. So of
/// a node and those below it the first that the twig leaves at no more than [`LEAN`] to the wood below; the one with the
/// least angle where none is. All are within `far` of the place.
fn fork(positions: &[Vec3], parents: &[u32], (node, here): (u32, Vec3), far: f32) -> u32 {
    let place = |node: u32| positions.get(node as usize).copied();
    let (mut at, mut best) = (node, (node, f32::NEG_INFINITY));
    for _ in 0..MOST_BACK {
        let below = parents.get(at as usize).and_then(|&below| Some((below, place(below)?)));
        let (Some((below, from)), Some(start)) = (below, place(at)) else { break };
        if at != node && start.distance(here) > far {
            break;
        }
        let (wood, twig) = ((start - from).normalize_or_zero(), (here - start).normalize_or_zero());
        let cosine = wood.dot(twig);
        if cosine > best.1 {
            best = (at, cosine);
        }
        if cosine >= libm::cosf(LEAN) {
            break;
        }
        at = below;
    }
    best.0
}

/// A place in a cell, about as deep as a node.
fn grow(view: &View, cell: usize, from: Vec3, rng: &mut Rng) -> Vec3 {
    let (x, y) = (cell % view.size[0], cell / view.size[0]);
    let mut within = || 0.5 + uniform(rng, -0.3, 0.3);
    let seen = view.low + view.cell * Vec2::new(x as f32 + within(), y as f32 + within());
    let mut there = view.at_depth_of(seen, from);
    let depth = 0.5 * view.cell * uniform(rng, -1.0, 1.0);
    // Whatever is not seen: one of them is the view's depth.
    if view.seen(Vec3::X) == Vec2::ZERO {
        there.x += depth;
    } else {
        there.z += depth;
    }
    there
}

/// The cells of a view: leaf area, and a node.
struct Grid<'a> {
    view: &'a View,
    area: Vec<f32>,
    nodes: Vec<u32>,
    /// The cell from which each was reached; itself where there is wood.
    from: Vec<usize>,
    waiting: VecDeque<usize>,
    is_known: Vec<bool>,
}

impl<'a> Grid<'a> {
    fn of(view: &'a View, positions: &[Vec3], leaves: &Foliage, blade: f32) -> Self {
        let n = view.inside.len();
        let (mut area, mut nodes) = (vec![0.0; n], vec![NONE; n]);
        for (i, &point) in positions.iter().enumerate() {
            if let Some(cell) = view.cell_of(point) {
                nodes[cell] = i as u32;
            }
        }
        let columns = leaves.positions().iter().zip(leaves.rotations()).zip(leaves.sizes());
        for ((&position, &rotation), &size) in columns {
            let midrib = size * (rotation * Vec3::Y);
            let face = rotation * Vec3::Z;
            let slant = if view.is_side { face.x } else { face.z };
            let share = slant.abs() * blade * size * size / 2.0;
            for part in [0.3, 0.7] {
                if let Some(cell) = view.cell_of(position + part * midrib) {
                    area[cell] += share;
                }
            }
        }
        let mut is_known = vec![false; n];
        let mut waiting = VecDeque::new();
        for cell in 0..n {
            if view.inside[cell] && nodes[cell] != NONE {
                is_known[cell] = true;
                waiting.push_back(cell);
            }
        }
        let from = (0..n).collect();
        Self { view, area, nodes, from, waiting, is_known }
    }

    /// The next cell, the nearest to wood first, and the node to grow from.
    fn next(&mut self) -> Option<(usize, u32)> {
        let cell = self.waiting.pop_front()?;
        // The one it was reached from has its own node by now.
        let node = self.nodes[self.from[cell]];
        self.nodes[cell] = node;
        let [width, height] = self.view.size;
        let (x, y) = (cell % width, cell / width);
        let mut reach = |neighbour: usize| {
            if self.view.inside[neighbour] && !self.is_known[neighbour] {
                self.is_known[neighbour] = true;
                self.from[neighbour] = cell;
                self.waiting.push_back(neighbour);
            }
        };
        if x > 0 {
            reach(cell - 1);
        }
        if x + 1 < width {
            reach(cell + 1);
        }
        if y > 0 {
            reach(cell - width);
        }
        if y + 1 < height {
            reach(cell + width);
        }
        Some((cell, node))
    }
}
