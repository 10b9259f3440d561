//! The search: least-cost paths from the base to every working pixel (Dijkstra 1959), and their union.
//!
//! One search from the base gives every seed's path, and their union is a tree by construction. Where
//! the picture shows no branches, least-cost paths fan out from the base and hardly ever meet. Trees
//! are not so: side branches join a main one at an acute angle. So the search is done three times: for
//! the leader, for a few main seeds, for all; and what an earlier one found is cheaper in the
//! next (an idea near the "path cooling" of Mortensen & Barrett 1998), as if a faint branch had been seen there.
//! A path meets a cheaper one at the critical angle of refraction: cos = share of the cost.
//!
//! Costs are whole numbers, so that buckets serve as the queue (Dial 1969): O(pixels · 16 + cost).

use super::LivewireParams;
use super::cost::Costs;
use super::ridge::STEPS;
use super::trunk::Trunk;
use super::working::Working;
use crate::error::Result;
use glam::Vec2;
use tree_core::Control;

/// Cost units in one pixel's length at cost 1.
const UNIT: f32 = 32.0;

/// Buckets of the queue. The dearest step costs one less: beyond 500 times a step through leaves, all
/// steps outside the tree cost the same.
const BUCKETS: usize = 1 << 14;

/// One main seed for this many seeds.
const SEEDS_FOR_A_MAIN: usize = 4;

/// How much a pixel aside of the axis counts against the leader, in pixels of height.
const LEADER_ASIDE: f32 = 0.6;

/// How much upwards counts beside away from the base in the direction in which branches grow.
const UP: f32 = 0.5;

/// Columns and rows within which a path joins another.
const CLOSE: usize = 2;

/// No predecessor.
pub(super) const NONE: u32 = u32::MAX;

/// A union of paths over working pixels.
pub(super) struct Union {
    /// Pixels, the base first, each after the one it leads to.
    pub(super) pixels: Vec<u32>,
    /// The row of the pixel each leads to; [`NONE`] at the base.
    pub(super) parents: Vec<u32>,
}

/// The union of the paths of all `seeds` (working pixels) to `base`.
pub(super) fn union(
    working: &Working,
    costs: &Costs,
    trunk: &Trunk,
    base: u32,
    seeds: &[u32],
    params: &LivewireParams,
    control: &Control,
) -> Result<Union> {
    let mut cheap = vec![1.0; costs.plain.len()];
    for &(row, middle, _) in &trunk.rows {
        // The axis of a wide trunk is no ridge at the scales of branches.
        let start = row * working.alpha.width;
        for x in [middle.floor(), middle.floor() + 1.0] {
            cheap[start + (x as usize).min(working.alpha.width - 1)] = 1.0 - params.follow;
        }
    }
    let main = (seeds.len() / SEEDS_FOR_A_MAIN).max(1);
    let order = by_importance(working, base, seeds, main);
    let mut search = Search::new(working, costs, base, params);
    for (round, n) in [1, main].into_iter().enumerate() {
        control.report("livewire", 0.4 + 0.2 * round as f32)?;
        if params.join > 0.0 && n < order.len() {
            let before = search.run(&cheap);
            let found = collect(working, before, base, &order[..n]);
            cool(&mut cheap, working, &found, 1.0 - params.join);
        }
    }
    control.report("livewire", 0.8)?;
    Ok(collect(working, search.run(&cheap), base, &order))
}

/// The leader first, then `main` seeds, each the farthest from all before it, then the rest.
fn by_importance(working: &Working, base: u32, seeds: &[u32], main: usize) -> Vec<u32> {
    let at = |pixel: u32| {
        let (x, y) = working.column_row(pixel as usize);
        Vec2::new(x as f32, y as f32)
    };
    let foot = at(base);
    let height = |&pixel: &u32| foot.y - at(pixel).y - LEADER_ASIDE * (at(pixel).x - foot.x).abs();
    let mut rest = seeds.to_vec();
    let mut order = Vec::with_capacity(seeds.len());
    let leader = (0..rest.len()).max_by(|&a, &b| height(&rest[a]).total_cmp(&height(&rest[b])));
    order.extend(leader.map(|row| rest.remove(row)));
    while order.len() < main && !rest.is_empty() {
        let nearest = |&pixel: &u32| {
            let near = |&other: &u32| at(pixel).distance_squared(at(other));
            order.iter().map(near).fold(f32::INFINITY, f32::min)
        };
        let farthest =
            (0..rest.len()).max_by(|&a, &b| nearest(&rest[a]).total_cmp(&nearest(&rest[b])));
        let Some(row) = farthest else { break };
        order.push(rest.remove(row));
    }
    order.extend(rest);
    order
}

/// Makes the pixels of `found` and their neighbours cost no more than `share`.
fn cool(cheap: &mut [f32], working: &Working, found: &Union, share: f32) {
    for &pixel in &found.pixels {
        around(working, pixel, 1, |near| cheap[near] = cheap[near].min(share));
    }
}

/// The union of the paths from `seeds` by the predecessors `before`. A path that comes close to an
/// earlier one joins it there: two wires side by side in one branch are one.
fn collect(working: &Working, before: &[u32], base: u32, seeds: &[u32]) -> Union {
    let mut union = Union { pixels: vec![base], parents: vec![NONE] };
    // For each pixel the row of a collected one that is close.
    let mut close_to = vec![NONE; before.len()];
    close_to[base as usize] = 0;
    let mut path = Vec::new();
    for &seed in seeds {
        path.clear();
        let mut pixel = seed;
        while pixel != NONE && close_to[pixel as usize] == NONE {
            path.push(pixel);
            pixel = before[pixel as usize];
        }
        if pixel == NONE {
            continue;
        }
        let mut parent = close_to[pixel as usize];
        let first = union.pixels.len();
        for &pixel in path.iter().rev() {
            union.pixels.push(pixel);
            union.parents.push(parent);
            parent = union.pixels.len() as u32 - 1;
        }
        for row in first..union.pixels.len() {
            around(working, union.pixels[row], CLOSE, |near| {
                // A path's own pixel counts before its neighbours'.
                let is_itself = near == union.pixels[row] as usize;
                if close_to[near] == NONE || is_itself {
                    close_to[near] = row as u32;
                }
            });
        }
    }
    union
}

/// Calls `visit` with every pixel at most `reach` columns and rows away.
fn around(working: &Working, pixel: u32, reach: usize, mut visit: impl FnMut(usize)) {
    let (width, height) = (working.alpha.width, working.alpha.height);
    let (x, y) = working.column_row(pixel as usize);
    for y in y.saturating_sub(reach)..(y + reach + 1).min(height) {
        for x in x.saturating_sub(reach)..(x + reach + 1).min(width) {
            visit(y * width + x);
        }
    }
}

/// Dijkstra's search with its memory, to be run several times.
struct Search<'a> {
    working: &'a Working,
    costs: &'a Costs,
    base: u32,
    params: &'a LivewireParams,
    distance: Vec<u32>,
    before: Vec<u32>,
    buckets: Vec<Vec<u32>>,
}

impl<'a> Search<'a> {
    fn new(working: &'a Working, costs: &'a Costs, base: u32, params: &'a LivewireParams) -> Self {
        let n = costs.plain.len();
        Self {
            working,
            costs,
            base,
            params,
            distance: vec![u32::MAX; n],
            before: vec![NONE; n],
            buckets: vec![Vec::new(); BUCKETS],
        }
    }

    /// The predecessor of every pixel on its path to the base.
    fn run(&mut self, cheap: &[f32]) -> &[u32] {
        self.distance.fill(u32::MAX);
        self.before.fill(NONE);
        self.distance[self.base as usize] = 0;
        self.buckets[0].push(self.base);
        let (mut waiting, mut now) = (1_usize, 0_u32);
        while waiting > 0 {
            while let Some(pixel) = self.buckets[now as usize % BUCKETS].pop() {
                waiting -= 1;
                if self.distance[pixel as usize] == now {
                    waiting += self.expand(pixel, now, cheap);
                }
            }
            now += 1;
        }
        &self.before
    }

    /// Offers the way through `pixel` to its neighbours; how many took it.
    fn expand(&mut self, pixel: u32, now: u32, cheap: &[f32]) -> usize {
        let (width, height) = (self.working.alpha.width as i32, self.working.alpha.height as i32);
        let (x, y) = self.working.column_row(pixel as usize);
        let (bx, by) = self.working.column_row(self.base as usize);
        let outwards = Vec2::new(x as f32 - bx as f32, y as f32 - by as f32);
        let outwards = (outwards.normalize_or_zero() + UP * Vec2::NEG_Y).normalize_or(Vec2::NEG_Y);
        let mut taken = 0;
        for (direction, &(dx, dy)) in STEPS.iter().enumerate() {
            let length = ((dx * dx + dy * dy) as f32).sqrt();
            // How far the step leads inwards: 0 outwards to 1 inwards.
            let turn = outwards.dot(Vec2::new(dx as f32, dy as f32)) / length;
            for (sign, turn) in [(1, turn), (-1, -turn)] {
                let (x, y) = (x as i32 + sign * dx, y as i32 + sign * dy);
                if x < 0 || y < 0 || x >= width || y >= height {
                    continue;
                }
                let next = (y * width + x) as u32;
                let inwards = 1.0 + self.params.outwards * 0.5 * (1.0 - turn);
                let cost = length * inwards * self.pair(pixel, next, direction, cheap);
                let cost = (UNIT * cost).clamp(1.0, (BUCKETS - 1) as f32) as u32;
                let total = now.saturating_add(cost);
                if total < self.distance[next as usize] {
                    self.distance[next as usize] = total;
                    self.before[next as usize] = pixel;
                    self.buckets[total as usize % BUCKETS].push(next);
                    taken += 1;
                }
            }
        }
        taken
    }

    /// Cost of a unit of length between two pixels along a direction.
    #[inline]
    fn pair(&self, a: u32, b: u32, direction: usize, cheap: &[f32]) -> f32 {
        let of = |pixel: u32| {
            let i = pixel as usize;
            let evidence = f32::from(self.costs.evidence[i][direction]) / 255.0;
            self.costs.plain[i] * (1.0 - self.params.follow * evidence).min(cheap[i])
        };
        0.5 * (of(a) + of(b))
    }
}
