//! Replication blocks: a parent segment and its children (thesis, section 4.7).
//!
//! Blocks are taken from the sketch by the order of the parent's axis. Of a child much longer than natural only the
//! part up to its first new fork counts. Where an order has less than [`FEW`] of them, blocks drawn from Ω fill the pool
//! up, with as many children as forks of the sketch have.

use super::drawn::{Drawn, RATIO, code, habit};
use super::frame::BETWEEN;
use crate::sketch::{Habit, Label, Normal, Omega};
use glam::Vec2;
use std::f32::consts::{PI, TAU};
use tree_core::Seed;
use tree_core::seed::{Rng, normal, uniform};

/// An order with fewer blocks in the sketch gets more from Ω: the same two forks all over look copied.
const FEW: usize = 3;
/// Blocks of such an order.
const FILLED: usize = 12;
/// Blocks of the sketch that an order keeps at most; further ones hardly add variety, but cost time at each draw.
const MANY: usize = 48;
/// Most children of a block from Ω.
const MOST_CHILDREN: u32 = 9;
/// Children of a fork where the sketch has none: an apical and one or two laterals.
const USUAL_CHILDREN: [u32; 2] = [2, 3];
/// Laterals whose length is on average less than this share of the segment below are none: the order does not branch.
const NO_LATERAL: f32 = 0.02;
/// Largest bend that is replicated, in lengths: strokes curl more, but not at every scale.
const MOST_BEND: f32 = 0.15;
/// Standard deviation of the bow of a block from Ω, in lengths.
const BOW: f32 = 0.05;
/// Most that an angle may deviate by chance, in standard deviations.
const TAIL: f32 = 2.0;
/// Largest angle of an apical child, and smallest and largest of a lateral, in radians.
const APICAL_MOST: f32 = 1.0;
const LATERAL: [f32; 2] = [0.25, 1.9];

/// A child of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Child {
    pub(super) label: Label,
    /// Its length against its parent's.
    pub(super) ratio: f32,
    /// α or β.
    pub(super) angle: f32,
    /// Azimuth about the parent, from the first lateral's.
    pub(super) azimuth: f32,
    pub(super) bend: [Vec2; BETWEEN],
}

/// Where a block's children are, and its name.
#[derive(Clone, Copy, Debug)]
struct Block {
    key: Seed,
    first: u32,
    end: u32,
}

/// The blocks of one order.
#[derive(Clone, Debug, Default)]
struct Pool {
    blocks: Vec<Block>,
    children: Vec<Child>,
    branches: bool,
}

/// All blocks by order; the last pool holds for all higher orders too.
#[derive(Clone, Debug)]
pub(super) struct Pools {
    pools: Vec<Pool>,
    /// Blocks taken from the sketch, and drawn from Ω.
    pub(super) n_drawn: u32,
    pub(super) n_filled: u32,
}

impl Pools {
    pub(super) fn new(drawn: &Drawn<'_>, omega: &Omega, seed: Seed) -> Self {
        let deepest = drawn.orders.iter().copied().max().unwrap_or(0) as usize;
        let n_orders = (deepest + 2).max(omega.orders.len());
        let mut pools = vec![Pool::default(); n_orders];
        let mut n_drawn = 0;
        for segment in 0..drawn.orders.len() {
            let pool = &mut pools[drawn.orders[segment] as usize];
            let laterals = drawn.children(segment).len() > 1;
            if laterals && !drawn.is_imagined(segment) && pool.blocks.len() < MANY {
                pool.take(drawn, segment);
                n_drawn += 1;
            }
        }
        let counts = |pool: &Pool| -> Vec<u32> {
            pool.blocks.iter().map(|block| block.end - block.first).collect()
        };
        let mut all: Vec<u32> = pools.iter().flat_map(counts).collect();
        all.sort_unstable();
        let mut n_filled = 0;
        for (order, pool) in pools.iter_mut().enumerate() {
            let habit = habit(omega, order as u32);
            let seen = !pool.blocks.is_empty();
            pool.branches = seen || libm::expf(habit.lateral_scale.mean) >= NO_LATERAL;
            if pool.branches && pool.blocks.len() < FEW {
                let mut own = counts(pool);
                own.sort_unstable();
                let counts = [&own[..], &all, &USUAL_CHILDREN].into_iter().find(|c| !c.is_empty());
                n_filled += pool.fill(habit, counts.unwrap_or(&[]), seed.child(order as u64));
            }
        }
        Self { pools, n_drawn, n_filled }
    }

    /// Whether axes of this order bear laterals.
    pub(super) fn branches(&self, order: u32) -> bool {
        self.pool(order).branches
    }

    /// Draws a block: that whose name and `key` together give the largest number (rendezvous hashing, Thaler and
    /// Ravishankar 1998), so that a block more or less in the pool changes only who draws it.
    pub(super) fn draw(&self, order: u32, key: Seed) -> &[Child] {
        let pool = self.pool(order);
        let best = pool.blocks.iter().max_by_key(|block| Seed(key.0 ^ block.key.0).child(0));
        best.map_or(&[], |block| &pool.children[block.first as usize..block.end as usize])
    }

    /// Most children a block has.
    pub(super) fn most_children(&self) -> u64 {
        let blocks = self.pools.iter().flat_map(|pool| &pool.blocks);
        blocks.map(|block| u64::from(block.end - block.first)).max().unwrap_or(0)
    }

    fn pool(&self, order: u32) -> &Pool {
        &self.pools[(order as usize).min(self.pools.len() - 1)]
    }
}

impl Pool {
    /// Takes the fork at the end of a sketched segment.
    fn take(&mut self, drawn: &Drawn<'_>, segment: usize) {
        let first = self.children.len();
        let frame = drawn.ends[segment];
        let unit = drawn.natural[segment].max(f32::MIN_POSITIVE);
        for &child in drawn.children(segment) {
            let child = child as usize;
            let (course, way) = (&drawn.courses[child], drawn.natural[child]);
            let along = course.heading(0.0, way, frame.along);
            let label = drawn.branches.labels()[child];
            let [angle, azimuth] = frame.angles(along);
            let bend = course.bend(way, frame.child(angle, azimuth));
            self.children.push(Child {
                label,
                ratio: (way / unit).clamp(RATIO[0], RATIO[1]),
                angle: within(label, angle),
                azimuth,
                bend: bend.map(|off| off.clamp_length_max(MOST_BEND)),
            });
        }
        let block = &mut self.children[first..];
        let origin =
            block.iter().find(|child| child.label != Label::Apical).map_or(0.0, |c| c.azimuth);
        for child in block {
            child.azimuth -= origin;
        }
        self.close(drawn.keys[segment], first);
    }

    /// Adds blocks drawn from the habit up to [`FILLED`]; `counts` has the numbers of children seen, sorted. Returns how
    /// many.
    fn fill(&mut self, habit: &Habit, counts: &[u32], seed: Seed) -> u32 {
        let n_filled = FILLED.saturating_sub(self.blocks.len());
        for i in 0..n_filled {
            let first = self.children.len();
            let rng = &mut seed.child(i as u64).rng();
            let count = counts.get(i * counts.len() / FILLED).copied().unwrap_or(2);
            let n_laterals = count.clamp(2, MOST_CHILDREN) - 1;
            // An apical segment turns away from a single lateral, and any way from several.
            let away = if n_laterals == 1 { PI } else { uniform(rng, 0.0, TAU) };
            self.children.push(child(Label::Apical, habit.scale, habit.alpha, away, rng));
            for number in 0..n_laterals {
                let even = TAU * number as f32 / n_laterals as f32;
                let azimuth = even + tame(Normal::new(0.0, habit.gamma.deviation.min(0.5)), rng);
                let label = Label::Lateral(number as u16);
                self.children.push(child(label, habit.lateral_scale, habit.beta, azimuth, rng));
            }
            self.close(seed.child(code(Label::Apical) ^ (i as u64 + 1)), first);
        }
        n_filled as u32
    }

    fn close(&mut self, key: Seed, first: usize) {
        let end = self.children.len() as u32;
        self.blocks.push(Block { key, first: first as u32, end });
    }
}

/// A child drawn from normal distributions.
fn child(label: Label, scale: Normal, angle: Normal, azimuth: f32, rng: &mut Rng) -> Child {
    let ratio = libm::expf(tame(scale, rng)).clamp(RATIO[0], RATIO[1]);
    let angle = within(label, tame(angle, rng).abs());
    let [bow, side, wave] = [(); 3].map(|()| tame(Normal::new(0.0, BOW), rng));
    // A bow, and half a wave of half its height for an S.
    let bend = std::array::from_fn(|i| {
        let share = (i + 1) as f32 / (BETWEEN + 1) as f32;
        let arch = 4.0 * share * (1.0 - share);
        Vec2::new(bow * arch + 0.5 * wave * libm::sinf(TAU * share), side * arch)
    });
    Child { label, ratio, angle, azimuth, bend }
}

/// A number from a normal distribution without its tails.
fn tame(of: Normal, rng: &mut Rng) -> f32 {
    of.mean + of.deviation * normal(rng).clamp(-TAIL, TAIL)
}

/// An angle that a child of this label may have.
fn within(label: Label, angle: f32) -> f32 {
    if label == Label::Apical {
        angle.min(APICAL_MOST)
    } else {
        angle.clamp(LATERAL[0], LATERAL[1])
    }
}
