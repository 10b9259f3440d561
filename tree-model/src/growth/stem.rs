//! A growing tree in columns: nodes, and at each node its ends (the axis going on, and axillary places),
//! which are buds, branches or nothing.

use glam::Vec3;
use tree_core::NO_PARENT;

/// An end that is a living bud.
pub(super) const BUD: u32 = u32::MAX - 1;
/// An end where nothing grows any more.
pub(super) const NOTHING: u32 = u32::MAX;

/// Nodes in the order they grew, so parents come first.
#[derive(Clone, Debug)]
pub(super) struct Stem {
    pub(super) positions: Vec<Vec3>,
    /// Direction of the metamer below each node.
    pub(super) directions: Vec<Vec3>,
    /// Direction of the first axillary bud, across the metamer.
    pub(super) sides: Vec<Vec3>,
    pub(super) parents: Vec<u32>,
    pub(super) orders: Vec<u8>,
    /// Iteration in which each node grew.
    pub(super) born: Vec<u32>,
    /// A row for each node: the axis going on, then the axillary places. A child node, [`BUD`] or
    /// [`NOTHING`].
    ends: Vec<u32>,
    width: usize,
}

/// A node to be.
#[derive(Clone, Copy, Debug)]
pub(super) struct Metamer {
    pub(super) position: Vec3,
    pub(super) direction: Vec3,
    pub(super) side: Vec3,
}

/// What one bud has made.
#[derive(Clone, Debug)]
pub(super) struct Shoot {
    pub(super) node: u32,
    pub(super) slot: usize,
    pub(super) metamers: Vec<Metamer>,
    /// Whether something was in the way of the rest.
    pub(super) blocked: bool,
}

/// Which nodes get axillary buds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Budding {
    pub(super) zone: u32,
    pub(super) max_order: u32,
}

impl Stem {
    /// The base, and no end open.
    pub(super) fn new(base: Metamer, n_axillary: usize) -> Self {
        let width = n_axillary + 1;
        Self {
            positions: vec![base.position],
            directions: vec![base.direction],
            sides: vec![base.side],
            parents: vec![NO_PARENT],
            orders: vec![0],
            born: vec![0],
            ends: vec![NOTHING; width],
            width,
        }
    }

    pub(super) fn len(&self) -> usize {
        self.parents.len()
    }

    /// Ends of each node.
    pub(super) fn width(&self) -> usize {
        self.width
    }

    /// All ends, node after node.
    pub(super) fn ends(&self) -> &[u32] {
        &self.ends
    }

    pub(super) fn ends_of(&self, node: usize) -> &[u32] {
        &self.ends[node * self.width..(node + 1) * self.width]
    }

    pub(super) fn has_bud(&self, node: usize) -> bool {
        self.ends_of(node).contains(&BUD)
    }

    /// Appends a shoot grown in `iteration`.
    pub(super) fn append(&mut self, shoot: &Shoot, iteration: u32, budding: Budding) {
        let lateral = u8::from(shoot.slot > 0);
        let order = self.orders[shoot.node as usize].saturating_add(lateral);
        let bears = u32::from(order) < budding.max_order;
        let n = shoot.metamers.len();
        let (mut below, mut slot) = (shoot.node as usize, shoot.slot);
        for (place, metamer) in shoot.metamers.iter().enumerate() {
            let node = self.len();
            self.ends[below * self.width + slot] = node as u32;
            self.positions.push(metamer.position);
            self.directions.push(metamer.direction);
            self.sides.push(metamer.side);
            self.parents.push(below as u32);
            self.orders.push(order);
            self.born.push(iteration);
            let in_zone = bears && (n - place) as u64 <= u64::from(budding.zone);
            let axillary = if in_zone { BUD } else { NOTHING };
            self.ends.push(BUD);
            self.ends.extend(std::iter::repeat_n(axillary, self.width - 1));
            (below, slot) = (node, 0);
        }
    }

    /// Axillary buds older than `life` die.
    pub(super) fn age_buds(&mut self, iteration: u32, life: u32) {
        for (ends, &born) in self.ends.chunks_exact_mut(self.width).zip(&self.born) {
            if iteration.saturating_sub(born) <= life {
                continue;
            }
            for end in ends.iter_mut().skip(1).filter(|end| **end == BUD) {
                *end = NOTHING;
            }
        }
    }

    /// Removes nodes; what grows on a removed node must go too.
    pub(super) fn retain(&mut self, keep: &[bool]) {
        let mut new = vec![NOTHING; self.len()];
        let kept = keep.iter().enumerate().filter(|&(_, &keep)| keep);
        for (name, (node, _)) in (0..).zip(kept) {
            new[node] = name;
        }
        let renamed = |old: u32| match old {
            BUD | NOTHING => old,
            node => new.get(node as usize).copied().unwrap_or(NOTHING),
        };
        self.ends.iter_mut().for_each(|end| *end = renamed(*end));
        self.parents.iter_mut().for_each(|parent| *parent = renamed(*parent));
        let width = self.width;
        let mut row = 0;
        self.ends.retain(|_| {
            row += 1;
            keep.get((row - 1) / width).copied().unwrap_or(true)
        });
        retain(&mut self.positions, keep);
        retain(&mut self.directions, keep);
        retain(&mut self.sides, keep);
        retain(&mut self.parents, keep);
        retain(&mut self.orders, keep);
        retain(&mut self.born, keep);
    }
}

fn retain<T>(column: &mut Vec<T>, keep: &[bool]) {
    let mut keep = keep.iter();
    column.retain(|_| keep.next().copied().unwrap_or(true));
}
